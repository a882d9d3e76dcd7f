//! Gives tones shapes of a least size.

use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, View, shader},
    layers,
};

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Soften {
    pipeline: RenderPipeline,
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
        let module = gpu.module(shader!("light/soften"));
        let pipeline =
            RasterPipeline { label: "light.soften", targets: &[layers::NORMAL_FORMAT], ..Default::default() };
        Self { pipeline: pipeline.build(&module) }
    }

    /// Averages normals over `radius` texels to each side; `step` pixels make a texel.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        view: &View,
        normal: Transient,
        radius: u32,
        step: u32,
    ) -> Transient {
        let size = [normal.texture().width(), normal.texture().height()];
        let mut normal = normal;
        for axis in [[1, 0], [0, 1]] {
            let to = frame.texture("layers.normal", size, layers::NORMAL_FORMAT);
            let uniform = SoftenUniform {
                axis,
                radius: radius as i32,
                scale: 1.0 / step as f32,
                focal_px: view.uniform.focal_px,
                pad: [0.0; 3],
            };
            let uniform = frame.uniform("light.soften.uniform", &uniform);
            frame.fullscreen(
                "light.soften",
                &self.pipeline,
                Target::colour(&to, Some(wgpu::Color::TRANSPARENT)),
                &[uniform.as_entire_binding(), wgpu::BindingResource::TextureView(&normal)],
            );
            normal = to;
        }
        normal
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: SoftenUniform, "Soften" of "light/soften" { axis, radius, scale, focal_px });
}
