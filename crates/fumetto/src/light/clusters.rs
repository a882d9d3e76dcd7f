//! Soft shadows: those of several lights close to each other add up (Heidmann, "Real shadows, real time", 1991).
//!
//! Each of them throws hard shadows by the same passes as a light that stands alone. What they keep away together is
//! a share of the light, in as many steps as there are lights.

use super::{LightsUniform, shadows::SHADOW_FORMAT};
use crate::{
    gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, linear_sampler, shader},
    layers::Layers,
};

/// Lights that stand in place of one.
#[derive(Debug)]
pub(crate) struct Cluster {
    /// Of the shadow layer.
    pub(super) channel: usize,
    /// Each alone, in the first channel.
    pub(super) members: Vec<LightsUniform>,
}

/// The long-lived pipeline.
#[derive(Debug)]
pub(crate) struct Clusters {
    pipeline: RenderPipeline,
    linear: wgpu::Sampler,
}

/// `Gathering` of `gather.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
struct GatheringUniform {
    soft: [f32; 4],
    channel: [f32; 4],
    size: [f32; 2],
    members: f32,
    pad: f32,
}

impl Clusters {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("light/gather"));
        let pipeline =
            RasterPipeline { label: "light.gather", targets: &[SHADOW_FORMAT], ..Default::default() };
        Self { pipeline: pipeline.build(&module), linear: linear_sampler(gpu) }
    }

    /// Adds to `shadow` what each of the clusters keeps away from what `layers` show; `cast` tells where lights throw
    /// hard shadows.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        layers: &Layers,
        clusters: &[Cluster],
        shadow: Transient,
        mut cast: impl FnMut(&mut Frame<'_>, &LightsUniform) -> Transient,
    ) -> Transient {
        let mut shadow = shadow;
        let mut soft = [0.0; 4];
        for Cluster { channel, members } in clusters {
            for member in members {
                let kept = cast(frame, member);
                let mut uniform = GatheringUniform {
                    soft,
                    channel: [0.0; 4],
                    size: layers.size.map(|side| side as f32),
                    members: members.len() as f32,
                    pad: 0.0,
                };
                uniform.channel[*channel] = 1.0;
                shadow = self.gather(frame, layers, &uniform, (&shadow, &kept));
                soft[*channel] = 1.0;
            }
        }
        shadow
    }

    fn gather(
        &self,
        frame: &mut Frame<'_>,
        layers: &Layers,
        uniform: &GatheringUniform,
        (known, kept): (&Transient, &Transient),
    ) -> Transient {
        let sum = frame.texture("light.shadow", layers.size, SHADOW_FORMAT);
        let uniform = frame.uniform("light.gathering", uniform);
        frame.fullscreen(
            "light.gather",
            &self.pipeline,
            Target::colour(&sum, Some(wgpu::Color::TRANSPARENT)),
            &[
                uniform.as_entire_binding(),
                wgpu::BindingResource::TextureView(known),
                wgpu::BindingResource::TextureView(kept),
                wgpu::BindingResource::Sampler(&self.linear),
            ],
        );
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: GatheringUniform, "Gathering" of "light/gather" { soft, channel, size, members });
}
