//! How the strokes of each pen are drawn, as shaders take it.

use fumetto_scene::{EdgeKind, Object, Stroke, Width, limits};

use super::textures::StrokeTextures;
use crate::ink::MAX_PENS;

/// The widest stroke that prints reckon with, as a share of the picture's height, where heights are in metres.
const WIDEST: f32 = 0.125;

/// `StrokeStyle` of `style.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct StrokeStyle {
    height_px: f32,
    height_m: f32,
    length: f32,
    outward: f32,
    taper: f32,
    pressure: f32,
    curvature: f32,
    distance: f32,
    reference_m: f32,
    wobble: f32,
    overshoot: f32,
    grain: f32,
    shortest_px: f32,
    passes: u32,
    layer: u32,
    seed: u32,
}

/// What strokes depend on besides their own style.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moment {
    pub(crate) frame: u32,
    /// Samples along the whole picture's height.
    pub(crate) picture_height: u32,
    /// Metres from the camera to what it looks at.
    pub(crate) reference_m: f32,
}

impl StrokeStyle {
    /// Those of all pens of `objects`, in the pens' order.
    pub(crate) fn of_all(objects: &[&Object], textures: &StrokeTextures, moment: Moment) -> [Self; MAX_PENS] {
        let mut all = [bytemuck::Zeroable::zeroed(); MAX_PENS];
        let pens = objects.iter().flat_map(|object| EdgeKind::ALL.map(|kind| (*object, kind)));
        for ((number, slot), (object, kind)) in (0..).zip(&mut all).zip(pens) {
            if let Some(stroke) = object.style.ink.stroke_of(kind) {
                *slot = Self::new((object, kind), stroke, textures.layer(&stroke.texture), moment);
                slot.seed =
                    drawn_anew(stroke, moment.frame).wrapping_mul(limits::MAX_OBJECTS as u32 * 4) + number;
            }
        }
        all
    }

    fn new(
        (object, kind): (&Object, EdgeKind),
        stroke: &Stroke,
        (layer, length): (u32, f32),
        moment: Moment,
    ) -> Self {
        let ink = &object.style.ink;
        let scale = moment.picture_height as f32 / object.style.height_px;
        let width = stroke.height.unwrap_or(ink.width_of(kind));
        let (height_px, height_m) = match width {
            Width::Px(px) => (px * scale, 0.0),
            Width::World(metres) => (0.0, metres),
        };
        Self {
            height_px,
            height_m,
            length: length * stroke.scale,
            outward: stroke.outward,
            taper: stroke.taper,
            pressure: stroke.pressure,
            curvature: stroke.curvature,
            distance: stroke.distance,
            reference_m: moment.reference_m,
            wobble: stroke.wobble,
            overshoot: stroke.overshoot,
            grain: stroke.grain,
            shortest_px: ink.shortest * height_px,
            passes: stroke.passes,
            layer,
            seed: 0,
        }
    }

    /// How often it is drawn.
    pub(crate) fn passes(&self) -> u32 {
        self.passes
    }
}

/// How often the hand has drawn anew by a frame.
fn drawn_anew(stroke: &Stroke, frame: u32) -> u32 {
    frame.checked_div(stroke.boil).unwrap_or(0)
}

/// How far from a pixel of a picture `height_px` samples high anything may lie that the strokes of `object` there
/// depend on, in samples.
pub(crate) fn reach_px(object: &Object, height_px: u32) -> f32 {
    let ink = &object.style.ink;
    let reach = |kind| {
        let stroke = ink.stroke_of(kind)?;
        let height = match stroke.height.unwrap_or(ink.width_of(kind)) {
            Width::Px(px) => px * height_px as f32 / object.style.height_px,
            Width::World(_) => WIDEST * height_px as f32,
        };
        // As far as runs are followed, across gaps, averaged; then to the side and beyond the end.
        let along = (stroke.taper + 1.0).max(ink.shortest) + 3.0;
        Some((along + stroke.overshoot + stroke.wobble + 2.0) * height)
    };
    EdgeKind::ALL.into_iter().filter_map(reach).fold(0.0, f32::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: StrokeStyle, "StrokeStyle" of "ink/stroke/polygon" { height_px, height_m, length, outward, taper, pressure, curvature, distance, reference_m, wobble, overshoot, grain, shortest_px, passes, layer, seed });
}
