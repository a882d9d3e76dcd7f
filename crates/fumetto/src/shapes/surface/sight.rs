//! From where a surface is seen, which says how large its cells are where they are lengths on the picture.

use fumetto_scene::{Camera, Particle, Spacing, Surface};
use glam::Vec3;

/// A cell is no larger than this part of the longest side. Also in `bounds.wgsl`.
const LEAST_CELLS: f32 = 8.0;
/// Less than this has no hold on a surface: `LEAST` of `blob.wgsl`.
const LEAST: f32 = 1e-6;

/// From where a surface is seen. Not where to: cells stay as they are when the camera turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sight {
    pub(super) eye: Vec3,
    /// What the picture's height shows at a distance of one metre, in metres.
    pub(super) height_m: f32,
}

impl Sight {
    pub(crate) fn of(camera: &Camera) -> Self {
        let height_m = 2.0 * (0.5 * camera.fov_deg.to_radians()).tan();
        Self { eye: Vec3::from(camera.eye), height_m }
    }
}

/// What is asked of matter that stands, to tell how large its cells are without making anything.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Balls(Vec<(Vec3, f32)>);

impl Balls {
    /// Of the particles that have a hold on a surface.
    pub(super) fn new(surface: &Surface, mass_scale: f32, particles: &[Particle]) -> Self {
        let ball = |particle: &Particle| (Vec3::from(particle.center), surface.size * particle.radius);
        let holds = |particle: &&Particle| {
            particle.mass * mass_scale >= LEAST && surface.size * particle.radius >= LEAST
        };
        Self(particles.iter().filter(holds).map(ball).collect())
    }

    /// As `fitted` of `bounds.wgsl`: the side of a cell that covers this `share` of the picture's height where
    /// they are nearest, and of which no more than `most` lie along them.
    pub(super) fn spacing(&self, sight: Sight, share: f32, most: f32) -> Spacing {
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let mut nearest_m = f32::INFINITY;
        for &(center, radius) in &self.0 {
            (low, high) = (low.min(center - radius), high.max(center + radius));
            nearest_m = nearest_m.min(center.distance(sight.eye) - radius);
        }
        if self.0.is_empty() {
            return Spacing::Cell(1.0);
        }
        let longest_m = (high - low).max_element();
        let wanted_m = share * sight.height_m * nearest_m.max(0.0);
        let cell_m = wanted_m.max(longest_m / most).min(longest_m / LEAST_CELLS.min(most));
        Spacing::Cell((0.25 * (4.0 * cell_m.log2()).ceil()).exp2())
    }
}
