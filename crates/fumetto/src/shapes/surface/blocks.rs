//! Which blocks the surface can cross: only these do any further work.

use super::{Job, scan::Scan};
use crate::gpu::{Frame, Gpu, Slot, kernels, shader, workgroups};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Blocks {
    classify: wgpu::ComputePipeline,
    enlist: wgpu::ComputePipeline,
    dispatch: wgpu::ComputePipeline,
    sort: wgpu::ComputePipeline,
    sort_long: wgpu::ComputePipeline,
}

impl Blocks {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [
            Slot::Uniform,
            Slot::Write,
            Slot::Read,
            Slot::Read,
            Slot::Read,
            Slot::Write,
            Slot::Write,
            Slot::Read,
            Slot::Write,
        ];
        let [classify, enlist] =
            kernels(gpu, shader!("shapes/surface/blocks"), &slots, ["classify", "enlist"]);
        let [dispatch] = kernels(
            gpu,
            shader!("shapes/surface/dispatch"),
            &[Slot::Read, Slot::Write, Slot::Write],
            ["main"],
        );
        let slots = [Slot::Read, Slot::Read, Slot::Read, Slot::Write, Slot::Write];
        let [sort] = kernels(gpu, shader!("shapes/surface/sort"), &slots, ["main"]);
        let [sort_long] = kernels(gpu, shader!("shapes/surface/sort_long"), &slots[..4], ["main"]);
        Self { classify, enlist, dispatch, sort, sort_long }
    }

    /// Lists the active blocks in their own order, and sorts the particles on their lists.
    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>, scan: &Scan) {
        let Job { recipe, room, work, .. } = job;
        let all = workgroups(room.blocks);
        let bindings = [
            recipe,
            &work.lattice,
            &work.blobs,
            &work.starts,
            &work.entries,
            &work.states,
            &work.crossed,
            &work.slots,
            &work.active,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.classify", &self.classify, &bindings, all);
        scan.record(frame, room.blocks, [&work.crossed, &work.runs, &work.slots]);
        frame.compute("shapes.surface.enlist", &self.enlist, &bindings, all);
        let bindings = [&work.lattice, &work.dispatch, &work.long].map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.dispatch", &self.dispatch, &bindings, [1, 1, 1]);
        let bindings = [&work.lattice, &work.starts, &work.active, &work.entries, &work.long]
            .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("shapes.surface.sort", &self.sort, &bindings, &work.dispatch);
        frame.compute_indirect("shapes.surface.sort_long", &self.sort_long, &bindings[..4], &work.long);
    }
}
