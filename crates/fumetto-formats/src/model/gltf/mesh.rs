//! Triangles (glTF 2.0, section 3.7.2).

use std::ops::Range;

use glam::{Vec2, Vec3, Vec4};
use gltf_json::accessor::ComponentType::{self, F32, I8, I16, U8, U16, U32};
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::validation::Checked;
use rustc_hash::FxHashMap;

use super::accessor::Accessor;
use super::document::{Document, label};
use super::material::Materials;
use super::scene::Visit;
use crate::FormatError;
use crate::model::companions::Companions;
use crate::model::mend::{Label, Surface, used};
use crate::model::rig::Node;
use crate::model::{MAX_MODEL_TRIANGLES, ModelOptions, Part};
use crate::notes::Notes;

/// Most places where parts may stand: each is drawn for itself. They take 70 MB.
const MAX_PLACED: u64 = 1_000_000;

/// Refuses more triangles, or more parts in their places, than can be drawn, before any is read.
pub(super) fn check_size(
    document: &Document<'_>,
    visits: &[Visit],
    nodes: &[Node],
) -> Result<(), FormatError> {
    let mut of_mesh = FxHashMap::default();
    let (mut asked, mut placed) = (0_u64, 0_u64);
    for (visit, node) in visits.iter().zip(nodes) {
        let Some(mesh) = document.root.nodes[visit.node].mesh.map(|mesh| mesh.value()) else { continue };
        let (parts, triangles) = match of_mesh.get(&mesh) {
            Some(&known) => known,
            None => *of_mesh.entry(mesh).or_insert(size(document, mesh)?),
        };
        let copies = node.copies() as u64;
        asked = asked.saturating_add(copies.saturating_mul(triangles));
        placed = placed.saturating_add(copies.saturating_mul(parts));
    }
    if asked > MAX_MODEL_TRIANGLES {
        return Err(FormatError::TooManyTriangles {
            file: document.path.to_owned(),
            asked,
            allowed: MAX_MODEL_TRIANGLES,
        });
    }
    if placed > MAX_PLACED {
        let problem =
            format!("it places {placed} parts, more than the {MAX_PLACED} that are allowed; join meshes");
        return Err(document.wrong("the scene", problem));
    }
    Ok(())
}

/// How many parts a mesh has, and how many triangles.
fn size(document: &Document<'_>, index: usize) -> Result<(u64, u64), FormatError> {
    let mesh = document.root.meshes.get(index).ok_or_else(|| document.absent("a node", "mesh", index))?;
    let mut triangles = 0_u64;
    for (number, primitive) in mesh.primitives.iter().enumerate() {
        let element = primitive_label(index, mesh.name.as_deref(), number);
        if let (Checked::Valid(mode), Some(positions)) = (primitive.mode, positions(primitive)) {
            let corners = primitive.indices.map_or(positions, |indices| indices.value());
            triangles =
                triangles.saturating_add(triangle_count(mode, document.accessor(&element, corners)?.count));
        }
    }
    Ok((mesh.primitives.len() as u64, triangles))
}

fn primitive_label(mesh: usize, name: Option<&str>, primitive: usize) -> String {
    format!("{}, primitive {primitive}", label("mesh", mesh, name))
}

/// The place of a primitive's accessor of positions.
fn positions(primitive: &Primitive) -> Option<usize> {
    attribute(primitive, Semantic::Positions)
}

fn attribute(primitive: &Primitive, semantic: Semantic) -> Option<usize> {
    primitive.attributes.get(&Checked::Valid(semantic)).map(gltf_json::Index::value)
}

/// The triangles that so many corners make.
fn triangle_count(mode: Mode, corners: usize) -> u64 {
    let corners = corners as u64;
    match mode {
        Mode::Triangles => corners / 3,
        Mode::TriangleStrip | Mode::TriangleFan => corners.saturating_sub(2),
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => 0,
    }
}

/// The corners of the triangle `i`, in the order of glTF 2.0, section 3.7.2.1.
fn triangle(mode: Mode, i: usize) -> [usize; 3] {
    match mode {
        Mode::TriangleStrip => [i, i + 1 + i % 2, i + 2 - i % 2],
        Mode::TriangleFan => [i + 1, i + 2, 0],
        _ => [3 * i, 3 * i + 1, 3 * i + 2],
    }
}

/// Reads meshes, each once.
pub(super) struct Meshes<'a> {
    document: &'a Document<'a>,
    options: ModelOptions,
    parts: Vec<Part>,
    known: FxHashMap<usize, Range<usize>>,
}

impl<'a> Meshes<'a> {
    pub(super) fn new(document: &'a Document<'a>, options: ModelOptions) -> Self {
        Self { document, options, parts: Vec::new(), known: FxHashMap::default() }
    }

    /// All parts of the meshes that were read.
    pub(super) fn finish(self) -> Vec<Part> {
        self.parts
    }

    /// The places of a mesh's parts.
    pub(super) fn read(
        &mut self,
        index: usize,
        materials: &mut Materials<'_>,
        companions: &mut Companions<'_>,
        notes: &mut Notes,
    ) -> Result<Range<usize>, FormatError> {
        if let Some(known) = self.known.get(&index) {
            return Ok(known.clone());
        }
        let document = self.document;
        let mesh = document.root.meshes.get(index).ok_or_else(|| document.absent("a node", "mesh", index))?;
        let start = self.parts.len();
        for (number, primitive) in mesh.primitives.iter().enumerate() {
            let element = primitive_label(index, mesh.name.as_deref(), number);
            if primitive.targets.as_ref().is_some_and(|targets| !targets.is_empty()) {
                notes.say(&element, "it has morph targets, which do not move: it is shown at rest");
            }
            let material = primitive.material.map(|material| material.value());
            let material = materials.at(&element, material, companions, notes)?;
            let Some(surface) = self.surface(&element, primitive, materials.uvs(material), notes)? else {
                continue;
            };
            let label = Label { element: &element, name: mesh.name.as_deref().unwrap_or_default(), material };
            self.parts.extend(surface.finish(label, self.options, notes));
        }
        let parts = start..self.parts.len();
        self.known.insert(index, parts.clone());
        Ok(parts)
    }

