use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{ColourFile, PixelsFile, WidthFile};
use crate::limits;

/// Strokes that shade; what is left out stays as it was.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct HatchingFile {
    /// Whether there are any. True where nothing else is said.
    pub on: Option<bool>,
    /// What they are drawn in. Default "#000000".
    pub colour: Option<ColourFile>,
    /// How wide a stroke is where it is widest. Default 3 px.
    pub width: Option<WidthFile>,
    /// From the middle of a stroke to the middle of the next. In px they are as close on the picture
    /// however near they are seen; in metres they get sparser and denser. Default 6 px.
    pub spacing: Option<WidthFile>,
    /// The amount of light from which on there are none, above 0, to 1. Default 0.85.
    #[schemars(transform = &limits::PART)]
    pub from: Option<f32>,
    /// The amount of light at which there are most, 0 to 1, below `from`. Default 0.
    #[schemars(transform = &limits::SHARE)]
    pub full: Option<f32>,
    /// Whether it is the strokes' width that follows the tone (1, as in an engraving), or their number
    /// (0, as in a pen drawing), or a little of both. Default 1.
    #[schemars(transform = &limits::SHARE)]
    pub swell: Option<f32>,
    /// Tones that strokes tell apart, 1 to 32; 0 follows the light smoothly. Default 0.
    #[schemars(transform = &limits::MATERIAL_STEPS)]
    pub levels: Option<u32>,
    /// Directions that strokes have, one after the other as it gets darker, 1 to 4. Default 2.
    #[schemars(transform = &limits::HATCHING_LAYERS)]
    pub layers: Option<u32>,
    /// Angle from one of these to the next, in degrees. Default 60.
    #[schemars(transform = &limits::ANGLE_DEG)]
    pub cross: Option<f32>,
    /// What the strokes' direction comes of. Default "angle".
    pub along: Option<AlongFile>,
    /// For `along = "angle"`: direction on the picture of the scene's first camera, in degrees
    /// counter-clockwise from the horizontal. Default 30.
    pub angle: Option<f32>,
    /// How strongly strokes bend round the form, from 0 (straight) to 90 degrees: how far the planes that
    /// cut them lean toward the scene's first camera. Default 25.
    #[schemars(transform = &limits::TILT_DEG)]
    pub tilt: Option<f32>,
    /// What strokes stay with when things move. Default "form".
    pub follow: Option<FollowFile>,
    /// How long strokes are, about; 0 never ends them. Default 140 px.
    pub length: Option<PixelsFile>,
    /// Share of each stroke's line that is left out between it and the next, 0 to 1. Default 0.05.
    #[schemars(transform = &limits::SHARE)]
    pub gaps: Option<f32>,
    /// How far strokes stray from where they should be. Default 0.6 px.
    pub wobble: Option<PixelsFile>,
    /// How much the paper's tooth shows in them, 0 (ink) to 1 (chalk). Default 0.
    #[schemars(transform = &limits::SHARE)]
    pub tooth: Option<f32>,
    /// Relief smaller than this does not bend strokes; 0 lets all of it. The largest that any object
    /// wants counts for the whole picture. Default 16 px.
    pub smooth: Option<PixelsFile>,
}

/// What the direction of strokes comes of.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum AlongFile {
    /// The style's `angle` and `tilt`.
    Angle,
    /// The border of light and shade, with which they run: the first light decides.
    Shade,
    /// The first light: they run from light to shade.
    Light,
    /// The form: they run the way that it bends most, and as the style's `angle` says where it bends all
    /// ways alike.
    Curvature,
}

/// What strokes stay with.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FollowFile {
    /// The form, as it stands in the world.
    Form,
    /// The form, and what it is of as that moves: a puff, or a part of a model.
    Object,
    /// The picture: straight strokes, flat on the paper.
    Screen,
}
