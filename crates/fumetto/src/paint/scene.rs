use std::collections::BTreeMap;

use bytemuck::{Pod, Zeroable};
use fumetto_scene::{Look, Paint, Scene, Stain};
use wgpu::util::DeviceExt as _;

use super::{
    cells::Grid,
    coat::{Coat, Coats},
    ground::Ground,
    group::{Firsts, Group},
    sphere::{Icosahedron, Sphere},
    stains::Stains,
};
use crate::{
    gpu::{Frame, Gpu},
    particles::Emission,
    shapes::mesh::Geometry,
};

/// Bytes of a `Run` of `spread.wgsl`.
const RUN_BYTES: u64 = 32;

/// Bytes of a vertex: its radius and its speed.
const VERTEX_BYTES: u64 = 8;

/// How far from a surface paint feels it, as a share of its radius. Also in `downhill.wgsl`.
const REACH: f32 = 0.25;

/// `Body` of `body.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Body {
    pub(super) start: [f32; 3],
    pub(super) near: f32,
    pub(super) end: [f32; 3],
    pub(super) far: f32,
    first_vertex: u32,
    first_direction: u32,
    first_patch: u32,
    pieces: u32,
    layer: u32,
    coat: u32,
    blend: f32,
    pad: u32,
}

/// All paints of a scene on the device.
#[derive(Debug)]
pub(crate) struct PaintScene {
    pub(super) groups: Vec<Group>,
    pub(super) grids: Vec<Grid>,
    pub(super) stains: Vec<Stains>,
    /// What particles and paint touch; there is none where nothing asks for it.
    pub(super) ground: Ground,
    pub(crate) coats: Coats,
    /// `Body`s of `body.wgsl`.
    pub(super) bodies: wgpu::Buffer,
    pub(super) body_count: u32,
    /// Radius and speed of each vertex.
    pub(super) vertices: wgpu::Buffer,
    /// `Run`s of `spread.wgsl`.
    pub(super) runs: wgpu::Buffer,
    /// Of the meshes that volumes are made of, one after the other: see `sphere.wgsl`.
    pub(super) directions: wgpu::Buffer,
    pub(super) patches: wgpu::Buffer,
    pub(super) icosahedron: wgpu::Buffer,
}

/// What paint meets: models, and for each object by its number what it emits.
#[derive(Clone, Copy)]
pub(crate) struct Surroundings<'a> {
    pub(crate) geometry: &'a Geometry,
    pub(crate) emissions: &'a dyn Fn(usize) -> &'a [Emission],
}

/// Meshes of all sizes that volumes of a scene are made of.
#[derive(Default)]
struct Spheres {
    /// By the pieces of an edge, the first direction and the first number in the patches.
    firsts: BTreeMap<u32, [u32; 2]>,
    all: Sphere,
}

impl Spheres {
    fn firsts(&mut self, pieces: u32) -> [u32; 2] {
        *self.firsts.entry(pieces).or_insert_with(|| {
            let firsts = [self.all.directions.len(), self.all.patches.as_flattened().len()];
            let sphere = Sphere::new(pieces);
            self.all.directions.extend(sphere.directions);
            self.all.patches.extend(sphere.patches);
            firsts.map(|first| first as u32)
        })
    }
}

/// What the groups of a scene hold, while they are listed.
#[derive(Default)]
struct Listing {
    groups: Vec<Group>,
    grids: Vec<Grid>,
    stains: Vec<Stains>,
    bodies: Vec<Body>,
    coats: Vec<Coat>,
    spheres: Spheres,
    vertices: u32,
    layers: u32,
}

impl Listing {
    /// Adds a paint's volumes, layer by layer.
    fn add(&mut self, gpu: &Gpu, paint: &Paint, coat: Coat, around: Surroundings<'_>, clock: (u32, f64)) {
        let grid = Grid::new(gpu, paint, around.geometry, clock.0);
        let stains_of = |stain: &Stain| Stains::of(gpu, paint, stain, (around.emissions)(stain.from));
        let stains: Vec<_> = paint.stains.iter().flat_map(stains_of).collect();
        let pieces = paint.spread.subdivisions;
        let [direction, patch] = self.spheres.firsts(pieces);
        for layer in 0..paint.layers() {
            let listed = Group::listed(paint, &coat, layer, self.firsts(direction), clock);
            self.add_group(listed, [pieces, patch]);
            let cells = grid.iter().map(|grid| grid.ordered(layer));
            for ordered in cells.chain(stains.iter().map(|stains| stains.ordered(layer))) {
                let group = Group::ordered(paint, &coat, (ordered, layer), self.firsts(direction), clock);
                self.add_group(group, [pieces, patch]);
            }
            self.layers += 1;
        }
        self.grids.extend(grid);
        self.stains.extend(stains);
        self.coats.push(coat);
    }

    fn firsts(&self, direction: u32) -> Firsts {
        Firsts { body: self.bodies.len() as u32, vertex: self.vertices, direction }
    }

    fn add_group(&mut self, group: Group, [pieces, first_patch]: [u32; 2]) {
        for _ in 0..group.uniform.volumes {
            self.bodies.push(Body {
                first_vertex: self.vertices,
                first_direction: group.uniform.first_direction,
                first_patch,
                pieces,
                layer: self.layers,
                coat: self.coats.len() as u32,
                blend: group.blend_m,
                ..Body::zeroed()
            });
            self.vertices += group.uniform.vertices;
        }
        if group.uniform.volumes > 0 {
            self.groups.push(group);
        }
    }
}

