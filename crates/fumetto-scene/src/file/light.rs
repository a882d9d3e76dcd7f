use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits;

/// A light that throws hard, cartoon light.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum LightFile {
    /// Parallel rays.
    Sun {
        /// The way the light travels; of any length above zero.
        direction: [f32; 3],
        /// How much it adds; 1 lights a facing surface fully. Default 1.
        #[serde(default = "intensity")]
        #[schemars(transform = &limits::INTENSITY)]
        intensity: f32,
        /// Whether objects throw its shadows. Default true.
        #[serde(default = "yes")]
        shadow: bool,
        /// Makes its shadows soft: several suns close to each other throw them.
        cluster: Option<SunClusterFile>,
    },
    /// Rays from one place, not weaker in the distance.
    Point {
        /// Where it is, in metres.
        position: [f32; 3],
        /// How much it adds; 1 lights a facing surface fully. Default 1.
        #[serde(default = "intensity")]
        #[schemars(transform = &limits::INTENSITY)]
        intensity: f32,
        /// Whether objects throw its shadows. Default true.
        #[serde(default = "yes")]
        shadow: bool,
        /// Makes its shadows soft: several lights close to each other throw them.
        cluster: Option<LampClusterFile>,
    },
}

fn intensity() -> f32 {
    1.0
}

fn yes() -> bool {
    true
}

/// Suns in place of one.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct SunClusterFile {
    /// How many there are, 2 to 16: shadows fade in as many steps. Default 8.
    #[serde(default = "lights")]
    #[schemars(transform = &limits::CLUSTER)]
    pub lights: u32,
    /// How far they stand from their middle, in degrees, above 0, to 45.
    #[schemars(transform = &limits::CLUSTER_DEG)]
    pub angle: f32,
}

/// Lights in place of one.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct LampClusterFile {
    /// How many there are, 2 to 16: shadows fade in as many steps. Default 8.
    #[serde(default = "lights")]
    #[schemars(transform = &limits::CLUSTER)]
    pub lights: u32,
    /// How far they stand from their middle, in metres, above 0.
    #[schemars(transform = &limits::LENGTH)]
    pub radius: f32,
}

fn lights() -> u32 {
    8
}
