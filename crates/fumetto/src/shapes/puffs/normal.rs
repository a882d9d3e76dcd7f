//! Works out the normals of what the id layer shows.

use super::{atlas::Atlas, scene::Subject};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader},
    layers::{self, Layers},
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Normal {
    pipeline: RenderPipeline,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct SamplingUniform {
    step: u32,
    form_side: f32,
    form_objects: f32,
    pad: u32,
}

impl Normal {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("shapes/puffs/normal"));
        let pipeline = RasterPipeline {
            label: "shapes.puffs.normal",
            targets: &[layers::NORMAL_FORMAT],
            ..Default::default()
        };
        Self { pipeline: pipeline.build(&module) }
    }

    /// One normal for every `step`-th pixel of every `step`-th row.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        layers: &Layers,
        step: u32,
    ) -> Transient {
        let size = layers.size.map(|pixels| pixels.div_ceil(step));
        let normal = frame.texture("layers.normal", size, layers::NORMAL_FORMAT);
        let Atlas { view: texture, sampler, uniform, .. } = &subject.scene.atlas;
        let form = &subject.scene.form;
        let sampling =
            SamplingUniform { step, form_side: form.side as f32, form_objects: form.objects as f32, pad: 0 };
        let sampling = frame.uniform("shapes.puffs.normal.sampling", &sampling);
        frame.fullscreen(
            "shapes.puffs.normal",
            &self.pipeline,
            Target::colour(&normal, Some(wgpu::Color::TRANSPARENT)),
            &[
                subject.view.as_entire_binding(),
                uniform.as_entire_binding(),
                sampling.as_entire_binding(),
                subject.scene.puffs.as_entire_binding(),
                subject.scene.styles.as_entire_binding(),
                form.grids.as_entire_binding(),
                wgpu::BindingResource::TextureView(texture),
                wgpu::BindingResource::Sampler(sampler),
                wgpu::BindingResource::TextureView(&form.view),
                wgpu::BindingResource::TextureView(&layers.id),
                wgpu::BindingResource::TextureView(&layers.depth),
                wgpu::BindingResource::TextureView(&layers.hits),
            ],
        );
        normal
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: SamplingUniform, "Sampling" of "shapes/puffs/normal" { step, form_side, form_objects });
}
