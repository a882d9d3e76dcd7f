//! The form that strokes bend round: distances, smoothed.

use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader},
    layers::Layers,
};

/// Metres before the camera, 0 where there is nothing.
const GROUND_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R32Float;

/// The same, and metres for a sample to the right and below.
const SLOPES_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;

/// Texels that distances are smoothed over to each side, where the picture is fine enough for it.
const RADIUS: f32 = 4.0;

/// Samples to a texel: tiles begin at multiples of them.
const FINEST: f32 = 2.0;
pub(super) const COARSEST: f32 = 4.0;

/// Samples of two rounds of smoothing to each side over those of one that smooths as much.
const ROUND: f32 = std::f32::consts::FRAC_1_SQRT_2;

/// How deep a form may go from texel to texel, in texels: as on a plane seen at 80 degrees.
const STEEPEST: f32 = 6.0;

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Ground {
    smooth: RenderPipeline,
    slopes: RenderPipeline,
}

/// Distances as strokes see them.
#[derive(Debug)]
pub(crate) struct Grounded {
    pub(super) slopes: Transient,
    /// Samples to a texel.
    pub(super) step: u32,
    /// What lies so much farther is another form, in samples as deep as wide.
    pub(super) far_px: f32,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct GroundUniform {
    axis: [i32; 2],
    radius: i32,
    step: i32,
    far_px: f32,
    pad: [f32; 3],
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct SlopesUniform {
    step: f32,
    far_px: f32,
    pad: [f32; 2],
}

impl Ground {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let build = |label, program, format| {
            let module = gpu.module(program);
            RasterPipeline { label, targets: &[format], ..Default::default() }.build(&module)
        };
        Self {
            smooth: build("tone.ground", shader!("tone/ground"), GROUND_FORMAT),
            slopes: build("tone.slopes", shader!("tone/slopes"), SLOPES_FORMAT),
        }
    }

    /// Smooths over `smooth_px` samples; `None`, where nothing is hatched, costs nothing.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        view: &wgpu::Buffer,
        layers: &Layers,
        smooth_px: Option<f32>,
    ) -> Grounded {
        let Some(smooth_px) = smooth_px.filter(|px| *px > 0.0) else {
            return Grounded {
                slopes: frame.texture("tone.slopes", [1, 1], SLOPES_FORMAT),
                step: 1,
                far_px: 0.0,
            };
        };
        let step = if smooth_px < RADIUS * COARSEST { FINEST } else { COARSEST };
        let far_px = smooth_px.max(STEEPEST * step);
        let radius = (smooth_px * ROUND / step).ceil() as i32;
        let mut distances = frame.texture("tone.ground", [1, 1], GROUND_FORMAT);
        let (across, down) = (([1, 0], radius), ([0, 1], radius));
        for (axis, radius) in [([0, 0], 0), across, down, across, down] {
            let uniform = GroundUniform { axis, radius, step: step as i32, far_px, pad: [0.0; 3] };
            distances = self.smooth(frame, view, layers, &distances, uniform);
        }
        let slopes = frame.texture(
            "tone.slopes",
            [distances.texture().width(), distances.texture().height()],
            SLOPES_FORMAT,
        );
        let uniform = frame.uniform("tone.slopes.uniform", &SlopesUniform { step, far_px, pad: [0.0; 2] });
        frame.fullscreen(
            "tone.slopes",
            &self.slopes,
            Target::colour(&slopes, Some(wgpu::Color::TRANSPARENT)),
            &[
                view.as_entire_binding(),
                uniform.as_entire_binding(),
                wgpu::BindingResource::TextureView(&distances),
            ],
        );
        Grounded { slopes, step: step as u32, far_px: 2.0 * far_px }
    }

    fn smooth(
        &self,
        frame: &mut Frame<'_>,
        view: &wgpu::Buffer,
        layers: &Layers,
        before: &Transient,
        uniform: GroundUniform,
    ) -> Transient {
        let size = layers.size.map(|pixels| pixels.div_ceil(uniform.step as u32));
        let to = frame.texture("tone.ground", size, GROUND_FORMAT);
        let uniform = frame.uniform("tone.ground.uniform", &uniform);
        frame.fullscreen(
            "tone.ground",
            &self.smooth,
            Target::colour(&to, Some(wgpu::Color::TRANSPARENT)),
            &[
                view.as_entire_binding(),
                uniform.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.depth),
                wgpu::BindingResource::TextureView(before),
            ],
        );
        to
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(slopes_lie_as_their_twin: SlopesUniform, "Slopes" of "tone/slopes" { step, far_px });

    layout_test!(lies_as_its_twin: GroundUniform, "Ground" of "tone/ground" { axis, radius, step, far_px });
}
