//! Which triangles meet at an edge, for surfaces that throw shadows.

use super::Job;
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader};

/// The long-lived kernel.
#[derive(Debug)]
pub(super) struct Adjacent {
    pipeline: ComputePipeline,
}

impl Adjacent {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let [uniform, read, write] = [Slot::Uniform, Slot::Read, Slot::Write];
        let slots = [uniform, read, read, read, read, read, read, write];
        let [pipeline] = kernels(gpu, shader!("shapes/surface/adjacent"), &slots, ["main"]);
        Self { pipeline }
    }

    /// Fills the list `adjacent` for a mesh that has just been made.
    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>, adjacent: &wgpu::Buffer) {
        let Job { recipe, work, .. } = job;
        let bindings = [
            recipe,
            &work.lattice,
            &work.states,
            &work.active,
            &work.crossings,
            &work.polygons,
            &work.mesh_starts,
            adjacent,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("shapes.surface.adjacent", &self.pipeline, &bindings, &work.chunks);
    }
}
