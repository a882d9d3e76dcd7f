//! What paints do to what they cover, as shaders take it.

use bytemuck::{Pod, Zeroable};
use fumetto_scene::{Look, Object, Paint, Width, limits};

/// Paints that there is room for. Also in `coat.wgsl`.
pub(super) const MAX_COATS: usize = 12;

const _: () = assert!(limits::MAX_PAINT_LAYERS as usize == MAX_COATS, "a paint has a layer at least");

const MONOCHROME: u32 = 1;
const COVERS: u32 = 2;

/// Where paint stays that may go anywhere.
const ANYWHERE_M: f32 = 1e30;

/// `Coat` of `coat.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Coat {
    pub(super) keep_low: [f32; 3],
    line_px: f32,
    pub(super) keep_high: [f32; 3],
    line_m: f32,
    line_colour: [f32; 3],
    look: u32,
    wash_colour: [f32; 3],
    wash_strength: f32,
    bits: u32,
    flags: u32,
    pad: [u32; 2],
}

/// `Coats` of `coat.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Coats {
    pub(super) bodies: u32,
    count: u32,
    look: u32,
    flags: u32,
    coats: [Coat; MAX_COATS],
}

impl Coat {
    /// Of an object's `paint` whose layers begin at bit `first`; `look` is the number of the look that it shows.
    pub(super) fn new(object: &Object, paint: &Paint, first: u32, look: usize) -> Self {
        let [center, size] = paint.keep.unwrap_or([[0.0; 3], [2.0 * ANYWHERE_M; 3]]);
        let side = |sign: f32| [0, 1, 2].map(|axis| center[axis] + sign * 0.5 * size[axis]);
        let (line_px, line_m) = match paint.border.map(|border| border.width) {
            // Half of it to each side, and as a share of the picture's height.
            Some(Width::Px(px)) => (0.5 * px / object.style.height_px, 0.0),
            Some(Width::World(metres)) => (0.0, 0.5 * metres),
            None => (0.0, 0.0),
        };
        let line_colour = paint.border.map_or([0; 3], |border| border.colour.to_srgb8());
        let flag = |on, bit| if on { bit } else { 0 };
        Self {
            keep_low: side(-1.0),
            line_px,
            keep_high: side(1.0),
            line_m,
            line_colour: line_colour.map(|channel| f32::from(channel) / 255.0),
            look: look as u32,
            wash_colour: paint.wash.map_or([1.0; 3], |wash| wash.colour.linear),
            wash_strength: paint.wash.map_or(0.0, |wash| wash.strength),
            bits: ((1 << paint.layers()) - 1) << first,
            flags: flag(paint.inside == Look::Monochrome, MONOCHROME)
                | flag(paint.wash.is_some_and(|wash| wash.covers), COVERS),
            pad: [0; 2],
        }
    }
}

impl Coats {
    /// All of them, in the order in which they lie on each other; outside of them everything is shown in the look
    /// of number `look`.
    pub(super) fn new(coats: &[Coat], bodies: u32, (look, is_grey_outside): (usize, bool)) -> Self {
        let mut all = Self {
            bodies,
            count: coats.len() as u32,
            look: look as u32,
            flags: if is_grey_outside { MONOCHROME } else { 0 },
            coats: Zeroable::zeroed(),
        };
        for (slot, coat) in all.coats.iter_mut().zip(coats) {
            *slot = *coat;
        }
        all
    }

    /// The same with widths that were shares of the picture's height in samples.
    pub(crate) fn at_height(&self, height_px: u32) -> Self {
        let mut coats = *self;
        for coat in &mut coats.coats {
            coat.line_px *= height_px as f32;
        }
        coats
    }

    /// Whether what no paint covers is shown in shades of grey.
    pub(crate) fn is_grey_outside(&self) -> bool {
        self.flags & MONOCHROME != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: Coat, "Coat" of "paint/mask" { keep_low, line_px, keep_high, line_m, line_colour, look, wash_colour, wash_strength, bits, flags });

    layout_test!(all_lie_as_their_twin: Coats, "Coats" of "paint/mask" { bodies, count, look, flags, coats });
}
