//! Which regions of the lattice particles touch: only these have blocks.

use super::{Job, bins::sharers, scan::Scan};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, folded, kernels, shader, workgroups};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Regions {
    mark: ComputePipeline,
    choose: ComputePipeline,
    keep: ComputePipeline,
}

impl Regions {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Write, Slot::Read, Slot::Write, Slot::Read, Slot::Write];
        let entries = ["mark", "choose", "keep"];
        let [mark, choose, keep] = kernels(gpu, shader!("shapes/surface/regions"), &slots, entries);
        Self { mark, choose, keep }
    }

    /// Settles the lattice, and fills its table.
    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>, scan: &Scan) {
        let Job { recipe, count, room, work, .. } = job;
        let bindings = [recipe, &work.lattice, &work.blobs, &work.marks, &work.ranks, &work.kept]
            .map(wgpu::Buffer::as_entire_binding);
        let groups = folded((count * sharers(count)).div_ceil(64));
        frame.compute("shapes.surface.mark", &self.mark, &bindings, groups);
        scan.words(frame, room.regions, [&work.marks, &work.runs, &work.ranks]);
        frame.compute("shapes.surface.choose", &self.choose, &bindings, [1, 1, 1]);
        frame.compute("shapes.surface.keep", &self.keep, &bindings, workgroups(room.regions));
    }
}
