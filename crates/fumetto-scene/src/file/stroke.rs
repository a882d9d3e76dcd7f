use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::WidthFile;
use crate::limits;

/// What is drawn along lines, as a hand would. What is left out is as usual for its texture; lengths are in heights
/// of the stroke.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct StrokeFile {
    /// Whether there is one; without it lines are plain.
    pub on: Option<bool>,
    /// "pencil" (the default), "brush", "charcoal", "chalk" or "dashes"; or a .png, relative to this file, whose
    /// columns run along the line and whose dark or opaque pixels are ink. Brings values of its own for the other
    /// keys.
    #[schemars(extend("x-files" = ["png"], "examples" = ["pencil", "brush", "charcoal", "chalk", "dashes"]))]
    pub texture: Option<String>,
    /// How wide it is, across the line. Default: as the line.
    pub height: Option<WidthFile>,
    /// What multiplies the length that the texture takes along the line, above 0.
    #[schemars(transform = &limits::STROKE_SCALE)]
    pub scale: Option<f32>,
    /// Share of its height that lies outside of the body, 0 to 1.
    #[schemars(transform = &limits::SHARE)]
    pub outward: Option<f32>,
    /// Length over which it thins to nothing at its ends.
    #[schemars(transform = &limits::STROKE_LENGTH)]
    pub taper: Option<f32>,
    /// How much of its width and darkness comes and goes along it, 0 to 1.
    #[schemars(transform = &limits::SHARE)]
    pub pressure: Option<f32>,
    /// How much heavier it is where the line bends: 1 doubles it where the bend has a radius of 4 heights.
    #[schemars(transform = &limits::STROKE_CURVATURE)]
    pub curvature: Option<f32>,
    /// How much lighter it is farther away, from not at all (0) to as perspective has it (1); at the distance of
    /// what the camera looks at it is as wide as said.
    #[schemars(transform = &limits::SHARE)]
    pub distance: Option<f32>,
    /// How far it strays from the line.
    #[schemars(transform = &limits::STROKE_WOBBLE)]
    pub wobble: Option<f32>,
    /// How far it goes on beyond its ends.
    #[schemars(transform = &limits::STROKE_LENGTH)]
    pub overshoot: Option<f32>,
    /// How often it is drawn, each time a little different, 1 to 8.
    #[schemars(transform = &limits::STROKE_PASSES)]
    pub passes: Option<u32>,
    /// How much of the paper's tooth shows in it, 0 to 1.
    #[schemars(transform = &limits::SHARE)]
    pub grain: Option<f32>,
    /// Frames after which the hand draws it anew; 0 for never.
    #[schemars(transform = &limits::STROKE_BOIL)]
    pub boil: Option<u32>,
}
