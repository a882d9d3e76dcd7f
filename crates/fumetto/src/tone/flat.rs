//! Light to flat colour.

use super::{Canvas, Ramps};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Transient, linear_sampler, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// A cel: sRGB as it will be in the picture, straight alpha.
pub(crate) const CEL_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Flat {
    /// For cels of puffs alone, and for those that may show triangles; of either, for a cel of its own and for
    /// the picture.
    pipelines: [[wgpu::RenderPipeline; 2]; 2],
    linear: wgpu::Sampler,
}

impl Flat {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("tone/flat"));
        let build = |has_meshes, is_picture| {
            let pipeline = RasterPipeline {
                label: "tone.flat",
                targets: &[CEL_FORMAT],
                depth: Some(layers::where_filled()),
                constants: &[("HAS_MESHES", has_meshes), ("IS_PICTURE", is_picture)],
                ..Default::default()
            };
            pipeline.build(&gpu.device, &module)
        };
        let pipelines =
            [0.0, 1.0].map(|has_meshes| [0.0, 1.0].map(|is_picture| build(has_meshes, is_picture)));
        Self { pipelines, linear: linear_sampler(gpu) }
    }

    /// Paints what the layers show onto `canvas`; `step` pixels make a texel of the normal layer.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        layers: &Layers,
        (normal, shadow): (&Transient, &Transient),
        (step, ramps): (u32, &Ramps),
        canvas: Canvas<'_>,
    ) {
        let sampling = frame.uniform("tone.flat.sampling", &[step, 0, 0, 0]);
        let meshes = subject.meshes;
        frame.fullscreen(
            "tone.flat",
            &self.pipelines[usize::from(meshes.vertex_count > 0)][usize::from(canvas.is_picture)],
            canvas.target().with_depth_test(&layers.depth),
            &[
                subject.view.as_entire_binding(),
                sampling.as_entire_binding(),
                subject.lights.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
                wgpu::BindingResource::TextureView(normal),
                wgpu::BindingResource::TextureView(shadow),
                wgpu::BindingResource::TextureView(&ramps.view),
                wgpu::BindingResource::Sampler(&self.linear),
                meshes.sources.as_entire_binding(),
                meshes.vertices.as_entire_binding(),
                meshes.triangles.as_entire_binding(),
                meshes.parts.as_entire_binding(),
                wgpu::BindingResource::TextureView(&meshes.textures),
                wgpu::BindingResource::Sampler(&meshes.sampler),
            ],
        );
    }
}
