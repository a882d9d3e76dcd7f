use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::ColourFile;
use crate::limits;

/// Flat colours.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum TonesFile {
    /// From dark to light, 1 to 32.
    List(Vec<ToneFile>),
    /// Two colours and as many between them as there are steps.
    Steps(StepsFile),
}

/// One flat colour.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ToneFile {
    /// Six hexadecimal digits of sRGB after a `#`.
    Hex(#[schemars(regex(pattern = "^#[0-9a-fA-F]{6}$"))] String),
    /// Red, green and blue, linear, from 0 to 1.
    Linear(#[schemars(transform = &limits::SHARE)] [f32; 3]),
    /// A colour and where it begins.
    Placed(PlacedToneFile),
}

/// A colour and where it begins.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PlacedToneFile {
    /// What is drawn.
    pub colour: ColourFile,
    /// From this amount of light upward, 0 to 1; 0 for the darkest, rising from tone to tone.
    #[schemars(transform = &limits::SHARE)]
    pub from: f32,
}

/// Two colours, and what is mixed between them in linear light.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct StepsFile {
    /// The darkest tone.
    pub dark: ColourFile,
    /// The lightest tone.
    pub light: ColourFile,
    /// How many tones there are in all, 2 to 32.
    #[schemars(transform = &limits::STEPS)]
    pub steps: u32,
}

/// A picture whose columns run from dark to light.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(untagged)]
pub enum RampFile {
    /// A PNG, relative to this file; its middle row counts.
    Path(#[schemars(extend("x-files" = ["png"]))] String),
    /// A PNG whose rows count too.
    Image(RampImageFile),
}

/// A picture whose columns run from dark to light and whose rows run along something else.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct RampImageFile {
    /// A PNG, relative to this file.
    #[schemars(extend("x-files" = ["png"]))]
    pub image: String,
    /// What its rows run along, from top to bottom. Without it the middle row counts.
    pub rows: Option<RampRowsFile>,
}

/// What the rows of a ramp run along, from top to bottom: exactly one of these.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RampRowsFile {
    /// Distance before the camera: metres of the top row and of the bottom row.
    Depth(#[schemars(transform = &limits::LENGTH)] [f32; 2]),
    /// How much the surface faces the viewer, from fully (top) to edge-on (bottom): the cosine between
    /// the two, to this power.
    Facing(#[schemars(transform = &limits::EXPONENT)] f32),
    /// Distance from a place.
    Focus(FocusFile),
}

/// Distance from a place.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct FocusFile {
    /// The place, in metres.
    pub center: [f32; 3],
    /// Metres from it of the top row and of the bottom row.
    #[schemars(transform = &limits::DISTANCE)]
    pub radius: [f32; 2],
}

/// Shading from cool to warm; what is left out stays as it was.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct GoochFile {
    /// Where the surface faces away from the light. Default "#000066".
    pub cool: Option<ColourFile>,
    /// Where the surface faces the light. Default "#666600".
    pub warm: Option<ColourFile>,
    /// What the object is painted with; a mesh's own colours come on top. Default "#ffffff".
    pub colour: Option<ColourFile>,
    /// Share of the object's colour that is added to `cool`, 0 to 1. Default 0.2.
    #[schemars(transform = &limits::SHARE)]
    pub alpha: Option<f32>,
    /// Share of the object's colour that is added to `warm`, 0 to 1. Default 0.6.
    #[schemars(transform = &limits::SHARE)]
    pub beta: Option<f32>,
}

/// A flat highlight; what is left out stays as it was.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct HighlightFile {
    /// Whether there is one. True where nothing else is said.
    pub on: Option<bool>,
    /// What is drawn. Default "#ffffff".
    pub colour: Option<ColourFile>,
    /// From this value of Blinn and Phong's term upward, above 0, to 1. Default 0.9.
    #[schemars(transform = &limits::PART)]
    pub from: Option<f32>,
    /// The term's exponent: the larger, the smaller is the highlight. Default 40.
    #[schemars(transform = &limits::EXPONENT)]
    pub gloss: Option<f32>,
}

/// A flat line of light where the surface turns away from the viewer; what is left out stays as it was.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct RimFile {
    /// Whether there is one. True where nothing else is said.
    pub on: Option<bool>,
    /// What is drawn. Default "#ffffff".
    pub colour: Option<ColourFile>,
    /// Drawn where the cosine between the surface and the viewer is less than this, above 0, to 1.
    /// Default 0.35.
    #[schemars(transform = &limits::PART)]
    pub width: Option<f32>,
    /// Only where there is at least this amount of light, 0 to 1; 0 draws it all round. Default 0.3.
    #[schemars(transform = &limits::SHARE)]
    pub from: Option<f32>,
}

/// Shading that brings out relief of all sizes; what is left out stays as it was.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct ExaggerateFile {
    /// From light as it is (0) to light as it shows relief best (1). 1 where nothing else is said.
    #[schemars(transform = &limits::SHARE)]
    pub amount: Option<f32>,
    /// Sizes of relief that are told apart, 1 to 8. Default 5.
    #[schemars(transform = &limits::SCALES)]
    pub scales: Option<u32>,
    /// How steeply light changes with the slope of the relief, above 0. Default 16.
    #[schemars(transform = &limits::SCALE)]
    pub contrast: Option<f32>,
}
