use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits;

/// Which way is up in a model's file.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum UpFile {
    /// As in glTF and in scenes.
    Y,
    /// As in Blender's and CAD programs' own files: the model is turned to stand.
    Z,
}

/// Where a volume or a copy of a model stands: scaled first, then turned, then moved.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct TransformFile {
    /// Where its origin comes to lie, in metres. Default [0, 0, 0].
    pub position: [f32; 3],
    /// Turns about the x, then the y, then the z axis, in degrees. Default [0, 0, 0].
    pub rotation: [f32; 3],
    /// One factor, or one along each axis; not 0. Default 1.
    pub scale: ScaleFile,
}

/// A factor, or one along each axis.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ScaleFile {
    /// The same along all axes.
    One(#[schemars(transform = &limits::STRETCH)] f32),
    /// Along x, y and z.
    Axes(#[schemars(transform = &limits::STRETCH)] [f32; 3]),
}

impl Default for ScaleFile {
    fn default() -> Self {
        Self::One(1.0)
    }
}
