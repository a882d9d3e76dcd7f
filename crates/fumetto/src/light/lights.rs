use super::clusters::Cluster;
use fumetto_scene::{Light, LightKind, Scene};
use glam::Vec3;

/// Lights in a scene. Also in `lights.wgsl`.
const MAX_LIGHTS: usize = 8;

/// Lights that throw shadows: the shadow layer has a channel for each.
const MAX_SHADOWS: usize = 4;

/// From one to the next of points that fill a disc evenly, in radians, and as a share of a turn.
const GOLDEN_ANGLE: f32 = 2.399_963;
const GOLDEN_SHARE: f32 = 0.618_034;

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
    members: f32,
    pad: f32,
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
                members: light.cluster.map_or(0.0, |cluster| cluster.lights as f32),
                pad: 0.0,
            };
        }
        uniform
    }

    /// Whether a light is a point, not a sun.
    pub(crate) fn is_point(&self, light: u32) -> bool {
        self.lights[light as usize].is_point > 0.0
    }

    /// Whether any light throws shadows.
    pub(crate) fn have_shadows(&self) -> bool {
        self.lights.iter().any(|light| light.channel >= 0)
    }

    /// Numbers of the lights that throw hard shadows, and the channels they have.
    pub(crate) fn casting(&self) -> impl Iterator<Item = (u32, usize)> {
        (0..)
            .zip(&self.lights[..self.count as usize])
            .filter(|(_, light)| light.members == 0.0)
            .filter_map(|(index, light)| usize::try_from(light.channel).ok().map(|channel| (index, channel)))
    }

    /// Lights of `scene`, which these are, that stand for one whose shadows are soft.
    pub(crate) fn clusters(&self, scene: &Scene) -> Vec<Cluster> {
        let alone = |light| Self::new(&[light], true);
        let pairs = self.lights.iter().zip(&scene.lights).filter(|(entry, _)| entry.members > 0.0);
        let clusters = pairs.filter_map(|(entry, light)| {
            let channel = usize::try_from(entry.channel).ok()?;
            Some(Cluster { channel, members: members(light).into_iter().map(alone).collect() })
        });
        clusters.collect()
    }
}

/// The lights of a cluster: suns evenly over a disc of the sky (Vogel 1979), others evenly in a ball.
fn members(light: &Light) -> Vec<Light> {
    let Some(cluster) = light.cluster else { return vec![*light] };
    let count = cluster.lights as f32;
    let member = |number: u32| {
        let share = (number as f32 + 0.5) / count;
        let (sine, cosine) = (number as f32 * GOLDEN_ANGLE).sin_cos();
        let kind = match light.kind {
            LightKind::Sun { direction } => {
                let axis = Vec3::from(direction).normalize_or(Vec3::Y);
                let (across, along) = axis.any_orthonormal_pair();
                let arm = cluster.reach * share.sqrt();
                LightKind::Sun { direction: (axis + arm * (cosine * across + sine * along)).into() }
            }
            LightKind::Point { position } => {
                let height = 1.0 - 2.0 * share;
                let ring = (1.0 - height * height).sqrt();
                // By another share than the height, so that the ball is filled.
                let arm = cluster.reach * ((number as f32 * GOLDEN_SHARE + 0.5).fract()).cbrt();
                let place = Vec3::from(position) + arm * Vec3::new(ring * cosine, height, ring * sine);
                LightKind::Point { position: place.into() }
            }
        };
        Light { kind, cluster: None, shadow: true, ..*light }
    };
    (0..cluster.lights).map(member).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(all_lie_as_their_twin: LightsUniform, "Lights" of "tone/flat" { lights as light, count });

    layout_test!(one_lies_as_its_twin: LightUniform, "Light" of "tone/flat" { vector, is_point, intensity, channel, members });

    fn clustered(kind: LightKind, reach: f32) -> Light {
        Light {
            kind,
            intensity: 1.0,
            shadow: true,
            cluster: Some(fumetto_scene::Cluster { lights: 16, reach }),
        }
    }

    #[test]
    fn a_clusters_lights_stand_around_their_middle() {
        let position = [1.0, 2.0, 3.0];
        let lamps = members(&clustered(LightKind::Point { position }, 0.5));
        let places = lamps.iter().map(|lamp| match lamp.kind {
            LightKind::Point { position } => Vec3::from(position),
            LightKind::Sun { .. } => panic!("lamps stay lamps"),
        });
        let places: Vec<_> = places.collect();
        let middle = places.iter().sum::<Vec3>() / 16.0;
        assert!(middle.distance(position.into()) < 0.1, "{middle}");
        assert!(places.iter().all(|place| place.distance(position.into()) <= 0.5));
        let suns = members(&clustered(LightKind::Sun { direction: [0.0, -2.0, 0.0] }, 0.1));
        let tangents = suns.iter().map(|sun| match sun.kind {
            LightKind::Sun { direction: [x, y, z] } => x.hypot(z) / -y,
            LightKind::Point { .. } => panic!("suns stay suns"),
        });
        let tangents: Vec<_> = tangents.collect();
        assert!(
            tangents.iter().all(|tangent| *tangent <= 0.1) && tangents.iter().any(|tangent| *tangent > 0.09)
        );
    }

    #[test]
    fn clusters_and_single_lights_share_the_channels() {
        let sun = LightKind::Sun { direction: [0.0, -1.0, 0.0] };
        let hard = Light { cluster: None, ..clustered(sun, 0.1) };
        let uniform = LightsUniform::new(&[clustered(sun, 0.1), hard, clustered(sun, 0.2)], true);
        assert!(uniform.casting().eq([(1, 1)]), "the second alone is hard");
        assert_eq!(uniform.lights[2].channel, 2);
        assert!(uniform.have_shadows());
    }
}
