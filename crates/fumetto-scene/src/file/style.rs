use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{ExaggerateFile, GoochFile, HatchingFile, HighlightFile, InkFile, RampFile, RimFile, TonesFile};
use crate::{limits, presets};

/// How an object is drawn. Keys that are left out keep what the preset, or the scene's style, says.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct StyleFile {
    /// A ready-made style to start from: "cartoon" (the default), "comic", "engraving", "watercolour" or
    /// another one.
    #[schemars(extend("examples" = presets::names()))]
    pub preset: Option<String>,
    /// A style file to start from, relative to the scene file; it holds the keys of this table.
    #[schemars(extend("x-files" = ["toml"]))]
    pub file: Option<String>,
    /// Flat colours from dark to light, 1 to 32: each a colour, or `{ colour = …, from = … }` with the
    /// amount of light from which it is drawn; or `{ dark = …, light = …, steps = … }`. Excludes `ramp`
    /// and `gooch`.
    pub tones: Option<TonesFile>,
    /// A PNG whose columns run from dark to light, relative to this file; or `{ image = …, rows = … }`
    /// where its rows count too. Excludes `tones` and `gooch`.
    pub ramp: Option<RampFile>,
    /// Smooth shading from a cool to a warm colour. Excludes `tones` and `ramp`.
    pub gooch: Option<GoochFile>,
    /// A flat highlight on what is lit.
    pub highlight: Option<HighlightFile>,
    /// A flat line of light where the surface turns away from the viewer.
    pub rim: Option<RimFile>,
    /// Shading that brings out relief of all sizes.
    pub exaggerate: Option<ExaggerateFile>,
    /// Strokes that shade, over the tones.
    pub hatching: Option<HatchingFile>,
    /// How far normals bend from the puff's own (0) to the whole cloud's (1).
    #[schemars(transform = &limits::SHARE)]
    pub form: Option<f32>,
    /// Width of the lobes that `form` sees, in mean particle radii, above 0.
    #[schemars(transform = &limits::SCALE)]
    pub form_scale: Option<f32>,
    /// How far light reaches round the terminator, from 0 (Lambert's law) to 1 (all but the far pole).
    #[schemars(transform = &limits::SHARE)]
    pub wrap: Option<f32>,
    /// Flat tones smaller than this join their surroundings; 0 keeps all.
    pub clean: Option<PixelsFile>,
    /// How much of its own colours a mesh or a volume shows: tones are multiplied by them, from not at all
    /// (0) to fully (1).
    #[schemars(transform = &limits::SHARE)]
    pub material: Option<f32>,
    /// Colours of a mesh or a volume are brought to this many values and strengths of each hue, 1 to 32; 0 keeps them.
    #[schemars(transform = &limits::MATERIAL_STEPS)]
    pub material_steps: Option<u32>,
    /// Whether the object is not painted: what the picture lies on shows in its place, and it hides only the lines and
    /// the objects behind it.
    pub mask: Option<bool>,
    /// How tones get onto puffs.
    pub shading: Option<ShadingFile>,
    /// Lines.
    pub ink: Option<InkFile>,
    /// The shadows that the object throws on itself and others.
    pub shadow: Option<ShadowFile>,
    /// Height of the picture, in pixels, for which lengths in pixels are meant; at other sizes they
    /// scale with it.
    #[schemars(transform = &limits::PICTURE_PX)]
    pub height: Option<f32>,
}

/// A length in pixels.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PixelsFile {
    /// In pixels at the style's `height`.
    #[schemars(transform = &limits::PIXELS)]
    pub px: f32,
}

/// How tones get onto puffs.
#[derive(Clone, Copy, Debug, Deserialize, Eq, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ShadingFile {
    /// Whichever of the others is faster and looks the same.
    Auto,
    /// Light is worked out for every pixel.
    PerPixel,
    /// Puffs are shaded once a frame and then copied: suns only, and `form` counts as 0.
    PreShaded,
}

/// Hard shadows.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct ShadowFile {
    /// Whether the object throws any; the other keys but `receive` are for puffs alone.
    pub on: Option<bool>,
    /// Whether the object shows those that fall on it.
    pub receive: Option<bool>,
    /// Length of a puff's shadow in its radii.
    #[schemars(transform = &limits::FACTOR)]
    pub reach: Option<f32>,
    /// How far behind a puff its shadow begins, in its own height there: 1 is its far side.
    #[schemars(transform = &limits::FACTOR)]
    pub start: Option<f32>,
    /// Width of the shadow over the puff's, above 0.
    #[schemars(transform = &limits::SCALE)]
    pub size: Option<f32>,
}
