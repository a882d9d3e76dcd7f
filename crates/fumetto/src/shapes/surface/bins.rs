//! Which particles touch which block.

use super::{Job, scan::Scan};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, folded, kernels, shader};

/// Invocations that keep a device busy.
const BUSY: u32 = 1 << 14;

/// Invocations that share the blocks around one of `count` particles.
pub(super) fn sharers(count: u32) -> u32 {
    (BUSY / count.max(1)).next_power_of_two().clamp(1, 4096)
}

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Bins {
    count: ComputePipeline,
    scatter: ComputePipeline,
}

impl Bins {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Read, Slot::Write, Slot::Write, Slot::Write];
        let [count, scatter] = kernels(gpu, shader!("shapes/surface/bins"), &slots, ["count", "scatter"]);
        Self { count, scatter }
    }

    /// Fills the lists of all blocks, in any order.
    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>, scan: &Scan) {
        let Job { recipe, count, room, work, .. } = job;
        let bindings = [recipe, &work.lattice, &work.blobs, &work.tally, &work.starts, &work.entries]
            .map(wgpu::Buffer::as_entire_binding);
        // Few particles have many sharers, so this is far from what the numbers hold.
        let groups = folded((count * sharers(count)).div_ceil(64));
        frame.compute("shapes.surface.count", &self.count, &bindings, groups);
        scan.words_further(frame, room.blocks, [&work.tally, &work.runs, &work.starts]);
        frame.compute("shapes.surface.scatter", &self.scatter, &bindings, groups);
    }
}
