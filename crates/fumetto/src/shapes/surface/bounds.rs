//! Puffs become blobs, and the lattice is laid around them.

use super::{Job, order::are_many};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, folded, kernels, shader};

/// Particles that one workgroup of `bounds.wgsl` weighs.
pub(super) const STRETCH: u32 = 1024;

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Bounds {
    weigh: ComputePipeline,
    fit: ComputePipeline,
}

impl Bounds {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write, Slot::Write, Slot::Write];
        let [weigh, fit] = kernels(gpu, shader!("shapes/surface/bounds"), &slots, ["weigh", "fit"]);
        Self { weigh, fit }
    }

    /// Settles the blobs, and the lattice. Very many are not in order yet.
    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>, puffs: &wgpu::Buffer) {
        let Job { recipe, count, work, .. } = job;
        let blobs = if are_many(count) { &work.loose } else { &work.blobs };
        let bindings =
            [recipe, puffs, blobs, &work.shares, &work.lattice].map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.weigh", &self.weigh, &bindings, folded(count.div_ceil(STRETCH)));
        frame.compute("shapes.surface.fit", &self.fit, &bindings, [1, 1, 1]);
    }
}
