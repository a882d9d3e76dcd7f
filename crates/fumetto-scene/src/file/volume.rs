use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::ColourFile;
use crate::limits;

/// Matter that light goes through: every particle is a soft or knobbly puff of it and all together are one field,
/// or a file tells where it is.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct VolumeFile {
    /// How fast light dies in matter of mass 1, per metre, above 0: in 1 / `extinction` metres 1/e of it is
    /// left. Default 4.
    #[schemars(transform = &limits::EXTINCTION)]
    pub extinction: f32,
    /// How dense a puff is inside: "constant" (the default), or "linear", which falls from the middle to
    /// nothing at its surface.
    pub profile: ProfileFile,
    /// How fuzzy a puff's edge is: the share of its radius over which the density rises inward, 0 (hard) to 1.
    /// Default 0.
    #[schemars(transform = &limits::SHARE)]
    pub edge: f32,
    /// The puff's radius over the particle's radius, above 0. Default 1.
    #[schemars(transform = &limits::SCALE)]
    pub size: f32,
    /// Noise that pushes a puff's surface in and out. Default: none, and puffs are balls.
    pub noise: Option<VolumeNoiseFile>,
    /// Colours of the matter, 1 to 8: each puff takes one and keeps it. Where a file tells how hot matter is, from
    /// the cold to the hot. Default white.
    pub colours: Option<Vec<ColourFile>>,
    /// Light that the matter gives off by itself, as if from all sides, 0 to 1e6; where a file tells how hot matter
    /// is, at heat 1. Default 0.
    #[schemars(transform = &limits::FACTOR)]
    pub glow: f32,
    /// From flat (0) to soft (1): how much of the picture is as a camera would see it, in place of the style's
    /// tones. Default 0.
    #[schemars(transform = &limits::SHARE)]
    pub soft: f32,
    /// How much matter a line of sight goes through before it meets the surface that is drawn and inked: its
    /// opacity, above 0 and below 1. Default 0.5.
    #[schemars(transform = &limits::INSIDE)]
    pub surface: f32,
    /// How much the way that the surface faces counts for tones, beside the light that comes through, 0 to 1.
    /// Default 0.5.
    #[schemars(transform = &limits::SHARE)]
    pub relief: f32,
    /// The shadow that it throws on other things: where the matter on the way to a light is more opaque than this, 0 to 1. At
    /// 0, the default, it throws none.
    #[schemars(transform = &limits::SHARE)]
    pub shadow: f32,
    /// How many cells the density is sampled with along the object's longest side, 8 to 512. Default 128.
    #[schemars(transform = &limits::VOLUME_CELLS)]
    pub cells: u32,
    /// How many cells light is sampled with along the longest side, 4 to 256. Default 64.
    #[schemars(transform = &limits::LIGHT_CELLS)]
    pub light_cells: u32,
    /// Only of a volume out of a file: the radius of its lobes in metres, above 0, for `style.form` and for inner
    /// lines. Default: an eighth of its longest side.
    #[schemars(transform = &limits::LENGTH)]
    pub lobe: Option<f32>,
    /// Length of a step along the line of sight in metres, above 0. Default: half a cell, or half a voxel.
    #[schemars(transform = &limits::LENGTH)]
    pub step: Option<f32>,
    /// Sides, in pixels, of the squares that one line of sight is followed for, 1 to 8. Above 1 light is blended between
    /// them, as far as what is solid lies as far away: for soft matter without fine edges, and for a quick look.
    /// Default 1.
    #[schemars(transform = &limits::VOLUME_PIXELS)]
    pub pixels: u32,
    /// Multiplies `cells` and `light_cells`, and shortens the default step, above 0, to 4: less for a quick look.
    /// Default 1.
    #[schemars(transform = &limits::QUALITY)]
    pub quality: f32,
}

impl Default for VolumeFile {
    fn default() -> Self {
        Self {
            extinction: 4.0,
            profile: ProfileFile::Constant,
            edge: 0.0,
            size: 1.0,
            noise: None,
            colours: None,
            glow: 0.0,
            soft: 0.0,
            surface: 0.5,
            relief: 0.5,
            shadow: 0.0,
            cells: 128,
            light_cells: 64,
            lobe: None,
            step: None,
            pixels: 1,
            quality: 1.0,
        }
    }
}

/// How dense a puff is inside.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProfileFile {
    /// The same everywhere.
    Constant,
    /// Falls from the middle to nothing at the surface.
    Linear,
}

/// Octaves of noise that displace a puff's surface along its normal.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct VolumeNoiseFile {
    /// The farthest that the surface is displaced, in radii of the puff, 0 to 10. Default 0.5.
    #[schemars(transform = &limits::DISPLACEMENT)]
    pub amplitude: f32,
    /// Bumps of the first octave to a radius, above 0, to 100. Default 2.
    #[schemars(transform = &limits::FREQUENCY)]
    pub frequency: f32,
    /// Octaves, 1 to 8. Default 4.
    #[schemars(transform = &limits::VOLUME_OCTAVES)]
    pub octaves: u32,
    /// Each octave's strength over that of the one before, 0 to 1. Default 0.5.
    #[schemars(transform = &limits::SHARE)]
    pub persistence: f32,
    /// Each octave's frequency over that of the one before, 1 to 8. Default 2.
    #[schemars(transform = &limits::LACUNARITY)]
    pub lacunarity: f32,
    /// What it is made from. Default 1.
    pub seed: u32,
    /// How fast it travels through the puffs, in radii a second. Default `[0, 0, 0]`.
    pub drift: [f32; 3],
    /// Whether bumps are round and the creases between them sharp (outward only), or plain noise that goes in
    /// and out. Default true.
    pub billow: bool,
}

impl Default for VolumeNoiseFile {
    fn default() -> Self {
        Self {
            amplitude: 0.5,
            frequency: 2.0,
            octaves: 4,
            persistence: 0.5,
            lacunarity: 2.0,
            seed: 1,
            drift: [0.0; 3],
            billow: true,
        }
    }
}
