//! What vortices are summed with.

use fumetto_scene::limits::MIN_VORTEX_ROOM;

use crate::gpu::Gpu;

/// Bytes of a `Leaf` of `tree.wgsl`.
const LEAF_BYTES: u64 = 32;
/// Bytes of a `Node` of `tree.wgsl`.
const NODE_BYTES: u64 = 80;

/// A tree of pairs over the vortices of an object.
#[derive(Debug)]
pub(crate) struct Tree {
    /// Leaves: a power of two, or none.
    pub(crate) places: u32,
    pub(crate) leaves: wgpu::Buffer,
    /// The root is the second; what is below node n are 2 n and 2 n + 1.
    pub(crate) nodes: wgpu::Buffer,
    /// The box around them, and their places on a curve through it.
    pub(super) bounds: wgpu::Buffer,
    pub(super) keys: wgpu::Buffer,
}

impl Tree {
    /// For `count` vortices.
    pub(crate) fn new(gpu: &Gpu, count: u32) -> Self {
        let least = MIN_VORTEX_ROOM as u32;
        let places = if count == 0 { 0 } else { count.max(least).next_power_of_two() };
        let buffer = |label, bytes: u64| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: bytes,
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            })
        };
        let list = |label, bytes: u64| buffer(label, u64::from(places.max(1)) * bytes);
        Self {
            places,
            leaves: list("particles.vortex.leaves", LEAF_BYTES),
            nodes: list("particles.vortex.nodes", NODE_BYTES),
            bounds: buffer("particles.vortex.bounds", 16),
            keys: list("particles.vortex.keys", 8),
        }
    }
}
