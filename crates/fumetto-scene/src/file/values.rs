use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits;

/// One table, or an array of tables.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
#[schemars(rename = "OneOrMany{T}")]
pub enum OneOrMany<T> {
    /// `[camera]`
    One(T),
    /// `[[camera]]`
    Many(Vec<T>),
}

impl<T> OneOrMany<T> {
    /// All of them, in the file's order.
    #[must_use]
    pub fn as_slice(&self) -> &[T] {
        match self {
            Self::One(one) => std::slice::from_ref(one),
            Self::Many(many) => many,
        }
    }
}

/// A colour: `"#rrggbb"` (sRGB), or `[r, g, b]` from 0 to 1 (linear).
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ColourFile {
    /// Six hexadecimal digits of sRGB after a `#`.
    Hex(#[schemars(regex(pattern = "^#[0-9a-fA-F]{6}$"))] String),
    /// Red, green and blue, linear, from 0 to 1.
    Linear(#[schemars(transform = &limits::SHARE)] [f32; 3]),
}

/// One number, or `[least, most]` between which every particle draws its own.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum RangeFile {
    /// The same for all.
    One(f32),
    /// Least and most.
    Range([f32; 2]),
}

/// One number, or points `[[age, value], …]` with ages rising from 0 (birth) to 1 (death).
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum CurveFile {
    /// The same for the whole of life.
    One(f32),
    /// `[age, value]` pairs; the value is linear between them.
    Points(Vec<[f32; 2]>),
}
