//! How dense particles are at most, where that is too little for a surface: told to the user, who else sees an
//! empty picture and no reason.

use fumetto_scene::{Particle, Surface};
use glam::Vec3;

/// Pairs of particles that are looked at: a tenth of a second of work.
const MOST_PAIRS: usize = 50_000_000;

/// About the largest density of `particles`, if it is too little for their `surface`.
///
/// Looks at the particles' middles, of very many particles not at all of them.
pub(crate) fn peak_of_nothing(surface: &Surface, particles: &[Particle]) -> Option<f32> {
    let looked_at = (MOST_PAIRS / particles.len().max(1)).max(1);
    let stride = particles.len().div_ceil(looked_at).max(1);
    let mut peak = 0.0_f32;
    for particle in particles.iter().step_by(stride) {
        peak = peak.max(density_at(particle.center.into(), surface, particles));
        if !is_outside(surface, peak) {
            return None;
        }
    }
    Some(peak)
}

/// Equation 2 of Álvarez et al. 2007, summed.
fn density_at(place: Vec3, surface: &Surface, particles: &[Particle]) -> f32 {
    let densities = particles.iter().map(|particle| {
        let share = place.distance(particle.center.into()) / (particle.radius * surface.size);
        particle.mass * (1.0 - share * share).max(0.0).powi(2)
    });
    densities.sum()
}

/// Whether no place of such a density is inside. As `surely_outside` of `blocks.wgsl`.
pub(crate) fn is_outside(surface: &Surface, density: f32) -> bool {
    let share = (density / surface.threshold).min(1.0);
    let amplitude = surface.noise.map_or(0.0, |noise| noise.amplitude);
    share + amplitude * share * (2.0 - share) < 1.0
}

#[cfg(test)]
mod tests {
    use fumetto_scene::{Noise, Resolution};

    use super::*;

    #[test]
    fn only_what_leaves_nothing_is_told_and_with_its_peak() {
        let at =
            |threshold, noise| Surface { threshold, resolution: Resolution::Cell(0.1), size: 1.0, noise };
        let ball = |x: f32| Particle { center: [x, 0.0, 0.0], radius: 1.0, mass: 2.0 };
        // Halfway to each other's rim: 2 + 2 (1 − ½²)².
        let two = [ball(0.0), ball(0.5)];
        assert_eq!(peak_of_nothing(&at(3.0, None), &two), None);
        assert_eq!(peak_of_nothing(&at(3.2, None), &two), Some(3.125));
        let noise = Noise { amplitude: 1.0, size_m: 1.0, octaves: 1, seed: 1, drift_m_per_s: [0.0; 3] };
        assert_eq!(peak_of_nothing(&at(3.2, Some(noise)), &two), None);
        assert_eq!(peak_of_nothing(&at(1.0, None), &[]), Some(0.0));
        let apart: Vec<_> = (0..200_000_u32).map(|index| ball(3.0 * index as f32)).collect();
        assert_eq!(peak_of_nothing(&at(2.5, None), &apart), Some(2.0));
    }
}
