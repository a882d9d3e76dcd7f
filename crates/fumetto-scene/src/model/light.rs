/// A light that throws hard, cartoon light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where it shines from.
    pub kind: LightKind,
    /// How much it adds to the diffuse term; 1 lights a facing surface fully.
    pub intensity: f32,
    /// Whether objects throw its shadows.
    pub shadow: bool,
    /// Lights in place of it that throw its shadows, if these are soft.
    pub cluster: Option<Cluster>,
}

/// Lights close to each other whose shadows add up to soft ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cluster {
    /// How many there are, 2 or more.
    pub lights: u32,
    /// How far they stand from their middle: of a point light in metres, of a sun as a share of its distance.
    pub reach: f32,
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
