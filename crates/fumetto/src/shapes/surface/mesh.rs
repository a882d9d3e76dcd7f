//! Counts the mesh, and writes it: vertices on lattice edges, triangles in cells.

use super::{Job, noisy::Noisy};
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader},
    shapes::mesh::Reserved,
};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Meshing {
    counters: ComputePipeline,
    vertices: Noisy,
    careful: Noisy,
    triangles: ComputePipeline,
}

impl Meshing {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let [uniform, read, write] = [Slot::Uniform, Slot::Read, Slot::Write];
        let slots = [uniform, read, read, write, write, write];
        let [counters] = kernels(gpu, shader!("shapes/surface/counters"), &slots, ["main"]);
        let slots = [uniform, read, read, read, read, read, read, write, write];
        let vertices = Noisy::new(gpu, &shader!("shapes/surface/vertices"), &slots);
        let slots = [uniform, read, read, read, read, read, read, read, write];
        let careful = Noisy::new(gpu, &shader!("shapes/surface/careful"), &slots);
        let slots = [uniform, read, read, read, read, read, read, write];
        let [triangles] = kernels(gpu, shader!("shapes/surface/triangles"), &slots, ["main"]);
        Self { counters, vertices, careful, triangles }
    }

    /// Tells how large the mesh becomes.
    pub(super) fn count(&self, frame: &mut Frame<'_>, job: Job<'_>, mesh: &Reserved) {
        let Job { recipe, work, .. } = job;
        let bindings = [recipe, &work.lattice, &work.mesh_starts, &mesh.counters, &work.chunks, &work.hard]
            .map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.counters", &self.counters, &bindings, [1, 1, 1]);
    }

    /// Writes the vertices.
    pub(super) fn vertices(&self, frame: &mut Frame<'_>, job: Job<'_>, mesh: &Reserved) {
        let Job { recipe, noisy, work, .. } = job;
        let bindings = [
            recipe.as_entire_binding(),
            work.lattice.as_entire_binding(),
            work.blobs.as_entire_binding(),
            work.entries.as_entire_binding(),
            work.active.as_entire_binding(),
            work.crossings.as_entire_binding(),
            work.mesh_starts.as_entire_binding(),
            work.hard.as_entire_binding(),
            mesh.vertices(),
        ];
        frame.compute_indirect("shapes.surface.vertices", self.vertices.get(noisy), &bindings, &work.chunks);
        frame.compute_indirect("shapes.surface.careful", self.careful.get(noisy), &bindings, &work.hard);
    }

    /// Writes the triangles.
    pub(super) fn triangles(&self, frame: &mut Frame<'_>, job: Job<'_>, mesh: &Reserved) {
        let Job { recipe, work, .. } = job;
        let bindings = [
            recipe.as_entire_binding(),
            work.lattice.as_entire_binding(),
            work.states.as_entire_binding(),
            work.active.as_entire_binding(),
            work.crossings.as_entire_binding(),
            work.polygons.as_entire_binding(),
            work.mesh_starts.as_entire_binding(),
            mesh.triangles(),
        ];
        frame.compute_indirect("shapes.surface.triangles", &self.triangles, &bindings, &work.chunks);
    }
}
