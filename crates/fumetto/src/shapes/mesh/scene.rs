use std::ops::Range;

use super::{
    VERTEX_BYTES,
    edge_scene::EdgeScene,
    edges::Candidate,
    geometry::{Geometry, Part, Source, Triangle},
    push::Push,
    reserved::{Reserved, places},
    shells::{Edge, Shells},
    textures::textures,
};
use crate::gpu::Gpu;

/// All models of a scene on the device.
#[derive(Debug)]
pub(crate) struct MeshScene {
    /// `Source`s of `mesh.wgsl`.
    pub(crate) sources: wgpu::Buffer,
    /// `Vertex`s of `mesh.wgsl`: one for each source, and those that the device makes.
    pub(crate) vertices: wgpu::Buffer,
    /// Sources.
    pub(crate) source_count: u32,
    /// For each of the first sources, its normal smoothed more and more; of an object that wants none,
    /// whatever.
    pub(crate) smoothed: wgpu::Buffer,
    /// `Triangle`s of `mesh.wgsl`.
    pub(crate) triangles: wgpu::Buffer,
    /// `Part`s of `mesh.wgsl`.
    pub(crate) parts: wgpu::Buffer,
    /// For each triangle, a number that it shares with those that it hangs together with.
    pub(crate) pieces: wgpu::Buffer,
    /// `Push`es of `mesh.wgsl`, of each of the first vertices; of an object that wants none, whatever.
    pub(crate) pushes: wgpu::Buffer,
    /// Array of the parts' textures.
    pub(crate) textures: wgpu::TextureView,
    pub(crate) sampler: wgpu::Sampler,
    /// Where lines may run.
    pub(crate) edges: EdgeScene,
    /// Each object's triangles, by its number.
    pub(crate) objects: Vec<Range<u32>>,
    /// Room for triangles that the device makes, in their objects' order.
    pub(crate) reserved: Vec<Reserved>,
    /// Whether a texture cuts holes into any of them.
    pub(crate) has_holes: bool,
    /// What throws shadows, if anything does.
    pub(crate) casters: Option<Casters>,
}

/// Bytes of a side of a shadow volume: two numbers.
const SIDE_BYTES: usize = 8;

/// What shadow volumes are made of, and room for what is found of them for one light after another.
#[derive(Debug)]
pub(crate) struct Casters {
    /// Triangles and edges of models.
    pub(crate) triangle_count: u32,
    pub(crate) edge_count: u32,
    /// Room for so many caps.
    pub(crate) cap_count: u32,
    /// When each triangle of a model throws a shadow.
    pub(crate) casting: wgpu::Buffer,
    /// `Edge`s of `shells.wgsl`.
    pub(crate) edges: wgpu::Buffer,
    /// How each triangle stands to the light.
    pub(crate) facings: wgpu::Buffer,
    /// The triangles with a volume: those whose lit side is seen, and from the end on the others.
    pub(crate) caps: wgpu::Buffer,
    /// The edges at which a volume has a side, as often as it has, as pairs of vertices.
    pub(crate) sides: wgpu::Buffer,
}

/// A model is too large for the device.
#[derive(Debug, thiserror::Error)]
#[error(
    "models and surfaces have {what} for {asked} bytes; this device allows {allowed} in one piece. Simplify models, \
     leave copies out, or choose larger cells for surfaces"
)]
pub struct MeshError {
    what: &'static str,
    asked: u64,
    allowed: u64,
}

