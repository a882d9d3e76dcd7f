//! Vortices move.

use fumetto_scene::Force;

use super::{Span, Swirl, swirl::Source};
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups},
    particles::forces::forces_at,
};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Carry {
    predict: ComputePipeline,
    complete: ComputePipeline,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct CarryUniform {
    dt: f32,
    forces: u32,
    first: u32,
    count: u32,
    places: u32,
    circulation: f32,
    forming: f32,
    growth: f32,
    decay: f32,
    pad: [u32; 3],
}

/// What both halves of a step need.
pub(super) struct Uniforms {
    carry: wgpu::Buffer,
    forces: wgpu::Buffer,
}

impl Uniforms {
    /// What moves the vortices of `source` in a step.
    pub(super) fn new(
        frame: &Frame<'_>,
        swirl: &Swirl,
        source: &Source,
        forces: &[Force],
        span: Span,
    ) -> Self {
        let plan = &source.plan;
        let uniform = CarryUniform {
            dt: span.dt as f32,
            forces: forces.len() as u32,
            first: source.first,
            count: source.count,
            places: swirl.tree.places,
            circulation: plan.circulation,
            forming: plan.forming_secs,
            growth: plan.growth_m,
            decay: swirl.vortex.decay,
            pad: [0; 3],
        };
        Self {
            carry: frame.uniform("particles.vortex.carry.uniform", &uniform),
            // The same eddies of turbulence as the smoke of this emitter is in.
            forces: frame
                .storage("particles.vortex.forces", &forces_at(forces, source.seed, span.time as f32)),
        }
    }
}

impl Carry {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write, Slot::Write, Slot::Read, Slot::Read];
        let [predict, complete] =
            kernels(gpu, shader!("particles/vortex/carry"), &slots, ["predict", "complete"]);
        Self { predict, complete }
    }

    /// To the middle of the step, by the tree of its start.
    pub(super) fn predict(&self, frame: &mut Frame<'_>, swirl: &Swirl, source: &Source, uniforms: &Uniforms) {
        record(frame, "particles.vortex.predict", &self.predict, swirl, (source, uniforms));
    }

    /// To the end of the step, by the tree of its middle.
    pub(super) fn complete(
        &self,
        frame: &mut Frame<'_>,
        swirl: &Swirl,
        source: &Source,
        uniforms: &Uniforms,
    ) {
        record(frame, "particles.vortex.complete", &self.complete, swirl, (source, uniforms));
    }
}

fn record(
    frame: &mut Frame<'_>,
    label: &str,
    kernel: &wgpu::ComputePipeline,
    swirl: &Swirl,
    (source, uniforms): (&Source, &Uniforms),
) {
    let bindings = [
        &uniforms.carry,
        &uniforms.forces,
        &swirl.vortices,
        &swirl.halfway,
        &swirl.tree.leaves,
        &swirl.tree.nodes,
    ];
    let bindings = bindings.map(wgpu::Buffer::as_entire_binding);
    frame.compute(label, kernel, &bindings, workgroups(source.count));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: CarryUniform, "Carry" of "particles/vortex/carry" { dt, forces, first, count, places, circulation, forming, growth, decay });
}
