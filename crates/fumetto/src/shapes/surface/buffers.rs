//! Buffers that extraction works with.

use fumetto_scene::SurfaceRoom;
use wgpu::util::DeviceExt as _;

use super::{polygons, scan::RUN};
use crate::gpu::Gpu;

/// Words of the `Lattice` before its table.
const LATTICE_WORDS: u32 = 18;
/// Blocks of one region: `IN_REGION` of `lattice.wgsl`.
const IN_REGION: u32 = 512;

/// What extraction works with. One serves any number of surfaces, one after the other.
#[derive(Debug)]
pub(crate) struct Workspace {
    /// `Blob`s of `blob.wgsl`.
    pub(super) blobs: wgpu::Buffer,
    /// `Share`s of `bounds.wgsl`.
    pub(super) shares: wgpu::Buffer,
    /// The `Lattice` of `lattice.wgsl`.
    pub(super) lattice: wgpu::Buffer,
    /// Whether a particle touches each region, while these are looked for; and how many are before each.
    pub(super) marks: wgpu::Buffer,
    pub(super) ranks: wgpu::Buffer,
    /// Numbers of the regions that are kept.
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
    /// Scratch of `scan.wgsl`.
    pub(super) runs: wgpu::Buffer,
    /// `ActiveBlock`s of `lattice.wgsl`.
    pub(super) active: wgpu::Buffer,
    /// Workgroups for kernels that run over these, one for every eight.
    pub(super) dispatch: wgpu::Buffer,
    /// Workgroups that sort long lists, one for each block where there are any.
    pub(super) long: wgpu::Buffer,
    pub(super) signs: wgpu::Buffer,
    /// `Crossed` of `cell.wgsl`.
    pub(super) crossings: wgpu::Buffer,
    pub(super) vertex_counts: wgpu::Buffer,
    pub(super) vertex_starts: wgpu::Buffer,
    pub(super) triangle_counts: wgpu::Buffer,
    pub(super) triangle_starts: wgpu::Buffer,
    pub(super) polygons: wgpu::Buffer,
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
            shares: words("shapes.surface.shares", room.particles.div_ceil(256), 16),
            lattice: words("shapes.surface.lattice", LATTICE_WORDS + room.regions, 1),
            marks: words("shapes.surface.marks", room.regions + 1, 1),
            ranks: words("shapes.surface.ranks", room.regions + 1, 1),
            kept: words("shapes.surface.kept", room.blocks.div_ceil(IN_REGION), 1),
            tally: words("shapes.surface.tally", room.blocks, 1),
            starts: words("shapes.surface.starts", room.blocks + 1, 1),
            entries: words("shapes.surface.entries", room.entries, 1),
            states: words("shapes.surface.states", room.blocks, 1),
            crossed: words("shapes.surface.crossed", room.blocks, 1),
            slots: words("shapes.surface.slots", room.blocks + 1, 1),
            runs: words(
                "shapes.surface.runs",
                room.regions.max(room.blocks).max(room.active).div_ceil(RUN),
                1,
            ),
            active: words("shapes.surface.active", room.active, 4),
            dispatch: buffer(gpu, "shapes.surface.dispatch", 12, wgpu::BufferUsages::INDIRECT),
            long: buffer(gpu, "shapes.surface.long", 12, wgpu::BufferUsages::INDIRECT),
            signs: words("shapes.surface.signs", room.active, 4),
            crossings: words("shapes.surface.crossings", room.active, 14),
            vertex_counts: words("shapes.surface.vertex_counts", room.active, 1),
            vertex_starts: words("shapes.surface.vertex_starts", room.active + 1, 1),
            triangle_counts: words("shapes.surface.triangle_counts", room.active, 1),
            triangle_starts: words("shapes.surface.triangle_starts", room.active + 1, 1),
            polygons: gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("shapes.surface.polygons"),
                contents: bytemuck::cast_slice(&polygons::packed()),
                usage: wgpu::BufferUsages::STORAGE,
            }),
        }
    }
}
