//! One particle, whose surface is a sphere of known radius.

use std::f64::consts::PI;

use fumetto_scene::Particle;
use glam::Vec3;

use super::{PART, ROOM, Recipe, Spacing, extract, extract_faded, particle, recipe, surface};

const CENTER: Vec3 = Vec3::new(0.13, -0.31, 0.07);

/// Where equation 2 is the threshold.
fn radius_of(particle: Particle, threshold: f32) -> f32 {
    particle.radius * (1.0 - (threshold / particle.mass).sqrt()).sqrt()
}

#[test]
fn a_lone_particle_is_a_sphere_of_the_radius_that_equation_2_gives() {
    for (radius, mass, threshold) in [(1.0, 8.0, 0.05), (0.7, 2.0, 0.6), (2.0, 1.0, 0.9)] {
        let alone = particle(CENTER, radius, mass);
        let expected = radius_of(alone, threshold);
        let sphere = surface(&[alone], threshold, expected / 9.0);
        sphere.assert_closed();
        assert_eq!((sphere.euler_characteristic(), sphere.pieces()), (2, 1));
        assert_eq!(sphere.overflow, 0);
        assert!(sphere.parts.iter().all(|&part| part == PART));
        for (place, normal) in sphere.places.iter().zip(&sphere.normals) {
            let off = (place.distance(CENTER) - expected).abs();
            assert!(off < 2e-5 * radius, "{off} at {place} off a radius of {expected}");
            let outward = (place - CENTER).normalize_or_zero();
            assert!(normal.distance(outward) < 1e-4, "{normal} should be {outward}");
        }
    }
}

#[test]
fn volume_and_area_converge_with_the_square_of_the_cell() {
    let alone = particle(CENTER, 1.0, 8.0);
    let radius = f64::from(radius_of(alone, 0.05));
    let errors = [0.2_f32, 0.1, 0.05].map(|cell| {
        let sphere = surface(&[alone], 0.05, cell);
        [
            1.0 - sphere.volume() / (4.0 / 3.0 * PI * radius.powi(3)),
            1.0 - sphere.area() / (4.0 * PI * radius.powi(2)),
        ]
    });
    for [coarse, fine] in [[errors[0], errors[1]], [errors[1], errors[2]]] {
        for (coarse, fine) in coarse.iter().zip(fine) {
            assert!(fine > 0.0, "a polyhedron within a sphere is smaller, not {fine}");
            let ratio = coarse / fine;
            assert!((3.4..4.6).contains(&ratio), "errors {errors:?}");
        }
    }
    assert!(errors[2][0] < 2e-3, "errors {errors:?}");
}

#[test]
fn scales_make_an_inner_layer() {
    let alone = particle(CENTER, 1.0, 8.0);
    let inner = Recipe { radius_scale: 0.8, mass_scale: 0.5, ..recipe(1, 0.05, 0.1) };
    let expected = radius_of(particle(CENTER, 0.8, 4.0), 0.05);
    let mesh = extract(&[alone], &inner, ROOM);
    mesh.assert_closed();
    assert!(mesh.places.iter().all(|place| (place.distance(CENTER) - expected).abs() < 2e-5));
}

#[test]
fn matter_that_erodes_or_fades_has_less_hold() {
    // Half eroded, half opaque.
    let fade = 0x7fff_8000;
    let expected = radius_of(particle(CENTER, 1.0, 2.0), 0.05);
    let mesh = extract_faded(&[particle(CENTER, 1.0, 8.0)], fade, &recipe(1, 0.05, 0.1), ROOM);
    assert!(mesh.places.iter().all(|place| (place.distance(CENTER) - expected).abs() < 4e-5));
    let gone = extract_faded(&[particle(CENTER, 1.0, 8.0)], 0xffff_ffff, &recipe(1, 0.05, 0.1), ROOM);
    assert!(gone.triangles.is_empty());
}

#[test]
fn subdivisions_count_along_the_longest_side_or_a_little_less() {
    // Bounds are 4 × 2 × 2, and 4 / 22 is rounded up to a quarter of an octave.
    let two = [particle(-Vec3::X, 1.0, 8.0), particle(Vec3::X, 1.0, 8.0)];
    let mesh = extract(&two, &Recipe { spacing: Spacing::Subdivisions(22.0), ..recipe(2, 0.05, 0.0) }, ROOM);
    let cell = ((4.0 * (4.0_f32 / 22.0).log2()).ceil() / 4.0).exp2();
    let same = surface(&two, 0.05, cell);
    assert!((18.5..=22.0).contains(&(4.0 / cell)));
    assert_eq!(mesh.triangles, same.triangles);
}

#[test]
fn the_lattice_stays_where_it_is_while_particles_come_and_go() {
    let alone = particle(CENTER, 1.0, 8.0);
    let far = particle(CENTER + Vec3::new(-5.3, 4.1, 2.9), 0.6, 8.0);
    let one = surface(&[alone], 0.05, 0.1);
    let both = surface(&[alone, far], 0.05, 0.1);
    assert_eq!(both.pieces(), 2);
    let of_first: Vec<_> = both.places.iter().filter(|place| place.distance(CENTER) < 1.5).collect();
    assert_eq!(of_first.len(), one.places.len());
    assert!(one.places.iter().all(|place| of_first.contains(&place)));
}

#[test]
fn few_triangles_are_slivers() {
    let angles = surface(&[particle(CENTER, 1.0, 8.0)], 0.05, 0.06).sharpest_angles();
    let at = |share: f32| angles[(angles.len() as f32 * share) as usize];
    assert!(at(0.0) > 10.0, "the sharpest is {}°", at(0.0));
    assert!(at(0.02) > 20.0, "one in fifty is sharper than {}°", at(0.02));
    assert!(at(0.5) > 35.0, "half are sharper than {}°", at(0.5));
}
