//! Puts the picture together, cel by cel.

use super::{Backdrop, CEL_FORMAT};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, Transient, linear_sampler, shader},
    ink::InkAround,
    shapes::puffs::Subject,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Compose {
    /// Averages and blends.
    soft: wgpu::RenderPipeline,
    /// Copies.
    hard: wgpu::RenderPipeline,
    sampler: wgpu::Sampler,
}

/// A painted cel and its lines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InkedCel<'a> {
    pub(crate) cel: &'a Transient,
    pub(crate) ink: &'a Transient,
    pub(crate) around: &'a InkAround,
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
}

impl Compose {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("tone/compose"));
        let [soft, hard] = [0.0, 1.0].map(|hard| {
            let constants = [("HARD", hard)];
            let pipeline = RasterPipeline {
                label: "tone.compose",
                targets: &[CEL_FORMAT],
                constants: &constants,
                ..Default::default()
            };
            pipeline.build(&gpu.device, &module)
        });
        Self { soft, hard, sampler: linear_sampler(gpu) }
    }

    /// Lays `cel` and its ink over `under` into `target`; `samples` of them make a pixel's side,
    /// and an opaque cel lets nothing through.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        InkedCel { cel, ink, around }: InkedCel<'_>,
        under: Under<'_>,
        (samples, is_opaque): (u32, bool),
        target: &wgpu::TextureView,
    ) {
        let (mode, image) = match under {
            Under::Backdrop(Backdrop::Transparent) => (0, &**cel),
            Under::Backdrop(Backdrop::Gradient(image)) | Under::Picture(image) => (1, image),
            Under::Backdrop(Backdrop::Image(image)) => (2, image),
        };
        let uniform =
            ComposeUniform { samples, under: mode, cell: around.cell as f32, window: around.window() };
        let uniform = frame.uniform("tone.compose.uniform", &uniform);
        frame.fullscreen(
            "tone.compose",
            if samples == 1 && is_opaque { &self.hard } else { &self.soft },
            Target::colour(target, Some(wgpu::Color::TRANSPARENT)),
            &[
                uniform.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                wgpu::BindingResource::TextureView(cel),
                wgpu::BindingResource::TextureView(ink),
                wgpu::BindingResource::TextureView(&around.layer),
                wgpu::BindingResource::TextureView(image),
                wgpu::BindingResource::Sampler(&self.sampler),
            ],
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ComposeUniform, "Compose" of "tone/compose" { samples, under, cell, window });
}
