//! The occlusion pyramid over the depth layer: how near everything in each cell of the screen is at least.

use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader};

/// Width of a cell of the finest level, in pixels. Also in `pyramid.wgsl`.
const CELL_PX: u32 = 4;
/// Enough for any texture.
const MAX_LEVELS: usize = 16;
/// Levels of so few cells are left to one workgroup, together.
const TOP_CELLS: u32 = 1024;

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Reduce {
    pixels: ComputePipeline,
    cells: ComputePipeline,
    top: ComputePipeline,
    nearest: wgpu::Sampler,
}

/// The pyramid for pictures of one size.
#[derive(Debug)]
pub(crate) struct Pyramid {
    /// Width and height of each level, in cells.
    levels: Vec<[u32; 2]>,
    pub(crate) uniform: wgpu::Buffer,
    level_uniforms: Vec<wgpu::Buffer>,
    pub(crate) nearness: wgpu::Buffer,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct PyramidUniform {
    levels: u32,
    pad: [u32; 3],
    level: [[u32; 4]; MAX_LEVELS],
}

impl Pyramid {
    pub(crate) fn new(gpu: &Gpu, size: [u32; 2]) -> Self {
        let mut levels = vec![size.map(|pixels| pixels.div_ceil(CELL_PX))];
        while levels[levels.len() - 1] != [1, 1] {
            levels.push(levels[levels.len() - 1].map(|cells| cells.div_ceil(2)));
        }
        let mut uniform =
            PyramidUniform { levels: levels.len() as u32, pad: [0; 3], level: [[0; 4]; MAX_LEVELS] };
        let mut cells = 0;
        for (entry, &[width, height]) in uniform.level.iter_mut().zip(&levels) {
            *entry = [cells, width, height, 0];
            cells += width * height;
        }
        let pool = crate::gpu::TexturePool::default();
        let frame = Frame::new(gpu, &pool, "shapes.puffs.pyramid");
        Self {
            uniform: frame.uniform("shapes.puffs.pyramid.uniform", &uniform),
            level_uniforms: (0..levels.len() as u32)
                .map(|level| frame.uniform("shapes.puffs.pyramid.level", &[level, 0, 0, 0]))
                .collect(),
            nearness: gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("shapes.puffs.pyramid.nearness"),
                size: u64::from(cells) * 4,
                usage: wgpu::BufferUsages::STORAGE,
                mapped_at_creation: false,
            }),
            levels,
        }
    }
}

impl Reduce {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Uniform, Slot::Write, Slot::Depth, Slot::Nearest];
        let [pixels, cells, top] =
            kernels(gpu, shader!("shapes/puffs/reduce"), &slots, ["pixels", "cells", "top"]);
        let nearest = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("shapes.puffs.nearest"),
            ..Default::default()
        });
        Self { pixels, cells, top, nearest }
    }

    /// Builds `pyramid` over what `depth` shows.
    pub(crate) fn record(&self, frame: &mut Frame<'_>, pyramid: &Pyramid, depth: &wgpu::TextureView) {
        for (index, &[width, height]) in pyramid.levels.iter().enumerate() {
            let is_top = index > 0 && width * height <= TOP_CELLS;
            let (pipeline, groups) = match index {
                0 => (&self.pixels, [width.div_ceil(16), height.div_ceil(16), 1]),
                _ if is_top => (&self.top, [1, 1, 1]),
                _ => (&self.cells, [width.div_ceil(16), height.div_ceil(16), 1]),
            };
            frame.compute(
                "shapes.puffs.reduce",
                pipeline,
                &[
                    pyramid.uniform.as_entire_binding(),
                    pyramid.level_uniforms[index].as_entire_binding(),
                    pyramid.nearness.as_entire_binding(),
                    wgpu::BindingResource::TextureView(depth),
                    wgpu::BindingResource::Sampler(&self.nearest),
                ],
                groups,
            );
            if is_top {
                break;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: PyramidUniform, "Pyramid" of "shapes/puffs/reduce" { levels, level });
}
