//! Copies pre-shaded sprites.

use super::{CEL_FORMAT, Canvas, Ramps};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Transient, linear_sampler, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Copied {
    /// For a cel of its own, and for the picture; of each without shadows, and with them.
    pipelines: [[RenderPipeline; 2]; 2],
    linear: wgpu::Sampler,
}

impl Copied {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("tone/copied"));
        let build = |is_picture, has_shadows| {
            let pipeline = RasterPipeline {
                label: "tone.copied",
                targets: &[CEL_FORMAT],
                depth: Some(layers::where_filled()),
                constants: &[("IS_PICTURE", is_picture), ("HAS_SHADOWS", has_shadows)],
                ..Default::default()
            };
            pipeline.build(&module)
        };
        let pipelines =
            [0.0, 1.0].map(|is_picture| [0.0, 1.0].map(|has_shadows| build(is_picture, has_shadows)));
        Self { pipelines, linear: linear_sampler(gpu) }
    }

    /// Paints what the layers show onto `canvas`; `shadow` is `None` where nothing throws any.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (layers, shadow): (&Layers, Option<&Transient>),
        (sprites, projected): (&Transient, &wgpu::TextureView),
        ramps: &Ramps,
        canvas: Canvas<'_>,
    ) {
        frame.fullscreen(
            "tone.copied",
            &self.pipelines[usize::from(canvas.is_picture)][usize::from(shadow.is_some())],
            canvas.target().with_depth_test(&layers.depth),
            &[
                subject.view.as_entire_binding(),
                wgpu::BindingResource::TextureView(projected),
                subject.scene.styles.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(sprites),
                wgpu::BindingResource::TextureView(&ramps.view),
                wgpu::BindingResource::TextureView(shadow.unwrap_or(sprites)),
                wgpu::BindingResource::Sampler(&self.linear),
            ],
        );
    }
}
