//! Rings are born.

use glam::{Vec3, Vec4};

use super::{Span, Swirl, swirl::Source};
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups},
    particles::{
        births::{Timetable, births_between},
        emission::shape_uniform,
    },
};

/// The long-lived kernel.
#[derive(Debug)]
pub(super) struct Rings {
    main: ComputePipeline,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct RingsUniform {
    dt: f32,
    seed: u32,
    first: u32,
    capacity: u32,
    segments: u32,
    first_birth: u32,
    births: u32,
    burst: u32,
    circulation: f32,
    life: f32,
    radius: f32,
    core: f32,
    wobble: f32,
    shape: u32,
    outward: f32,
    speed: f32,
    center: Vec4,
    extent: Vec4,
    axis: Vec4,
}

impl Rings {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let [main] = kernels(gpu, shader!("particles/vortex/rings"), &[Slot::Uniform, Slot::Write], ["main"]);
        Self { main }
    }

    /// The rings that `source` sheds in a step.
    pub(super) fn record(&self, frame: &mut Frame<'_>, swirl: &Swirl, source: &Source, span: Span) {
        let plan = &source.plan;
        let timetable = Timetable { rate: plan.rate, active: plan.active, bursts: &plan.bursts };
        let births = births_between(timetable, span.time, span.time + span.dt);
        if births.count == 0 {
            return;
        }
        let (shape, center, extent, _) = shape_uniform(source.emitter.shape);
        let mouth = source.emitter.mouth();
        let uniform = RingsUniform {
            dt: span.dt as f32,
            seed: source.seed,
            first: source.first,
            capacity: plan.capacity as u32,
            segments: swirl.vortex.segments,
            // Only the place in the ring and the random numbers come of it: both may wrap.
            first_birth: births.first as u32,
            births: births.count as u32,
            burst: births.burst as u32,
            circulation: if plan.forming_secs > 0.0 { 0.0 } else { plan.circulation },
            life: plan.life_secs,
            radius: plan.radius,
            core: swirl.vortex.core * plan.radius,
            wobble: plan.wobble,
            shape,
            outward: mouth.outward,
            speed: mouth.speed,
            center,
            extent,
            axis: Vec3::from(mouth.axis).extend(0.0),
        };
        let uniform = frame.uniform("particles.vortex.rings.uniform", &uniform);
        let bindings = [uniform.as_entire_binding(), swirl.vortices.as_entire_binding()];
        frame.compute("particles.vortex.rings", &self.main, &bindings, workgroups(source.count));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: RingsUniform, "Rings" of "particles/vortex/rings" { dt, seed, first, capacity, segments, first_birth, births, burst, circulation, life, radius, core, wobble, shape, outward, speed, center, extent, axis });
}
