//! Draws puffs into the depth and id layers.

use super::{atlas::Atlas, scene::Subject};
use crate::{
    gpu::{DrawList, Frame, Gpu, RasterPipeline, Target, shader},
    layers,
};

/// Quads of a puff's billboard.
pub(crate) const QUADS: u32 = 1;

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Body {
    pipeline: wgpu::RenderPipeline,
}

impl Body {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("shapes/puffs/body"));
        let pipeline = RasterPipeline {
            label: "shapes.puffs.body",
            targets: &[layers::ID_FORMAT],
            depth: Some(layers::nearest_wins()),
            ..Default::default()
        };
        Self { pipeline: pipeline.build(&gpu.device, &module) }
    }

    /// Draws the listed puffs over what `target` holds.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        list: &DrawList,
        target: Target<'_>,
    ) {
        let Atlas { view: texture, sampler, uniform, .. } = &subject.scene.atlas;
        frame.raster(
            "shapes.puffs.body",
            &self.pipeline,
            target,
            &[
                subject.view.as_entire_binding(),
                uniform.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                list.items.as_entire_binding(),
                wgpu::BindingResource::TextureView(texture),
                wgpu::BindingResource::Sampler(sampler),
            ],
            |pass| list.draw(pass),
        );
    }
}
