//! Which way the form bends most, where strokes run that way.

use super::ground::Grounded;
use crate::gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader};

/// Two numbers: see `turns.wgsl`.
const TURNS_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg16Float;

/// Texels that directions are averaged over to each side: patches of one direction are to be larger than
/// what the form was smoothed over.
const RADIUS: i32 = 6;

/// The same in samples, at most. Also counts for the margins of tiles.
pub(crate) const TURNS_PX: f32 = RADIUS as f32 * super::ground::COARSEST;

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Turns {
    pipeline: RenderPipeline,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct TurnsUniform {
    axis: [i32; 2],
    radius: i32,
    step: i32,
}

impl Turns {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("tone/turns"));
        let pipeline = RasterPipeline { label: "tone.turns", targets: &[TURNS_FORMAT], ..Default::default() };
        Self { pipeline: pipeline.build(&module) }
    }

    /// Works directions out; where nothing wants them (`is_wanted`), it costs nothing.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        view: &wgpu::Buffer,
        ground: &Grounded,
        is_wanted: bool,
    ) -> Transient {
        let mut turns = frame.texture("tone.turns", [1, 1], TURNS_FORMAT);
        if !is_wanted {
            return turns;
        }
        let texture = ground.slopes.texture();
        let size = [texture.width(), texture.height()];
        for (axis, radius) in [([0, 0], 0), ([1, 0], RADIUS), ([0, 1], RADIUS)] {
            let to = frame.texture("tone.turns", size, TURNS_FORMAT);
            let uniform = TurnsUniform { axis, radius, step: ground.step as i32 };
            let uniform = frame.uniform("tone.turns.uniform", &uniform);
            frame.fullscreen(
                "tone.turns",
                &self.pipeline,
                Target::colour(&to, Some(wgpu::Color::TRANSPARENT)),
                &[
                    view.as_entire_binding(),
                    uniform.as_entire_binding(),
                    wgpu::BindingResource::TextureView(&ground.slopes),
                    wgpu::BindingResource::TextureView(&turns),
                ],
            );
            turns = to;
        }
        turns
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: TurnsUniform, "Turns" of "tone/turns" { axis, radius, step });
}
