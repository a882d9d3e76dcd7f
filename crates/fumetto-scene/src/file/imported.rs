use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits;

/// A volume that another program made: the path of its file, or a table that also says how it is read.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ImportedFile {
    /// The path of a .vdb, .nrrd or .npy file.
    Path(#[schemars(extend("x-files" = ["vdb", "nrrd", "npy"]))] String),
    /// The file, and what in it is what.
    Read(Box<ReadFile>),
}

/// Which file a volume is read from, and what in it is what.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct ReadFile {
    /// The path of a .vdb, .nrrd or .npy file, or of raw numbers, relative to the scene file; `####` or `{}` in
    /// its name numbers a sequence by frame.
    #[schemars(extend("x-files" = ["vdb", "nrrd", "npy", "raw"]))]
    pub file: String,
    /// The grid of a .vdb file that is the density. Default: "density", or the first grid of single numbers.
    pub density: Option<String>,
    /// The grid of a .vdb file that tells how hot matter is, as "temperature" or "flame". Default: none.
    pub heat: Option<String>,
    /// Numbers of the file that mean density 0 and density 1; the second may be the smaller. Default [0, 1], and
    /// for level sets a voxel outside and a voxel inside.
    pub range: Option<[f32; 2]>,
    /// Numbers of the file that mean heat 0 and heat 1. Default [0, 1].
    #[serde(default = "unit")]
    pub heat_range: [f32; 2],
    /// The numbers of a sequence's first and last file. Before and after them these two stand. Default: as many as
    /// the scene has frames.
    pub frames: Option<[u32; 2]>,
    /// Whether a sequence begins anew after the last of its `frames`. Default false.
    #[serde(default, rename = "loop")]
    pub repeats: bool,
    /// How the numbers of a file without a header lie in it.
    pub raw: Option<RawFile>,
}

fn unit() -> [f32; 2] {
    [0.0, 1.0]
}

/// How the numbers of a file without a header lie in it: along x first, then y, then z.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct RawFile {
    /// Voxels along x, y and z, 1 to 65536 each.
    #[schemars(transform = &limits::RAW_SIDE)]
    pub size: [u32; 3],
    /// What a number is.
    #[serde(rename = "type")]
    pub number: RawNumberFile,
    /// Which byte of a number comes first: the "little" end (the default) or the "big" one.
    #[serde(default)]
    pub order: ByteOrderFile,
    /// Sides of a voxel in metres, above 0. Default [1, 1, 1].
    #[serde(default = "metre")]
    #[schemars(transform = &limits::LENGTH)]
    pub voxel: [f32; 3],
    /// Where the middle of the first voxel lies, in metres. Default [0, 0, 0].
    #[serde(default)]
    pub origin: [f32; 3],
    /// Bytes before the first number. Default 0.
    #[serde(default)]
    pub skip: u32,
}

fn metre() -> [f32; 3] {
    [1.0; 3]
}

/// What a number in a file without a header is.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RawNumberFile {
    /// A byte, 0 to 255.
    U8,
    /// A byte, -128 to 127.
    I8,
    /// Two bytes, 0 to 65535.
    U16,
    /// Two bytes, -32768 to 32767.
    I16,
    /// Four bytes, from 0.
    U32,
    /// Four bytes, below 0 too.
    I32,
    /// Half precision.
    F16,
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}

/// Which byte of a number comes first.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ByteOrderFile {
    /// The least.
    #[default]
    Little,
    /// The greatest.
    Big,
}
