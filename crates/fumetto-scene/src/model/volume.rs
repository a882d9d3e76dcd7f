use crate::Colour;

/// Tessendorf's puffs as Normoyle renders them: every particle is a ball of matter whose surface noise
/// displaces; light is followed through all of them together.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    /// What light loses in matter of density 1, per metre: the paper's kappa; above zero.
    pub extinction_per_m: f32,
    /// How dense a puff is inside.
    pub profile: Profile,
    /// Share of the radius over which the density rises inward, 0 to 1.
    pub edge: f32,
    /// The puff's radius over the particle's; above zero.
    pub size: f32,
    /// What displaces the surface.
    pub noise: Option<VolumeNoise>,
    /// Of the matter, 1 to [`MAX_COLOURS`](crate::limits::MAX_COLOURS): each puff takes one.
    pub colours: Vec<Colour>,
    /// Light that the matter gives off by itself.
    pub glow: f32,
    /// From the style's tones (0) to what a camera would see (1).
    pub soft: f32,
    /// The opacity at which the surface lies that is drawn and inked; above 0 and below 1.
    pub surface: f32,
    /// How much the surface's normal counts for tones, 0 to 1.
    pub relief: f32,
    /// The opacity on the way to a light from which on it throws a shadow on other things, 0 to 1; none at 0.
    pub shadow: f32,
    /// Of the density along the longest side, quality included.
    pub cells: u32,
    /// Of the light along the longest side, quality included.
    pub light_cells: u32,
    /// Along the line of sight, in metres; above zero.
    pub step_m: Option<f32>,
    /// Where that is not given: in cells, or in the voxels of a file.
    pub step_cells: f32,
    /// Along the side of a square that one line of sight is followed for, 1 to 8.
    pub pixels: u32,
    /// Radius of the lobes of a volume out of a file; above zero. An eighth of its longest side where it is not
    /// given.
    pub lobe_m: Option<f32>,
}

/// How dense a puff is inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// The same everywhere.
    Constant,
    /// Falls from the middle to nothing at the surface.
    Linear,
}

/// Fractal noise on the unit sphere of a puff's directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VolumeNoise {
    /// The farthest that the surface is displaced, in radii.
    pub amplitude: f32,
    /// Of the first octave, in lattice cells to a radius; above zero.
    pub frequency: f32,
    /// 1 to 8.
    pub octaves: u32,
    /// Each octave's strength over that of the one before.
    pub persistence: f32,
    /// Each octave's frequency over that of the one before.
    pub lacunarity: f32,
    /// What it is made from.
    pub seed: u32,
    /// In radii a second.
    pub drift: [f32; 3],
    /// Takes each octave's absolute value: Perlin's turbulence.
    pub billow: bool,
}

impl Volume {
    /// How far the farthest matter of a puff is from its middle, over the particle's radius.
    #[must_use]
    pub fn reach(&self) -> f32 {
        self.size * (1.0 + self.noise.map_or(0.0, |noise| noise.amplitude))
    }

    /// Whether it changes where particles stand still.
    #[must_use]
    pub fn drifts(&self) -> bool {
        self.noise.is_some_and(|noise| noise.amplitude > 0.0 && noise.drift != [0.0; 3])
    }
}
