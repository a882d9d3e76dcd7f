use crate::{Colour, Width};

/// Strokes that shade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hatching {
    /// Whether there are any.
    pub on: bool,
    /// What they are drawn in.
    pub colour: Colour,
    /// How wide a stroke is where it is widest.
    pub width: Width,
    /// From the middle of a stroke to the middle of the next.
    pub spacing: Width,
    /// The amount of light from which on there are none.
    pub from: f32,
    /// The amount of light at which there are most; below `from`.
    pub full: f32,
    /// From strokes whose number follows the tone (0) to strokes whose width does (1).
    pub swell: f32,
    /// Tones that strokes tell apart, up to 32; 0 follows the light smoothly.
    pub levels: u32,
    /// Directions that strokes have, one after the other as it gets darker, 1 to 4.
    pub layers: u32,
    /// Angle from one of these to the next, in degrees.
    pub cross_deg: f32,
    /// What the strokes' direction comes of.
    pub along: Along,
    /// For [`Along::Angle`]: direction on the picture of the scene's first camera, in degrees
    /// counter-clockwise from the horizontal.
    pub angle_deg: f32,
    /// How far the planes that cut strokes lean toward the scene's first camera, in degrees, up to 90.
    pub tilt_deg: f32,
    /// What strokes stay with when things move.
    pub follow: Follow,
    /// How long strokes are, about, in pixels at [`Style::height_px`](crate::Style::height_px); 0 never ends
    /// them.
    pub length_px: f32,
    /// Share of each stroke's line that is left out between it and the next.
    pub gaps: f32,
    /// How far strokes stray, in the same pixels.
    pub wobble_px: f32,
    /// How much the paper's tooth shows in them, 0 to 1.
    pub tooth: f32,
    /// Relief smaller than this many of the same pixels does not bend strokes.
    pub smooth_px: f32,
}

/// What the direction of strokes comes of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// [`Hatching::angle_deg`] and [`Hatching::tilt_deg`].
    Angle,
    /// The border of light and shade.
    Shade,
    /// The first light: they run from light to shade.
    Light,
    /// The form: they run the way that it bends most, and as [`Along::Angle`] where it bends all ways alike.
    Curvature,
}

/// What strokes stay with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follow {
    /// The form, as it stands in the world.
    Form,
    /// The form, and what it is of as that moves: a puff, or a part of a model.
    Object,
    /// The picture.
    Screen,
}

impl Hatching {
    /// Whether strokes run as the form bends.
    #[must_use]
    pub fn follows_curvature(&self) -> bool {
        self.on && self.along == Along::Curvature && self.follow != Follow::Screen
    }
}

/// An engraver's burin, as far as it is on.
impl Default for Hatching {
    fn default() -> Self {
        Self {
            on: false,
            colour: Colour::from_srgb8([0; 3]),
            width: Width::Px(3.0),
            spacing: Width::Px(6.0),
            from: 0.85,
            full: 0.0,
            swell: 1.0,
            levels: 0,
            layers: 2,
            cross_deg: 60.0,
            along: Along::Angle,
            angle_deg: 30.0,
            tilt_deg: 25.0,
            follow: Follow::Form,
            length_px: 140.0,
            gaps: 0.05,
            wobble_px: 0.6,
            tooth: 0.0,
            smooth_px: 16.0,
        }
    }
}
