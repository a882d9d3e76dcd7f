//! What the surface is in each cell of the active blocks: its case, and how much comes of it.

use super::{Job, scan::Scan};
use crate::gpu::{Frame, Gpu, Slot, kernels, shader, workgroups};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Cells {
    signs: wgpu::ComputePipeline,
    cells: wgpu::ComputePipeline,
}

impl Cells {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let [uniform, read, write] = [Slot::Uniform, Slot::Read, Slot::Write];
        let slots = [uniform, read, read, read, read, read, write];
        let [signs] = kernels(gpu, shader!("shapes/surface/signs"), &slots, ["main"]);
        let slots = [uniform, read, read, read, read, read, write, write, write];
        let [cells] = kernels(gpu, shader!("shapes/surface/cells"), &slots, ["main"]);
        Self { signs, cells }
    }

    /// Samples the field, sorts cells into cases, and numbers vertices and triangles.
    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>, scan: &Scan) {
        let Job { recipe, room, work, .. } = job;
        let bindings =
            [recipe, &work.lattice, &work.blobs, &work.starts, &work.entries, &work.active, &work.signs]
                .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("shapes.surface.signs", &self.signs, &bindings, &work.dispatch);
        let bindings = [
            recipe,
            &work.lattice,
            &work.states,
            &work.active,
            &work.signs,
            &work.polygons,
            &work.crossings,
            &work.vertex_counts,
            &work.triangle_counts,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        let active = room.active;
        frame.compute("shapes.surface.cells", &self.cells, &bindings, workgroups(active));
        scan.record(frame, active, [&work.vertex_counts, &work.runs, &work.vertex_starts]);
        scan.record(frame, active, [&work.triangle_counts, &work.runs, &work.triangle_starts]);
    }
}
