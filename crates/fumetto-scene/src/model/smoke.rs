use crate::{Curve, Grid, Rings, Source, Vortex};

/// Matter that is emitted and moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Smoke {
    /// At least one.
    pub emitters: Vec<Emitter>,
    /// What moves the particles.
    pub forces: Vec<Force>,
    /// What makes them curl; `None` by other solvers than "vortex".
    pub vortex: Option<Vortex>,
    /// The box of air that carries them; `None` by other solvers than "grid".
    pub grid: Option<Grid>,
}

/// Where particles come from, and with what they are born.
#[derive(Clone, Debug, PartialEq)]
pub struct Emitter {
    /// The place of birth.
    pub shape: EmitterShape,
    /// Particles a second, continuously.
    pub rate: f32,
    /// Particles all at once.
    pub bursts: Vec<Burst>,
    /// Keeps exactly this many alive: the dead are reborn (Álvarez, section 6). `rate` and
    /// `bursts` are then unused, and first births are spread over the longest life.
    pub count: Option<u32>,
    /// Seconds during which `rate` or `count` makes births: from, until.
    pub active: [f32; 2],
    /// Mean velocity at birth, in m/s.
    pub velocity: [f32; 3],
    /// Half angle of the cone of directions around `velocity`, in degrees, 0 to 180.
    pub spread_deg: f32,
    /// How much speed varies: 0.2 draws it from 0.8 to 1.2 times `velocity`'s.
    pub speed_jitter: f32,
    /// Shortest and longest life in seconds, above zero.
    pub life: [f32; 2],
    /// Smallest and largest radius in metres, above zero.
    pub radius: [f32; 2],
    /// Smallest and largest mass, above zero.
    pub mass: [f32; 2],
    /// Multiplies the radius.
    pub radius_over_life: Curve,
    /// Multiplies the mass.
    pub mass_over_life: Curve,
    /// How much of the puff is eaten away: 0 whole, 1 gone.
    pub erosion_over_life: Curve,
    /// Flat transparency: 1 opaque, 0 gone.
    pub opacity_over_life: Curve,
    /// Vortex rings in place of those that it sheds of itself.
    pub rings: Option<Rings>,
    /// What it brings into the air of a grid.
    pub source: Source,
}

/// Particles that are born at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Burst {
    /// When, in seconds.
    pub at: f32,
    /// How many.
    pub count: u32,
}

/// Where an emitter's particles are born.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EmitterShape {
    /// One place.
    Point {
        /// The place.
        center: [f32; 3],
    },
    /// A filled disc.
    Disc {
        /// Its middle.
        center: [f32; 3],
        /// Its axis; of any length above zero.
        normal: [f32; 3],
        /// Its radius in metres.
        radius: f32,
        /// Share of the radius, from the middle on, in which nothing is born.
        hole: f32,
    },
    /// A filled ball.
    Sphere {
        /// Its middle.
        center: [f32; 3],
        /// Its radius in metres.
        radius: f32,
    },
    /// A filled box along the axes.
    Box {
        /// Its middle.
        center: [f32; 3],
        /// Its sides in metres.
        size: [f32; 3],
    },
    /// A segment.
    Line {
        /// One end.
        from: [f32; 3],
        /// The other end.
        to: [f32; 3],
    },
}

impl EmitterShape {
    /// Its middle.
    #[must_use]
    pub fn middle(&self) -> [f32; 3] {
        match *self {
            Self::Point { center }
            | Self::Disc { center, .. }
            | Self::Sphere { center, .. }
            | Self::Box { center, .. } => center,
            Self::Line { from, to } => [0, 1, 2].map(|axis: usize| 0.5 * (from[axis] + to[axis])),
        }
    }
}

/// What moves particles.
///
/// Wind, turbulence and vortices are velocities of the air; [`Force::Drag`] pulls particles along
/// with it. The others accelerate particles themselves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Force {
    /// The same acceleration for all.
    Gravity {
        /// In m/s².
        acceleration: [f32; 3],
    },
    /// Lift along +Y that fades as the particle cools.
    Buoyancy {
        /// At birth, in m/s².
        acceleration: f32,
        /// Rate of cooling per second; 0 keeps lifting for ever.
        cooling: f32,
    },
    /// Pull toward the velocity of the air.
    Drag {
        /// Per second: the inverse of the time in which the difference falls to 1/e.
        rate: f32,
    },
    /// Air that moves everywhere alike.
    Wind {
        /// Mean velocity in m/s.
        velocity: [f32; 3],
        /// How much it swells and slackens: 0.3 varies it by ±30 %.
        gust: f32,
        /// Seconds from one gust to the next.
        gust_secs: f32,
    },
    /// Air that swirls: divergence-free noise.
    Turbulence {
        /// Root-mean-square speed in m/s.
        speed: f32,
        /// Size of the largest swirl in metres.
        scale: f32,
        /// Each octave has half the size and half the speed of the one before; 1 to 6.
        octaves: u32,
        /// How fast the swirls themselves travel, in m/s.
        drift: [f32; 3],
    },
    /// Air that turns around an axis, fastest at `radius`.
    Vortex {
        /// A place on the axis.
        center: [f32; 3],
        /// The axis; of any length above zero; turns by the right hand.
        axis: [f32; 3],
        /// Where it is fastest, in metres.
        radius: f32,
        /// Speed there, in m/s.
        speed: f32,
    },
    /// Pull toward a place, or away from it.
    Attract {
        /// The place.
        center: [f32; 3],
        /// Where the pull is strongest, in metres.
        radius: f32,
        /// The strongest pull, in m/s²; negative repels.
        acceleration: f32,
    },
}

impl Emitter {
    /// The largest radius that any of its particles ever has, in metres.
    #[must_use]
    pub fn largest_radius(&self) -> f32 {
        self.radius[0].max(self.radius[1]) * self.radius_over_life.largest()
    }
}
