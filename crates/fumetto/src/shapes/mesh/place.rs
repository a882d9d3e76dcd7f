//! Takes models' vertices to where their parts stand.

use super::MeshScene;
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups};

/// The long-lived kernel.
#[derive(Debug)]
pub(crate) struct Place {
    pipeline: ComputePipeline,
}

impl Place {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Read, Slot::Read, Slot::Write];
        let [pipeline] = kernels(gpu, shader!("shapes/mesh/place"), &slots, ["main"]);
        Self { pipeline }
    }

    /// Brings the vertices to where the parts now are.
    pub(crate) fn record(&self, frame: &mut Frame<'_>, meshes: &MeshScene) {
        if meshes.source_count == 0 {
            return;
        }
        frame.compute(
            "shapes.mesh.place",
            &self.pipeline,
            &[
                meshes.sources.as_entire_binding(),
                meshes.parts.as_entire_binding(),
                meshes.vertices.as_entire_binding(),
            ],
            workgroups(meshes.source_count),
        );
    }
}
