//! Draws puffs into the depth and id layers.

use super::{atlas::Atlas, scene::PuffScene};
use crate::{
    gpu::{DrawList, Frame, Gpu, RasterPipeline, Target, shader},
    layers,
};

/// Vertices of a puff's billboard: one triangle.
pub(crate) const VERTICES: u32 = 3;

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
        view: &wgpu::Buffer,
        scene: &PuffScene,
        list: &DrawList,
        target: Target<'_>,
    ) {
        let Atlas { view: texture, sampler, uniform, .. } = &scene.atlas;
        frame.raster(
            "shapes.puffs.body",
            &self.pipeline,
            target,
            &[
                view.as_entire_binding(),
                uniform.as_entire_binding(),
                scene.puffs.as_entire_binding(),
                list.items.as_entire_binding(),
                wgpu::BindingResource::TextureView(texture),
                wgpu::BindingResource::Sampler(sampler),
            ],
            |pass| pass.draw_indirect(&list.draw, 0),
        );
    }
}
