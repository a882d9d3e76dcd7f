//! Models out of files that 3-D programs write.

mod companions;
mod curve;
mod gltf;
mod mend;
mod normals;
mod obj;
mod rig;
mod textures;

use std::io;

use self::companions::Companions;
use self::rig::Rig;
use crate::{FormatError, Image};

/// Most triangles that a model may show, counted once for every place where a part stands.
///
/// Their corners alone take 600 MB.
pub const MAX_MODEL_TRIANGLES: u64 = 16_000_000;

/// The angle between two triangles above which their common edge is sharp, where a file does not say.
pub const DEFAULT_SMOOTH_DEGREES: f32 = 60.0;

/// Triangles in parts, with materials, placed by nodes that may move over time.
///
/// Lengths are metres and +Y is up, as in glTF: numbers are taken as they are.
#[derive(Clone, Debug)]
pub struct Model {
    /// What is placed; at least one.
    pub parts: Vec<Part>,
    /// What the parts are made of; at least one.
    pub materials: Vec<Material>,
    /// The pictures that materials show.
    pub textures: Vec<Image>,
    /// What the user should know about how the file was understood: sentences that name the file.
    pub notes: Vec<String>,
    rig: Rig,
}

/// Triangles of one material; at least one, and none without area.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The name that the file gives it; may be empty, and may be that of other parts.
    pub name: String,
    /// Its place in [`Model::materials`].
    pub material: usize,
    /// Where its vertices are; finite.
    pub positions: Vec<[f32; 3]>,
    /// The direction in which the surface looks at each vertex; as many as positions, all of length 1.
    pub normals: Vec<[f32; 3]>,
    /// Where each vertex lies on the material's texture: from its top left corner, downwards. As many
    /// as positions, or none.
    pub uvs: Vec<[f32; 2]>,
    /// Linear colour and alpha of each vertex, which multiply the material's. As many as positions, or
    /// none.
    pub colours: Vec<[f32; 4]>,
    /// Three vertices each, counter-clockwise as seen from the front.
    pub triangles: Vec<[u32; 3]>,
}

/// What a part is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name that the file gives it; may be empty.
    pub name: String,
    /// Linear colour and alpha, which multiply the texture's.
    pub colour: [f32; 4],
    /// The picture on it.
    pub texture: Option<Texture>,
    /// Whether its triangles are seen from behind, too.
    pub double_sided: bool,
    /// The alpha, of texture, vertex and material multiplied, under which there is no surface; without
    /// it, alpha counts for nothing.
    pub alpha_cutoff: Option<f32>,
}

impl Default for Material {
    /// glTF's default: white, and seen from the front.
    fn default() -> Self {
        Self { name: String::new(), colour: [1.0; 4], texture: None, double_sided: false, alpha_cutoff: None }
    }
}

/// A picture on a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Texture {
    /// Its place in [`Model::textures`].
    pub image: usize,
    /// What lies beyond its edges: to the sides, then above and below.
    pub wrap: [Wrap; 2],
}

/// How a texture goes on beyond its edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// It starts anew.
    #[default]
    Repeat,
    /// It starts anew, every other time as in a mirror.
    Mirror,
    /// The pixels at its edge go on.
    Clamp,
}

/// A part in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// Its place in [`Model::parts`].
    pub part: usize,
    /// Parts of one group come one after another and always have the same transform.
    pub group: usize,
    /// From the part's coordinates to the model's, in columns; finite, and affine as long as the file is.
    ///
    /// It may mirror, when its determinant is below zero: the corners of a triangle that is placed by it
    /// then run clockwise as seen from the front. It may also flatten the part, to nothing at times, as
    /// files do to hide it.
    pub world_from_part: [[f32; 4]; 4],
}

/// How a model is read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ModelOptions {
    /// Computes normals anew, smooth across edges at which triangles meet with less than this angle and
    /// sharp across the others. `None` keeps the file's normals; parts without any get theirs as if with
    /// [`DEFAULT_SMOOTH_DEGREES`].
    pub smooth_degrees: Option<f32>,
}

impl Model {
    /// Where its parts are at `time_secs`: as many at every time, in the same order.
    ///
    /// Animations are played all together and start again when the longest of them is over, so that its
    /// last moment is its first.
    #[must_use]
    pub fn placed(&self, time_secs: f32) -> Vec<Placed> {
        self.rig.placed(time_secs)
    }

    /// Whether anything moves.
    #[must_use]
    pub fn is_animated(&self) -> bool {
        self.rig.is_animated()
    }

    /// How long its animations last; 0 without any.
    #[must_use]
    pub fn duration_secs(&self) -> f32 {
        self.rig.duration_secs()
    }

    /// The triangles that are seen, counted once for every place where a part stands.
    #[must_use]
    pub fn triangle_count(&self) -> u64 {
        self.rig.count(|part| self.parts[part].triangles.len() as u64)
    }
}

/// Reads a model from `bytes`; the extension of `path` (any case) says which format they have.
///
/// `.gltf` and `.glb`: glTF 2.0, the default scene. Nodes move as its animations say; skins and morph
/// targets stay as they are at rest. `.obj`: Wavefront OBJ with its materials; `o`, `g` and `usemtl`
/// start a part, and colours are taken as sRGB. Textures are PNG or JPEG.
///
/// `read` is asked for what the file needs beside itself, by paths that start where `path` starts: what
/// `models/house.gltf` calls `textures/wall%201.png` is asked for as `models/textures/wall 1.png`. Such a
/// path may well begin with `..`; whether it is followed is for `read` to decide.
///
/// # Errors
/// If the file is not of its format, needs an extension that is not known here or a buffer that cannot
/// be read, shows no triangle or more than [`MAX_MODEL_TRIANGLES`]. A texture that cannot be read is left
/// out with a note, as are triangles without area.
pub fn read_model(
    path: &str,
    bytes: &[u8],
    options: ModelOptions,
    read: &mut dyn FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<Model, FormatError> {
    let extension = path.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
    let companions = Companions::new(path, read);
    match extension.as_deref() {
        Some("gltf" | "glb") => gltf::read(path, bytes, options, companions),
        Some("obj") => obj::read(path, bytes, options, companions),
        _ => Err(FormatError::UnknownModel { file: path.to_owned() }),
    }
}
