//! Velocity, heat and smoke are carried along by the velocity.

use super::Moment;
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Advect {
    busy: ComputePipeline,
    /// For each axis.
    velocity: [Carrying; 3],
    guess_heat: ComputePipeline,
    correct_heat: ComputePipeline,
    feed: ComputePipeline,
}

/// What carries one component.
#[derive(Debug)]
struct Carrying {
    guess: ComputePipeline,
    find: ComputePipeline,
    keep: ComputePipeline,
}

impl Carrying {
    fn new(
        gpu: &Gpu,
        guess: wgpu::ShaderModuleDescriptor<'static>,
        correct: wgpu::ShaderModuleDescriptor<'static>,
    ) -> Self {
        let slots = [
            Slot::Uniform,
            Slot::Read,
            Slot::Read,
            Slot::Read,
            Slot::Read,
            Slot::Write,
            Slot::Write,
            Slot::Read,
        ];
        let [guess] = kernels(gpu, guess, &slots[..6], ["main"]);
        let [find, keep] = kernels(gpu, correct, &slots, ["find", "keep"]);
        Self { guess, find, keep }
    }
}

impl Advect {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write, Slot::Write];
        let [busy] = kernels(gpu, shader!("particles/grid/busy"), &slots, ["main"]);
        let slots = [
            Slot::Uniform,
            Slot::Read,
            Slot::Read,
            Slot::Read,
            Slot::Read,
            Slot::Write,
            Slot::Write,
            Slot::Read,
        ];
        let [guess_heat, correct_heat] =
            kernels(gpu, shader!("particles/grid/heat"), &slots, ["guess", "correct"]);
        let slots = [Slot::Uniform, Slot::Read, Slot::Write, Slot::Read, Slot::Write, Slot::Read];
        let [feed] = kernels(gpu, shader!("particles/grid/feed"), &slots, ["main"]);
        let velocity = [
            Carrying::new(gpu, shader!("particles/grid/guess_x"), shader!("particles/grid/correct_x")),
            Carrying::new(gpu, shader!("particles/grid/guess_y"), shader!("particles/grid/correct_y")),
            Carrying::new(gpu, shader!("particles/grid/guess_z"), shader!("particles/grid/correct_z")),
        ];
        Self { busy, velocity, guess_heat, correct_heat, feed }
    }

    /// Finds the busy blocks, then carries everything.
    pub(super) fn record(&self, frame: &mut Frame<'_>, moment: &Moment<'_>) {
        let air = moment.air;
        let bindings = [&moment.grid, &moment.sources, &air.smoky, &air.busy];
        frame.compute("particles.grid.busy", &self.busy, &super::entire(&bindings), [1, 1, 1]);
        let [u, v, w] = &air.velocity[moment.before];
        for (axis, carrying) in self.velocity.iter().enumerate() {
            let (field, carried) = (&air.velocity[moment.before][axis], &moment.velocity()[axis]);
            let bindings = [&moment.grid, u, v, w, field, carried, &air.fixed, &air.busy];
            let mut faces = air.plan.cells;
            faces[axis] += 1;
            Moment::over_all(frame, "particles.grid.guess", &carrying.guess, &bindings[..6], faces);
            // There is nothing to correct before the first step.
            if moment.uniform.begins == 0 {
                moment.over_busy(frame, "particles.grid.correct", &carrying.find, &bindings);
                moment.over_busy(frame, "particles.grid.keep", &carrying.keep, &bindings);
            }
        }
        self.carry_heat(frame, moment);
    }

    fn carry_heat(&self, frame: &mut Frame<'_>, moment: &Moment<'_>) {
        let air = moment.air;
        let [u, v, w] = &air.velocity[moment.before];
        let (field, carried) = (&air.heat[moment.before], moment.heat());
        // Where nothing is busy now something may have been.
        frame.encoder.clear_buffer(carried, 0, None);
        let bindings = [&moment.grid, u, v, w, field, carried, &air.fixed, &air.busy];
        moment.over_busy(frame, "particles.grid.guess_heat", &self.guess_heat, &bindings);
        moment.over_busy(frame, "particles.grid.correct_heat", &self.correct_heat, &bindings);
        let bindings = [&moment.grid, &air.fixed, carried, &moment.sources, &air.smoky, &air.busy];
        moment.over_busy(frame, "particles.grid.feed", &self.feed, &bindings);
    }
}
