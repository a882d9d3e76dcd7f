//! Places and normals against the field, and noise.

use fumetto_scene::Particle;
use glam::{DVec3, Vec3};

use super::{Mesh, Noise, ROOM, Recipe, extract, particle, recipe, surface};

const THRESHOLD: f32 = 0.3;

fn cloud() -> Vec<Particle> {
    vec![
        particle([0.0, 0.0, 0.0], 1.0, 3.0),
        particle([0.8, 0.3, 0.1], 0.8, 2.0),
        particle([-0.7, 0.4, -0.3], 0.7, 4.0),
        particle([0.2, -0.5, 0.9], 0.9, 1.0),
        particle([0.1, 0.9, 0.2], 0.5, 8.0),
    ]
}

/// Equation 3 and its gradient.
fn field(cloud: &[Particle], place: Vec3) -> (f64, DVec3) {
    let place = DVec3::from(place);
    let mut sum = (-f64::from(THRESHOLD), DVec3::ZERO);
    for particle in cloud {
        let off = place - Vec3::from(particle.center).as_dvec3();
        let square = f64::from(particle.radius).powi(2);
        let fall = (1.0 - off.length_squared() / square).max(0.0);
        sum.0 += f64::from(particle.mass) * fall * fall;
        sum.1 -= 4.0 * f64::from(particle.mass) * fall / square * off;
    }
    sum
}

#[test]
fn vertices_lie_on_the_surface_and_normals_are_its_gradient() {
    let cloud = cloud();
    let mesh = surface(&cloud, THRESHOLD, 0.08);
    mesh.assert_closed();
    let mut turned = Vec::new();
    for (&place, normal) in mesh.places.iter().zip(&mesh.normals) {
        let (value, gradient) = field(&cloud, place);
        let off_m = value.abs() / gradient.length();
        assert!(off_m < 0.002 * 0.08, "{place} is {off_m} m off the surface");
        turned.push(normal.angle_between((-gradient).normalize_or_zero().as_vec3()).to_degrees());
    }
    // Normals are those of where the last step began (`SHORT` of `vertices.wgsl`): where the surface bends within a
    // cell, by so much.
    let mean = turned.iter().sum::<f32>() / turned.len() as f32;
    let most = turned.into_iter().fold(0.0, f32::max);
    assert!(mean < 0.05 && most < 2.0, "normals are {mean} and at most {most} degrees off");
}

/// How far normals and triangles are from each other, as the mean of a cosine.
fn agreement(mesh: &Mesh) -> f32 {
    let mut sum = 0.0;
    for (corners, triangle) in mesh.corners().zip(&mesh.triangles) {
        let face = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
        sum += triangle.iter().map(|&vertex| mesh.normals[vertex as usize].dot(face)).sum::<f32>() / 3.0;
    }
    sum / mesh.triangles.len() as f32
}

#[test]
fn normals_of_a_noisy_surface_are_its_own() {
    let cloud = cloud();
    let noise = Noise { amplitude: 2.0, size_m: 0.5, octaves: 2, seed: 5, drift_m_per_s: [0.0; 3] };
    let noisy = Recipe { noise: Some(noise), ..recipe(cloud.len(), THRESHOLD, 0.03) };
    let noisy = extract(&cloud, &noisy, ROOM);
    let smooth = surface(&cloud, THRESHOLD, 0.03);
    noisy.assert_closed();
    assert!(agreement(&smooth) > 0.998, "{}", agreement(&smooth));
    assert!(agreement(&noisy) > 0.99, "{}", agreement(&noisy));
    // It does change the surface, and stays within the particles' reach.
    let off = |place: &Vec3| {
        let (value, gradient) = field(&cloud, *place);
        value.abs() / gradient.length()
    };
    let moved = noisy.places.iter().map(off).sum::<f64>() / noisy.places.len() as f64;
    assert!(moved > 0.01, "moved by {moved} m on average");
    let reached = |place: &Vec3| cloud.iter().any(|p| place.distance(Vec3::from(p.center)) < p.radius);
    assert!(noisy.places.iter().all(reached));
}
