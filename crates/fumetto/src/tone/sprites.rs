//! Pre-shaded puff sprites.

use super::{CEL_FORMAT, Ramps};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, Transient, shader},
    shapes::puffs::{Atlas, Subject},
};

/// Width of a sprite, and how many ways it is turned. Also in `sprite_tile.wgsl`.
const SPRITE_PX: u32 = 64;
const ROTATIONS: u32 = 16;

/// Objects whose sprites fit below each other in a texture of `WebGPU`'s default limits.
pub(crate) const MAX_OBJECTS: usize = 8192 / (SPRITE_PX * ROTATIONS) as usize;

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Sprites {
    pipeline: wgpu::RenderPipeline,
}

impl Sprites {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("tone/sprites"));
        let pipeline = RasterPipeline { label: "tone.sprites", targets: &[CEL_FORMAT], ..Default::default() };
        Self { pipeline: pipeline.build(&gpu.device, &module) }
    }

    /// Shades every variant of every object in every rotation.
    pub(crate) fn record(&self, frame: &mut Frame<'_>, subject: Subject<'_>, ramps: &Ramps) -> Transient {
        let Atlas { view: texture, sampler, uniform, variants, .. } = &subject.scene.atlas;
        let objects = subject.scene.objects.len() as u32;
        let size = [variants * SPRITE_PX, objects * ROTATIONS * SPRITE_PX];
        let sprites = frame.texture("tone.sprites", size, CEL_FORMAT);
        frame.fullscreen(
            "tone.sprites",
            &self.pipeline,
            Target::colour(&sprites, Some(wgpu::Color::TRANSPARENT)),
            &[
                subject.view.as_entire_binding(),
                uniform.as_entire_binding(),
                subject.lights.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                wgpu::BindingResource::TextureView(texture),
                wgpu::BindingResource::Sampler(sampler),
                wgpu::BindingResource::TextureView(&ramps.view),
            ],
        );
        sprites
    }
}
