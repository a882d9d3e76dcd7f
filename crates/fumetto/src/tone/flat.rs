//! Light to flat colour.

use std::collections::BTreeMap;

use super::{Canvas, Features, HatchStyles, Hatched, Ramps};
use crate::{
    gpu::{Frame, Gpu, Module, RasterPipeline, RenderPipeline, Transient, linear_sampler, shader},
    layers::{self, Layers},
    shapes::puffs::Subject,
};

/// A cel: sRGB as it will be in the picture, straight alpha.
pub(crate) const CEL_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Flat {
    module: Module,
    pipelines: BTreeMap<Features, RenderPipeline>,
    linear: wgpu::Sampler,
    /// Where nothing is hatched.
    no_strokes: wgpu::Buffer,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct SamplingUniform {
    step: u32,
    form_side: f32,
    form_objects: f32,
    ground_step: u32,
    ground_far_px: f32,
    pad: [u32; 3],
}

impl Flat {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("tone/flat"));
        let no_strokes = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("tone.flat.no-strokes"),
            size: size_of::<HatchStyles>() as u64,
            usage: wgpu::BufferUsages::UNIFORM,
            mapped_at_creation: false,
        });
        Self { module, pipelines: BTreeMap::new(), linear: linear_sampler(gpu), no_strokes }
    }

    /// Sees to the pipelines for what a scene needs, for a cel of its own and for the picture.
    pub(crate) fn prepare(&mut self, features: Features) {
        for features in [features, features.for_picture()] {
            self.pipelines.entry(features).or_insert_with(|| {
                let pipeline = RasterPipeline {
                    label: "tone.flat",
                    targets: &[CEL_FORMAT],
                    depth: Some(layers::where_filled()),
                    constants: &features.constants(),
                    ..Default::default()
                };
                pipeline.build(&self.module)
            });
        }
    }

    /// Paints what the layers show onto `canvas`; `step` pixels make a texel of the normal layer, and
    /// `features` are prepared.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        layers: &Layers,
        (normal, shadow, hatched): (&Transient, &Transient, Hatched<'_>),
        (step, ramps, features): (u32, &Ramps, Features),
        canvas: Canvas<'_>,
    ) {
        let (meshes, form) = (subject.meshes, &subject.scene.form);
        let sampling = SamplingUniform {
            step,
            form_side: form.side as f32,
            form_objects: form.objects as f32,
            ground_step: hatched.ground.step,
            ground_far_px: hatched.ground.far_px,
            pad: [0; 3],
        };
        let sampling = frame.uniform("tone.flat.sampling", &sampling);
        let features = if canvas.is_picture { features.for_picture() } else { features };
        frame.fullscreen(
            "tone.flat",
            &self.pipelines[&features],
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
                meshes.smoothed.as_entire_binding(),
                form.grids.as_entire_binding(),
                wgpu::BindingResource::TextureView(&form.view),
                ramps.tones.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.hits),
                wgpu::BindingResource::TextureView(&layers.light),
                hatched.styles.unwrap_or(&self.no_strokes).as_entire_binding(),
                wgpu::BindingResource::TextureView(&hatched.ground.slopes),
                wgpu::BindingResource::TextureView(hatched.turns),
            ],
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: SamplingUniform, "Sampling" of "tone/flat" { step, form_side, form_objects, ground_step, ground_far_px });
}
