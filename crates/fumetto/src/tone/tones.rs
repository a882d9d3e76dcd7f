//! How each object turns light into colour, beyond its ramp, as shaders take it.

use std::ops::Range;

use fumetto_scene::{Colour, Object, Ramp, RampImage, RampRows};
use glam::Vec3;

use super::hatching::is_hatched;
use crate::object::MAX_OBJECTS;

/// A value that no highlight reaches.
const OUT_OF_REACH: f32 = 1e30;

/// `ToneStyle` of `tones.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct ToneStyle {
    highlight_colour: [f32; 3],
    highlight_from: f32,
    rim_colour: [f32; 3],
    rim_from: f32,
    cool: [f32; 3],
    alpha: f32,
    warm: [f32; 3],
    beta: f32,
    paint: [f32; 3],
    gloss: f32,
    focus: [f32; 3],
    axis: u32,
    axis_ends: [f32; 2],
    first_row: i32,
    row_count: i32,
    rim_width: f32,
    exaggerate_amount: f32,
    exaggerate_contrast: f32,
    exaggerate_scales: i32,
    material_steps: f32,
    is_gooch: u32,
    pad: [u32; 2],
}

impl ToneStyle {
    /// The tones of `object`, of whose ramp `rows` count.
    fn new(object: &Object, rows: &Range<u32>) -> Self {
        let style = &object.style;
        let (highlight, rim, exaggerate) = (style.highlight, style.rim, style.exaggerate);
        let gooch = if let Ramp::Gooch(gooch) = style.ramp { Some(gooch) } else { None };
        let (axis, axis_ends, focus) = axis(&style.ramp);
        let shades = gooch.unwrap_or_default();
        Self {
            highlight_colour: encoded(highlight.colour),
            highlight_from: if highlight.on { highlight.from } else { OUT_OF_REACH },
            rim_colour: encoded(rim.colour),
            rim_from: rim.from,
            cool: encoded(shades.cool),
            alpha: shades.alpha,
            warm: encoded(shades.warm),
            beta: shades.beta,
            paint: encoded(shades.colour),
            gloss: highlight.gloss,
            focus,
            axis,
            axis_ends,
            first_row: rows.start as i32,
            row_count: rows.len() as i32,
            rim_width: if rim.on { rim.width } else { 0.0 },
            exaggerate_amount: exaggerate.amount,
            exaggerate_contrast: exaggerate.contrast,
            exaggerate_scales: exaggerate.scales as i32,
            material_steps: style.material_steps as f32,
            is_gooch: u32::from(gooch.is_some()),
            pad: [0; 2],
        }
    }

    /// Of all `objects`, of whose ramps `rows` count; the rest of the list is empty.
    pub(super) fn list(objects: &[Object], rows: &[Range<u32>]) -> [Self; MAX_OBJECTS] {
        let mut list: [Self; MAX_OBJECTS] = bytemuck::Zeroable::zeroed();
        for ((slot, object), rows) in list.iter_mut().zip(objects).zip(rows) {
            *slot = Self::new(object, rows);
        }
        list
    }
}

/// What the rows of a ramp run along, where its top row and its bottom row are, and from where.
fn axis(ramp: &Ramp) -> (u32, [f32; 2], [f32; 3]) {
    let Ramp::Image(RampImage { rows, .. }) = ramp else { return (0, [0.0; 2], [0.0; 3]) };
    match *rows {
        RampRows::Middle => (0, [0.0; 2], [0.0; 3]),
        RampRows::Depth(ends) => (1, ends, [0.0; 3]),
        RampRows::Facing(exponent) => (2, [exponent; 2], [0.0; 3]),
        RampRows::Focus { center, radius } => (3, radius, Vec3::from(center).to_array()),
    }
}

fn encoded(colour: Colour) -> [f32; 3] {
    colour.to_srgb8().map(|channel| f32::from(channel) / 255.0)
}

/// Which of the rarer ways to shade are needed: a processor that draws in place of a graphics card works
/// out both sides of a branch, so that each set of them has a pipeline of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Features(u32);

impl Features {
    /// The shader's constants, bit by bit.
    const CONSTANTS: [&str; 10] = [
        "HAS_MESHES",
        "HAS_ROWS",
        "HAS_GOOCH",
        "HAS_HIGHLIGHT",
        "HAS_RIM",
        "HAS_EXAGGERATION",
        "HAS_STEPS",
        "HAS_VOLUMES",
        "HAS_HATCHING",
        "IS_PICTURE",
    ];

    /// What `objects` need.
    pub(crate) fn of(objects: &[Object], has_meshes: bool) -> Self {
        let any = |needs: fn(&Object) -> bool| objects.iter().any(|object| object.visible && needs(object));
        let has_volumes = any(|object| object.shape.volume().is_some());
        let needs = [
            has_meshes,
            any(|object| axis(&object.style.ramp).0 != 0),
            any(|object| matches!(object.style.ramp, Ramp::Gooch(_))),
            any(|object| object.style.highlight.on),
            any(|object| object.style.rim.on),
            any(|object| object.style.exaggerate.amount > 0.0),
            (has_meshes || has_volumes) && any(|object| object.style.material_steps > 0),
            has_volumes,
            any(is_hatched),
        ];
        Self((0..).zip(needs).map(|(bit, is_needed)| u32::from(is_needed) << bit).sum())
    }

    /// The same where tones go straight into the picture.
    pub(crate) fn for_picture(self) -> Self {
        Self(self.0 | 1 << (Self::CONSTANTS.len() - 1))
    }

    /// Values of the shader's constants.
    pub(crate) fn constants(self) -> Vec<(&'static str, f64)> {
        let value = |bit: u32| f64::from((self.0 >> bit) & 1);
        (0..).zip(Self::CONSTANTS).map(|(bit, name)| (name, value(bit))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ToneStyle, "ToneStyle" of "tone/flat" { highlight_colour, highlight_from, rim_colour, rim_from, cool, alpha, warm, beta, paint, gloss, focus, axis, axis_ends, first_row, row_count, rim_width, exaggerate_amount, exaggerate_contrast, exaggerate_scales, material_steps, is_gooch });
}
