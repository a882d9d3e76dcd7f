use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{ColourFile, StyleFile, WidthFile};
use crate::limits;

/// A drop of paint.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct DropFile {
    /// Where it falls, in metres.
    pub at: [f32; 3],
    /// When it falls, in seconds. Default 0.
    #[serde(default)]
    #[schemars(transform = &limits::SECONDS)]
    pub time: f32,
    /// The radius that its pressure drives it to, in metres: a number above 0, or points
    /// `[[seconds since it fell, metres], …]`.
    pub radius: GrowthFile,
    /// The radius with which it falls, and which elasticity pulls it back to, in metres, above 0. Default: a
    /// tenth of the largest `radius`.
    #[schemars(transform = &limits::LENGTH)]
    pub start: Option<f32>,
}

/// A brush that paints along a path.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct BrushFile {
    /// Places that the brush goes through at an even speed, two or more, in metres.
    pub path: Vec<[f32; 3]>,
    /// From when until when, in seconds.
    #[schemars(transform = &limits::SECONDS)]
    pub during: [f32; 2],
    /// As of a drop; seconds count from when the brush comes to a piece of the path.
    pub radius: GrowthFile,
    /// As of a drop.
    #[schemars(transform = &limits::LENGTH)]
    pub start: Option<f32>,
}

/// A radius in metres, or points `[[seconds, metres], …]`; linear between them.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum GrowthFile {
    /// The same all the time.
    One(f32),
    /// Pairs with rising seconds.
    Points(Vec<[f32; 2]>),
}

/// Paint that is poured onto the cells of a grid.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PourFile {
    /// Where it falls, in metres; only x and z count.
    pub at: [f32; 3],
    /// From when until when, in seconds.
    #[schemars(transform = &limits::SECONDS)]
    pub during: [f32; 2],
    /// How much paint comes, in cubic metres a second, above 0.
    #[schemars(transform = &limits::SCALE)]
    pub rate: f32,
}

/// A grid over the models of the scene, of which each cell holds paint and spills into its neighbours when full.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct CellsFile {
    /// The middle of the box that the grid fills, in metres; paint lies on the highest model in it.
    pub center: [f32; 3],
    /// The box's sides, in metres, above 0.
    #[schemars(transform = &limits::LENGTH)]
    pub size: [f32; 3],
    /// Side of a cell along x and z, in metres, above 0.
    #[schemars(transform = &limits::LENGTH)]
    pub cell: f32,
    /// How deep paint lies in a cell before it spills, in metres, above 0. Default: a tenth of `cell`.
    #[schemars(transform = &limits::LENGTH)]
    pub depth: Option<f32>,
    /// How fast paint runs from cell to cell, in m/s, above 0. Default 2.
    #[serde(default = "speed")]
    #[schemars(transform = &limits::SCALE)]
    pub speed: f32,
    /// How unevenly cells hold paint, 0 to 1. Default 0.4.
    #[serde(default = "uneven")]
    #[schemars(transform = &limits::SHARE)]
    pub uneven: f32,
}

fn speed() -> f32 {
    2.0
}

fn uneven() -> f32 {
    0.4
}

/// How paint spreads: every vertex of its volumes is a particle that pressure drives outward, elasticity pulls
/// back and friction slows down.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SpreadFile {
    /// Into how many pieces each edge of an icosahedron is cut, 1 to 16, for a volume's mesh: n make 10 n² + 2
    /// vertices. Default 8.
    #[schemars(transform = &limits::SPHERE_PIECES)]
    pub subdivisions: u32,
    /// How hard pressure drives a volume to its desired radius, per square second, above 0. Default 16.
    #[schemars(transform = &limits::STIFFNESS)]
    pub stiffness: f32,
    /// How hard elasticity pulls it back to what it was at first, per square second. Default 0.
    #[schemars(transform = &limits::ELASTICITY)]
    pub elasticity: f32,
    /// Friction as a share of what just keeps volumes from ringing, above 0, to 10. Default 1.
    #[schemars(transform = &limits::FRICTION)]
    pub friction: f32,
    /// What pulls all of it, in m/s². Default `[0, 0, 0]`.
    pub gravity: [f32; 3],
    /// How hard paint that lies on models is drawn down along their surface, in m/s² where this stands upright.
    /// Default 0.
    #[schemars(transform = &limits::DOWNHILL)]
    pub downhill: f32,
    /// How far the grain of what it lies on moves a volume's border, as a share of its radius, 0 to 0.9.
    /// Default 0.12.
    #[schemars(transform = &limits::GRAIN)]
    pub grain: f32,
    /// Size of the grain's largest bumps, in metres, above 0. Default: half of the largest radius.
    #[schemars(transform = &limits::LENGTH)]
    pub grain_size: Option<f32>,
}

impl Default for SpreadFile {
    fn default() -> Self {
        Self {
            subdivisions: 8,
            stiffness: 16.0,
            elasticity: 0.0,
            friction: 1.0,
            gravity: [0.0; 3],
            downhill: 0.0,
            grain: 0.12,
            grain_size: None,
        }
    }
}

/// A box along the axes.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct BoxFile {
    /// Its middle, in metres.
    pub center: [f32; 3],
    /// Its sides, in metres, above 0.
    #[schemars(transform = &limits::LENGTH)]
    pub size: [f32; 3],
}

/// Volumes in volumes: each lays another wash over what it covers.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct WashFile {
    /// How many there are, 1 to 8. Default 3.
    #[serde(default = "washes")]
    #[schemars(transform = &limits::WASHES)]
    pub steps: u32,
    /// How much smaller each is than the one around it, as a share of the radius, 0 to 1. Default 0.2.
    #[serde(default = "spacing")]
    #[schemars(transform = &limits::SHARE)]
    pub spacing: f32,
    /// The paint's colour.
    pub colour: ColourFile,
    /// How much of it each wash lays on, 0 to 1. Default 0.4.
    #[serde(default = "strength")]
    #[schemars(transform = &limits::SHARE)]
    pub strength: f32,
    /// "glaze" (the default) tints what lies under it, "cover" hides it.
    #[serde(default)]
    pub mode: WashModeFile,
}

fn washes() -> u32 {
    3
}

fn spacing() -> f32 {
    0.2
}

fn strength() -> f32 {
    0.4
}

/// What a wash does with what lies under it.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum WashModeFile {
    /// Takes from its light, as watercolour does.
    #[default]
    Glaze,
    /// Hides it, as gouache does; white washes it out.
    Cover,
}

/// A line along the edge of paint.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct BorderFile {
    /// Of the line.
    pub colour: ColourFile,
    /// How wide it is: `{ px = … }` at the style's `height`, or `{ world = … }` in metres.
    pub width: WidthFile,
}

/// How a region is drawn.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum LookFile {
    /// "own": each object as its style says; "monochrome": the same in shades of grey.
    Named(#[schemars(regex(pattern = "^(own|monochrome)$"))] String),
    /// The keys of `[style]`: laid over every object's own style.
    Style(Box<StyleFile>),
}
