//! Particles that are apart, that merge, and that make a ring.

use std::f32::consts::TAU;

use fumetto_scene::Particle;
use glam::Vec3;

use super::{particle, surface};

const MASS: f32 = 2.0;
const THRESHOLD: f32 = 0.6;

fn pair(distance: f32) -> [Particle; 2] {
    let direction = Vec3::new(2.0, 1.0, -2.0) / 3.0;
    [-0.5, 0.5].map(|side| particle(side * distance * direction, 1.0, MASS))
}

#[test]
fn two_particles_merge_where_their_densities_meet_halfway() {
    // Halfway both have m (1 − (d / 2)²)²; together that is the threshold.
    let merging = 2.0 * (1.0 - (THRESHOLD / (2.0 * MASS)).sqrt()).sqrt();
    let apart = surface(&pair(merging + 0.02), THRESHOLD, 0.03);
    let merged = surface(&pair(merging - 0.02), THRESHOLD, 0.03);
    apart.assert_closed();
    merged.assert_closed();
    assert_eq!((apart.pieces(), apart.euler_characteristic()), (2, 4));
    assert_eq!((merged.pieces(), merged.euler_characteristic()), (1, 2));
}

#[test]
fn a_ring_of_particles_is_a_torus() {
    let ring: Vec<_> = (0..16)
        .map(|index| {
            let (sin, cos) = (TAU * index as f32 / 16.0).sin_cos();
            particle(Vec3::new(2.0 * cos, 0.3 * cos, 2.0 * sin), 0.9, MASS)
        })
        .collect();
    let torus = surface(&ring, THRESHOLD, 0.1);
    torus.assert_closed();
    assert_eq!((torus.pieces(), torus.euler_characteristic()), (1, 0));
}

#[test]
fn a_shell_of_particles_has_an_inside_and_an_outside_skin() {
    // Spread evenly over a sphere by the golden angle.
    let shell: Vec<_> = (0..200)
        .map(|index| {
            let y = 1.0 - (2.0 * index as f32 + 1.0) / 200.0;
            let (sin, cos) = (index as f32 * 2.399_963_2).sin_cos();
            let around = (1.0 - y * y).sqrt();
            particle(2.0 * Vec3::new(around * cos, y, around * sin), 0.7, MASS)
        })
        .collect();
    let mesh = surface(&shell, THRESHOLD, 0.1);
    mesh.assert_closed();
    assert_eq!((mesh.pieces(), mesh.euler_characteristic()), (2, 4));
    assert!(mesh.volume() < 4.0 / 3.0 * std::f64::consts::PI * 2.7_f64.powi(3) * 0.9, "it is hollow");
}
