use crate::{Colour, Exaggerate, Hatching, Highlight, Ink, Ramp, RampImage, RampRows, Rim, Tone};

/// How an object is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// From light to colour.
    pub ramp: Ramp,
    /// A flat highlight on what is lit.
    pub highlight: Highlight,
    /// A flat line of light where the surface turns away from the viewer.
    pub rim: Rim,
    /// Shading that brings out relief of all sizes.
    pub exaggerate: Exaggerate,
    /// Strokes that shade, over the tones.
    pub hatching: Hatching,
    /// How far normals bend from the puff's own (0) to the whole cloud's (1).
    pub form: f32,
    /// Width of the lobes that `form` sees, in mean particle radii; above zero.
    pub form_scale: f32,
    /// How far light reaches round the terminator: 0 is Lambert's, 1 lights all but the far pole.
    pub wrap: f32,
    /// Flat tones smaller than this many pixels join their surroundings; 0 keeps all.
    pub clean_px: f32,
    /// How much of its own colours a mesh shows: tones are multiplied by them, from not at all (0) to
    /// fully (1).
    pub material: f32,
    /// Values and strengths of each hue that a mesh's own colours are brought to; 0 keeps all.
    pub material_steps: u32,
    /// Whether the object is not painted, and only hides what lies behind it.
    pub mask: bool,
    /// How tones get onto puffs.
    pub shading: Shading,
    /// Lines.
    pub ink: Ink,
    /// The shadows that the object throws on itself and others.
    pub shadow: Shadow,
    /// Height of the picture, in pixels, for which lengths in pixels are meant; at other sizes they
    /// scale with it.
    pub height_px: f32,
}

impl Style {
    /// Whether puffs can be shaded once and then copied: the amount of light alone decides about colours.
    #[must_use]
    pub fn suits_sprites(&self) -> bool {
        let by_light_alone = match &self.ramp {
            Ramp::Tones(_) => true,
            Ramp::Image(RampImage { rows, .. }) => *rows == RampRows::Middle,
            Ramp::Gooch(_) => false,
        };
        let by_light_alone = by_light_alone && self.exaggerate.amount == 0.0 && !self.mask;
        by_light_alone && !self.highlight.on && !self.rim.on && !self.hatching.on
    }
}

/// How tones get onto puffs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Whichever of the others is faster and looks the same.
    Auto,
    /// Light is worked out for every pixel.
    PerPixel,
    /// Puffs are shaded once a frame and then copied (McGuire's fixed-function variant): suns only,
    /// and `form` counts as 0.
    PreShaded,
}

/// Hard shadows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shadow {
    /// Whether the object throws any.
    pub on: bool,
    /// Whether the object shows those that fall on it.
    pub receive: bool,
    /// Length of a puff's shadow in its radii.
    pub reach: f32,
    /// How far behind a puff its shadow begins, in its own height there: 1 is its far side.
    pub start: f32,
    /// Width of the shadow over the puff's, above 0.
    pub size: f32,
}

/// What a style is before any preset or file has said otherwise.
impl Default for Style {
    fn default() -> Self {
        let tone = |srgb, from| Tone { colour: Colour::from_srgb8(srgb), from };
        Self {
            ramp: Ramp::Tones(vec![tone([0x80; 3], 0.0), tone([0xff; 3], 0.5)]),
            highlight: Highlight::default(),
            rim: Rim::default(),
            exaggerate: Exaggerate::default(),
            hatching: Hatching::default(),
            form: 0.0,
            form_scale: 3.0,
            wrap: 0.0,
            clean_px: 0.0,
            material: 1.0,
            material_steps: 0,
            mask: false,
            shading: Shading::Auto,
            ink: Ink::default(),
            shadow: Shadow::default(),
            height_px: 720.0,
        }
    }
}

impl Default for Shadow {
    fn default() -> Self {
        Self { on: true, receive: true, reach: 8.0, start: 0.5, size: 0.8 }
    }
}