impl PaintScene {
    /// The paints that are visible.
    pub(crate) fn new(
        gpu: &Gpu,
        scene: &Scene,
        around: Surroundings<'_>,
        seed_of: impl Fn(usize) -> u32,
    ) -> Self {
        let mut listing = Listing::default();
        // Looks are numbered as `Scene::styled_looks` lists them, after the scene's own.
        let mut looks = 0;
        let mut number_of = |look: &Look| match look {
            Look::Own | Look::Monochrome => 0,
            Look::Styled(_) => {
                looks += 1;
                looks
            }
        };
        let mut outside = (0, true);
        for (index, paint) in scene.paints() {
            let object = &scene.objects[index];
            let coat = Coat::new(object, paint, listing.layers, number_of(&paint.inside));
            if let Some(look) = &paint.outside {
                outside = (number_of(look), *look == Look::Monochrome);
            }
            listing.add(gpu, paint, coat, around, (seed_of(index), scene.time.step_secs()));
        }
        let coats = Coats::new(&listing.coats, listing.bodies.len() as u32, outside);
        let is_felt =
            !listing.stains.is_empty() || scene.paints().any(|(_, paint)| paint.spread.downhill > 0.0);
        let largest_m = largest_particle(scene, around).max(REACH * largest_drop(scene));
        let geometry = if is_felt { around.geometry } else { &Geometry::default() };
        let ground = Ground::new(gpu, geometry, largest_m);
        Self::upload(gpu, listing, coats, ground)
    }

    fn upload(gpu: &Gpu, listing: Listing, coats: Coats, ground: Ground) -> Self {
        let Listing { groups, grids, stains, bodies, spheres: Spheres { all, .. }, vertices, .. } = listing;
        let list = |label, contents: &[u8], usage| {
            let nothing = [0; 64];
            let contents = if contents.is_empty() { &nothing } else { contents };
            gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some(label),
                contents,
                usage,
            })
        };
        let room = |label, count: u64, bytes: u64| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: count.max(1) * bytes,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_DST
                    | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            })
        };
        let storage = wgpu::BufferUsages::STORAGE;
        let kept = storage | wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST;
        Self {
            coats,
            bodies: list("paint.bodies", bytemuck::cast_slice(&bodies), kept),
            body_count: bodies.len() as u32,
            vertices: room("paint.vertices", vertices.into(), VERTEX_BYTES),
            runs: room("paint.runs", bodies.len() as u64, RUN_BYTES),
            directions: list("paint.directions", bytemuck::cast_slice(&all.directions), storage),
            patches: list("paint.patches", bytemuck::cast_slice(&all.patches), storage),
            icosahedron: list(
                "paint.icosahedron",
                bytemuck::bytes_of(&Icosahedron::new()),
                wgpu::BufferUsages::UNIFORM,
            ),
            groups,
            grids,
            stains,
            ground,
        }
    }

    /// Whether there is no paint.
    pub(crate) fn is_empty(&self) -> bool {
        self.body_count == 0
    }

    /// Of each grid, whether there is any ground for it.
    pub(crate) fn have_floors(&self) -> impl Iterator<Item = bool> {
        self.grids.iter().map(|grid| grid.has_floor)
    }

    /// What pictures show of them.
    pub(crate) fn shown(&self) -> impl Iterator<Item = &wgpu::Buffer> {
        [&self.vertices, &self.bodies].into_iter().filter(|_| !self.is_empty())
    }

    /// What the next step needs beside that.
    pub(crate) fn hidden(&self) -> impl Iterator<Item = &wgpu::Buffer> {
        let runs = (!self.is_empty()).then_some(&self.runs);
        runs.into_iter()
            .chain(self.grids.iter().map(Grid::states))
            .chain(self.stains.iter().map(Stains::states))
    }

    /// Back to before anything fell.
    pub(crate) fn reset(&self, frame: &mut Frame<'_>) {
        frame.encoder.clear_buffer(&self.vertices, 0, None);
        frame.encoder.clear_buffer(&self.runs, 0, None);
        for grid in &self.grids {
            grid.reset(frame);
        }
        for stains in &self.stains {
            stains.reset(frame);
        }
    }
}

/// The radius of the largest particle that leaves a stain.
fn largest_particle(scene: &Scene, around: Surroundings<'_>) -> f32 {
    let stains = scene.paints().flat_map(|(_, paint)| &paint.stains);
    let emissions = stains.flat_map(|stain| (around.emissions)(stain.from));
    emissions.map(|emission| emission.emitter().largest_radius()).fold(0.0, f32::max)
}

/// The largest radius of what is drawn down along surfaces.
fn largest_drop(scene: &Scene) -> f32 {
    let drawn = scene.paints().filter(|(_, paint)| paint.spread.downhill > 0.0);
    drawn.map(|(_, paint)| paint.largest_m()).fold(0.0, f32::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: Body, "Body" of "paint/mask" { start, near, end, far, first_vertex, first_direction, first_patch, pieces, layer, coat, blend });
}
