use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::InkFile;
use crate::limits;

/// One closed skin round all particles, where their densities add up to the threshold; or round what is denser in a
/// volume out of a file.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SurfaceFile {
    /// The density at which the surface lies, above 0. A particle's density is its mass in its middle and
    /// falls to 0 at its radius. Default 0.05, and of a volume out of a file 0.5.
    #[schemars(transform = &limits::MASS)]
    pub threshold: Option<f32>,
    /// How many cells the surface is sampled with along the object's longest side, 1 to 512. Default 48.
    #[schemars(transform = &limits::SUBDIVISIONS)]
    pub subdivisions: Option<u32>,
    /// In place of `subdivisions`: the side of a cell in metres, above 0.
    #[schemars(transform = &limits::LENGTH)]
    pub cell: Option<f32>,
    /// In place of `subdivisions`: cells to a particle's mean radius, above 0.
    #[schemars(transform = &limits::PER_RADIUS)]
    pub per_radius: Option<f32>,
    /// In place of `subdivisions`: the side of a cell in pixels of the picture, where the object is nearest to the
    /// camera, 1 to 512. For the style's `height`.
    #[schemars(transform = &limits::CELL_PX)]
    pub pixels: Option<f32>,
    /// Multiplies the particles' radii, above 0. Default 1.
    #[schemars(transform = &limits::SCALE)]
    pub size: f32,
    /// Noise that roughens the surface. Default: none.
    pub noise: Option<NoiseFile>,
    /// Inner surfaces of which only the lines are drawn, over this one.
    pub detail: Option<Vec<DetailFile>>,
}

impl Default for SurfaceFile {
    fn default() -> Self {
        Self {
            threshold: None,
            subdivisions: None,
            cell: None,
            per_radius: None,
            pixels: None,
            size: 1.0,
            noise: None,
            detail: None,
        }
    }
}

/// A layer of detail: a second surface of the same particles with less radius and mass, of which only the
/// lines are drawn. What is left out is as for the outer surface.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct DetailFile {
    /// Multiplies the radii that the particles have in the outer surface, above 0. Default 0.8.
    #[schemars(transform = &limits::SCALE)]
    pub size: f32,
    /// Multiplies the particles' masses, above 0. Default 1.
    #[schemars(transform = &limits::SCALE)]
    pub mass: f32,
    /// The density at which it lies, above 0.
    #[schemars(transform = &limits::MASS)]
    pub threshold: Option<f32>,
    /// How many cells it is sampled with along its longest side, 1 to 512.
    #[schemars(transform = &limits::SUBDIVISIONS)]
    pub subdivisions: Option<u32>,
    /// In place of `subdivisions`: the side of a cell in metres, above 0.
    #[schemars(transform = &limits::LENGTH)]
    pub cell: Option<f32>,
    /// In place of `subdivisions`: cells to a particle's mean radius, above 0.
    #[schemars(transform = &limits::PER_RADIUS)]
    pub per_radius: Option<f32>,
    /// In place of `subdivisions`: the side of a cell in pixels of the picture, where the layer is nearest to the
    /// camera, 1 to 512. For the style's `height`.
    #[schemars(transform = &limits::CELL_PX)]
    pub pixels: Option<f32>,
    /// Noise that roughens it; an `amplitude` of 0 leaves it smooth.
    pub noise: Option<NoiseFile>,
    /// How its lines differ from the object's.
    pub ink: Option<InkFile>,
}

impl Default for DetailFile {
    fn default() -> Self {
        Self {
            size: 0.8,
            mass: 1.0,
            threshold: None,
            subdivisions: None,
            cell: None,
            per_radius: None,
            pixels: None,
            noise: None,
            ink: None,
        }
    }
}

/// Noise that is added to the density, fixed in the world unless it drifts.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct NoiseFile {
    /// The most that it adds or takes away, in thresholds, 0 to 100.
    #[schemars(transform = &limits::AMPLITUDE)]
    pub amplitude: f32,
    /// Size of the largest bumps in metres, above 0.
    #[schemars(transform = &limits::LENGTH)]
    pub size: f32,
    /// Each octave has half the size and half the strength of the one before; 1 to 6. Default 3.
    #[serde(default = "octaves")]
    #[schemars(transform = &limits::OCTAVES)]
    pub octaves: u32,
    /// What it is made from. Default 1.
    #[serde(default = "seed")]
    pub seed: u32,
    /// How fast it travels, in m/s: as fast as smoke rises, and its bumps rise along. Default `[0, 0, 0]`.
    #[serde(default)]
    #[schemars(transform = &limits::SPEED)]
    pub drift: [f32; 3],
}

fn octaves() -> u32 {
    3
}

fn seed() -> u32 {
    1
}
