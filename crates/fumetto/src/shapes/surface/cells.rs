//! What the surface is in each cell of the active blocks: its case, and how much comes of it.

use super::{Job, scan::Scan};
use crate::gpu::{Frame, Gpu, Slot, kernels, shader};

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
        let slots = [read, read, read, read, read, write, write, write];
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
        // Blocks that are not active this time count nothing.
        frame.encoder.clear_buffer(&work.vertex_counts, 0, None);
        frame.encoder.clear_buffer(&work.triangle_counts, 0, None);
        let bindings = [
            &work.lattice,
            &work.states,
            &work.active,
            &work.signs,
            &work.polygons,
            &work.cells,
            &work.vertex_counts,
            &work.triangle_counts,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("shapes.surface.cells", &self.cells, &bindings, &work.dispatch);
        let active = room.active;
        scan.record(frame, active, [&work.vertex_counts, &work.runs, &work.vertex_starts]);
        scan.record(frame, active, [&work.triangle_counts, &work.runs, &work.triangle_starts]);
    }
}
