//! Which puffs can be seen at all, found in two phases: a few that surely can are drawn first, then a
//! pyramid over their depth tells which of the others they hide.

use super::scene::Subject;
use crate::gpu::{Frame, Gpu, Slot, kernels, shader, workgroups};

/// Width of a cell of the finest level, in pixels. Also in `pyramid.wgsl`.
const CELL_PX: u32 = 4;
/// Enough for any texture.
const MAX_LEVELS: usize = 16;
/// Levels of so few cells are left to one workgroup, together.
const TOP_CELLS: u32 = 1024;

/// Bits of a puff's flags. Also in `pyramid.wgsl`.
pub(crate) const FRONT: u32 = 1;
pub(crate) const REST: u32 = 2;
pub(crate) const INK: u32 = 4;

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Occlusion {
    compete: wgpu::ComputePipeline,
    choose: wgpu::ComputePipeline,
    pixels: wgpu::ComputePipeline,
    cells: wgpu::ComputePipeline,
    top: wgpu::ComputePipeline,
    bodies: wgpu::ComputePipeline,
    inks: wgpu::ComputePipeline,
    nearest: wgpu::Sampler,
}

/// The pyramid for pictures of one size.
#[derive(Debug)]
pub(crate) struct Pyramid {
    pub(crate) size: [u32; 2],
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
            size,
            uniform: frame.uniform("shapes.puffs.pyramid.uniform", &uniform),
            level_uniforms: (0..levels.len() as u32)
                .map(|level| frame.uniform("shapes.puffs.pyramid.level", &[level, 0, 0, 0]))
                .collect(),
            nearness: gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("shapes.puffs.pyramid.nearness"),
                size: u64::from(cells) * 4,
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            }),
            levels,
        }
    }
}

impl Occlusion {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots = [
            Slot::Uniform,
            Slot::Uniform,
            Slot::Uniform,
            Slot::Read,
            Slot::Uniform,
            Slot::Write,
            Slot::Write,
        ];
        let [compete, choose] = kernels(gpu, shader!("shapes/puffs/front"), &slots, ["compete", "choose"]);
        let slots =
            [Slot::Uniform, Slot::Uniform, Slot::Uniform, Slot::Read, Slot::Uniform, Slot::Read, Slot::Write];
        let [bodies, inks] = kernels(gpu, shader!("shapes/puffs/cull"), &slots, ["bodies", "inks"]);
        let slots = [Slot::Uniform, Slot::Uniform, Slot::Write, Slot::Depth, Slot::Nearest];
        let [pixels, cells, top] =
            kernels(gpu, shader!("shapes/puffs/reduce"), &slots, ["pixels", "cells", "top"]);
        let nearest = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("shapes.puffs.nearest"),
            ..Default::default()
        });
        Self { compete, choose, pixels, cells, top, bodies, inks, nearest }
    }

    /// Flags the puffs to draw first, [`FRONT`].
    pub(crate) fn front(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        pyramid: &Pyramid,
        flags: &wgpu::Buffer,
    ) {
        frame.encoder.clear_buffer(&pyramid.nearness, 0, None);
        for (label, pipeline) in
            [("shapes.puffs.compete", &self.compete), ("shapes.puffs.choose", &self.choose)]
        {
            flag(frame, label, pipeline, subject, pyramid, flags);
        }
    }

    /// With what was drawn first in `depth`, flags the bodies that are still to be drawn, [`REST`].
    pub(crate) fn rest(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        pyramid: &Pyramid,
        flags: &wgpu::Buffer,
        depth: &wgpu::TextureView,
    ) {
        self.reduce(frame, pyramid, depth);
        flag(frame, "shapes.puffs.bodies", &self.bodies, subject, pyramid, flags);
    }

    /// With all bodies in `depth`, flags the puffs whose ink shows, [`INK`].
    pub(crate) fn inks(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        pyramid: &Pyramid,
        flags: &wgpu::Buffer,
        depth: &wgpu::TextureView,
    ) {
        self.reduce(frame, pyramid, depth);
        flag(frame, "shapes.puffs.inks", &self.inks, subject, pyramid, flags);
    }

    fn reduce(&self, frame: &mut Frame<'_>, pyramid: &Pyramid, depth: &wgpu::TextureView) {
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

fn flag(
    frame: &mut Frame<'_>,
    label: &str,
    pipeline: &wgpu::ComputePipeline,
    subject: Subject<'_>,
    pyramid: &Pyramid,
    flags: &wgpu::Buffer,
) {
    let range = frame.uniform("shapes.puffs.range", &[subject.scene.count, 0, 0, 0]);
    frame.compute(
        label,
        pipeline,
        &[
            subject.view.as_entire_binding(),
            range.as_entire_binding(),
            pyramid.uniform.as_entire_binding(),
            subject.scene.puffs.as_entire_binding(),
            subject.scene.styles.as_entire_binding(),
            pyramid.nearness.as_entire_binding(),
            flags.as_entire_binding(),
        ],
        workgroups(subject.scene.count),
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: PyramidUniform, "Pyramid" of "shapes/puffs/reduce" { levels, level });
}