    /// A primitive's triangles, if it is made of them.
    fn surface(
        &self,
        element: &str,
        primitive: &Primitive,
        uvs: super::material::Uvs,
        notes: &mut Notes,
    ) -> Result<Option<Surface>, FormatError> {
        let Checked::Valid(mode @ (Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan)) =
            primitive.mode
        else {
            notes.say(element, "it is made of points or lines, so it was left out");
            return Ok(None);
        };
        let Some(positions) = positions(primitive) else {
            notes.say(element, "it has no positions, so it was left out");
            return Ok(None);
        };
        let reader = Attributes { document: self.document, element, primitive };
        let positions = reader.accessor(positions, "positions", &[3], &[F32, I8, U8, I16, U16])?;
        let mut triangles = reader.triangles(mode, positions.count)?;
        let kept = used(&mut triangles, positions.count);

        let at = |vertex: &u32| *vertex as usize;
        let vertices = kept.iter().map(at);
        let floats = [F32, U8, U16];
        let normals =
            reader.attribute(Semantic::Normals, "normals", &[3], &[F32, I8, I16], positions.count)?;
        let texture = reader.attribute(
            Semantic::TexCoords(uvs.set),
            "texture coordinates",
            &[2],
            &[F32, I8, U8, I16, U16],
            positions.count,
        )?;
        let colours = reader.attribute(Semantic::Colors(0), "colours", &[3, 4], &floats, positions.count)?;
        if texture.is_none() && uvs.needed {
            notes.say(element, "it has no texture coordinates, so it goes without its texture");
        }
        Ok(Some(Surface {
            positions: vertices.clone().map(|vertex| positions.vector(vertex).into()).collect(),
            normals: gather(normals.as_ref(), &kept, |normals, vertex| {
                Vec3::from(normals.vector::<3>(vertex))
            }),
            uvs: gather(texture.as_ref(), &kept, |texture, vertex| {
                uvs.transform.transform_point2(Vec2::from(texture.vector::<2>(vertex)))
            }),
            colours: gather(colours.as_ref(), &kept, |colours, vertex| {
                let [r, g, b, a] = colours.vector(vertex);
                Vec4::new(r, g, b, if colours.width == 4 { a } else { 1.0 })
            }),
            triangles,
        }))
    }
}

/// The values of an attribute for some vertices; none if there is no such attribute.
fn gather<T>(
    accessor: Option<&Accessor<'_>>,
    vertices: &[u32],
    value: impl Fn(&Accessor<'_>, usize) -> T,
) -> Vec<T> {
    let all = |accessor| vertices.iter().map(|&vertex| value(accessor, vertex as usize)).collect();
    accessor.map_or_else(Vec::new, all)
}

/// Opens a primitive's accessors.
struct Attributes<'a> {
    document: &'a Document<'a>,
    element: &'a str,
    primitive: &'a Primitive,
}

impl<'a> Attributes<'a> {
    fn accessor(
        &self,
        index: usize,
        what: &str,
        widths: &[usize],
        components: &[ComponentType],
    ) -> Result<Accessor<'a>, FormatError> {
        let accessor = self.document.accessor(self.element, index)?;
        if widths.iter().any(|&width| accessor.is(width, components)) {
            return Ok(accessor);
        }
        let problem = format!("accessor {index} has numbers that cannot be {what}; export the model again");
        Err(self.document.wrong(self.element, problem))
    }

    /// The accessor of an attribute that has a value for each of `count` vertices.
    fn attribute(
        &self,
        semantic: Semantic,
        what: &str,
        widths: &[usize],
        components: &[ComponentType],
        count: usize,
    ) -> Result<Option<Accessor<'a>>, FormatError> {
        let Some(index) = attribute(self.primitive, semantic) else { return Ok(None) };
        let accessor = self.accessor(index, what, widths, components)?;
        if accessor.count < count {
            let problem =
                format!("it has {count} vertices but {} {what}; export the model again", accessor.count);
            return Err(self.document.wrong(self.element, problem));
        }
        Ok(Some(accessor))
    }

    /// The primitive's triangles, whose corners were seen to be among its `vertices`.
    fn triangles(&self, mode: Mode, vertices: usize) -> Result<Vec<[u32; 3]>, FormatError> {
        let Some(indices) = self.primitive.indices else {
            let count = triangle_count(mode, vertices) as usize;
            return Ok((0..count).map(|i| triangle(mode, i).map(|corner| corner as u32)).collect());
        };
        let indices = self.accessor(indices.value(), "indices", &[1], &[U8, U16, U32])?;
        let count = triangle_count(mode, indices.count) as usize;
        let mut triangles = Vec::with_capacity(count);
        for i in 0..count {
            let corners = triangle(mode, i).map(|corner| indices.index(corner));
            if let Some(past) = corners.iter().find(|&&corner| corner as usize >= vertices) {
                let problem =
                    format!("index {past} is past the last of {vertices} vertices; export the model again");
                return Err(self.document.wrong(self.element, problem));
            }
            // Strips turn corners with triangles that have none of their own.
            let [a, b, c] = corners;
            if mode == Mode::Triangles || (a != b && b != c && c != a) {
                triangles.push(corners);
            }
        }
        Ok(triangles)
    }
}
