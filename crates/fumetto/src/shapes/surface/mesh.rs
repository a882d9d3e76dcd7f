//! Writes the mesh: vertices on lattice edges, triangles in cells.

use super::Job;
use crate::{
    gpu::{Frame, Gpu, Slot, kernels, shader},
    shapes::mesh::Reserved,
};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Meshing {
    vertices: wgpu::ComputePipeline,
    triangles: wgpu::ComputePipeline,
    counters: wgpu::ComputePipeline,
}

impl Meshing {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let [uniform, read, write] = [Slot::Uniform, Slot::Read, Slot::Write];
        let slots = [uniform, read, read, read, read, read, read, read, write];
        let [vertices] = kernels(gpu, shader!("shapes/surface/vertices"), &slots, ["main"]);
        let [triangles] = kernels(gpu, shader!("shapes/surface/triangles"), &slots, ["main"]);
        let slots = [uniform, read, read, read, write];
        let [counters] = kernels(gpu, shader!("shapes/surface/counters"), &slots, ["main"]);
        Self { vertices, triangles, counters }
    }

    pub(super) fn record(&self, frame: &mut Frame<'_>, job: Job<'_>, mesh: &Reserved) {
        let Job { recipe, work, .. } = job;
        let bindings = [
            recipe.as_entire_binding(),
            work.lattice.as_entire_binding(),
            work.blobs.as_entire_binding(),
            work.starts.as_entire_binding(),
            work.entries.as_entire_binding(),
            work.active.as_entire_binding(),
            work.crossings.as_entire_binding(),
            work.vertex_starts.as_entire_binding(),
            mesh.vertices(),
        ];
        frame.compute_indirect("shapes.surface.vertices", &self.vertices, &bindings, &work.dispatch);
        let bindings = [
            recipe.as_entire_binding(),
            work.lattice.as_entire_binding(),
            work.states.as_entire_binding(),
            work.active.as_entire_binding(),
            work.crossings.as_entire_binding(),
            work.polygons.as_entire_binding(),
            work.vertex_starts.as_entire_binding(),
            work.triangle_starts.as_entire_binding(),
            mesh.triangles(),
        ];
        frame.compute_indirect("shapes.surface.triangles", &self.triangles, &bindings, &work.dispatch);
        let bindings = [recipe, &work.lattice, &work.vertex_starts, &work.triangle_starts, &mesh.counters]
            .map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.counters", &self.counters, &bindings, [1, 1, 1]);
    }
}
