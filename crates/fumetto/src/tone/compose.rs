//! Puts the picture together, cel by cel.

use super::{Backdrop, CEL_FORMAT};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, Transient, shader},
    ink::InkAround,
    shapes::puffs::PuffScene,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Compose {
    pipeline: wgpu::RenderPipeline,
    sampler: wgpu::Sampler,
}

/// What a cel is laid over.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Under<'a> {
    Backdrop(&'a Backdrop),
    /// The picture so far.
    Picture(&'a wgpu::TextureView),
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct ComposeUniform {
    samples: u32,
    under: u32,
    cell: f32,
    window: f32,
    top: [f32; 4],
    bottom: [f32; 4],
}

impl Compose {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("tone/compose"));
        let pipeline = RasterPipeline { label: "tone.compose", targets: &[CEL_FORMAT], ..Default::default() };
        let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("tone.compose.sampler"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        });
        Self { pipeline: pipeline.build(&gpu.device, &module), sampler }
    }

    /// Lays `cel` and its ink over `under` into `target`; `samples` of them make a pixel's side.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        scene: &PuffScene,
        cel: &Transient,
        (ink, around): (&Transient, &InkAround),
        under: Under<'_>,
        samples: u32,
        target: &wgpu::TextureView,
    ) {
        let rgb = |[r, g, b]: [f32; 3]| [r, g, b, 1.0];
        let (mode, top, bottom, image) = match under {
            Under::Backdrop(Backdrop::Transparent) => (0, [0.0; 4], [0.0; 4], &**cel),
            Under::Backdrop(&Backdrop::Gradient { top, bottom }) => (1, rgb(top), rgb(bottom), &**cel),
            Under::Backdrop(Backdrop::Image(image)) => (2, [0.0; 4], [0.0; 4], image),
            Under::Picture(picture) => (3, [0.0; 4], [0.0; 4], picture),
        };
        let uniform = ComposeUniform {
            samples,
            under: mode,
            cell: around.cell as f32,
            window: around.window(),
            top,
            bottom,
        };
        let uniform = frame.uniform("tone.compose.uniform", &uniform);
        frame.fullscreen(
            "tone.compose",
            &self.pipeline,
            Target::colour(target, Some(wgpu::Color::TRANSPARENT)),
            &[
                uniform.as_entire_binding(),
                scene.styles.as_entire_binding(),
                wgpu::BindingResource::TextureView(cel),
                wgpu::BindingResource::TextureView(ink),
                wgpu::BindingResource::TextureView(&around.layer),
                wgpu::BindingResource::TextureView(image),
                wgpu::BindingResource::Sampler(&self.sampler),
            ],
        );
    }
}
