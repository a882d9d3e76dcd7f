//! What accelerates the air: forces, heat, emitters, and vorticity confinement.

use super::Moment;
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Pushes {
    push: ComputePipeline,
    curl: ComputePipeline,
    confine: ComputePipeline,
}

impl Pushes {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let (uniform, read, write) = (Slot::Uniform, Slot::Read, Slot::Write);
        let slots = [uniform, read, read, read, read, read, read, write, read];
        let [push] = kernels(gpu, shader!("particles/grid/push"), &slots, ["main"]);
        let slots = [uniform, read, read, read, write, read];
        let [curl] = kernels(gpu, shader!("particles/grid/curl"), &slots, ["main"]);
        let slots = [uniform, read, write, read];
        let [confine] = kernels(gpu, shader!("particles/grid/confine"), &slots, ["main"]);
        Self { push, curl, confine }
    }

    pub(super) fn record(&self, frame: &mut Frame<'_>, moment: &Moment<'_>) {
        let (air, [u, v, w]) = (moment.air, moment.velocity());
        frame.encoder.clear_buffer(&air.push, 0, None);
        let bindings =
            [&moment.grid, u, v, w, moment.heat(), &moment.forces, &moment.sources, &air.push, &air.busy];
        moment.over_busy(frame, "particles.grid.push", &self.push, &bindings);
        if moment.uniform.confinement > 0.0 {
            // Neighbours that are not busy turn nothing.
            frame.encoder.clear_buffer(&air.spin, 0, None);
            let bindings = [&moment.grid, u, v, w, &air.spin, &air.busy];
            moment.over_busy(frame, "particles.grid.curl", &self.curl, &bindings);
            let bindings = [&moment.grid, &air.spin, &air.push, &air.busy];
            moment.over_busy(frame, "particles.grid.confine", &self.confine, &bindings);
        }
    }
}
