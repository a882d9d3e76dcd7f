use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits;

/// What moves smoke besides its forces.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SolverFile {
    /// Vortex rings, which emitters shed and which carry the smoke and each other: it curls and rolls.
    Vortex,
    /// Nothing: every particle goes its own way.
    Forces,
    /// Air in a box of cells, which smoke heats and pushes and which carries it.
    Grid,
}

/// How the vortices of `solver = "vortex"` are shed, and what becomes of them.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct VortexFile {
    /// Multiplies the circulation of the rings that emitters shed of themselves; 0 sheds none, 1 is what a
    /// jet of air would shed. Default 0.5.
    #[schemars(transform = &limits::FACTOR)]
    pub strength: f32,
    /// Multiplies what buoyancy adds to their circulation as they rise. Default 0.25.
    #[schemars(transform = &limits::FACTOR)]
    pub buoyancy: f32,
    /// How thick a ring's line is, as a share of the ring's radius, 0.05 to 1. Default 0.5.
    #[schemars(transform = &limits::CORE)]
    pub core: f32,
    /// How fast lines get thicker, in m²/s: after a time t the square of their thickness has grown by
    /// 4 viscosity t. Default 0.
    #[schemars(transform = &limits::FACTOR)]
    pub viscosity: f32,
    /// How fast circulation dies, per second. Default 0.3.
    #[schemars(transform = &limits::RATE)]
    pub decay: f32,
    /// Vortex particles in a ring, 8 to 128. Default 24.
    #[schemars(transform = &limits::SEGMENTS)]
    pub segments: u32,
    /// The most by which the speed of the air may be wrong, as a share of what it would be if all vortices
    /// turned it the same way, above 0, at most 1. Default 0.1.
    #[schemars(transform = &limits::PART)]
    pub error: f32,
}

impl Default for VortexFile {
    fn default() -> Self {
        Self {
            strength: 0.5,
            buoyancy: 0.25,
            core: 0.5,
            viscosity: 0.0,
            decay: 0.3,
            segments: 24,
            error: 0.1,
        }
    }
}

/// Vortex rings on demand, in place of those that an emitter sheds of itself.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct RingsFile {
    /// Circulation in m²/s: a thin ring of radius R travels along the emitter's `velocity` at about
    /// circulation / (4 R); negative: against it.
    #[schemars(transform = &limits::SPEED)]
    pub circulation: f32,
    /// Rings a second. Default 0.
    #[serde(default)]
    #[schemars(transform = &limits::RATE)]
    pub rate: f32,
    /// Moments of single rings, in seconds from the beginning of the simulation: frame 0, but for `pre_roll`.
    #[serde(default)]
    #[schemars(transform = &limits::SECONDS)]
    pub at: Vec<f32>,
    /// Radius of a ring in metres, above 0. Default: that of the emitter's mouth.
    #[schemars(transform = &limits::LENGTH)]
    pub radius: Option<f32>,
    /// How far rings are from round, as a share of their radius, 0 to 1. Default 0.05.
    #[serde(default = "wobble")]
    #[schemars(transform = &limits::SHARE)]
    pub wobble: f32,
}

fn wobble() -> f32 {
    0.05
}
