/// How the vortices of smoke are shed, and what becomes of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vortex {
    /// Multiplies the circulation of the rings that emitters shed of themselves.
    pub strength: f32,
    /// Multiplies what buoyancy adds to their circulation.
    pub buoyancy: f32,
    /// How thick a ring's line is, as a share of the ring's radius.
    pub core: f32,
    /// How fast lines get thicker, in m²/s.
    pub viscosity: f32,
    /// How fast circulation dies, per second.
    pub decay: f32,
    /// Vortex particles in a ring.
    pub segments: u32,
    /// The most by which the speed of the air may be wrong, as a share of the sum of all vortices' speeds.
    pub error: f32,
}

/// Vortex rings on demand.
#[derive(Clone, Debug, PartialEq)]
pub struct Rings {
    /// In m²/s; positive rings travel along the emitter's velocity.
    pub circulation: f32,
    /// Rings a second.
    pub rate: f32,
    /// Moments of single rings, in seconds.
    pub at: Vec<f32>,
    /// In metres; `None` for that of the emitter's mouth.
    pub radius: Option<f32>,
    /// How far rings are from round, as a share of their radius.
    pub wobble: f32,
}
