//! Nothing there, too much there, and what is no particle at all.

use fumetto_scene::Particle;
use glam::Vec3;

use super::{
    BENCH, Bench, Mesh, PoisonError, ROOM, Recipe, SurfaceRoom, check, extract, particle, recipe, surface,
};

/// Bits of `lattice.wgsl`.
const COARSENED: u32 = 1;
const BLOCKS_LEFT_OUT: u32 = 2;
const VERTICES_LEFT_OUT: u32 = 4;
const TRIANGLES_LEFT_OUT: u32 = 8;

fn ball() -> Particle {
    particle([0.1, 0.2, 0.3], 1.0, 8.0)
}

#[track_caller]
fn assert_empty(particles: &[Particle], threshold: f32) {
    let mesh = surface(particles, threshold, 0.1);
    assert_eq!((mesh.places.len(), mesh.draw, mesh.overflow), (0, [0, 1, 0, 0], 0));
}

#[test]
fn no_matter_has_no_surface() {
    assert_empty(&[], 0.05);
    assert_empty(&[Particle { radius: 0.0, ..ball() }], 0.05);
    assert_empty(&[Particle { mass: 0.0, ..ball() }], 0.05);
    assert_empty(&[ball()], 8.0);
    assert_empty(&[ball()], 1e30);
}

#[test]
fn what_is_no_number_is_no_particle() {
    let alone = surface(&[ball()], 0.05, 0.1);
    let odd = [
        Particle { radius: f32::NAN, ..ball() },
        Particle { radius: f32::INFINITY, ..ball() },
        Particle { radius: -1.0, ..ball() },
        Particle { mass: f32::NAN, ..ball() },
        Particle { mass: -3.0, ..ball() },
        particle([f32::NAN, 0.0, 0.0], 1.0, 8.0),
        particle([0.0, f32::NEG_INFINITY, 0.0], 1.0, 8.0),
        particle([0.0, 0.0, 3e38], 1.0, 8.0),
        ball(),
    ];
    assert_eq!(surface(&odd, 0.05, 0.1), alone);
    // An odd threshold or cell is no reason to fail.
    for recipe in [recipe(9, f32::NAN, 0.1), recipe(9, 0.05, f32::NAN), recipe(9, 0.0, 0.0)] {
        extract(&odd, &recipe, ROOM).assert_closed();
    }
}

#[test]
fn only_the_range_counts() {
    let three = [particle([9.0, 0.0, 0.0], 1.0, 8.0), ball(), particle([-9.0, 0.0, 0.0], 1.0, 8.0)];
    let middle = extract(&three, &Recipe { puffs: 1..2, ..recipe(3, 0.05, 0.1) }, ROOM);
    assert_eq!(middle, surface(&[ball()], 0.05, 0.1));
}

#[test]
fn far_from_the_origin_the_surface_is_closed_though_coarser() {
    for distance in [1e3, 1e5, 1e9] {
        let far = particle(Vec3::new(distance, -distance, 0.5 * distance), 1.0, 8.0);
        let mesh = surface(&[far], 0.05, 0.1);
        mesh.assert_closed();
        assert_eq!(mesh.overflow, if distance > 6e3 { COARSENED } else { 0 });
        // Not where a cell is larger than the particle.
        assert_eq!(mesh.triangles.is_empty(), distance > 1e6, "at {distance} m");
    }
}

#[test]
fn huge_particles_end() {
    let huge: Vec<_> = (0..2000).map(|index| particle([index as f32; 3], 1e6, 1e9)).collect();
    let mesh = surface(&huge, 1e-3, 0.01);
    mesh.assert_closed();
    assert_eq!(mesh.overflow, COARSENED);
    assert_eq!((mesh.pieces(), mesh.euler_characteristic()), (1, 2));
}

#[test]
fn cells_become_larger_where_blocks_or_lists_are_full() {
    let few_blocks = extract(&[ball()], &recipe(1, 0.05, 0.02), SurfaceRoom { blocks: 4096, ..ROOM });
    let short_lists = extract(&[ball()], &recipe(1, 0.05, 0.02), SurfaceRoom { entries: 500, ..ROOM });
    for mesh in [few_blocks, short_lists] {
        mesh.assert_closed();
        assert_eq!(mesh.overflow, COARSENED);
        assert_eq!((mesh.pieces(), mesh.euler_characteristic()), (1, 2));
    }
}

#[test]
fn what_has_no_room_is_left_out_and_the_rest_is_sound() {
    let whole = surface(&[ball()], 0.05, 0.05);
    let sound = |room: SurfaceRoom, flag: u32| -> Mesh {
        let mesh = extract(&[ball()], &recipe(1, 0.05, 0.05), room);
        assert_eq!(mesh.overflow, flag);
        assert_eq!(mesh.draw[0] as usize, 3 * mesh.triangles.len());
        let vertices = mesh.places.len() as u32;
        assert!(mesh.triangles.as_flattened().iter().all(|&vertex| vertex < vertices));
        mesh
    };
    let mesh = sound(SurfaceRoom { vertices: 1000, ..ROOM }, VERTICES_LEFT_OUT);
    assert_eq!(
        (mesh.places.as_slice(), mesh.triangles.len()),
        (&whole.places[..1000], whole.triangles.len())
    );
    let mesh = sound(SurfaceRoom { triangles: 1000, ..ROOM }, TRIANGLES_LEFT_OUT);
    assert_eq!(mesh.triangles, whole.triangles[..1000]);
    let mesh = sound(SurfaceRoom { active: 20, ..ROOM }, BLOCKS_LEFT_OUT);
    assert!(!mesh.triangles.is_empty() && mesh.triangles.len() < whole.triangles.len());
}

#[test]
fn room_by_formula_is_enough() {
    let cloud: Vec<_> = (0..24_u8)
        .map(|index| {
            let (sin, cos) = (f32::from(index) * 2.4).sin_cos();
            particle([1.5 * cos, f32::from(index % 5) * 0.3, 1.5 * sin], 0.7, 8.0)
        })
        .collect();
    // Bounds are about 4.4 along the longest side.
    for cells in [22, 64] {
        let cell_m = 4.4 / cells as f32;
        let room = SurfaceRoom::of([(24, 0.7 / cell_m)], cells);
        let mesh = extract(&cloud, &recipe(24, 0.05, cell_m), room);
        mesh.assert_closed();
        assert_eq!(mesh.overflow, 0, "{cells} cells");
    }
}

#[test]
fn what_the_device_cannot_hold_is_refused_with_figures() {
    let Bench { gpu, .. } = &*BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let check = |count, radius_cells, cells| check(gpu, SurfaceRoom::of([(count, radius_cells)], cells));
    assert_eq!(check(24, 64.0, 128), Ok(()));
    let error = check(1_000_000, 20.0, 128).expect_err("lists are too long");
    let message = error.to_string();
    assert!(message.contains("particles on blocks' lists") && message.contains("134217728"), "{message}");
    assert!(check(u64::MAX, f32::MAX, u32::MAX).is_err());
    let [small, large] = [22, 128].map(|cells| SurfaceRoom::of([(24, 6.0)], cells).bytes());
    assert!(small < 8 << 20 && large > small && large < 256 << 20, "{small} and {large} bytes");
}
