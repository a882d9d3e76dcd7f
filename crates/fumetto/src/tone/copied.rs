//! Copies pre-shaded sprites.

use super::{CEL_FORMAT, Ramps};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, Transient, linear_sampler, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Copied {
    pipeline: wgpu::RenderPipeline,
    linear: wgpu::Sampler,
}

impl Copied {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("tone/copied"));
        let pipeline = RasterPipeline {
            label: "tone.copied",
            targets: &[CEL_FORMAT],
            depth: Some(layers::where_filled()),
            ..Default::default()
        };
        Self { pipeline: pipeline.build(&gpu.device, &module), linear: linear_sampler(gpu) }
    }

    /// Paints what the layers show.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        layers: &Layers,
        shadow: &Transient,
        sprites: &Transient,
        ramps: &Ramps,
    ) -> Transient {
        let cel = frame.texture("tone.cel", layers.size, CEL_FORMAT);
        frame.fullscreen(
            "tone.copied",
            &self.pipeline,
            Target::colour(&cel, Some(wgpu::Color::TRANSPARENT)).with_depth_test(&layers.depth),
            &[
                subject.view.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(sprites),
                wgpu::BindingResource::TextureView(&ramps.view),
                wgpu::BindingResource::TextureView(shadow),
                wgpu::BindingResource::Sampler(&self.linear),
            ],
        );
        cel
    }
}
