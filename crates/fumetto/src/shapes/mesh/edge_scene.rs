use wgpu::util::DeviceExt as _;

use super::edges::Candidate;
use crate::gpu::{DrawList, Gpu};

/// The places of a scene's models where lines may run, on the device.
#[derive(Debug)]
pub(crate) struct EdgeScene {
    /// `Candidate`s of `candidate.wgsl`.
    pub(crate) candidates: wgpu::Buffer,
    pub(crate) count: u32,
    /// For each of them the bit of the kind of edge that it is in the view that is drawn; 0 without a line.
    pub(crate) flags: wgpu::Buffer,
    /// Those with lines.
    pub(crate) list: DrawList,
}

impl EdgeScene {
    pub(crate) fn new(gpu: &Gpu, candidates: &[Candidate]) -> Self {
        let count = candidates.len() as u32;
        let nothing = [bytemuck::Zeroable::zeroed()];
        Self {
            candidates: gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("shapes.mesh.candidates"),
                contents: bytemuck::cast_slice(if candidates.is_empty() { &nothing } else { candidates }),
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
            }),
            count,
            flags: gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("shapes.mesh.edges"),
                size: u64::from(count.max(1)) * 4,
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            }),
            list: DrawList::new(gpu, "shapes.mesh.lines", count, 1),
        }
    }
}
