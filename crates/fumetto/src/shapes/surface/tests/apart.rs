//! What lies between two clouds costs nothing.

use fumetto_scene::{Particle, Resolution};
use glam::Vec3;

use super::{
    BENCH, Frame, PoisonError, SurfaceRoom, UNFADED, Workspace, meshes, puffs, read, read_buffer, recipe,
    reserved,
};

/// Powers of two, so that both clouds lie alike in the lattice: a region is 2 m wide.
const CELL_M: f32 = 0.0625;

/// Two clouds, so far apart.
fn clouds(apart: Vec3) -> Vec<Particle> {
    let place = |index: u8| {
        let turn = f32::from(index) * 2.4;
        Vec3::new(0.8 * turn.cos(), 0.01 * f32::from(index), 0.8 * turn.sin())
    };
    let first = (0..150).map(|index| super::particle(place(index), 0.25, 1.0));
    let second = (0..150).map(|index| super::particle(place(index) + apart, 0.25, 1.0));
    first.chain(second).collect()
}

/// What a surface took.
#[derive(Debug)]
struct Taken {
    room: SurfaceRoom,
    regions: u32,
    active_blocks: u32,
    triangles: usize,
    overflow: u32,
}

/// Of the surface of `particles`, in the room that is planned for them.
fn taken(particles: &[Particle]) -> Taken {
    let resolution = Resolution::Cell(CELL_M);
    let surface = fumetto_scene::Surface { threshold: 0.3, resolution, size: 1.0, noise: None };
    let room = surface.plan(particles).room;
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let work = Workspace::new(&bench.gpu, room);
    let mesh = meshes(&bench.gpu, room);
    let puffs = puffs(&bench.gpu, particles, UNFADED);
    let recipe = recipe(particles.len(), surface.threshold, CELL_M);
    let mut frame = Frame::new(&bench.gpu, &bench.pool, "test");
    bench.surface.record(&mut frame, &puffs, &recipe, (room, &work), (0.0, reserved(&mesh)));
    frame.submit();
    // As `Lattice` of `lattice.wgsl`.
    let lattice: Vec<u32> = read_buffer(&bench.gpu, &work.lattice).expect("the device lives");
    let mesh = read(&bench.gpu, &mesh);
    mesh.assert_closed();
    let triangles = mesh.triangles.len();
    Taken { room, regions: lattice[15], active_blocks: lattice[7], triangles, overflow: mesh.overflow }
}

#[test]
fn two_far_clouds_cost_no_more_than_two_near_ones() {
    let near = taken(&clouds(Vec3::new(4.0, 0.0, 0.0)));
    assert!(near.triangles > 10_000 && near.overflow == 0, "{near:?}");
    for apart in [Vec3::new(400.0, 0.0, 0.0), Vec3::new(100.0, -60.0, 200.0)] {
        let far = taken(&clouds(apart));
        assert_eq!(far.overflow, 0, "cells are as small as asked for");
        let both = |of: fn(&Taken) -> u64| (of(&far), of(&near));
        let (many, few) = both(|taken| u64::from(taken.regions));
        assert!(many <= few + few / 4, "{many} regions are kept, and {few}");
        let (many, few) = both(|taken| u64::from(taken.active_blocks));
        assert!(many <= few + few / 20, "{many} blocks are looked at, and {few}");
        let (many, few) = both(|taken| taken.triangles as u64);
        assert!(many <= few + few / 100, "{many} triangles, and {few}");
        // Besides what is alike, a table of the regions between them.
        let (many, few) = both(|taken| taken.room.bytes() - 12 * u64::from(taken.room.regions));
        assert!(many <= few + few / 2, "{many} bytes, and {few}");
    }
}
