//! Lines that are found in the picture, as filled shapes.

use super::{fills::Turn, regions::Labels};
use crate::frame::Plate;

/// Opacities that lines may have.
const OPACITIES: u8 = 15;

/// Labels of a plate's lines but for those that are found along triangles: 0 where there is none, else the place of
/// the pen among those that are answered with. These are numbers of pens with an opacity of 1 to 255.
pub(super) fn inked(plate: &Plate) -> (Labels, Vec<[u8; 2]>) {
    let mut marks: Vec<[u8; 2]> = Vec::new();
    let edge = |index: usize| plate.edges.get(index).is_some_and(|edge| edge[0] == plate.ink[index][0]);
    let label = |(index, &mark): (usize, &[u8; 2])| {
        if mark[0] == 0 || mark[1] == 0 || edge(index) {
            return 0;
        }
        let mark = [mark[0] - 1, stepped(mark[1])];
        let known = marks.iter().position(|known| *known == mark);
        1 + known.unwrap_or_else(|| {
            marks.push(mark);
            marks.len() - 1
        }) as u16
    };
    let of = plate.ink.iter().enumerate().map(label).collect();
    (Labels { size: plate.size, of }, marks)
}

/// An opacity as one of a few: where lines fade, each step becomes a shape.
fn stepped(opacity: u8) -> u8 {
    let step = u8::MAX / OPACITIES;
    (opacity.div_ceil(step)) * step
}

/// When each of so many labels is painted: opaque lines lie on each other.
pub(super) fn turns(marks: &[[u8; 2]]) -> Vec<Turn> {
    let turn = |(stack, mark): (usize, &[u8; 2])| match mark[1] {
        u8::MAX => Turn::Stacked { stack, rank: 0 },
        _ => Turn::Beside,
    };
    std::iter::once(Turn::Nothing).chain(marks.iter().enumerate().map(turn)).collect()
}
