//! Vortices ─▶ tree.

use fumetto_scene::limits::MIN_VORTEX_ROOM;

use super::Swirl;
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader};

/// Keys that one workgroup of `sort.wgsl` sorts by itself.
const CHUNK: u32 = MIN_VORTEX_ROOM as u32;
/// Levels that a workgroup of `build.wgsl` makes; also there.
const LEVELS: u32 = 8;

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Order {
    bounds: ComputePipeline,
    keys: ComputePipeline,
    sort_chunks: ComputePipeline,
    compare: ComputePipeline,
    settle_chunks: ComputePipeline,
    leaves: ComputePipeline,
    nodes: ComputePipeline,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct TreeUniform {
    count: u32,
    places: u32,
    segments: u32,
    halfway: u32,
    viscosity: f32,
    opening: f32,
    level: u32,
    pad: u32,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct SortUniform {
    half: u32,
    gap: u32,
    pad: [u32; 2],
}

impl Order {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let program = shader!("particles/vortex/order");
        let slots = [Slot::Uniform, Slot::Read, Slot::Read, Slot::Write, Slot::Write];
        let [bounds, keys] = kernels(gpu, program, &slots, ["find_bounds", "find_keys"]);
        let program = shader!("particles/vortex/sort");
        let [sort_chunks, compare, settle_chunks] =
            kernels(gpu, program, &[Slot::Uniform, Slot::Write], ["sort_chunks", "compare", "settle_chunks"]);
        let program = shader!("particles/vortex/build");
        let slots = [Slot::Uniform, Slot::Read, Slot::Read, Slot::Read, Slot::Write, Slot::Write];
        let [leaves, nodes] = kernels(gpu, program, &slots, ["make_leaves", "make_nodes"]);
        Self { bounds, keys, sort_chunks, compare, settle_chunks, leaves, nodes }
    }

    /// Makes the tree anew, of where vortices are now or in the middle of the step.
    pub(super) fn record(&self, frame: &mut Frame<'_>, swirl: &Swirl, halfway: bool) {
        let tree = &swirl.tree;
        let uniform = |frame: &Frame<'_>, level| {
            let tree = TreeUniform {
                count: swirl.count,
                places: tree.places,
                segments: swirl.vortex.segments,
                halfway: u32::from(halfway),
                viscosity: swirl.vortex.viscosity,
                opening: (3.0 / swirl.vortex.error).sqrt(),
                level,
                pad: 0,
            };
            frame.uniform("particles.vortex.tree", &tree)
        };
        let low = uniform(frame, 1);
        let places = [tree.places / 256, 1, 1];
        let bindings = [&low, &swirl.vortices, &swirl.halfway, &tree.bounds, &tree.keys]
            .map(wgpu::Buffer::as_entire_binding);
        frame.compute("particles.vortex.bounds", &self.bounds, &bindings, [1, 1, 1]);
        frame.compute("particles.vortex.keys", &self.keys, &bindings, places);
        self.sort(frame, &tree.keys, tree.places);
        let high = uniform(frame, 1 + LEVELS);
        let bindings = |uniform| {
            [uniform, &swirl.vortices, &swirl.halfway, &tree.keys, &tree.leaves, &tree.nodes]
                .map(wgpu::Buffer::as_entire_binding)
        };
        frame.compute("particles.vortex.leaves", &self.leaves, &bindings(&low), places);
        frame.compute("particles.vortex.nodes", &self.nodes, &bindings(&low), places);
        frame.compute("particles.vortex.top", &self.nodes, &bindings(&high), [1, 1, 1]);
    }

    fn sort(&self, frame: &mut Frame<'_>, keys: &wgpu::Buffer, places: u32) {
        let mut pass = |label, kernel, half, gap, each| {
            let uniform = frame.uniform("particles.vortex.sort", &SortUniform { half, gap, pad: [0; 2] });
            let bindings = [uniform.as_entire_binding(), keys.as_entire_binding()];
            frame.compute(label, kernel, &bindings, [places / each, 1, 1]);
        };
        pass("particles.vortex.sort", &self.sort_chunks, 0, 0, CHUNK);
        let mut half = CHUNK;
        while half < places {
            let mut gap = half;
            while gap >= CHUNK {
                // Each of its 256 lanes compares two.
                pass("particles.vortex.compare", &self.compare, half, gap, 512);
                gap /= 2;
            }
            pass("particles.vortex.settle", &self.settle_chunks, half, gap, CHUNK);
            half *= 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: TreeUniform, "Tree" of "particles/vortex/build" { count, places, segments, halfway, viscosity, opening, level });
}
