//! Light to flat colour.

use super::Ramps;
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, Transient, linear_sampler, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// A cel: sRGB as it will be in the picture, straight alpha.
pub(crate) const CEL_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Flat {
    /// For cels of puffs alone, and for those that may show triangles.
    pipelines: [wgpu::RenderPipeline; 2],
    linear: wgpu::Sampler,
}

impl Flat {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("tone/flat"));
        let pipelines = [0.0, 1.0].map(|has_meshes| {
            let pipeline = RasterPipeline {
                label: "tone.flat",
                targets: &[CEL_FORMAT],
                depth: Some(layers::where_filled()),
                constants: &[("HAS_MESHES", has_meshes)],
                ..Default::default()
            };
            pipeline.build(&gpu.device, &module)
        });
        Self { pipelines, linear: linear_sampler(gpu) }
    }

    /// Paints what the layers show; `step` pixels make a texel of the normal layer.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        layers: &Layers,
        (normal, shadow): (&Transient, &Transient),
        step: u32,
        ramps: &Ramps,
    ) -> Transient {
        let cel = frame.texture("tone.cel", layers.size, CEL_FORMAT);
        let sampling = frame.uniform("tone.flat.sampling", &[step, 0, 0, 0]);
        let meshes = subject.meshes;
        frame.fullscreen(
            "tone.flat",
            &self.pipelines[usize::from(meshes.vertex_count > 0)],
            Target::colour(&cel, Some(wgpu::Color::TRANSPARENT)).with_depth_test(&layers.depth),
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
        cel
    }
}
