//! Surfaces of files' densities, against closed forms.

use std::sync::{Arc, PoisonError};

use fumetto_formats::{Grid, GridClass, Volume, Voxels};
use fumetto_scene::{Imported, Noise, Transform};
use glam::{DMat4, DVec3, Vec3};

use super::{BENCH, Mesh, ROOM, Recipe, extract, recipe};
use crate::shapes::volume::{BrickField, BrickMap, Samples};

/// Where the ball's middle is, off the lattice and the voxels.
const MIDDLE: Vec3 = Vec3::new(0.13, -0.31, 0.07);

/// Sides of a voxel.
const VOXEL_M: f64 = 0.1;

/// A ball whose density falls from 1 in its middle to 0 at a radius of 1, in voxels that stand askew.
fn ball() -> Volume {
    let turned = DMat4::from_rotation_y(0.4) * DMat4::from_rotation_x(0.7);
    let middle = DMat4::from_translation(MIDDLE.as_dvec3());
    let scale = DMat4::from_scale(DVec3::splat(VOXEL_M));
    let count = 24_u32;
    let world_from_index = middle * turned * scale * DMat4::from_translation(DVec3::splat(-11.3));
    let side = || 0..count;
    let at = side().flat_map(|z| {
        side().flat_map(move |y| side().map(move |x| DVec3::new(x.into(), y.into(), z.into())))
    });
    let density = |index: DVec3| {
        let away = world_from_index.transform_point3(index).distance(MIDDLE.as_dvec3());
        (1.0 - away).max(0.0) as f32
    };
    let values: Vec<f32> = at.map(density).collect();
    let voxels = Voxels::from_dense([0; 3], [count; 3], 1, &values, [0.0; 3]).expect("as many as voxels");
    let grid = Grid {
        name: "density".into(),
        class: GridClass::FogVolume,
        world_from_index: world_from_index.to_cols_array_2d(),
        voxels: Arc::new(voxels),
    };
    Volume { grids: vec![grid], notes: Vec::new() }
}

fn imported() -> Imported {
    Imported {
        file: "ball.vdb".into(),
        density: None,
        heat: None,
        range: None,
        heat_range: [0.0, 1.0],
        frames: None,
        repeats: false,
        raw: None,
        z_up: false,
        place: Transform::default(),
    }
}

fn surface(threshold: f32, cell_m: f32, noise: Option<Noise>) -> Mesh {
    let (volume, imported) = (ball(), imported());
    let samples = Samples::new(&volume, &imported).expect("there is a density");
    let map = BrickMap::new(&samples, None).expect("it is small");
    let bricks = {
        let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
        BrickField::new(&bench.gpu, &map, 4).expect("it is small")
    };
    let recipe = Recipe { bricks: Some(bricks), noise, ..recipe(map.cover.len(), threshold, cell_m) };
    extract(&map.cover, &recipe, ROOM)
}

#[test]
fn a_ball_out_of_a_file_is_a_sphere_that_is_closed_and_faces_outward() {
    for (threshold, cell_m) in [(0.3, 0.13), (0.5, 0.07), (0.5, 0.03)] {
        let sphere = surface(threshold, cell_m, None);
        sphere.assert_closed();
        assert_eq!((sphere.euler_characteristic(), sphere.pieces()), (2, 1), "at {threshold}");
        assert_eq!(sphere.overflow, 0);
        let expected = 1.0 - threshold;
        for (place, normal) in sphere.places.iter().zip(&sphere.normals) {
            let off = (place.distance(MIDDLE) - expected).abs();
            // Between voxels the density is linear along the axes, not along radii.
            assert!(off < 0.01, "{off} at {place} off a radius of {expected}");
            let outward = (place - MIDDLE).normalize_or_zero();
            assert!(normal.distance(outward) < 0.06, "{normal} should be {outward}");
        }
    }
}

#[test]
fn what_is_nowhere_dense_enough_has_no_surface() {
    let nothing = surface(1.1, 0.07, None);
    assert!(nothing.triangles.is_empty() && nothing.places.is_empty());
}

#[test]
fn noise_roughens_it_and_leaves_it_closed() {
    let noise = Noise { amplitude: 0.3, size_m: 0.4, octaves: 3, seed: 1, drift_m_per_s: [0.0; 3] };
    let rough = surface(0.5, 0.05, Some(noise));
    rough.assert_closed();
    let away = || rough.places.iter().map(|place| place.distance(MIDDLE));
    let (low, high) = (away().fold(f32::MAX, f32::min), away().fold(0.0, f32::max));
    assert!(low < 0.48 && high > 0.52, "from {low} to {high}");
}
