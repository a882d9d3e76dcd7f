use crate::Ink;

/// Álvarez's implicit surface: one closed skin round all particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The density at which it lies; above zero.
    pub threshold: f32,
    /// How finely it is sampled.
    pub resolution: Resolution,
    /// Multiplies the particles' radii; above zero.
    pub size: f32,
    /// What roughens it.
    pub noise: Option<Noise>,
}

impl Surface {
    /// Whether it changes even where its particles do not.
    #[must_use]
    pub fn drifts(&self) -> bool {
        self.noise.is_some_and(|noise| noise.amplitude > 0.0 && noise.drift_m_per_s != [0.0; 3])
    }
}

/// A surface inside another, made of the same particles, of which only lines are drawn (Álvarez et al. 2007,
/// section 5).
#[derive(Clone, Debug, PartialEq)]
pub struct Detail {
    /// Its `size` is over the particles' own radii, as that of the surface around it is.
    pub surface: Surface,
    /// Multiplies the particles' masses; above zero.
    pub mass: f32,
    /// How its lines are drawn.
    pub ink: Ink,
}

/// How finely a surface is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Resolution {
    /// Cells along the object's longest side, 1 to 512.
    Subdivisions(u32),
    /// The side of a cell in metres; above zero.
    Cell(f32),
    /// Cells to the mean radius of the particles; above zero.
    PerRadius(f32),
    /// The side of a cell as it appears where the object is nearest to the camera, over the picture's height;
    /// above zero.
    Picture(f32),
}

/// Noise that is added to the density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// The most that it adds, in thresholds.
    pub amplitude: f32,
    /// Size of the first octave in metres; above zero.
    pub size_m: f32,
    /// Each has half the size and half the strength of the one before; 1 to 6.
    pub octaves: u32,
    /// What it is made from.
    pub seed: u32,
    /// How fast it travels.
    pub drift_m_per_s: [f32; 3],
}
