//! Which ways of finding lines a cel's objects want.

use fumetto_scene::{EdgeKind, InkMethod, Object, Width};

use crate::object::{has_outline, ink_method};

/// The widest line that the picture itself is looked through for, as a share of the picture's height, where
/// widths are in metres: how near the viewer comes to a surface is not known beforehand.
const WIDEST: f32 = 0.125;

/// Which ways of finding lines a cel's objects want.
#[derive(Debug, Default)]
pub(crate) struct Methods {
    /// Some by billboards behind their puffs.
    pub(crate) outline: bool,
    /// Some by the angle between surface and viewer.
    pub(crate) angle: bool,
    /// Numbers of the objects that want a shell.
    pub(crate) shells: Vec<usize>,
    /// Some by looking through the picture.
    pub(crate) image: bool,
    /// Some by what suits each shape.
    pub(crate) hybrid: bool,
    /// Half the width of the widest line, in samples.
    pub(crate) radius_px: f32,
    /// Number of the first object; what else is in its layers comes before it and has its lines elsewhere.
    pub(crate) first: usize,
}

impl Methods {
    /// What those of `objects` want that `members` numbers, in a picture `height_px` samples high.
    pub(crate) fn of(objects: &[&Object], members: &[usize], height_px: u32) -> Self {
        let first = members.iter().copied().min().unwrap_or(0);
        let mut methods = Self { first, ..Self::default() };
        for &member in members {
            let style = &objects[member].style;
            if !style.ink.on {
                continue;
            }
            methods.outline |= has_outline(objects[member]);
            match ink_method(objects[member]) {
                InkMethod::Angle => methods.angle = true,
                InkMethod::Shell => methods.shells.push(member),
                InkMethod::Image => methods.image = true,
                InkMethod::Hybrid => methods.hybrid = true,
                InkMethod::Vector => {}
            }
            let width_px = |kind| match style.ink.width_of(kind) {
                Width::Px(px) => px * height_px as f32 / style.height_px,
                Width::World(_) => WIDEST * height_px as f32,
            };
            methods.radius_px =
                EdgeKind::ALL.map(|kind| 0.5 * width_px(kind)).into_iter().fold(methods.radius_px, f32::max);
        }
        methods
    }
}
