use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{ColourFile, StrokeFile};
use crate::limits;

/// Lines.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct InkFile {
    /// Whether there are any.
    pub on: Option<bool>,
    /// How they are found: "hybrid" (the default) takes what suits each shape.
    pub method: Option<InkMethodFile>,
    /// Their colour, where a kind of edge has no other.
    pub colour: Option<ColourFile>,
    /// How wide the outline is.
    pub width: Option<WidthFile>,
    /// How far ink lies behind its particle, in widths of the particle: the larger, the fewer inner
    /// lines.
    #[schemars(transform = &limits::FACTOR)]
    pub offset: Option<f32>,
    /// Width of inner lines over the outline's, 0 to 1.
    #[schemars(transform = &limits::SHARE)]
    pub inner: Option<f32>,
    /// How much thinner lines are where they face the light, 0 to 1. Those left with less than a quarter of
    /// their width end there.
    #[schemars(transform = &limits::SHARE)]
    pub lit_thinning: Option<f32>,
    /// Lines shorter than this many widths are left out.
    #[schemars(transform = &limits::FACTOR)]
    pub shortest: Option<f32>,
    /// Lines of meshes where the surface turns away from the viewer.
    pub silhouette: Option<PenFile>,
    /// Lines of meshes where faces meet at an angle.
    pub crease: Option<CreaseFile>,
    /// Lines of meshes where the surface ends.
    pub boundary: Option<PenFile>,
    /// Lines of meshes where two materials meet.
    pub material: Option<PenFile>,
    /// For `method = "angle"`: there is ink where the cosine between the surface and the viewer is less.
    #[schemars(transform = &limits::SHARE)]
    pub facing: Option<f32>,
    /// What becomes of lines of meshes that something hides.
    pub hidden: Option<HiddenLinesFile>,
    /// What is drawn along the lines of meshes and surfaces, where a kind of edge has no stroke of its own; for
    /// methods "hybrid" and "vector".
    pub stroke: Option<StrokeFile>,
}

/// How lines are found.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum InkMethodFile {
    /// Where the surface is seen edge-on.
    Angle,
    /// By a larger copy of the model, of which only the inside is drawn.
    Shell,
    /// Where neighbouring pixels differ in depth, normal or object.
    Image,
    /// Along the model's edges, found anew for every view.
    Vector,
    /// Ink billboards behind puffs, vector edges on meshes, and image edges where shapes run into each
    /// other.
    Hybrid,
}

/// What becomes of lines that something hides.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum HiddenLinesFile {
    /// They are not drawn.
    Gone,
    /// They are dashed, as in technical drawings.
    Dashed,
}

/// How one kind of edge is drawn; what is left out is as for all ink.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct PenFile {
    /// Whether it is.
    pub on: Option<bool>,
    /// Its colour.
    pub colour: Option<ColourFile>,
    /// Its width.
    pub width: Option<WidthFile>,
    /// Lengths that are drawn and left out in turn, in pixels at the style's `height`.
    #[schemars(transform = &limits::WIDTH_PX)]
    pub dash: Option<[f32; 2]>,
    /// What is drawn along it.
    pub stroke: Option<StrokeFile>,
}

/// How creases are found and drawn; what is left out is as for all ink.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct CreaseFile {
    /// Whether they are drawn.
    pub on: Option<bool>,
    /// Their colour.
    pub colour: Option<ColourFile>,
    /// Their width.
    pub width: Option<WidthFile>,
    /// Lengths that are drawn and left out in turn, in pixels at the style's `height`.
    #[schemars(transform = &limits::WIDTH_PX)]
    pub dash: Option<[f32; 2]>,
    /// Faces that turn by more than this make a crease, in degrees.
    #[schemars(transform = &limits::ANGLE_DEG)]
    pub angle: Option<f32>,
    /// What is drawn along them.
    pub stroke: Option<StrokeFile>,
}

/// Width of a line: exactly one of these.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum WidthFile {
    /// In pixels at the style's `height`, above 0.
    Px(#[schemars(transform = &limits::WIDTH_PX)] f32),
    /// In metres, above 0.
    World(#[schemars(transform = &limits::WIDTH_WORLD)] f32),
}
