//! How each object is hatched, as shaders take it.

use fumetto_scene::{Along, Camera, Follow, Hatching, Light, LightKind, Object, Scene, Width};
use glam::{Quat, Vec2, Vec3};

use super::ground::Grounded;
use crate::{gpu::Transient, object::MAX_OBJECTS};

/// Most layers of strokes, and directions among which the form chooses. Also in `hatching.wgsl`.
const MAX_LAYERS: u32 = 4;
const AXES: usize = 8;

const IS_HARD: u32 = 1;
const IS_SMOOTHED: u32 = 2;
const IS_CURVED: u32 = 4;

/// `HatchStyle` of `hatching.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct HatchStyle {
    axes: [[f32; 4]; AXES],
    colour: [f32; 3],
    light_from: f32,
    light_full: f32,
    swell: f32,
    levels: f32,
    layers: u32,
    width_px: f32,
    width_m: f32,
    spacing_px: f32,
    spacing_m: f32,
    length_px: f32,
    gaps: f32,
    wobble_px: f32,
    tooth: f32,
    scale: f32,
    follow: u32,
    seed: u32,
    look: u32,
    cross: f32,
    pad: [u32; 3],
}

/// What the strokes of a picture need.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hatched<'a> {
    /// The styles of all objects, where any is hatched.
    pub(crate) styles: Option<&'a wgpu::Buffer>,
    pub(crate) ground: &'a Grounded,
    pub(crate) turns: &'a Transient,
}

/// The picture that strokes are for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sheeted {
    /// In samples.
    pub(crate) height_px: u32,
    /// Along each side of a pixel.
    pub(crate) samples: u32,
}

/// Strokes of all objects; those of most are off.
pub(crate) type HatchStyles = [HatchStyle; MAX_OBJECTS];

impl HatchStyle {
    /// Of all of a scene's objects as they are `drawn`; `None` where there is nothing to hatch.
    pub(crate) fn list(scene: &Scene, drawn: &[Object], sheet: Sheeted) -> Option<HatchStyles> {
        drawn.iter().any(is_hatched).then(|| {
            let from = From::of(scene);
            let mut list: HatchStyles = bytemuck::Zeroable::zeroed();
            for (index, (slot, object)) in list.iter_mut().zip(drawn).enumerate() {
                if is_hatched(object) {
                    *slot = Self::new(object, from, sheet);
                    slot.seed = scene.seed.wrapping_mul(0x9e37_79b9).wrapping_add(index as u32);
                }
            }
            list
        })
    }

    fn new(object: &Object, from: From, sheet: Sheeted) -> Self {
        let hatching = &object.style.hatching;
        let scale = sheet.height_px as f32 / object.style.height_px;
        let length = |width| match width {
            Width::Px(px) => (px * scale, 0.0),
            Width::World(metres) => (0.0, metres),
        };
        let (width_px, width_m) = length(hatching.width);
        let (spacing_px, spacing_m) = length(hatching.spacing);
        let is_curved = hatching.follows_curvature();
        let apart_deg = if is_curved { 180.0 / AXES as f32 } else { hatching.cross_deg };
        let axis = |number| from.axis(hatching, number as f32 * apart_deg).extend(0.0).to_array();
        let flag = |on, bit| if on { bit } else { 0 };
        Self {
            axes: std::array::from_fn(axis),
            colour: hatching.colour.to_srgb8().map(|channel| f32::from(channel) / 255.0),
            light_from: hatching.from,
            light_full: hatching.full,
            swell: hatching.swell,
            levels: hatching.levels as f32,
            layers: hatching.layers.min(MAX_LAYERS),
            width_px,
            width_m,
            spacing_px,
            spacing_m,
            length_px: hatching.length_px * scale,
            gaps: hatching.gaps,
            wobble_px: hatching.wobble_px * scale,
            tooth: hatching.tooth,
            scale,
            follow: match hatching.follow {
                Follow::Form => 1,
                Follow::Object => 2,
                Follow::Screen => 3,
            },
            seed: 0,
            look: flag(sheet.samples == 1, IS_HARD)
                | flag(hatching.smooth_px > 0.0, IS_SMOOTHED)
                | flag(is_curved, IS_CURVED),
            cross: hatching.cross_deg.to_radians(),
            pad: [0; 3],
        }
    }
}

/// Whether strokes are drawn on an object.
pub(super) fn is_hatched(object: &Object) -> bool {
    object.visible && object.style.hatching.on
}

/// From where a scene is seen and lit. Directions come of its first camera, whichever looks, so that strokes
/// stay on the form when the camera moves.
#[derive(Clone, Copy, Debug)]
struct From {
    right: Vec3,
    up: Vec3,
    toward_eye: Vec3,
    toward_light: Vec3,
}

impl From {
    fn of(scene: &Scene) -> Self {
        let Camera { eye, target, up, .. } = &scene.cameras[0];
        let toward_eye = (Vec3::from(*eye) - Vec3::from(*target)).normalize_or(Vec3::Z);
        let right = Vec3::from(*up).cross(toward_eye).normalize_or(Vec3::X);
        let toward = |light: &Light| match light.kind {
            LightKind::Sun { direction } => -Vec3::from(direction),
            LightKind::Point { position } => Vec3::from(position) - Vec3::from(*target),
        };
        let toward_light = scene.lights.first().map_or(Vec3::Y, toward).normalize_or(Vec3::Y);
        Self { right, up: toward_eye.cross(right), toward_eye, toward_light }
    }

    /// Across strokes that are turned by `turn_deg` on the picture.
    fn axis(&self, hatching: &Hatching, turn_deg: f32) -> Vec3 {
        if hatching.follow == Follow::Screen {
            return self.flat(hatching, turn_deg);
        }
        let turn = Quat::from_axis_angle(self.toward_eye, turn_deg.to_radians());
        let (sin, cos) = hatching.tilt_deg.to_radians().sin_cos();
        match hatching.along {
            Along::Angle | Along::Curvature => {
                let upright = (hatching.angle_deg + turn_deg).to_radians() + std::f32::consts::FRAC_PI_2;
                let across = self.right * upright.cos() + self.up * upright.sin();
                // The place that planes only touch, where strokes would be rings, shall lie in the light.
                let across = if across.dot(self.toward_light) < 0.0 { -across } else { across };
                across * cos + self.toward_eye * sin
            }
            Along::Shade => turn * self.toward_light,
            Along::Light => {
                let aside = self.toward_light.cross(self.toward_eye).normalize_or(self.right);
                let toward = self.toward_light.cross(aside);
                let toward = if toward.dot(self.toward_eye) < 0.0 { -toward } else { toward };
                turn * (aside * cos + toward * sin)
            }
        }
    }

    /// The same for straight strokes on the picture, in its coordinates.
    fn flat(&self, hatching: &Hatching, turn_deg: f32) -> Vec3 {
        let light = Vec2::new(self.toward_light.dot(self.right), self.toward_light.dot(self.up));
        let light = light.normalize_or(Vec2::Y);
        let across = match hatching.along {
            Along::Angle | Along::Curvature => Vec2::from_angle(hatching.angle_deg.to_radians()).perp(),
            Along::Shade => light,
            Along::Light => light.perp(),
        };
        Vec2::from_angle(turn_deg.to_radians()).rotate(across).extend(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: HatchStyle, "HatchStyle" of "tone/flat" { axes, colour, light_from, light_full, swell, levels, layers, width_px, width_m, spacing_px, spacing_m, length_px, gaps, wobble_px, tooth, scale, follow, seed, look, cross });
}
