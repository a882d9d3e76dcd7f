//! Brings the lists of blocks that have vertices into the order of particles.

use super::Job;
use crate::gpu::{Frame, Gpu, Slot, kernels, shader};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Lists {
    sort: wgpu::ComputePipeline,
    sort_long: wgpu::ComputePipeline,
}

impl Lists {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Read, Slot::Read, Slot::Read, Slot::Read, Slot::Write, Slot::Write];
        let [sort] = kernels(gpu, shader!("shapes/surface/sort"), &slots, ["main"]);
        let [sort_long] = kernels(gpu, shader!("shapes/surface/sort_long"), &slots[..5], ["main"]);
        Self { sort, sort_long }
    }

    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>) {
        let Job { work, .. } = job;
        let bindings =
            [&work.lattice, &work.starts, &work.active, &work.vertex_counts, &work.entries, &work.long]
                .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("shapes.surface.sort", &self.sort, &bindings, &work.dispatch);
        frame.compute_indirect("shapes.surface.sort_long", &self.sort_long, &bindings[..5], &work.long);
    }
}
