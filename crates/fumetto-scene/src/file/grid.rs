use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::limits;

/// The air of `solver = "grid"`: a box of cells in which it is simulated.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct GridFile {
    /// Where it is. Default: around the emitters and where their smoke is likely to go.
    #[serde(rename = "box")]
    pub bounds: Option<GridBoxFile>,
    /// Cells along its longest side, 8 to 512; rounded up to a multiple of 8, or of more where there are more than
    /// 128. At most 16,777,216 in all. Default 64.
    #[schemars(transform = &limits::GRID_CELLS)]
    pub cells: u32,
    /// Which of its sides are walls. Default: none.
    pub walls: WallsFile,
    /// How hard eddies that the grid would lose are kept alive, per second: 0 leaves them alone, 2 is usual.
    /// Default 2.
    #[schemars(transform = &limits::FACTOR)]
    pub confinement: f32,
    /// Eddies that emitters bring, smaller than cells could by themselves. Default: none.
    pub eddies: Option<EddiesFile>,
    /// How fast air loses the smoke that it carries, per second: what `gravity` and `attract` push. Default 0.2.
    #[schemars(transform = &limits::RATE)]
    pub dissipation: f32,
    /// Of the air, in m²/s. Default 0.
    #[schemars(transform = &limits::FACTOR)]
    pub viscosity: f32,
    /// The share of divergence (air that appears or is lost) that may be left in every sub-step, above 0, to 0.5.
    /// Default 0.02.
    #[schemars(transform = &limits::RESIDUAL)]
    pub residual: f32,
}

impl Default for GridFile {
    fn default() -> Self {
        Self {
            bounds: None,
            cells: 64,
            walls: WallsFile::default(),
            confinement: 2.0,
            eddies: None,
            dissipation: 0.2,
            viscosity: 0.0,
            residual: 0.02,
        }
    }
}

/// A box along the axes.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct GridBoxFile {
    /// Its middle, in metres.
    pub center: [f32; 3],
    /// Its sides in metres, each above 0. All but the longest are rounded up to whole cells.
    #[schemars(transform = &limits::LENGTH)]
    pub size: [f32; 3],
}

/// One side of a box.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum WallFile {
    /// Air goes in and out.
    #[default]
    Open,
    /// Nothing goes through.
    Closed,
}

/// The low and the high side along every axis. Default: all open.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct WallsFile {
    /// Left and right.
    pub x: [WallFile; 2],
    /// Below and above.
    pub y: [WallFile; 2],
    /// Behind and in front.
    pub z: [WallFile; 2],
}

/// Vortex particles that live in a grid: they go with the air, and turn it.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct EddiesFile {
    /// How many are alive for each emitter, 1 to 4096.
    #[schemars(transform = &limits::EDDIES)]
    pub count: u32,
    /// How far each reaches, in metres, above 0.
    #[schemars(transform = &limits::LENGTH)]
    pub radius: f32,
    /// How hard each pushes the air round, in m/s².
    #[schemars(transform = &limits::FACTOR)]
    pub strength: f32,
}

/// What an emitter brings into the air of a grid, besides its particles.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SourceFile {
    /// How hot its air is: `buoyancy` lifts air of 1 as it says. Default 1.
    #[schemars(transform = &limits::FACTOR)]
    pub heat: f32,
    /// How much smoke is in its air: `gravity` and `attract` push air of 1 as they say. Default 1.
    #[schemars(transform = &limits::FACTOR)]
    pub smoke: f32,
    /// Air that appears in it, in its own volumes a second: an explosion. Negative: air that is sucked in. Default 0.
    #[schemars(transform = &limits::EXPANSION)]
    pub expansion: f32,
    /// Seconds for which each of its `bursts` brings all this, above 0. Default 0.1.
    #[schemars(transform = &limits::PERIOD_SECS)]
    pub secs: f32,
}

impl Default for SourceFile {
    fn default() -> Self {
        Self { heat: 1.0, smoke: 1.0, expansion: 0.0, secs: 0.1 }
    }
}
