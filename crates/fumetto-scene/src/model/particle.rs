/// A weighted particle: a soft ball of matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Where it is, in metres.
    pub center: [f32; 3],
    /// How far its matter reaches, in metres; finite and above zero.
    pub radius: f32,
    /// How much matter it holds, relative to its neighbours; finite and above zero.
    pub mass: f32,
}
