use fumetto_scene::{Light, LightKind, Scene};
use glam::Vec3;

/// Lights in a scene. Also in `lights.wgsl`.
const MAX_LIGHTS: usize = 8;

/// Lights that throw shadows: the shadow layer has a channel for each.
const MAX_SHADOWS: usize = 4;

/// `Lights` of `lights.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct LightsUniform {
    lights: [LightUniform; MAX_LIGHTS],
    count: u32,
    pad: [u32; 3],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
struct LightUniform {
    vector: [f32; 3],
    is_point: f32,
    intensity: f32,
    channel: i32,
    pad: [f32; 2],
}

impl LightsUniform {
    /// The lights of `scene`.
    pub(crate) fn of(scene: &Scene) -> Self {
        let shadows = scene.objects.iter().any(|object| object.visible && object.style.shadow.on);
        Self::new(&scene.lights, shadows)
    }

    /// The first few lights that throw shadows get a channel each, in the scene's order; `shadows` is
    /// whether anything throws any.
    pub(crate) fn new(lights: &[Light], shadows: bool) -> Self {
        let mut uniform: Self = bytemuck::Zeroable::zeroed();
        uniform.count = lights.len().min(MAX_LIGHTS) as u32;
        let mut channels = 0..MAX_SHADOWS as i32;
        for (entry, light) in uniform.lights.iter_mut().zip(lights) {
            let (vector, is_point) = match light.kind {
                LightKind::Sun { direction } => (-Vec3::from(direction).normalize_or(Vec3::NEG_Y), 0.0),
                LightKind::Point { position } => (position.into(), 1.0),
            };
            let casts = light.shadow && shadows;
            let channel = if casts { channels.next().unwrap_or(-1) } else { -1 };
            *entry = LightUniform {
                vector: vector.to_array(),
                is_point,
                intensity: light.intensity,
                channel,
                pad: [0.0; 2],
            };
        }
        uniform
    }

    /// Whether a light is a point, not a sun.
    pub(crate) fn is_point(&self, light: u32) -> bool {
        self.lights[light as usize].is_point > 0.0
    }

    /// Numbers of the lights that throw shadows, and the channels they have.
    pub(crate) fn casting(&self) -> impl Iterator<Item = (u32, usize)> {
        (0..)
            .zip(&self.lights[..self.count as usize])
            .filter_map(|(index, light)| usize::try_from(light.channel).ok().map(|channel| (index, channel)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(all_lie_as_their_twin: LightsUniform, "Lights" of "tone/flat" { lights as light, count });

    layout_test!(one_lies_as_its_twin: LightUniform, "Light" of "tone/flat" { vector, is_point, intensity, channel });
}
