//! Room in the lists of triangles for those that the device makes and counts itself.

use std::ops::Range;

use super::{
    VERTEX_BYTES,
    edge_scene::ContourScene,
    geometry::Triangle,
    scene::{MeshError, room},
};
use crate::gpu::Gpu;

/// Records whose bytes make up what a binding's offset must be a multiple of.
const ALIGNED: u32 = 16;

/// Bytes of a triangle's neighbours: three numbers.
const ADJACENT_BYTES: usize = 12;

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reservation {
    pub(super) object: usize,
    pub(super) part: u32,
    pub(super) vertices: u32,
    pub(super) triangles: u32,
    /// Whether lines run through its triangles.
    pub(super) has_lines: bool,
}

/// Places in the lists of a [`super::MeshScene`].
#[derive(Debug)]
pub(crate) struct Reserved {
    /// Number of the object that it is for.
    pub(crate) object: usize,
    /// Number that its triangles carry.
    pub(crate) part: u32,
    pub(crate) vertices: Range<u32>,
    pub(crate) triangles: Range<u32>,
    /// `Counters` of `counters.wgsl`: begins with the arguments of an indirect draw.
    pub(crate) counters: wgpu::Buffer,
    /// Three numbers for each triangle, where they throw shadows: of those beyond its edges, counted from the
    /// first here.
    pub(crate) adjacent: Option<wgpu::Buffer>,
    /// Where lines may run.
    pub(crate) contours: Option<ContourScene>,
    vertex_list: wgpu::Buffer,
    triangle_list: wgpu::Buffer,
}

/// The places after the first `vertices` and `triangles`, and how long the lists become with them.
pub(super) fn places(
    reservations: &[Reservation],
    [mut vertices, mut triangles]: [u64; 2],
) -> (Vec<[u64; 2]>, [u64; 2]) {
    let places = reservations.iter().map(|reservation| {
        let firsts = [vertices, triangles].map(|end| end.next_multiple_of(u64::from(ALIGNED)));
        [vertices, triangles] =
            [firsts[0] + u64::from(reservation.vertices), firsts[1] + u64::from(reservation.triangles)];
        firsts
    });
    (places.collect(), [vertices, triangles])
}

impl Reserved {
    /// Room that begins at these numbers of the lists.
    pub(super) fn new(
        gpu: &Gpu,
        reservation: &Reservation,
        [vertex, triangle]: [u32; 2],
        [vertex_list, triangle_list]: [&wgpu::Buffer; 2],
    ) -> Self {
        Self {
            object: reservation.object,
            part: reservation.part,
            vertices: vertex..vertex + reservation.vertices,
            triangles: triangle..triangle + reservation.triangles,
            counters: gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("shapes.mesh.counters"),
                size: 32,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::INDIRECT
                    | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            }),
            adjacent: None,
            contours: reservation.has_lines.then(|| ContourScene::new(gpu, reservation.triangles)),
            vertex_list: vertex_list.clone(),
            triangle_list: triangle_list.clone(),
        }
    }

    /// Makes it throw shadows.
    pub(super) fn make_caster(&mut self, gpu: &Gpu) -> Result<(), MeshError> {
        let asked = room(gpu, "neighbours of triangles", self.triangles.len() as u64, ADJACENT_BYTES)?;
        self.adjacent = Some(gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("shapes.mesh.adjacent"),
            size: asked,
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        }));
        Ok(())
    }

    /// Its `Vertex`s of `mesh.wgsl`.
    pub(crate) fn vertices(&self) -> wgpu::BindingResource<'_> {
        binding(&self.vertex_list, &self.vertices, VERTEX_BYTES)
    }

    /// Its `Triangle`s of `mesh.wgsl`.
    pub(crate) fn triangles(&self) -> wgpu::BindingResource<'_> {
        binding(&self.triangle_list, &self.triangles, size_of::<Triangle>() as u64)
    }
}

fn binding<'a>(buffer: &'a wgpu::Buffer, range: &Range<u32>, bytes: u64) -> wgpu::BindingResource<'a> {
    wgpu::BindingResource::Buffer(wgpu::BufferBinding {
        buffer,
        offset: u64::from(range.start) * bytes,
        size: std::num::NonZero::new(range.len() as u64 * bytes),
    })
}
