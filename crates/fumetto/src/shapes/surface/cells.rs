//! What the surface is in each cell of the active blocks: its case, and how much comes of it.

use super::{Job, noisy::Noisy, scan::Scan};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Cells {
    signs: Noisy,
    cells: ComputePipeline,
}

impl Cells {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let [uniform, read, write] = [Slot::Uniform, Slot::Read, Slot::Write];
        let slots = [uniform, read, read, read, read, read, write];
        let signs = Noisy::new(gpu, &shader!("shapes/surface/signs"), &slots);
        let slots = [uniform, read, read, read, read, read, write, write, read];
        let [cells] = kernels(gpu, shader!("shapes/surface/cells"), &slots, ["main"]);
        Self { signs, cells }
    }

    /// Samples the field.
    pub(super) fn signs(&self, frame: &mut Frame<'_>, job: Job<'_>) {
        let Job { recipe, noisy, work, .. } = job;
        let bindings =
            [recipe, &work.lattice, &work.blobs, &work.starts, &work.entries, &work.active, &work.signs]
                .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("shapes.surface.signs", self.signs.get(noisy), &bindings, &work.dispatch);
    }

    /// Sorts cells into cases, and numbers vertices and triangles.
    pub(super) fn sort(&self, frame: &mut Frame<'_>, job: Job<'_>, scan: &Scan) {
        let Job { recipe, room, work, .. } = job;
        let bindings = [
            recipe,
            &work.lattice,
            &work.states,
            &work.active,
            &work.signs,
            &work.polygons,
            &work.crossings,
            &work.mesh_counts,
            &work.starts,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        let active = room.active;
        frame.compute("shapes.surface.cells", &self.cells, &bindings, workgroups(active));
        scan.fours(frame, active, [&work.mesh_counts, &work.mesh_runs, &work.mesh_starts]);
    }
}
