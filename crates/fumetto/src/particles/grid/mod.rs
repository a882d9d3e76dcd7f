//! Air in a box of cells, which smoke heats and pushes and which carries it: incompressible flow on a staggered
//! grid.
//!
//! ```text
//! busy blocks ─▶ velocity and heat are carried ─▶ forces, heat, eddies push ─▶ pressure ─▶ air without divergence
//!                                                                                 └─▶ the smoke's step
//! ```

mod advect;
mod air;
mod eddies;
mod pressure;
mod pushes;
mod solids;
mod sources;
mod stages;
mod voxels;

use fumetto_scene::Force;

pub(crate) use air::Air;
pub use stages::AirTimes;
pub use voxels::TooManyFacets;
pub(crate) use voxels::{Facet, Voxels};

use self::{
    advect::Advect, air::GridUniform, eddies::Stir, pressure::Pressure, pushes::Pushes, solids::Hold,
};
use super::{Emission, vortex::Span};
use crate::gpu::{Frame, Gpu};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Flow {
    advect: Advect,
    pushes: Pushes,
    stir: Stir,
    pressure: Pressure,
    hold: Hold,
}

/// What every pass of a sub-step needs.
struct Moment<'a> {
    air: &'a Air,
    /// Which of the two velocities and heats is that before the sub-step.
    before: usize,
    uniform: GridUniform,
    grid: wgpu::Buffer,
    sources: wgpu::Buffer,
    forces: wgpu::Buffer,
}

impl Flow {
    pub(super) fn new(gpu: &Gpu) -> Self {
        Self {
            advect: Advect::new(gpu),
            pushes: Pushes::new(gpu),
            stir: Stir::new(gpu),
            pressure: Pressure::new(gpu),
            hold: Hold::new(gpu),
        }
    }

    /// Advances the air by the `number`-th sub-step, counted from the start.
    pub(super) fn step(
        &self,
        frame: &mut Frame<'_>,
        air: &Air,
        emissions: &[Emission],
        (forces, seed): (&[Force], u32),
        (number, span): (u64, Span),
    ) {
        let moment = Moment::new(frame, air, (forces, seed), (number, span));
        self.advect.record(frame, &moment);
        self.pushes.record(frame, &moment);
        self.stir.record(frame, &moment, emissions);
        self.hold.record(frame, &moment);
        self.pressure.record(frame, &moment);
        self.hold.record(frame, &moment);
    }
}

impl Moment<'_> {
    /// Velocity after the sub-step.
    fn velocity(&self) -> &[wgpu::Buffer; 3] {
        &self.air.velocity[1 - self.before]
    }

    fn heat(&self) -> &wgpu::Buffer {
        &self.air.heat[1 - self.before]
    }

    /// Runs a kernel over the busy blocks.
    fn over_busy(
        &self,
        frame: &mut Frame<'_>,
        label: &str,
        kernel: &wgpu::ComputePipeline,
        bindings: &[&wgpu::Buffer],
    ) {
        frame.compute_indirect(label, kernel, &entire(bindings), &self.air.busy);
    }

    /// Runs a kernel over all places of a list of this extent.
    fn over_all(
        frame: &mut Frame<'_>,
        label: &str,
        kernel: &wgpu::ComputePipeline,
        bindings: &[&wgpu::Buffer],
        extent: [u32; 3],
    ) {
        frame.compute(label, kernel, &entire(bindings), tiles(extent));
    }
}

fn entire<'b>(buffers: &[&'b wgpu::Buffer]) -> Vec<wgpu::BindingResource<'b>> {
    buffers.iter().map(|buffer| buffer.as_entire_binding()).collect()
}

/// Workgroups of 32 × 4 × 2: rows of neighbours, which lie side by side in memory.
fn tiles(extent: [u32; 3]) -> [u32; 3] {
    [extent[0].div_ceil(32), extent[1].div_ceil(4), extent[2].div_ceil(2)]
}

#[cfg(test)]
mod tests;
