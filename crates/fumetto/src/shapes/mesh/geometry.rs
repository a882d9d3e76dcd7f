//! Models as the engine keeps them: one list of triangles for a whole scene.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use fumetto_formats::{Image, Material, Model, Placed, Wrap};
use fumetto_scene::Mesh;
use glam::{Mat4, Vec3};
use half::f16;

use super::{
    pieces::pieces,
    placements::placements,
    push::{Push, pushes},
    reserved::Reservation,
    smooth::MAX_SCALES,
    weld::weld,
};

/// `Source` of `mesh.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Source {
    pub(crate) position: [f32; 3],
    pub(crate) normal: u32,
    pub(crate) uv: [f32; 2],
    pub(crate) colour: [u32; 2],
    pub(crate) part: u32,
    pub(crate) pad: [u32; 3],
}

/// `Triangle` of `mesh.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
pub(crate) struct Triangle {
    pub(crate) corners: [u32; 3],
    pub(crate) part: u32,
}

/// `Part` of `mesh.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Part {
    pub(crate) world_from_part: Mat4,
    colour: [f32; 4],
    pub(crate) object: u32,
    pub(crate) material: u32,
    texture: i32,
    pub(crate) look: u32,
}

pub(super) const DOUBLE_SIDED: u32 = 16;
const NO_SOURCES: u32 = 32;

impl Part {
    /// Whether it is seen from behind, too.
    pub(crate) fn is_double_sided(&self) -> bool {
        self.look & DOUBLE_SIDED != 0
    }

    /// Whether its texture may cut holes into it.
    pub(crate) fn has_holes(&self) -> bool {
        self.texture >= 0 && self.look >> 16 != 0
    }
}

/// All models of a scene, copies counted singly.
#[derive(Debug, Default)]
pub(crate) struct Geometry {
    pub(crate) sources: Vec<Source>,
    pub(crate) triangles: Vec<Triangle>,
    pub(crate) parts: Vec<Part>,
    /// Smoothed normals of each source, as far as any object wants them.
    pub(crate) smoothed: Vec<[u32; MAX_SCALES]>,
    /// For each triangle, a number that it shares with those that it hangs together with.
    pub(crate) pieces: Vec<u32>,
    /// How each of the first vertices moves when its object gets larger all round, as far as any wants that.
    pub(crate) pushes: Vec<Push>,
    /// For each part the first of those that always move as it does.
    pub(crate) groups: Vec<usize>,
    pub(crate) textures: Vec<Image>,
    /// Each object's triangles, by its number.
    pub(crate) objects: Vec<Range<u32>>,
    /// Room for triangles that the device makes, in the objects' order.
    pub(crate) reservations: Vec<Reservation>,
    /// Whether a texture cuts holes into any of them.
    pub(crate) has_holes: bool,
    materials: u32,
}

impl Geometry {
    /// Adds an object that has no triangles, or whose triangles come from elsewhere.
    pub(crate) fn add_nothing(&mut self) {
        let end = self.triangles.len() as u32;
        self.objects.push(end..end);
    }

    /// Adds the next object: a surface that the device makes, of at most so many vertices and triangles, and
    /// whether lines run through these.
    pub(crate) fn add_surface(&mut self, vertices: u32, triangles: u32, has_lines: bool) {
        let part = self.parts.len() as u32;
        let object = self.objects.len();
        self.reservations.push(Reservation { object, part, vertices, triangles, has_lines });
        self.groups.push(self.parts.len());
        self.parts.push(Part {
            world_from_part: Mat4::IDENTITY,
            colour: [1.0; 4],
            object: object as u32,
            material: self.materials,
            texture: -1,
            look: NO_SOURCES,
        });
        self.materials += 1;
        self.add_nothing();
    }

    /// Adds the next object: the copies of `mesh`, which `model` holds. Answers with its parts.
    pub(crate) fn add(&mut self, mesh: &Mesh, model: &Model) -> Range<usize> {
        let object = self.objects.len() as u32;
        let (first_triangle, first_part) = (self.triangles.len() as u32, self.parts.len());
        let mut last: Option<Placed> = None;
        for (placed, world_from_part) in placements(mesh, model, 0.0) {
            // The next copy begins with the first group again.
            let goes_on = last.is_some_and(|last| last.group == placed.group && last.part + 1 == placed.part);
            let group = self.groups.last().filter(|_| goes_on);
            self.groups.push(group.copied().unwrap_or(self.parts.len()));
            last = Some(placed);
            self.add_part(model, &placed, world_from_part, object);
        }
        self.has_holes |= model.materials.iter().any(|material| material.alpha_cutoff.is_some());
        self.textures.extend(model.textures.iter().cloned());
        self.materials += model.materials.len() as u32;
        self.objects.push(first_triangle..self.triangles.len() as u32);
        let vertices = self.vertices(object as usize);
        let welded = weld(&self.sources[vertices.clone()], &self.groups);
        let triangles = &self.triangles[first_triangle as usize..];
        self.pieces.extend(pieces(triangles, &welded, vertices.start as u32));
        first_part..self.parts.len()
    }

    /// Works out how the vertices of an object move when it gets larger all round.
    pub(crate) fn find_pushes(&mut self, object: usize) {
        let vertices = self.vertices(object);
        let sources = &self.sources[vertices.clone()];
        let Range { start, end } = self.objects[object];
        let triangles = &self.triangles[start as usize..end as usize];
        let found = pushes(sources, triangles, &weld(sources, &self.groups), vertices.start as u32);
        self.pushes.resize(vertices.start, Push::default());
        self.pushes.extend(found);
    }

