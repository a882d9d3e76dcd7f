//! Buffers that extraction works with.

use fumetto_scene::SurfaceRoom;
use wgpu::util::DeviceExt as _;

use super::{
    bounds::STRETCH,
    order::{BUCKETS, are_many},
    polygons,
    scan::RUN,
};
use crate::gpu::Gpu;

/// Words of the `Lattice` before its table.
const LATTICE_WORDS: u32 = 18;
/// Words of a `Hard` before its list.
const HARD_WORDS: u32 = 4;
/// Blocks of one region: `IN_REGION` of `lattice.wgsl`.
const IN_REGION: u32 = 512;

/// What extraction works with. One serves any number of surfaces, one after the other.
#[derive(Debug)]
pub(crate) struct Workspace {
    /// `Blob`s of `blob.wgsl`; and as they come, where they are brought in order.
    pub(super) blobs: wgpu::Buffer,
    pub(super) loose: wgpu::Buffer,
    pub(super) bucket_tally: wgpu::Buffer,
    pub(super) bucket_starts: wgpu::Buffer,
    /// `Share`s of `bounds.wgsl`.
    pub(super) shares: wgpu::Buffer,
    /// The `Lattice` of `lattice.wgsl`.
    pub(super) lattice: wgpu::Buffer,
    /// Whether a particle touches each region, while these are looked for; and how many are before each.
    pub(super) marks: wgpu::Buffer,
    pub(super) ranks: wgpu::Buffer,
    /// Places of the regions that are kept.
    pub(super) kept: wgpu::Buffer,
    /// Particles that touch each block while they are counted.
    pub(super) tally: wgpu::Buffer,
    /// Where the list of each block begins in `entries`.
    pub(super) starts: wgpu::Buffer,
    pub(super) entries: wgpu::Buffer,
    /// Whether a block is outside, inside, or which one of the active.
    pub(super) states: wgpu::Buffer,
    pub(super) crossed: wgpu::Buffer,
    pub(super) slots: wgpu::Buffer,
    /// Scratch of `scan.wgsl`: for words, and for fours.
    pub(super) runs: wgpu::Buffer,
    pub(super) mesh_runs: wgpu::Buffer,
    /// `ActiveBlock`s of `lattice.wgsl`.
    pub(super) active: wgpu::Buffer,
    /// Workgroups for the kernel that runs over these, one for every 32.
    pub(super) dispatch: wgpu::Buffer,
    /// Workgroups for kernels that run over chunks of them, one for every 64.
    pub(super) chunks: wgpu::Buffer,
    pub(super) signs: wgpu::Buffer,
    /// `Crossed` of `cell.wgsl`.
    pub(super) crossings: wgpu::Buffer,
    /// Vertices, triangles and chunks of each active block, and how many are before it.
    pub(super) mesh_counts: wgpu::Buffer,
    pub(super) mesh_starts: wgpu::Buffer,
    pub(super) polygons: wgpu::Buffer,
    /// Vertices that are left for `careful.wgsl`: a `Hard` of `hard.wgsl`.
    pub(super) hard: wgpu::Buffer,
}

fn buffer(gpu: &Gpu, label: &str, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage: wgpu::BufferUsages::STORAGE | usage,
        mapped_at_creation: false,
    })
}

impl Workspace {
    /// For surfaces of which none needs more than this `room`, which must have been checked.
    pub(crate) fn new(gpu: &Gpu, room: SurfaceRoom) -> Self {
        let words = |label, count: u32, each: u64| {
            buffer(gpu, label, u64::from(count) * each * 4, wgpu::BufferUsages::COPY_SRC)
        };
        Self {
            blobs: words("shapes.surface.blobs", room.particles, 8),
            loose: words(
                "shapes.surface.loose",
                if are_many(room.particles) { room.particles } else { 1 },
                8,
            ),
            bucket_tally: words("shapes.surface.bucket_tally", BUCKETS, 1),
            bucket_starts: words("shapes.surface.bucket_starts", BUCKETS + 1, 1),
            shares: words("shapes.surface.shares", room.particles.div_ceil(STRETCH), 12),
            lattice: words("shapes.surface.lattice", LATTICE_WORDS + room.regions, 1),
            marks: words("shapes.surface.marks", room.regions + 1, 1),
            ranks: words("shapes.surface.ranks", room.regions + 1, 1),
            kept: words("shapes.surface.kept", room.blocks.div_ceil(IN_REGION), 4),
            tally: words("shapes.surface.tally", room.blocks, 1),
            starts: words("shapes.surface.starts", room.blocks + 1, 1),
            entries: words("shapes.surface.entries", room.entries, 1),
            states: words("shapes.surface.states", room.blocks, 1),
            crossed: words("shapes.surface.crossed", room.blocks, 1),
            slots: words("shapes.surface.slots", room.blocks + 1, 1),
            runs: words("shapes.surface.runs", room.regions.max(room.blocks).max(BUCKETS).div_ceil(RUN), 1),
            mesh_runs: words("shapes.surface.mesh_runs", room.active.div_ceil(RUN), 4),
            active: words("shapes.surface.active", room.active, 4),
            dispatch: buffer(gpu, "shapes.surface.dispatch", 12, wgpu::BufferUsages::INDIRECT),
            chunks: buffer(gpu, "shapes.surface.chunks", 12, wgpu::BufferUsages::INDIRECT),
            signs: words("shapes.surface.signs", room.active, 2),
            crossings: words("shapes.surface.crossings", room.active, 16),
            mesh_counts: words("shapes.surface.mesh_counts", room.active, 4),
            mesh_starts: words("shapes.surface.mesh_starts", room.active + 1, 4),
            polygons: gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("shapes.surface.polygons"),
                contents: bytemuck::cast_slice(&polygons::packed()),
                usage: wgpu::BufferUsages::STORAGE,
            }),
            hard: buffer(
                gpu,
                "shapes.surface.hard",
                u64::from(HARD_WORDS + room.vertices) * 4,
                wgpu::BufferUsages::INDIRECT,
            ),
        }
    }
}
