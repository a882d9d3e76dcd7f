use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits;

/// Paint that the particles of a smoke leave on the models that they touch.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct StainFile {
    /// Name of the `kind = "smoke"`; it may be invisible.
    pub from: String,
    /// Of so many particles one leaves paint, 1 or more. Default 1.
    #[serde(default = "one")]
    #[schemars(transform = &limits::COUNT)]
    pub every: u32,
    /// How many stains stay, 1 or more; then the oldest give way. Default 512.
    #[serde(default = "most")]
    #[schemars(transform = &limits::COUNT)]
    pub most: u32,
    /// A stain's radius over that of its particle, above 0. Default 1.
    #[serde(default = "size")]
    #[schemars(transform = &limits::SCALE)]
    pub size: f32,
    /// Whether particles end where they touch a model, as rain does. Default false.
    #[serde(default)]
    pub ends: bool,
}

fn one() -> u32 {
    1
}

fn most() -> u32 {
    512
}

fn size() -> f32 {
    1.0
}
