/// How the air around smoke is simulated in a box of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Middle and sides of the box in metres; `None`: around the emitters.
    pub bounds: Option<[[f32; 3]; 2]>,
    /// Cells along its longest side, at least.
    pub cells: u32,
    /// Whether the low and the high side along each axis are open.
    pub open: [[bool; 2]; 3],
    /// Of vorticity, per second.
    pub confinement: f32,
    /// Vortex particles in it.
    pub eddies: Option<Eddies>,
    /// How fast air loses its smoke, per second.
    pub dissipation: f32,
    /// In m²/s.
    pub viscosity: f32,
    /// The share of divergence that may be left.
    pub residual: f32,
}

/// Vortex particles that live in a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eddies {
    /// Alive for each emitter.
    pub count: u32,
    /// How far each reaches, in metres.
    pub radius: f32,
    /// How hard each pushes, in m/s².
    pub strength: f32,
}

/// What an emitter brings into the air of a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source {
    /// 1: as hot as what buoyancy lifts at birth.
    pub heat: f32,
    /// 1: as thick as smoke at birth.
    pub smoke: f32,
    /// Air that appears, in its own volumes a second.
    pub expansion: f32,
    /// Seconds for which a burst lasts.
    pub secs: f32,
}
