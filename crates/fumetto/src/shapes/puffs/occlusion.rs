//! Which puffs can be seen at all: a pyramid of how near something solid surely is, and a cull by it.

use super::{bundle, scene::PuffScene};
use crate::gpu::{Frame, Gpu, Slot, kernels, shader, workgroups};

/// Width of a cell of the finest level, in pixels. Also in `pyramid.wgsl`.
const CELL_PX: u32 = 2;
/// Enough for a finest level of 4096 cells.
const MAX_LEVELS: usize = 16;

/// Bits of a puff's flags. Also in `cull.wgsl`.
pub(crate) const BODY: u32 = 1;
pub(crate) const INK: u32 = 2;

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Occlusion {
    occluders: wgpu::ComputePipeline,
    down: wgpu::ComputePipeline,
    up: wgpu::ComputePipeline,
    cull: wgpu::ComputePipeline,
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

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct CoreUniform {
    radius: f32,
    height: f32,
    first: u32,
    count: u32,
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
        let [occluders] = kernels(
            gpu,
            shader!("shapes/puffs/occluders"),
            &[Slot::Uniform, Slot::Uniform, Slot::Uniform, Slot::Read, Slot::Write],
            ["occluders"],
        );
        let slots = [Slot::Uniform, Slot::Uniform, Slot::Write];
        let [down, up] = kernels(gpu, shader!("shapes/puffs/spread"), &slots, ["down", "up"]);
        let slots =
            [Slot::Uniform, Slot::Uniform, Slot::Uniform, Slot::Read, Slot::Read, Slot::Read, Slot::Write];
        let [cull] = kernels(gpu, shader!("shapes/puffs/cull"), &slots, ["cull"]);
        Self { occluders, down, up, cull }
    }

    /// Flags the puffs that something solid does not surely hide.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        view: &wgpu::Buffer,
        scene: &PuffScene,
        pyramid: &Pyramid,
        flags: &wgpu::Buffer,
    ) {
        frame.encoder.clear_buffer(&pyramid.nearness, 0, None);
        let core = CoreUniform {
            radius: bundle::CORE_RADIUS,
            height: bundle::core_height(),
            first: 0,
            count: scene.count,
        };
        let core = frame.uniform("shapes.puffs.core", &core);
        frame.compute(
            "shapes.puffs.occluders",
            &self.occluders,
            &[
                view.as_entire_binding(),
                core.as_entire_binding(),
                pyramid.uniform.as_entire_binding(),
                scene.puffs.as_entire_binding(),
                pyramid.nearness.as_entire_binding(),
            ],
            workgroups(scene.count),
        );
        self.spread(frame, pyramid);
        let range = frame.uniform("shapes.puffs.range", &[0, scene.count, 0, 0]);
        frame.compute(
            "shapes.puffs.cull",
            &self.cull,
            &[
                view.as_entire_binding(),
                range.as_entire_binding(),
                pyramid.uniform.as_entire_binding(),
                scene.puffs.as_entire_binding(),
                scene.styles.as_entire_binding(),
                pyramid.nearness.as_entire_binding(),
                flags.as_entire_binding(),
            ],
            workgroups(scene.count),
        );
    }

    fn spread(&self, frame: &mut Frame<'_>, pyramid: &Pyramid) {
        let mut level = |pipeline, index: usize| {
            let [width, height] = pyramid.levels[index];
            frame.compute(
                "shapes.puffs.spread",
                pipeline,
                &[
                    pyramid.uniform.as_entire_binding(),
                    pyramid.level_uniforms[index].as_entire_binding(),
                    pyramid.nearness.as_entire_binding(),
                ],
                [width.div_ceil(16), height.div_ceil(16), 1],
            );
        };
        for index in (0..pyramid.levels.len() - 1).rev() {
            level(&self.down, index);
        }
        for index in 1..pyramid.levels.len() {
            level(&self.up, index);
        }
    }
}
