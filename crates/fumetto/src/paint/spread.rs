//! How volumes move, step by step.

use super::{PaintScene, cells::Pouring, group::Group, stains::Touching};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, folded, kernels, shader, workgroups};

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Spreading {
    pouring: Pouring,
    touching: Touching,
    spread: ComputePipeline,
    run: ComputePipeline,
    measure: ComputePipeline,
}

impl Spreading {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        use Slot::{Read, Uniform, Write};
        let slots = [Uniform, Read, Read, Write, Write, Write, Uniform, Read, Read];
        let [spread, run] = kernels(gpu, shader!("paint/spread"), &slots, ["spread", "run"]);
        let [measure] = kernels(gpu, shader!("paint/measure"), &[Read, Write], ["main"]);
        Self { pouring: Pouring::new(gpu), touching: Touching::new(gpu), spread, run, measure }
    }

    /// Advances by the step from `step · dt` to `(step + 1) · dt`.
    pub(crate) fn step(&self, frame: &mut Frame<'_>, paints: &PaintScene, step: u64, dt: f64) {
        let secs = [step as f64 * dt, (step + 1) as f64 * dt];
        for grid in &paints.grids {
            self.pouring.step(frame, grid, secs);
        }
        for stains in &paints.stains {
            self.touching.step(frame, stains, &paints.ground, (step, dt));
        }
        for group in &paints.groups {
            let orders = group.orders(frame, secs);
            self.advance(frame, paints, group, &orders);
        }
    }

    fn advance(&self, frame: &mut Frame<'_>, paints: &PaintScene, group: &Group, orders: &wgpu::Buffer) {
        let uniform = frame.uniform("paint.group", &group.uniform);
        let PaintScene { ground, directions, vertices, runs, bodies, .. } = paints;
        let place = frame.uniform("paint.ground", &ground.uniform);
        let bindings =
            [&uniform, orders, directions, vertices, runs, bodies, &place, &ground.cells, &ground.corners];
        let bindings = bindings.map(wgpu::Buffer::as_entire_binding);
        frame.compute("paint.spread", &self.spread, &bindings, workgroups(group.vertices()));
        frame.compute("paint.run", &self.run, &bindings, workgroups(group.uniform.volumes));
    }

    /// Works out how far volumes reach at the moment.
    pub(crate) fn measure(&self, frame: &mut Frame<'_>, paints: &PaintScene) {
        if !paints.is_empty() {
            let bindings = [&paints.vertices, &paints.bodies].map(wgpu::Buffer::as_entire_binding);
            frame.compute("paint.measure", &self.measure, &bindings, folded(paints.body_count));
        }
    }
}
