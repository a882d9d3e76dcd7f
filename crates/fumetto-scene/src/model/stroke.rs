use std::collections::BTreeSet;

use crate::{Ink, Object, Scene, Width};

/// What is drawn along a line, as a hand would: textured polygons (Álvarez et al. 2007, section 4).
///
/// Lengths are in heights of the stroke unless they say otherwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// Whether there is one; without it the line is plain.
    pub on: bool,
    /// What it is drawn with.
    pub texture: StrokeTexture,
    /// How wide it is, across the line; without one, as the line is.
    pub height: Option<Width>,
    /// What multiplies the length that the texture takes along the line.
    pub scale: f32,
    /// Share of its height that lies outside of the body, 0 to 1.
    pub outward: f32,
    /// Length over which it thins to nothing at its ends.
    pub taper: f32,
    /// How much of its width and darkness comes and goes along it, 0 to 1.
    pub pressure: f32,
    /// How much heavier it is where the line bends; 1 doubles it where the radius is 4 heights.
    pub curvature: f32,
    /// How much lighter it is farther away, from not at all (0) to as perspective has it (1).
    pub distance: f32,
    /// How far it strays from the line.
    pub wobble: f32,
    /// How far it goes on beyond its ends.
    pub overshoot: f32,
    /// How often it is drawn, each time a little different.
    pub passes: u32,
    /// How much of the paper's tooth shows in it, 0 to 1.
    pub grain: f32,
    /// Frames after which the hand draws it anew; 0 for never.
    pub boil: u32,
}

/// What a stroke is drawn with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StrokeTexture {
    /// Grains of graphite on the paper's tooth.
    Pencil,
    /// Wet ink, with bristles where it runs dry.
    Brush,
    /// A broad, broken, dusty line.
    Charcoal,
    /// Crumbs that the paper's tooth holds.
    Chalk,
    /// Short strokes with gaps between them.
    Dashes,
    /// A picture: dark, or opaque where it has an alpha channel, is ink. Its top lies outside of the body.
    File(String),
}

impl StrokeTexture {
    /// All but files, with their names in scenes.
    pub const NAMED: [(&'static str, Self); 5] = [
        ("pencil", Self::Pencil),
        ("brush", Self::Brush),
        ("charcoal", Self::Charcoal),
        ("chalk", Self::Chalk),
        ("dashes", Self::Dashes),
    ];
}

impl Stroke {
    /// What a tool does when nothing else is said.
    #[must_use]
    pub fn of(texture: StrokeTexture) -> Self {
        let plain = Self {
            on: true,
            texture: StrokeTexture::Dashes,
            height: None,
            scale: 1.0,
            outward: 0.5,
            taper: 3.0,
            pressure: 0.0,
            curvature: 0.0,
            distance: 0.0,
            wobble: 0.0,
            overshoot: 0.0,
            passes: 1,
            grain: 0.0,
            boil: 0,
        };
        let changed = match texture {
            StrokeTexture::Pencil => Self {
                taper: 9.0,
                pressure: 0.8,
                wobble: 1.8,
                overshoot: 6.0,
                passes: 4,
                grain: 0.45,
                ..plain
            },
            StrokeTexture::Brush => Self { taper: 8.0, pressure: 0.6, curvature: 0.6, wobble: 0.12, ..plain },
            StrokeTexture::Charcoal => Self {
                taper: 3.0,
                pressure: 0.6,
                wobble: 0.2,
                overshoot: 0.5,
                passes: 2,
                grain: 1.0,
                ..plain
            },
            StrokeTexture::Chalk => Self { taper: 1.0, pressure: 0.4, wobble: 0.12, grain: 1.0, ..plain },
            StrokeTexture::Dashes => Self { taper: 0.0, pressure: 0.2, wobble: 0.1, ..plain },
            StrokeTexture::File(_) => Self { taper: 2.0, ..plain },
        };
        Self { texture, ..changed }
    }
}

impl Scene {
    /// How lines of all objects are drawn, in all looks.
    pub fn inks(&self) -> impl Iterator<Item = &Ink> {
        let looks = self.styled_looks().flat_map(|styles| styles.iter().take(self.objects.len()));
        self.objects.iter().flat_map(Object::inks).chain(looks.map(|style| &style.ink))
    }

    /// The pictures that any of them are drawn with.
    #[must_use]
    pub fn stroke_pictures(&self) -> BTreeSet<&str> {
        let strokes = self.inks().flat_map(Ink::strokes);
        strokes
            .filter_map(|stroke| match &stroke.texture {
                StrokeTexture::File(path) => Some(path.as_str()),
                _ => None,
            })
            .collect()
    }
}
