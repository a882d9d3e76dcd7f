use crate::Colour;

/// From light to colour.
#[derive(Clone, Debug, PartialEq)]
pub enum Ramp {
    /// Flat colours, dark to light, 1 to 32.
    Tones(Vec<Tone>),
    /// The columns of a picture.
    Image(RampImage),
    /// Smoothly from cool to warm.
    Gooch(Gooch),
}

/// One flat colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tone {
    /// What is drawn.
    pub colour: Colour,
    /// From this amount of light upward; 0 for the darkest, rising from tone to tone.
    pub from: f32,
}

/// A picture whose columns run from dark to light.
#[derive(Clone, Debug, PartialEq)]
pub struct RampImage {
    /// A PNG.
    pub path: String,
    /// What its rows run along.
    pub rows: RampRows,
}

/// The second axis of a ramp (Barla, Thollot & Markosian, "X-Toon", 2006), from its top row to its bottom
/// row. Beyond either, that row counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RampRows {
    /// None: the middle row counts.
    Middle,
    /// With the logarithm of the distance before the camera, in metres: both above 0, and rising.
    Depth([f32; 2]),
    /// From where the surface faces the viewer to where it is seen edge-on: the cosine between the two,
    /// to this power.
    Facing(f32),
    /// With the distance from a place.
    Focus {
        /// In metres.
        center: [f32; 3],
        /// Distances in metres, rising.
        radius: [f32; 2],
    },
}

/// Shading from cool to warm (Gooch, Gooch, Shirley & Cohen 1998).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gooch {
    /// Where the surface faces away from the light.
    pub cool: Colour,
    /// Where it faces the light.
    pub warm: Colour,
    /// What the object is painted with; a mesh's own colours come on top.
    pub colour: Colour,
    /// Share of the object's colour that is added to `cool`, 0 to 1.
    pub alpha: f32,
    /// Share of the object's colour that is added to `warm`, 0 to 1.
    pub beta: f32,
}

/// A flat highlight, where Blinn and Phong's term is large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Highlight {
    /// Whether there is one.
    pub on: bool,
    /// What is drawn.
    pub colour: Colour,
    /// From this value of the term upward, times the light's intensity; above 0, to 1.
    pub from: f32,
    /// The term's exponent: the larger, the smaller is the highlight.
    pub gloss: f32,
}

/// A flat line of light where the surface turns away from the viewer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim {
    /// Whether there is one.
    pub on: bool,
    /// What is drawn.
    pub colour: Colour,
    /// Where the cosine between the surface and the viewer is less; above 0, to 1.
    pub width: f32,
    /// Only where there is at least this amount of light, 0 to 1.
    pub from: f32,
}

/// Shading that brings out relief of all sizes (Rusinkiewicz, Burns & `DeCarlo` 2006).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exaggerate {
    /// From light as it is (0) to light as it shows relief best (1).
    pub amount: f32,
    /// Sizes of relief that are told apart, 1 to 8.
    pub scales: u32,
    /// How steeply light changes with the slope of the relief; above 0.
    pub contrast: f32,
}

impl Default for Gooch {
    /// The paper's blue and yellow, with its shares.
    fn default() -> Self {
        Self {
            cool: Colour::from_srgb8([0, 0, 0x66]),
            warm: Colour::from_srgb8([0x66, 0x66, 0]),
            colour: Colour::from_srgb8([0xff; 3]),
            alpha: 0.2,
            beta: 0.6,
        }
    }
}

impl Default for Highlight {
    fn default() -> Self {
        Self { on: false, colour: Colour::from_srgb8([0xff; 3]), from: 0.9, gloss: 40.0 }
    }
}

impl Default for Rim {
    fn default() -> Self {
        Self { on: false, colour: Colour::from_srgb8([0xff; 3]), width: 0.35, from: 0.3 }
    }
}

impl Default for Exaggerate {
    fn default() -> Self {
        Self { amount: 0.0, scales: 5, contrast: 16.0 }
    }
}
