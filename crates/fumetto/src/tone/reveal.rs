//! Paints over a cel and its ink.

use super::{
    Backdrop, CEL_FORMAT,
    compose::{ComposeUniform, Inked, Sheet, Under},
};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, linear_sampler, shader},
    ink::INK_FORMAT,
    layers::Layers,
    paint::Marks,
    shapes::puffs::Subject,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Reveal {
    pipeline: RenderPipeline,
    sampler: wgpu::Sampler,
}

impl Reveal {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("tone/reveal"));
        let pipeline = RasterPipeline { label: "tone.reveal", targets: &[CEL_FORMAT], ..Default::default() };
        Self { pipeline: pipeline.build(&module), sampler: linear_sampler(gpu) }
    }

    /// `cel` with its ink as the paints show it that `marks` tell of, where they show it in the look of number
    /// `look`; elsewhere what was there `before`.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (cel, inked): (&Transient, Inked<'_>),
        (layers, marks, sheet): (&Layers, &Marks, Sheet),
        (look, before): (usize, Option<&Transient>),
    ) -> Transient {
        let nothing = Under::Backdrop(&Backdrop::Transparent);
        let compose = frame.uniform("tone.reveal.compose", &ComposeUniform::new(sheet, nothing).inked(inked));
        let uniform = frame.uniform("tone.reveal.uniform", &[look as u32, 0, 0, 0]);
        let revealed = frame.texture("tone.revealed", layers.size, CEL_FORMAT);
        frame.fullscreen(
            "tone.reveal",
            &self.pipeline,
            Target::colour(&revealed, Some(wgpu::Color::TRANSPARENT)),
            &[
                compose.as_entire_binding(),
                subject.pens.as_entire_binding(),
                marks.coats.as_entire_binding(),
                uniform.as_entire_binding(),
                wgpu::BindingResource::TextureView(cel),
                wgpu::BindingResource::TextureView(inked.ink),
                wgpu::BindingResource::TextureView(inked.around()),
                wgpu::BindingResource::TextureView(before.unwrap_or(cel)),
                wgpu::BindingResource::Sampler(&self.sampler),
                marks.mask.as_entire_binding(),
            ],
        );
        revealed
    }
    /// Stands in for the ink of a cel that has it in itself.
    pub(crate) fn nothing_inked(frame: &mut Frame<'_>) -> Transient {
        let nothing = frame.texture("tone.reveal.ink", [1, 1], INK_FORMAT);
        frame.clear("tone.reveal.ink", Target::colour(&nothing, Some(wgpu::Color::TRANSPARENT)));
        nothing
    }
}
