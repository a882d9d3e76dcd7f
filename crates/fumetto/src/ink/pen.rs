//! How each kind of edge of each object is drawn, as shaders take it.

use fumetto_scene::{EdgeKind, HiddenLines, InkMethod, Matter, Object, Width, limits};

use crate::object::ink_method;

/// `Pen` of `pen.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct Pen {
    colour: [f32; 3],
    opacity: f32,
    width_px: f32,
    width_m: f32,
    dash_px: [f32; 2],
    shortest_px: f32,
    thinnest_px: f32,
    flags: u32,
    lit_thinning: f32,
}

const DRAWS: u32 = 1;
const FOLLOWS_EDGES: u32 = 2;
const DASHES_HIDDEN: u32 = 4;
const HAS_STROKES: u32 = 8;

/// Pens that a frame may have: as many as the ink layer tells apart. Also in `pen.wgsl`.
pub(crate) const MAX_PENS: usize = 256;

const _: () = assert!(EdgeKind::ALL.len() * limits::MAX_OBJECTS < MAX_PENS, "every object has its pens");

impl Pen {
    /// The pens of all `objects`, for the cel of those that `members` numbers, in a picture `height_px` samples
    /// high; those beyond draw nothing.
    pub(crate) fn of_all(objects: &[&Object], members: &[usize], height_px: u32) -> [Self; MAX_PENS] {
        let mut all = [bytemuck::Zeroable::zeroed(); MAX_PENS];
        let pens = |(index, object)| {
            EdgeKind::ALL.map(|kind| Self::new(object, kind, members.contains(&index), height_px))
        };
        for (slot, pen) in all.iter_mut().zip(objects.iter().copied().enumerate().flat_map(pens)) {
            *slot = pen;
        }
        all
    }

    fn new(object: &Object, kind: EdgeKind, in_cel: bool, height_px: u32) -> Self {
        let ink = &object.style.ink;
        let pen = ink.pen(kind);
        let scale = height_px as f32 / object.style.height_px;
        let (width_px, width_m) = match ink.width_of(kind) {
            Width::Px(px) => (px * scale, 0.0),
            Width::World(metres) => (0.0, metres),
        };
        let draws = draws(object, kind);
        let follows_edges = in_cel && follows_edges(object, kind);
        // Where there are strokes, these leave out what is too short.
        let has_strokes = follows_edges && ink.stroke_of(kind).is_some();
        let flag = |on, bit| if on { bit } else { 0 };
        Self {
            colour: ink.colour_of(kind).to_srgb8().map(|channel| f32::from(channel) / 255.0),
            opacity: object.opacity,
            width_px,
            width_m,
            dash_px: pen.dash_px.unwrap_or_default().map(|px| px * scale),
            shortest_px: if has_strokes { 0.0 } else { ink.shortest * width_px },
            thinnest_px: width_px * (1.0 - ink.lit_thinning),
            flags: flag(draws, DRAWS)
                | flag(follows_edges, FOLLOWS_EDGES)
                | flag(ink.hidden == HiddenLines::Dashed, DASHES_HIDDEN)
                | flag(has_strokes, HAS_STROKES),
            lit_thinning: ink.lit_thinning,
        }
    }

    /// Whether it draws along the edges or contours of something of the cel.
    pub(crate) fn follows_edges(&self) -> bool {
        self.flags & FOLLOWS_EDGES != 0
    }

    /// Whether it draws strokes along them.
    pub(crate) fn has_strokes(&self) -> bool {
        self.flags & HAS_STROKES != 0
    }

    /// Length of the shortest line that is kept.
    pub(crate) fn shortest_line_px(&self) -> f32 {
        self.shortest_px
    }
}

/// Whether an object's edges of a kind are drawn at all.
fn draws(object: &Object, kind: EdgeKind) -> bool {
    let ink = &object.style.ink;
    let (Width::Px(width) | Width::World(width)) = ink.width_of(kind);
    ink.on && ink.pen(kind).on && width > 0.0
}

/// Whether they are drawn along triangles.
pub(crate) fn follows_edges(object: &Object, kind: EdgeKind) -> bool {
    draws(object, kind)
        && (matches!(object.matter, Matter::Mesh(_)) || object.shape.surface().is_some())
        && matches!(ink_method(object), InkMethod::Vector | InkMethod::Hybrid)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: Pen, "Pen" of "tone/compose" { colour, opacity, width_px, width_m, dash_px, shortest_px, thinnest_px, flags, lit_thinning });
}
