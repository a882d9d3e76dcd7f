//! Which blocks the surface can cross: only these do any further work.

use super::{Job, scan::Scan};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Blocks {
    classify: ComputePipeline,
    enlist: ComputePipeline,
    dispatch: ComputePipeline,
}

impl Blocks {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [
            Slot::Uniform,
            Slot::Read,
            Slot::Read,
            Slot::Read,
            Slot::Read,
            Slot::Write,
            Slot::Write,
            Slot::Read,
            Slot::Write,
        ];
        let [classify] = kernels(gpu, shader!("shapes/surface/blocks"), &slots, ["main"]);
        let [uniform, read, write] = [Slot::Uniform, Slot::Read, Slot::Write];
        let slots = [uniform, write, read, read, read, write, write];
        let [enlist] = kernels(gpu, shader!("shapes/surface/enlist"), &slots, ["main"]);
        let [dispatch] =
            kernels(gpu, shader!("shapes/surface/dispatch"), &[Slot::Read, Slot::Write], ["main"]);
        Self { classify, enlist, dispatch }
    }

    /// Tells of each block whether the surface may cross it.
    pub(super) fn classify(&self, frame: &mut Frame<'_>, job: Job<'_>) {
        let Job { recipe, room, work, .. } = job;
        let bindings = [
            recipe,
            &work.lattice,
            &work.blobs,
            &work.starts,
            &work.entries,
            &work.states,
            &work.crossed,
            &work.kept,
            &work.tally,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.classify", &self.classify, &bindings, workgroups(room.blocks));
    }

    /// Lists the active blocks in their own order.
    pub(super) fn list(&self, frame: &mut Frame<'_>, job: Job<'_>, scan: &Scan) {
        let Job { recipe, room, work, .. } = job;
        scan.words(frame, room.blocks, [&work.crossed, &work.runs, &work.slots]);
        let bindings =
            [recipe, &work.lattice, &work.crossed, &work.slots, &work.kept, &work.states, &work.active]
                .map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.enlist", &self.enlist, &bindings, workgroups(room.blocks));
        let bindings = [&work.lattice, &work.dispatch].map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.dispatch", &self.dispatch, &bindings, [1, 1, 1]);
    }
}
