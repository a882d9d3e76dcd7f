use crate::{Camera, Colour, Light, Object};

/// A whole scene, checked: every value is in its range and every default filled in.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// What every random choice is made from.
    pub seed: u32,
    /// At least one; the first is drawn unless another is asked for.
    pub cameras: Vec<Camera>,
    /// Up to eight.
    pub lights: Vec<Light>,
    /// What lies behind.
    pub background: Background,
    /// The clock.
    pub time: Time,
    /// The picture.
    pub output: Output,
    /// Everything that is drawn.
    pub objects: Vec<Object>,
}

/// What lies behind the objects.
#[derive(Clone, Debug, PartialEq)]
pub enum Background {
    /// Nothing: the picture has an alpha channel.
    Transparent,
    /// One colour.
    Colour(Colour),
    /// From the top edge to the bottom edge.
    Gradient {
        /// At the top edge.
        top: Colour,
        /// At the bottom edge.
        bottom: Colour,
    },
    /// A PNG, scaled to cover the picture and centred.
    Image(String),
    /// Paper of one colour, with its tooth.
    Paper(Colour),
}

/// The scene's clock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// Frames in a second; above zero.
    pub fps: f32,
    /// First and last frame, inclusive; the simulation starts `pre_roll` before frame 0.
    pub frames: [u32; 2],
    /// Draw on ones (1), twos (2), threes…; the simulation still steps every frame.
    pub hold: u32,
    /// Simulation steps in a frame, at least 1.
    pub substeps: u32,
    /// Seconds that are simulated before frame 0, rounded to whole steps.
    pub pre_roll: f32,
}

/// The picture that is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Output {
    /// Width and height in pixels, each 1 to 32768.
    pub size: [u32; 2],
    /// Samples along each side of a pixel, 1 (hard edges) to 4.
    pub antialias: u32,
}
