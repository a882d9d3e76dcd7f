//! How each object is drawn, as shaders take it.

use fumetto_scene::{EdgeKind, InkMethod, Object, Shape, Width, limits};

/// `ObjectStyle` of `object.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct ObjectStyle {
    ink_width_px: f32,
    ink_width_m: f32,
    ink_offset: f32,
    ink_inner: f32,
    ink_lit_thinning: f32,
    form: f32,
    wrap: f32,
    opacity: f32,
    ramp_row: f32,
    shadow_reach: f32,
    shadow_start: f32,
    shadow_size: f32,
    flags: u32,
    form_scale: f32,
    material: f32,
    ink_facing: f32,
    ink_crease: f32,
    details: u32,
    relief: f32,
    glow: f32,
}

/// Objects that there is room for. Also in `object.wgsl`.
pub(crate) const MAX_OBJECTS: usize = 64;

const _: () = assert!(limits::MAX_OBJECTS <= MAX_OBJECTS, "every object of a scene has a style");

const HAS_INK: u32 = 1;
const THROWS_SHADOW: u32 = 2;
const IN_CEL: u32 = 4;
const ANGLE_INK: u32 = 8;
const IMAGE_INK: u32 = 16;
const HYBRID_INK: u32 = 32;
const SHOWS_SHADOWS: u32 = 64;
const IS_VOLUME: u32 = 128;
const IS_MASK: u32 = 256;

/// How an object's lines are found. What suits each shape is, for a surface, to look through the picture: where
/// lobes meet in a valley, its contours break off; unless it has strokes, which follow these. A volume has no edges to look along.
pub(crate) fn ink_method(object: &Object) -> InkMethod {
    let ink = &object.style.ink;
    match (ink.method, &object.shape) {
        (InkMethod::Hybrid, Shape::Surface(_)) if ink.stroke_of(EdgeKind::Silhouette).is_some() => {
            InkMethod::Vector
        }
        (InkMethod::Hybrid, Shape::Surface(_)) => InkMethod::Image,
        (InkMethod::Hybrid | InkMethod::Vector | InkMethod::Shell, Shape::Volume(_)) => InkMethod::Image,
        (method, _) => method,
    }
}

/// Whether an object's puffs have ink billboards. Puffs that are the matter of a surface or a volume are never
/// drawn singly.
pub(crate) fn has_outline(object: &Object) -> bool {
    let ink = &object.style.ink;
    let is_elsewhere = matches!(ink_method(object), InkMethod::Angle | InkMethod::Image);
    object.shape.puffs().is_some() && ink.on && ink.silhouette.on && !is_elsewhere
}

impl ObjectStyle {
    /// The style of `object`, the scene's `index`-th, in a picture `height_px` samples high.
    pub(crate) fn new(object: &Object, index: u32, height_px: u32, in_cel: bool) -> Self {
        let style = &object.style;
        let scale = height_px as f32 / style.height_px;
        let (ink_width_px, ink_width_m) = match style.ink.width_of(EdgeKind::Silhouette) {
            Width::Px(px) => (px * scale, 0.0),
            Width::World(metres) => (0.0, metres),
        };
        let method = match ink_method(object) {
            InkMethod::Angle => ANGLE_INK,
            InkMethod::Image => IMAGE_INK,
            InkMethod::Hybrid => HYBRID_INK,
            InkMethod::Shell | InkMethod::Vector => 0,
        };
        let flag = |on, bit| if on { bit } else { 0 };
        let volume = object.shape.volume();
        let has_puffs = object.shape.puffs().is_some();
        Self {
            ink_width_px,
            ink_width_m,
            ink_offset: style.ink.offset,
            ink_inner: style.ink.inner,
            ink_lit_thinning: style.ink.lit_thinning,
            form: style.form,
            wrap: style.wrap,
            opacity: object.opacity,
            ramp_row: index as f32,
            shadow_reach: style.shadow.reach,
            shadow_start: style.shadow.start,
            shadow_size: style.shadow.size,
            flags: flag(has_outline(object), HAS_INK)
                | flag(style.ink.on, method)
                | flag(has_puffs && style.shadow.on && object.visible, THROWS_SHADOW)
                | flag(has_puffs && in_cel, IN_CEL)
                | flag(style.shadow.receive, SHOWS_SHADOWS)
                | flag(volume.is_some(), IS_VOLUME)
                | flag(style.mask, IS_MASK),
            form_scale: style.form_scale,
            material: style.material,
            ink_facing: style.ink.facing,
            ink_crease: style.ink.crease_deg.to_radians().cos(),
            details: object.details.len() as u32,
            relief: volume.map_or(0.0, |volume| volume.relief),
            glow: volume.map_or(0.0, |volume| volume.glow),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ObjectStyle, "ObjectStyle" of "tone/flat" { ink_width_px, ink_width_m, ink_offset, ink_inner, ink_lit_thinning, form, wrap, opacity, ramp_row, shadow_reach, shadow_start, shadow_size, flags, form_scale, material, ink_facing, ink_crease, details, relief, glow });
}