    /// An object's vertices.
    pub(crate) fn vertices(&self, object: usize) -> Range<usize> {
        let start = |object: u32| {
            let is_before = |source: &Source| self.parts[source.part as usize].object < object;
            self.sources.partition_point(is_before)
        };
        start(object as u32)..start(object as u32 + 1)
    }

    fn add_part(&mut self, model: &Model, placed: &Placed, world_from_part: Mat4, object: u32) {
        let part = &model.parts[placed.part];
        let number = self.parts.len() as u32;
        let first = self.sources.len() as u32;
        let material = &model.materials[part.material];
        self.parts.push(Part {
            world_from_part,
            colour: material.colour,
            object,
            material: self.materials + part.material as u32,
            texture: material.texture.map_or(-1, |texture| (self.textures.len() + texture.image) as i32),
            look: look(material),
        });
        self.sources.extend((0..part.positions.len()).map(|i| Source {
            position: part.positions[i],
            normal: octahedral(part.normals[i].into()),
            uv: part.uvs.get(i).copied().unwrap_or_default(),
            colour: halves(part.colours.get(i).copied().unwrap_or([1.0; 4])),
            part: number,
            pad: [0; 3],
        }));
        // A mirror turns triangles inside out.
        let mirrored = world_from_part.determinant() < 0.0;
        self.triangles.extend(part.triangles.iter().map(|&[a, b, c]| {
            let corners = if mirrored { [a, c, b] } else { [a, b, c] };
            Triangle { corners: corners.map(|corner| first + corner), part: number }
        }));
    }

    /// Moves an object's `parts` to where they are at `time_secs`.
    pub(crate) fn animate(&mut self, parts: Range<usize>, mesh: &Mesh, model: &Model, time_secs: f32) {
        let placements = placements(mesh, model, time_secs);
        for (part, (_, world_from_part)) in self.parts[parts].iter_mut().zip(placements) {
            part.world_from_part = world_from_part;
        }
    }
}

/// As `octahedral_packed` of `octahedral.wgsl`.
pub(crate) fn octahedral(normal: Vec3) -> u32 {
    let [x, y, z] = (normal / normal.abs().element_sum().max(1e-20)).to_array();
    let fold = |a: f32, b: f32| (1.0 - b.abs()) * if a >= 0.0 { 1.0 } else { -1.0 };
    let folded = if z < 0.0 { [fold(x, y), fold(y, x)] } else { [x, y] };
    let [u, v] = folded.map(|share| u32::from((share * 32767.0).round() as i16 as u16));
    u | (v << 16)
}

fn halves(colour: [f32; 4]) -> [u32; 2] {
    let [r, g, b, a] = colour.map(|channel| u32::from(f16::from_f32(channel).to_bits()));
    [r | (g << 16), b | (a << 16)]
}

/// How a material's texture goes on, and where its surface is to be seen.
fn look(material: &Material) -> u32 {
    let bits = |wrap| match wrap {
        Wrap::Repeat => 0,
        Wrap::Mirror => 1,
        Wrap::Clamp => 2,
    };
    let wrap = material.texture.map_or(0, |texture| bits(texture.wrap[0]) | (bits(texture.wrap[1]) << 2));
    let double_sided = if material.double_sided { DOUBLE_SIDED } else { 0 };
    // A cutoff of 1 leaves what is opaque.
    let cutoff = (material.alpha_cutoff.unwrap_or(0.0).clamp(0.0, 1.0) * 65535.0) as u32;
    wrap | double_sided | (cutoff << 16)
}

#[cfg(test)]
pub(super) mod tests {
    use fumetto_formats::ModelOptions;
    use fumetto_scene::Transform;

    use super::*;
    use crate::gpu::layout_test;

    layout_test!(sources_lie_as_their_twin: Source, "Source" of "shapes/mesh/place" { position, normal, uv, colour, part });

    layout_test!(parts_lie_as_their_twin: Part, "Part" of "shapes/mesh/place" { world_from_part, colour, object, material, texture, look });

    layout_test!(triangles_lie_as_their_twin: Triangle, "Triangle" of "shapes/mesh/body" { corners, part });

    /// The geometry of one object.
    pub(in super::super) fn geometry_of(obj: &str) -> Geometry {
        let model =
            fumetto_formats::read_model("test.obj", obj.as_bytes(), ModelOptions::default(), &mut |_| {
                Err(std::io::ErrorKind::NotFound.into())
            });
        let still = Transform { position: [0.0; 3], rotation_deg: [0.0; 3], scale: [1.0; 3] };
        let mesh = Mesh {
            model: "test.obj".into(),
            z_up: false,
            smooth_deg: None,
            copies: vec![still],
            obstacle: false,
        };
        let mut geometry = Geometry::default();
        geometry.add(&mesh, &model.expect("the test's model can be read"));
        geometry
    }

    /// Boxes of 2 by 2 by 2 around `middles`, whose corners the reader splits for their normals.
    pub(in super::super) fn boxes(middles: &[[f32; 3]]) -> String {
        let mut obj = String::new();
        for [x, y, z] in middles {
            for corner in 0..8 {
                let side = |axis: u32| 2.0 * ((corner >> axis) & 1) as f32 - 1.0;
                obj += &format!("v {} {} {}\n", x + side(0), y + side(1), z + side(2));
            }
            obj +=
                "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
        }
        obj
    }
}
