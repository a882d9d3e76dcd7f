//! Writes the mesh: vertices on lattice edges, triangles in cells.

use super::buffers::{SurfaceMesh, Workspace};
use crate::gpu::{Frame, Gpu, Slot, kernels, shader};

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

    pub(super) fn record(
        &self,
        frame: &mut Frame<'_>,
        recipe: &wgpu::Buffer,
        work: &Workspace,
        mesh: &SurfaceMesh,
    ) {
        let bindings = [
            recipe,
            &work.lattice,
            &work.blobs,
            &work.starts,
            &work.entries,
            &work.active,
            &work.cells,
            &work.vertex_starts,
            &mesh.vertices,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("shapes.surface.vertices", &self.vertices, &bindings, &work.dispatch);
        let bindings = [
            recipe,
            &work.lattice,
            &work.states,
            &work.active,
            &work.cells,
            &work.polygons,
            &work.vertex_starts,
            &work.triangle_starts,
            &mesh.triangles,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("shapes.surface.triangles", &self.triangles, &bindings, &work.dispatch);
        let bindings = [recipe, &work.lattice, &work.vertex_starts, &work.triangle_starts, &mesh.counters]
            .map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.surface.counters", &self.counters, &bindings, [1, 1, 1]);
    }
}
