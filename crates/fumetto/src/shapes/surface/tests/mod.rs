//! The surface against closed forms, on whatever adapter there is.

mod adjacent;
mod apart;
mod bricks;
mod figures;
mod limits;
mod merging;
mod normals;
mod random;
mod repeat;
mod shape;
mod sight;
mod sphere;

use std::sync::{LazyLock, Mutex, PoisonError};

use fumetto_scene::{Noise, Particle, Spacing, SurfaceRoom};
use glam::{Vec2, Vec3};
use wgpu::util::DeviceExt as _;

use super::{Recipe, Surface, Workspace, refusal::check};
use crate::{
    Gpu,
    gpu::{Frame, TexturePool, read_buffer},
    shapes::{
        mesh::{Geometry, MeshScene, Reserved, Shells},
        puffs::{Placement, still_puffs},
    },
};

/// Making pipelines takes longer than most tests do: they share them.
static BENCH: LazyLock<Mutex<Bench>> = LazyLock::new(|| {
    let gpu = pollster::block_on(Gpu::headless()).expect("a Vulkan driver");
    let surface = Surface::new(&gpu);
    Mutex::new(Bench { gpu, surface, pool: TexturePool::default() })
});

struct Bench {
    gpu: Gpu,
    surface: Surface,
    pool: TexturePool,
}

/// A mesh that was read back.
#[derive(Clone, Debug, PartialEq)]
struct Mesh {
    places: Vec<Vec3>,
    normals: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    parts: Vec<u32>,
    overflow: u32,
    draw: [u32; 4],
}

fn particle(center: impl Into<Vec3>, radius: f32, mass: f32) -> Particle {
    Particle { center: center.into().to_array(), radius, mass }
}

fn recipe(count: usize, threshold: f32, cell_m: f32) -> Recipe {
    Recipe {
        puffs: 0..count as u32,
        threshold,
        radius_scale: 1.0,
        mass_scale: 1.0,
        spacing: Spacing::Cell(cell_m),
        sight: None,
        noise: None,
        bricks: None,
    }
}

/// Number that triangles carry.
const PART: u32 = 1;

/// Room for a surface that is not the first of its scene.
fn meshes(gpu: &Gpu, room: SurfaceRoom) -> MeshScene {
    let mut geometry = Geometry::default();
    geometry.add_surface(3, 5, false);
    geometry.add_surface(room.vertices, room.triangles, false);
    MeshScene::new(gpu, &geometry, &Shells::default(), &[], &[]).expect("the room is modest")
}

fn reserved(meshes: &MeshScene) -> &Reserved {
    &meshes.reserved[PART as usize]
}

/// Room for whatever these tests make.
const ROOM: SurfaceRoom = SurfaceRoom {
    particles: 4096,
    regions: 1 << 14,
    blocks: 1 << 17,
    entries: 1 << 20,
    active: 1 << 14,
    vertices: 1 << 19,
    triangles: 1 << 20,
};

/// The surface of `particles`.
fn surface(particles: &[Particle], threshold: f32, cell_m: f32) -> Mesh {
    extract(particles, &recipe(particles.len(), threshold, cell_m), ROOM)
}

fn extract(particles: &[Particle], recipe: &Recipe, room: SurfaceRoom) -> Mesh {
    extract_faded(particles, UNFADED, recipe, room)
}

/// Likewise, with this `fade` of a puff.
fn extract_faded(particles: &[Particle], fade: u32, recipe: &Recipe, room: SurfaceRoom) -> Mesh {
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let work = Workspace::new(&bench.gpu, room);
    let mesh = meshes(&bench.gpu, room);
    let puffs = puffs(&bench.gpu, particles, fade);
    let mut frame = Frame::new(&bench.gpu, &bench.pool, "test");
    bench.surface.record(&mut frame, &puffs, recipe, (room, &work), (0.0, reserved(&mesh)));
    frame.submit();
    read(&bench.gpu, &mesh)
}

/// Not eroded, and opaque.
const UNFADED: u32 = 0xffff_0000;

fn puffs(gpu: &Gpu, particles: &[Particle], fade: u32) -> wgpu::Buffer {
    let placement = Placement { first: 0, object: 0, first_variant: 0, variants: 1, size: 1.0, seed: 0 };
    let mut puffs = still_puffs(particles, placement);
    if puffs.is_empty() {
        puffs = still_puffs(&[particle(Vec3::ZERO, 0.0, 0.0)], placement);
    }
    for puff in &mut puffs {
        puff.fade = fade;
    }
    gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("test.puffs"),
        contents: bytemuck::cast_slice(&puffs),
        usage: wgpu::BufferUsages::STORAGE,
    })
}

fn read(gpu: &Gpu, meshes: &MeshScene) -> Mesh {
    let reserved = reserved(meshes);
    let counters: Vec<u32> = read_buffer(gpu, &reserved.counters).expect("the device lives");
    let places: Vec<[f32; 4]> = read_buffer(gpu, &meshes.vertices).expect("the device lives");
    let triangles: Vec<[u32; 4]> = read_buffer(gpu, &meshes.triangles).expect("the device lives");
    let [first_vertex, first_triangle] = [reserved.vertices.start, reserved.triangles.start];
    assert!(first_vertex > 0 && first_triangle > 0, "there is another surface");
    let places = &places[first_vertex as usize..][..counters[4] as usize];
    let triangles = &triangles[first_triangle as usize..][..counters[5] as usize];
    Mesh {
        places: places.iter().map(|&[x, y, z, _]| Vec3::new(x, y, z)).collect(),
        normals: places.iter().map(|&[.., packed]| unpack(packed.to_bits())).collect(),
        triangles: triangles
            .iter()
            .map(|&[a, b, c, _]| [a, b, c].map(|corner| corner - first_vertex))
            .collect(),
        parts: triangles.iter().map(|&[.., part]| part).collect(),
        overflow: counters[6],
        draw: [counters[0], counters[1], counters[2] - 3 * first_triangle, counters[3]],
    }
}

/// As `octahedral_decode` of `octahedral.wgsl`.
fn unpack(packed: u32) -> Vec3 {
    let snorm = |bits: u32| (f32::from(bits as u16 as i16) / 32767.0).max(-1.0);
    let at = Vec2::new(snorm(packed), snorm(packed >> 16));
    let z = 1.0 - at.x.abs() - at.y.abs();
    let fold = (-z).max(0.0);
    let unfolded = at - Vec2::new(fold.copysign(at.x), fold.copysign(at.y));
    unfolded.extend(z).normalize_or_zero()
}
