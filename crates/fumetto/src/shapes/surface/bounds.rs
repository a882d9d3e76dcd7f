//! Puffs become blobs, and the lattice is laid around them.

use super::Job;
use crate::gpu::{Frame, Gpu, Slot, kernels, shader, workgroups};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Bounds {
    weigh: wgpu::ComputePipeline,
    fit: wgpu::ComputePipeline,
}

impl Bounds {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write, Slot::Write, Slot::Write];
        let [weigh, fit] = kernels(gpu, shader!("shapes/surface/bounds"), &slots, ["weigh", "fit"]);
        Self { weigh, fit }
    }

    /// Settles the blobs and the lattice.
    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>, puffs: &wgpu::Buffer) {
        let Job { recipe, count, work, .. } = job;
        let bindings =
            [recipe, puffs, &work.blobs, &work.shares, &work.lattice].map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.weigh", &self.weigh, &bindings, workgroups(count));
        frame.compute("shapes.surface.fit", &self.fit, &bindings, [1, 1, 1]);
    }
}
