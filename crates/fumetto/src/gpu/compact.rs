//! Lists the items that a cull left, and draws exactly those, with nothing read back.

use wgpu::util::DeviceExt as _;

use super::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups};

/// Items that one invocation looks at. Also in `compact.wgsl`.
const RUN: u32 = 32;

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Compact {
    count: ComputePipeline,
    scan: ComputePipeline,
    scatter: ComputePipeline,
}

/// The items of one flag, and the draw over them.
#[derive(Debug)]
pub(crate) struct DrawList {
    /// The items' numbers, rising.
    pub(crate) items: wgpu::Buffer,
    /// Arguments of an indirect draw; then how many items are listed.
    pub(crate) draw: wgpu::Buffer,
    /// Two triangles for every four corners; without it, there are six corners.
    indices: Option<wgpu::Buffer>,
    before: wgpu::Buffer,
}

/// Which items go on a list.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Listing {
    /// Only the first so many are looked at.
    pub(crate) items: u32,
    /// Those whose flags share a bit with this are listed.
    pub(crate) mask: u32,
    /// Quads that each of them is drawn with.
    pub(crate) quads: u32,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct CompactionUniform {
    items: u32,
    mask: u32,
    quads: u32,
    pad: u32,
}

impl DrawList {
    /// Room for `capacity` items of up to `quads` quads each.
    pub(crate) fn new(gpu: &Gpu, label: &str, capacity: u32, quads: u32) -> Self {
        let indices = quad_indices(gpu, (capacity * quads).max(1));
        Self { indices: Some(indices), ..Self::without_indices(gpu, label, capacity) }
    }

    /// Room for `capacity` items, each corner of whose quads is worked out for both of its triangles.
    pub(crate) fn without_indices(gpu: &Gpu, label: &str, capacity: u32) -> Self {
        let buffer = |words: u32, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: u64::from(words.max(1)) * 4,
                usage: wgpu::BufferUsages::STORAGE | usage,
                mapped_at_creation: false,
            })
        };
        Self {
            items: buffer(capacity, wgpu::BufferUsages::COPY_SRC),
            draw: buffer(6, wgpu::BufferUsages::INDIRECT | wgpu::BufferUsages::COPY_SRC),
            indices: None,
            before: buffer(capacity.div_ceil(RUN), wgpu::BufferUsages::empty()),
        }
    }
}

impl DrawList {
    /// Draws the quads of the listed items; four vertices in a row are the corners of one, or without indices
    /// six in the order 0, 1, 2, 0, 2, 3.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        match &self.indices {
            Some(indices) => {
                pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
                pass.draw_indexed_indirect(&self.draw, 0);
            }
            // Their arguments begin alike.
            None => pass.draw_indirect(&self.draw, 0),
        }
    }
}

/// Corners are worked out once for both triangles of a quad.
fn quad_indices(gpu: &Gpu, quads: u32) -> wgpu::Buffer {
    let indices: Vec<u32> =
        (0..quads).flat_map(|quad| [0, 1, 2, 0, 2, 3].map(|corner| 4 * quad + corner)).collect();
    gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("gpu.compact.indices"),
        contents: bytemuck::cast_slice(&indices),
        usage: wgpu::BufferUsages::INDEX,
    })
}

impl Compact {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write, Slot::Write, Slot::Write];
        let [count, scan, scatter] =
            kernels(gpu, shader!("gpu/compact"), &slots, ["count", "scan", "scatter"]);
        Self { count, scan, scatter }
    }

    /// Lists the items whose `flags` say so.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        flags: &wgpu::Buffer,
        Listing { items, mask, quads }: Listing,
        list: &DrawList,
    ) {
        let uniform = frame.uniform("gpu.compact.uniform", &CompactionUniform { items, mask, quads, pad: 0 });
        let bindings = [
            uniform.as_entire_binding(),
            flags.as_entire_binding(),
            list.before.as_entire_binding(),
            list.items.as_entire_binding(),
            list.draw.as_entire_binding(),
        ];
        let runs = workgroups(items.div_ceil(RUN));
        frame.compute("gpu.compact.count", &self.count, &bindings, runs);
        frame.compute("gpu.compact.scan", &self.scan, &bindings, [1, 1, 1]);
        frame.compute("gpu.compact.scatter", &self.scatter, &bindings, runs);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: CompactionUniform, "Compaction" of "gpu/compact" { items, mask, quads });
}
