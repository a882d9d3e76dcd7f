//! What each volume is to do in a step, from the clock alone.

use bytemuck::{Pod, Zeroable};
use fumetto_scene::{Brush, Drop, Growth, Paint};
use glam::Vec3;

/// `Order` of `spread.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub(super) struct Order {
    pub(super) start: [f32; 3],
    pub(super) desired: f32,
    pub(super) end: [f32; 3],
    pub(super) first: f32,
    pub(super) state: u32,
    pub(super) pad: [u32; 3],
}

const COMES: u32 = 1;
const IS_THERE: u32 = 2;

/// Where a volume comes from: a drop, or a piece of a brush's path.
#[derive(Clone, Debug)]
pub(super) struct Source {
    from: Vec3,
    to: Vec3,
    /// When it comes, and when the brush has left it.
    during_secs: [f64; 2],
    radius: Growth,
    first_m: f32,
}

impl Source {
    /// Of the drops and the strokes of a paint.
    pub(super) fn of(paint: &Paint) -> Vec<Self> {
        paint.drops.iter().map(Self::of_drop).chain(paint.strokes.iter().flat_map(Self::of_stroke)).collect()
    }

    fn of_drop(drop: &Drop) -> Self {
        let at = Vec3::from(drop.at);
        let during_secs = [f64::from(drop.time_secs); 2];
        Self { from: at, to: at, during_secs, radius: drop.radius.clone(), first_m: drop.start_m }
    }

    /// The brush goes along its path at an even speed.
    fn of_stroke(stroke: &Brush) -> Vec<Self> {
        let ends: Vec<[Vec3; 2]> =
            stroke.path.windows(2).map(|pair| [pair[0], pair[1]].map(Vec3::from)).collect();
        let length = |[from, to]: &[Vec3; 2]| f64::from(from.distance(*to));
        let whole = ends.iter().map(length).sum::<f64>().max(f64::MIN_POSITIVE);
        let [begin, end] = stroke.during_secs.map(f64::from);
        let mut done = 0.0;
        let piece = |ends: &[Vec3; 2]| {
            let until = done + length(ends);
            let during_secs = [done, until].map(|along| begin + (end - begin) * along / whole);
            done = until;
            let [from, to] = *ends;
            Self { from, to, during_secs, radius: stroke.radius.clone(), first_m: stroke.start_m }
        };
        ends.iter().map(piece).collect()
    }

    /// What its volume does in the step between two moments; all lengths are multiplied by `scale`.
    pub(super) fn order(&self, [since, until]: [f64; 2], scale: f32) -> Order {
        let [begin, end] = self.during_secs;
        if begin >= until {
            return Order::zeroed();
        }
        let along = if end > begin { ((until - begin) / (end - begin)).min(1.0) } else { 1.0 };
        Order {
            start: self.from.into(),
            desired: scale * self.radius.at((until - begin) as f32),
            end: self.from.lerp(self.to, along as f32).into(),
            first: scale * self.first_m,
            state: if begin >= since { COMES } else { IS_THERE },
            pad: [0; 3],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: Order, "Order" of "paint/spread" { start, desired, end, first, state });

    fn growth(points: &[[f32; 2]]) -> Growth {
        Growth { points: points.to_vec() }
    }

    #[test]
    fn a_drop_comes_in_the_step_in_which_it_falls() {
        let drop = Drop {
            at: [1.0, 2.0, 3.0],
            time_secs: 0.5,
            radius: growth(&[[0.0, 1.0], [1.0, 3.0]]),
            start_m: 0.1,
        };
        let source = Source::of_drop(&drop);
        assert_eq!(source.order([0.25, 0.5], 1.0).state, 0);
        let comes = source.order([0.5, 0.75], 1.0);
        assert_eq!((comes.state, comes.start, comes.end), (COMES, [1.0, 2.0, 3.0], [1.0, 2.0, 3.0]));
        assert_eq!((comes.desired, comes.first), (1.5, 0.1));
        let later = source.order([1.0, 1.25], 0.5);
        assert_eq!((later.state, later.desired, later.first), (IS_THERE, 0.5 * 2.5, 0.05));
        assert_eq!(Source::of_drop(&Drop { time_secs: 0.0, ..drop }).order([0.0, 0.1], 1.0).state, COMES);
    }

    #[test]
    fn a_brush_goes_along_its_path_at_an_even_speed() {
        let path = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 3.0, 0.0]];
        let stroke = Brush { path, during_secs: [1.0, 5.0], radius: growth(&[[0.0, 0.5]]), start_m: 0.1 };
        let pieces = Source::of_stroke(&stroke);
        let ends = |until: f64| {
            let orders = pieces.iter().map(|piece| piece.order([until - 0.5, until], 1.0));
            orders.map(|order| (order.state != 0).then_some(order.end)).collect::<Vec<_>>()
        };
        assert_eq!(ends(1.0), [None, None]);
        assert_eq!(ends(1.5), [Some([0.5, 0.0, 0.0]), None]);
        assert_eq!(ends(3.5), [Some([1.0, 0.0, 0.0]), Some([1.0, 1.5, 0.0])]);
        assert_eq!(ends(9.0), [Some([1.0, 0.0, 0.0]), Some([1.0, 3.0, 0.0])]);
    }
}
