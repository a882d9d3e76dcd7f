//! Gives tones and shadows shapes of a least size.

use super::shadows::SHADOW_FORMAT;
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, Target, Transient, View, shader},
    layers,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Soften {
    pipeline: wgpu::RenderPipeline,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct SoftenUniform {
    axis: [i32; 2],
    radius: i32,
    scale: f32,
    focal_px: f32,
    pad: [f32; 3],
}

impl Soften {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("light/soften"));
        let pipeline = RasterPipeline {
            label: "light.soften",
            targets: &[layers::NORMAL_FORMAT, SHADOW_FORMAT],
            ..Default::default()
        };
        Self { pipeline: pipeline.build(&gpu.device, &module) }
    }

    /// Averages normals and shadows over `radius` texels to each side; `step` pixels make a texel.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        view: &View,
        layers: (Transient, Transient),
        radius: u32,
        step: u32,
    ) -> (Transient, Transient) {
        let mut layers = layers;
        for axis in [[1, 0], [0, 1]] {
            let (normal, shadow) = &layers;
            let size = [normal.texture().width(), normal.texture().height()];
            let to = (
                frame.texture("layers.normal", size, layers::NORMAL_FORMAT),
                frame.texture("light.shadow", size, SHADOW_FORMAT),
            );
            let uniform = SoftenUniform {
                axis,
                radius: radius as i32,
                scale: 1.0 / step as f32,
                focal_px: view.uniform.focal_px,
                pad: [0.0; 3],
            };
            let uniform = frame.uniform("light.soften.uniform", &uniform);
            let clear = Some(wgpu::Color::TRANSPARENT);
            frame.fullscreen(
                "light.soften",
                &self.pipeline,
                Target { colours: vec![(&to.0, clear), (&to.1, clear)], depth: None },
                &[
                    uniform.as_entire_binding(),
                    wgpu::BindingResource::TextureView(normal),
                    wgpu::BindingResource::TextureView(shadow),
                ],
            );
            layers = to;
        }
        layers
    }
}
