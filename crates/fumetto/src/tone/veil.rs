//! Softens a volume's tones.

use fumetto_scene::Object;

use super::CEL_FORMAT;
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader},
    layers::Layers,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Veil {
    pipeline: RenderPipeline,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct VeilUniform {
    soft: f32,
    opacity: f32,
    pad: [f32; 2],
}

impl Veil {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("tone/veil"));
        let pipeline = RasterPipeline { label: "tone.veil", targets: &[CEL_FORMAT], ..Default::default() };
        Self { pipeline: pipeline.build(&module) }
    }

    /// Blends the tones in `cel` with what a camera would see, where the cel is of an object that wants it.
    pub(crate) fn record<'o>(
        &self,
        frame: &mut Frame<'_>,
        members: impl Iterator<Item = &'o Object>,
        layers: &Layers,
        cel: Transient,
    ) -> Transient {
        let soft = |object: &'o Object| object.shape.volume().map(|volume| (volume.soft, object.opacity));
        let Some((soft, opacity)) = members.filter_map(soft).find(|(soft, _)| *soft > 0.0) else {
            return cel;
        };
        let uniform = frame.uniform("tone.veil.uniform", &VeilUniform { soft, opacity, pad: [0.0; 2] });
        let veiled = frame.texture("tone.cel", layers.size, CEL_FORMAT);
        frame.fullscreen(
            "tone.veil",
            &self.pipeline,
            Target::colour(&veiled, Some(wgpu::Color::TRANSPARENT)),
            &[
                uniform.as_entire_binding(),
                wgpu::BindingResource::TextureView(&cel),
                wgpu::BindingResource::TextureView(&layers.soft),
            ],
        );
        veiled
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: VeilUniform, "Veil" of "tone/veil" { soft, opacity });
}
