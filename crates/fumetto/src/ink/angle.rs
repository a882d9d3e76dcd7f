//! Ink where surfaces are seen edge-on.

use super::INK_FORMAT;
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Angle {
    pipeline: RenderPipeline,
}

impl Angle {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("ink/angle"));
        let pipeline = RasterPipeline {
            label: "ink.angle",
            targets: &[INK_FORMAT],
            depth: Some(layers::where_filled()),
            ..Default::default()
        };
        Self { pipeline: pipeline.build(&module) }
    }

    /// Adds to `ink` where the objects that want it so are seen edge-on; `normal` tells it of puffs.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        layers: &Layers,
        normal: &Transient,
        ink: &Transient,
    ) {
        let meshes = subject.meshes;
        frame.fullscreen(
            "ink.angle",
            &self.pipeline,
            Target::colour(ink, None).with_depth_test(&layers.depth),
            &[
                subject.view.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                subject.lights.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                subject.pens.as_entire_binding(),
                meshes.sources.as_entire_binding(),
                meshes.vertices.as_entire_binding(),
                meshes.triangles.as_entire_binding(),
                meshes.parts.as_entire_binding(),
                wgpu::BindingResource::TextureView(&meshes.textures),
                wgpu::BindingResource::Sampler(&meshes.sampler),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
                wgpu::BindingResource::TextureView(normal),
            ],
        );
    }
}
