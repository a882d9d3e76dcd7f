//! Binary glTF 2.0, with the document of the `gltf-json` crate.

use std::{collections::BTreeMap, io::Write};

use fumetto_scene::Colour;
use gltf_json::{
    Accessor, Asset, Buffer, Index, Material, Mesh, Node, Root, Scene,
    accessor::{ComponentType, GenericComponentType, Type},
    buffer::{Target, View},
    material::{PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor},
    mesh::{Mode, Primitive, Semantic},
    validation::Checked::Valid,
};

use super::{Group, Solid, materials, place_of};
use crate::WriteError;

/// The header of the file, and that of each of its two chunks.
const HEADER_BYTES: u64 = 12;
const CHUNK_HEADER_BYTES: u64 = 8;

/// Writes solids as binary glTF: a node and a mesh for each, and a primitive for each of its groups. All
/// primitives of a mesh share its vertices.
///
/// What has no triangles is left out.
///
/// # Errors
/// If a solid is not sound, the file would be longer than 4 GiB, or `out` refuses the bytes.
pub fn write_glb(solids: &[Solid], mut out: impl Write) -> Result<(), WriteError> {
    let mut document = Document::new(materials(solids));
    let seen = || solids.iter().filter(|solid| solid.triangle_count() > 0);
    for solid in seen() {
        solid.check()?;
        document.add(solid);
    }
    let (mut json, length) = document.finish()?;
    json.resize(json.len().next_multiple_of(4), b' ');

    let chunks = if length == 0 { 1 } else { 2 };
    let total = HEADER_BYTES + chunks * CHUNK_HEADER_BYTES + json.len() as u64 + length;
    let total = u32::try_from(total).map_err(|_| WriteError::GlbTooLong { bytes: total })?;
    out.write_all(b"glTF")?;
    write_words(&mut out, [2, total])?;
    write_words(&mut out, [json.len() as u32])?;
    out.write_all(b"JSON")?;
    out.write_all(&json)?;
    if length > 0 {
        write_words(&mut out, [length as u32])?;
        out.write_all(b"BIN\0")?;
        for solid in seen() {
            write_words(&mut out, solid.positions.iter().flatten().map(|along| along.to_bits()))?;
            write_words(&mut out, solid.normals.iter().flatten().map(|along| along.to_bits()))?;
            for group in drawn(solid) {
                write_words(&mut out, group.triangles.iter().flatten().copied())?;
            }
        }
    }
    Ok(())
}

/// A primitive needs a triangle.
fn drawn(solid: &Solid) -> impl Iterator<Item = &Group> {
    solid.groups.iter().filter(|group| !group.triangles.is_empty())
}

fn write_words(out: &mut impl Write, words: impl IntoIterator<Item = u32>) -> Result<(), WriteError> {
    for word in words {
        out.write_all(&word.to_le_bytes())?;
    }
    Ok(())
}

/// The JSON while it grows, and how long its buffer has become.
struct Document<'a> {
    root: Root,
    materials: Vec<(&'a str, Colour)>,
    nodes: Vec<Index<Node>>,
    length: u64,
}

impl<'a> Document<'a> {
    fn new(materials: Vec<(&'a str, Colour)>) -> Self {
        let mut root = Root {
            asset: Asset { generator: Some("Fumetto".to_owned()), ..Asset::default() },
            ..Root::default()
        };
        for &(name, Colour { linear: [r, g, b] }) in &materials {
            root.push(Material {
                name: Some(name.to_owned()),
                pbr_metallic_roughness: PbrMetallicRoughness {
                    base_color_factor: PbrBaseColorFactor([r, g, b, 1.0]),
                    metallic_factor: StrengthFactor(0.0),
                    ..PbrMetallicRoughness::default()
                },
                ..Material::default()
            });
        }
        Self { root, materials, nodes: Vec::new(), length: 0 }
    }

    fn add(&mut self, solid: &Solid) {
        let (vertices, attributes) = (solid.positions.len(), Some(Target::ArrayBuffer));
        let bounds = [f32::min as fn(f32, f32) -> f32, f32::max].map(|better| {
            let bound = solid.positions.iter().copied().reduce(|a, b| [0, 1, 2].map(|i| better(a[i], b[i])));
            bound.map(|bound| gltf_json::Value::from(bound.to_vec()))
        });
        let [min, max] = bounds;
        let positions = self.accessor(vertices, Type::Vec3, ComponentType::F32, attributes);
        let accessor = &mut self.root.accessors[positions.value()];
        (accessor.min, accessor.max) = (min, max);
        let normals = self.accessor(vertices, Type::Vec3, ComponentType::F32, attributes);
        let attributes =
            BTreeMap::from([(Valid(Semantic::Positions), positions), (Valid(Semantic::Normals), normals)]);
        let primitives: Vec<_> = drawn(solid)
            .map(|group| {
                let count = 3 * group.triangles.len();
                let target = Some(Target::ElementArrayBuffer);
                Primitive {
                    attributes: attributes.clone(),
                    indices: Some(self.accessor(count, Type::Scalar, ComponentType::U32, target)),
                    material: Some(Index::new(place_of(&self.materials, group) as u32)),
                    mode: Valid(Mode::Triangles),
                    targets: None,
                    extensions: None,
                    extras: Default::default(),
                }
            })
            .collect();
        let name = Some(solid.name.clone());
        let mesh = Mesh { name, primitives, weights: None, extensions: None, extras: Default::default() };
        let mesh = Some(self.root.push(mesh));
        let node = self.root.push(Node { name: Some(solid.name.clone()), mesh, ..Node::default() });
        self.nodes.push(node);
    }

    /// An accessor with a view of its own, behind everything so far.
    fn accessor(
        &mut self,
        count: usize,
        type_: Type,
        component: ComponentType,
        target: Option<Target>,
    ) -> Index<Accessor> {
        let bytes = (count * type_.multiplicity() * component.size()) as u64;
        let view = self.root.push(View {
            buffer: Index::new(0),
            byte_length: bytes.into(),
            byte_offset: Some(self.length.into()),
            byte_stride: None,
            name: None,
            target: target.map(Valid),
            extensions: None,
            extras: Default::default(),
        });
        self.length += bytes;
        self.root.push(Accessor {
            buffer_view: Some(view),
            byte_offset: None,
            count: count.into(),
            component_type: Valid(GenericComponentType(component)),
            type_: Valid(type_),
            min: None,
            max: None,
            name: None,
            normalized: false,
            sparse: None,
            extensions: None,
            extras: Default::default(),
        })
    }

    /// The JSON, and the length of the buffer.
    fn finish(mut self) -> Result<(Vec<u8>, u64), WriteError> {
        if self.length > 0 {
            self.root.push(Buffer {
                byte_length: self.length.into(),
                name: None,
                uri: None,
                extensions: None,
                extras: Default::default(),
            });
        }
        let scene = Scene { name: None, nodes: self.nodes, extensions: None, extras: Default::default() };
        self.root.scene = Some(self.root.push(scene));
        let json = self.root.to_vec().map_err(|error| WriteError::Io(error.into()))?;
        Ok((json, self.length))
    }
}
