/// A light that throws hard, cartoon light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where it shines from.
    pub kind: LightKind,
    /// How much it adds to the diffuse term; 1 lights a facing surface fully.
    pub intensity: f32,
    /// Whether objects throw its shadows.
    pub shadow: bool,
}

/// The kinds of light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// Parallel rays.
    Sun {
        /// The way the light travels; of any length above zero.
        direction: [f32; 3],
    },
    /// Rays from one place; it does not weaken with distance, as drawn light does not.
    Point {
        /// Where the light is, in metres.
        position: [f32; 3],
    },
}
