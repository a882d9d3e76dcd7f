//! Outlines by ink billboards behind the puffs.

use super::INK_FORMAT;
use crate::{
    gpu::{DrawList, Frame, Gpu, RasterPipeline, Target, Transient, shader},
    layers::{self, Layers},
    shapes::puffs::{Atlas, Subject},
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Outline {
    pipeline: wgpu::RenderPipeline,
}

impl Outline {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("ink/outline"));
        let pipeline = RasterPipeline {
            label: "ink.outline",
            targets: &[INK_FORMAT],
            depth: Some(layers::in_front()),
            ..Default::default()
        };
        Self { pipeline: pipeline.build(&gpu.device, &module) }
    }

    /// Inks the listed puffs into `ink`, where they are nearer than `depth` tells.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        list: &DrawList,
        (layers, depth): (&Layers, &Transient),
        ink: &Transient,
    ) {
        let Atlas { view: texture, sampler, uniform, .. } = &subject.scene.atlas;
        frame.raster(
            "ink.outline",
            &self.pipeline,
            Target::colour(ink, None).with_depth_test(depth),
            &[
                subject.view.as_entire_binding(),
                uniform.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                list.items.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                subject.lights.as_entire_binding(),
                wgpu::BindingResource::TextureView(texture),
                wgpu::BindingResource::Sampler(sampler),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
            ],
            |pass| list.draw(pass),
        );
    }
}