impl MeshScene {
    /// `shells`, `candidates` and `seams` are those of `geometry`; there are none of the last where nothing has
    /// strokes.
    pub(crate) fn new(
        gpu: &Gpu,
        geometry: &Geometry,
        shells: &Shells,
        candidates: &[Candidate],
        seams: &[[u32; 2]],
    ) -> Result<Self, MeshError> {
        let Geometry { sources, triangles, parts, smoothed, pieces, pushes, .. } = geometry;
        let ends = [sources.len() as u64, triangles.len() as u64];
        let (places, [vertex_count, triangle_count]) = places(&geometry.reservations, ends);
        let source_bytes = room(gpu, "vertices", ends[0], size_of::<Source>())?;
        let vertex_bytes = room(gpu, "vertices", vertex_count, VERTEX_BYTES as usize)?;
        let triangle_bytes = room(gpu, "triangles", triangle_count, size_of::<Triangle>())?;
        room(gpu, "places for lines", candidates.len() as u64, size_of::<Candidate>())?;
        let part_bytes = room(gpu, "parts", parts.len() as u64, size_of::<Part>())?;
        let buffer = |label, size| buffer(gpu, label, size);
        let (textures, sampler) = textures(gpu, &geometry.textures);
        let vertices = buffer("shapes.mesh.vertices", vertex_bytes);
        let triangle_list = buffer("shapes.mesh.triangles", triangle_bytes);
        let reserved = geometry.reservations.iter().zip(places).map(|(reservation, firsts)| {
            let firsts = firsts.map(|first| first as u32);
            Reserved::new(gpu, reservation, firsts, [&vertices, &triangle_list])
        });
        let mut reserved: Vec<_> = reserved.collect();
        for (surface, _) in reserved.iter_mut().zip(&shells.surfaces).filter(|(_, casts)| **casts) {
            surface.make_caster(gpu)?;
        }
        let scene = Self {
            sources: buffer("shapes.mesh.sources", source_bytes),
            vertices,
            source_count: sources.len() as u32,
            smoothed: buffer("shapes.mesh.smoothed", size_of_val(&smoothed[..]).max(4) as u64),
            triangles: triangle_list,
            parts: buffer("shapes.mesh.parts", part_bytes),
            pieces: buffer("shapes.mesh.pieces", size_of_val(&pieces[..]).max(4) as u64),
            pushes: buffer("shapes.mesh.pushes", size_of_val(&pushes[..]).max(size_of::<Push>()) as u64),
            textures,
            sampler,
            edges: EdgeScene::new(gpu, candidates, seams),
            objects: geometry.objects.clone(),
            has_holes: geometry.has_holes,
            casters: Casters::new(gpu, shells, &reserved)?,
            reserved,
        };
        gpu.queue.write_buffer(&scene.sources, 0, bytemuck::cast_slice(sources));
        gpu.queue.write_buffer(&scene.smoothed, 0, bytemuck::cast_slice(smoothed));
        gpu.queue.write_buffer(&scene.triangles, 0, bytemuck::cast_slice(triangles));
        gpu.queue.write_buffer(&scene.pieces, 0, bytemuck::cast_slice(pieces));
        gpu.queue.write_buffer(&scene.pushes, 0, bytemuck::cast_slice(pushes));
        scene.upload_parts(gpu, parts);
        Ok(scene)
    }

    /// Whether there is nothing to draw.
    pub(crate) fn is_empty(&self) -> bool {
        self.source_count == 0 && self.reserved.is_empty()
    }

    /// Tells the device where the parts now are.
    pub(crate) fn upload_parts(&self, gpu: &Gpu, parts: &[Part]) {
        gpu.queue.write_buffer(&self.parts, 0, bytemuck::cast_slice(parts));
    }
}

impl Casters {
    fn new(gpu: &Gpu, shells: &Shells, reserved: &[Reserved]) -> Result<Option<Self>, MeshError> {
        let Shells { edges, casting, .. } = shells;
        let surfaces = || reserved.iter().filter(|surface| surface.adjacent.is_some());
        if edges.is_empty() && surfaces().next().is_none() {
            return Ok(None);
        }
        let made: usize = surfaces().map(|surface| surface.triangles.len()).sum();
        let numbers =
            surfaces().map(|surface| surface.triangles.end as usize).fold(casting.len(), usize::max);
        let edge_bytes = room(gpu, "edges that throw shadows", edges.len() as u64, size_of::<Edge>())?;
        // Both triangles of an edge may have a side there; of a closed surface's edges, few ever have.
        let side_bytes =
            room(gpu, "sides of shadows", (2 * edges.len() + made.div_ceil(2)) as u64, SIDE_BYTES)?;
        let word = |label, count: usize| buffer(gpu, label, 4 * count.max(1) as u64);
        let casters = Self {
            triangle_count: casting.len() as u32,
            edge_count: edges.len() as u32,
            cap_count: (casting.len() + made) as u32,
            casting: word("shapes.mesh.casting", casting.len()),
            edges: buffer(gpu, "shapes.mesh.edges", edge_bytes),
            facings: word("shapes.mesh.facings", numbers),
            caps: word("shapes.mesh.caps", casting.len() + made),
            sides: buffer(gpu, "shapes.mesh.sides", side_bytes),
        };
        gpu.queue.write_buffer(&casters.casting, 0, bytemuck::cast_slice(casting));
        gpu.queue.write_buffer(&casters.edges, 0, bytemuck::cast_slice(edges));
        Ok(Some(casters))
    }
}

/// Bytes for so many items, unless they are more than the device allows.
pub(super) fn room(gpu: &Gpu, what: &'static str, items: u64, bytes: usize) -> Result<u64, MeshError> {
    let asked = items.max(1) * bytes as u64;
    let allowed = gpu.device.limits().max_storage_buffer_binding_size;
    if asked > allowed { Err(MeshError { what, asked, allowed }) } else { Ok(asked) }
}

fn buffer(gpu: &Gpu, label: &'static str, size: u64) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    })
}
