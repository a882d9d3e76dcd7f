//! Lists the faces of shadow volumes: of models, whose edges are known, and of surfaces that the device makes.

use wgpu::util::DeviceExt as _;

use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups},
    shapes::{
        mesh::{Casters, Reserved},
        puffs::Subject,
    },
};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Extrude {
    /// For models: caps, then sides.
    models: [ComputePipeline; 2],
    /// For surfaces that the device makes.
    closed: [ComputePipeline; 2],
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct VolumesUniform {
    light: u32,
    triangles: u32,
    edges: u32,
    side_vertices: u32,
}

/// One light's volumes.
pub(super) struct Extruded<'a> {
    pub(super) casters: &'a Casters,
    /// `Volumes` of `volumes.wgsl`.
    pub(super) uniform: wgpu::Buffer,
    /// Arguments of three draws: of the caps whose lit side is seen, of the others, of the sides.
    pub(super) draws: wgpu::Buffer,
}

impl Extrude {
    pub(super) fn new(gpu: &Gpu) -> Self {
        use Slot::{Read, Uniform, Write};
        let slots = [Uniform, Uniform, Uniform, Read, Read, Read, Read, Write, Write, Write, Write];
        let entries = ["list_caps", "list_sides"];
        Self {
            models: kernels(gpu, shader!("light/extrude"), &slots, entries),
            closed: kernels(gpu, shader!("light/extrude_closed"), &slots, entries),
        }
    }

    /// Lists the faces of all volumes that `casters` keep from a light.
    pub(super) fn record<'a>(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        casters: &'a Casters,
        light: u32,
        is_point: bool,
    ) -> Extruded<'a> {
        let Casters { triangle_count: triangles, edge_count: edges, .. } = *casters;
        let uniform = VolumesUniform { light, triangles, edges, side_vertices: if is_point { 6 } else { 3 } };
        let draws = [[0, 1, 0, 0], [0, 1, 3 * casters.cap_count, 0], [0, 1, 0, 0]];
        let extruded = Extruded {
            casters,
            uniform: frame.uniform("light.volumes.uniform", &uniform),
            draws: frame.gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("light.volumes.draws"),
                contents: bytemuck::cast_slice(&draws),
                usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::INDIRECT,
            }),
        };
        if edges > 0 {
            let of_models = [&casters.casting, &casters.edges];
            self.list(frame, subject, &extruded, (&self.models, of_models), [triangles, edges]);
        }
        for (surface, adjacent) in subject.meshes.reserved.iter().filter_map(casting) {
            let most = surface.triangles.len() as u32;
            let of_surface = [adjacent, &surface.counters];
            self.list(frame, subject, &extruded, (&self.closed, of_surface), [most, most]);
        }
        extruded
    }

    /// Adds the faces of at most `[caps, sides]` volumes.
    fn list(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        extruded: &Extruded<'_>,
        ([list_caps, list_sides], own): (&[ComputePipeline; 2], [&wgpu::Buffer; 2]),
        [caps, sides]: [u32; 2],
    ) {
        let Extruded { casters, uniform, draws } = extruded;
        let bindings = [
            subject.view,
            subject.lights,
            uniform,
            &subject.meshes.vertices,
            &subject.meshes.triangles,
            own[0],
            own[1],
            &casters.facings,
            &casters.caps,
            &casters.sides,
            draws,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        frame.compute("light.extrude.caps", list_caps, &bindings, workgroups(caps));
        frame.compute("light.extrude.sides", list_sides, &bindings, workgroups(sides));
    }
}

/// A surface that throws shadows, and which triangles lie beyond its triangles' edges.
fn casting(surface: &Reserved) -> Option<(&Reserved, &wgpu::Buffer)> {
    surface.adjacent.as_ref().map(|adjacent| (surface, adjacent))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: VolumesUniform, "Volumes" of "light/cap" { light, triangles, edges, side_vertices });
}
