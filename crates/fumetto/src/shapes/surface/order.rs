//! Brings particles that lie near each other together in memory, where there are very many.

use super::{Job, scan::Scan};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, folded, kernels, shader};

/// Fewer stay in a processor's caches in any order: they take a megabyte.
const MANY: u32 = 1 << 15;
/// Buckets of `order.wgsl`.
pub(super) const BUCKETS: u32 = 16 * 16 * 16;

/// Whether so many particles are brought in order.
pub(super) const fn are_many(count: u32) -> bool {
    count > MANY
}

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Order {
    count: ComputePipeline,
    settle: ComputePipeline,
}

impl Order {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Read, Slot::Write, Slot::Read, Slot::Write];
        let [count, settle] = kernels(gpu, shader!("shapes/surface/order"), &slots, ["count", "settle"]);
        Self { count, settle }
    }

    /// Moves the blobs from where `bounds.wgsl` left them.
    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>, scan: &Scan) {
        let Job { recipe, count, work, .. } = job;
        let bindings =
            [recipe, &work.lattice, &work.loose, &work.bucket_tally, &work.bucket_starts, &work.blobs]
                .map(wgpu::Buffer::as_entire_binding);
        let groups = folded(count.div_ceil(64));
        frame.compute("shapes.surface.order.count", &self.count, &bindings, groups);
        scan.words(frame, BUCKETS, [&work.bucket_tally, &work.runs, &work.bucket_starts]);
        frame.compute("shapes.surface.order.settle", &self.settle, &bindings, groups);
    }
}
