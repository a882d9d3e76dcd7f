use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{CurveFile, RangeFile, RingsFile, SourceFile};
use crate::limits;

/// Where particles come from, and with what they are born.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct EmitterFile {
    /// The place of birth.
    pub shape: EmitterShapeFile,
    /// Particles a second, continuously. Default 0.
    #[serde(default)]
    #[schemars(transform = &limits::RATE)]
    pub rate: f32,
    /// Particles all at once.
    #[serde(default)]
    pub bursts: Vec<BurstFile>,
    /// Keeps exactly this many alive: the dead are reborn. Takes the place of `rate` and `bursts`.
    pub count: Option<u32>,
    /// Seconds during which `rate` or `count` makes births: from, until. Default: always.
    pub active: Option<[f32; 2]>,
    /// Mean velocity at birth, in m/s. Default `[0, 0, 0]`.
    #[serde(default)]
    pub velocity: [f32; 3],
    /// Half angle of the cone of directions around `velocity`, in degrees, 0 to 180. Default 0.
    #[serde(default)]
    #[schemars(transform = &limits::SPREAD_DEG)]
    pub spread: f32,
    /// How much speed varies: 0.2 draws it from 0.8 to 1.2 times that of `velocity`. Default 0.
    #[serde(default)]
    #[schemars(transform = &limits::SHARE)]
    pub speed_jitter: f32,
    /// Life in seconds, above 0: one number, or shortest and longest. Default 3.
    #[serde(default = "life")]
    pub life: RangeFile,
    /// Radius in metres, above 0: one number, or smallest and largest. Default 0.2.
    #[serde(default = "radius")]
    pub radius: RangeFile,
    /// Mass, above 0: one number, or smallest and largest. Default 1.
    #[serde(default = "mass")]
    pub mass: RangeFile,
    /// Multiplies the radius. Default 1.
    #[serde(default = "whole")]
    pub radius_over_life: CurveFile,
    /// Multiplies the mass. Default 1.
    #[serde(default = "whole")]
    pub mass_over_life: CurveFile,
    /// How much of the puff is eaten away, 0 (whole) to 1 (gone). Default 0.
    #[serde(default = "none")]
    pub erosion_over_life: CurveFile,
    /// Flat transparency, 0 (gone) to 1 (opaque). Default 1.
    #[serde(default = "whole")]
    pub opacity_over_life: CurveFile,
    /// Vortex rings on demand, in place of those that the emitter sheds of itself.
    pub rings: Option<RingsFile>,
    /// What it brings into the air of `solver = "grid"`, besides its particles.
    pub source: Option<SourceFile>,
}

fn life() -> RangeFile {
    RangeFile::One(3.0)
}

fn radius() -> RangeFile {
    RangeFile::One(0.2)
}

fn mass() -> RangeFile {
    RangeFile::One(1.0)
}

fn whole() -> CurveFile {
    CurveFile::One(1.0)
}

fn none() -> CurveFile {
    CurveFile::One(0.0)
}

/// Particles that are born at one moment.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct BurstFile {
    /// When, in seconds from the beginning of the simulation: frame 0, but for `pre_roll`.
    #[schemars(transform = &limits::SECONDS)]
    pub at: f32,
    /// How many.
    pub count: u32,
}

/// Where an emitter's particles are born: exactly one of these.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum EmitterShapeFile {
    /// One place.
    Point {
        /// The place, in metres.
        center: [f32; 3],
    },
    /// A filled disc.
    Disc {
        /// Its middle, in metres.
        center: [f32; 3],
        /// Its axis; of any length above zero. Default `[0, 1, 0]`.
        #[serde(default = "upward")]
        normal: [f32; 3],
        /// Its radius in metres, above 0.
        #[schemars(transform = &limits::LENGTH)]
        radius: f32,
        /// Share of the radius, from the middle on, in which nothing is born; 0 to 1. Default 0.
        #[serde(default)]
        #[schemars(transform = &limits::SHARE)]
        hole: f32,
    },
    /// A filled ball.
    Sphere {
        /// Its middle, in metres.
        center: [f32; 3],
        /// Its radius in metres, above 0.
        #[schemars(transform = &limits::LENGTH)]
        radius: f32,
    },
    /// A filled box along the axes.
    Box {
        /// Its middle, in metres.
        center: [f32; 3],
        /// Its sides in metres, each above 0.
        #[schemars(transform = &limits::LENGTH)]
        size: [f32; 3],
    },
    /// A segment.
    Line {
        /// One end, in metres.
        from: [f32; 3],
        /// The other end, in metres.
        to: [f32; 3],
    },
}

fn upward() -> [f32; 3] {
    [0.0, 1.0, 0.0]
}

/// What moves particles. Wind, turbulence and vortices move the air, and drag pulls particles along
/// with it; the others accelerate particles themselves.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum ForceFile {
    /// The same acceleration for all.
    Gravity {
        /// In m/s². Default `[0, -9.81, 0]`.
        #[serde(default = "gravity")]
        acceleration: [f32; 3],
    },
    /// Lift along +Y that fades as the particle cools.
    Buoyancy {
        /// At birth, in m/s².
        #[schemars(transform = &limits::ACCELERATION)]
        acceleration: f32,
        /// Rate of cooling per second; 0 keeps lifting for ever. Default 0.
        #[serde(default)]
        #[schemars(transform = &limits::RATE)]
        cooling: f32,
    },
    /// Pull toward the velocity of the air.
    Drag {
        /// Per second: the inverse of the time in which the difference falls to 1/e.
        #[schemars(transform = &limits::RATE)]
        rate: f32,
    },
    /// Air that moves everywhere alike.
    Wind {
        /// Mean velocity in m/s.
        velocity: [f32; 3],
        /// How much it swells and slackens: 0.3 varies it by ±30 %. Default 0.
        #[serde(default)]
        #[schemars(transform = &limits::FACTOR)]
        gust: f32,
        /// Seconds from one gust to the next, above 0. Default 2.
        #[serde(default = "gust_secs")]
        #[schemars(transform = &limits::PERIOD_SECS)]
        gust_secs: f32,
    },
    /// Air that swirls.
    Turbulence {
        /// Root-mean-square speed in m/s.
        #[schemars(transform = &limits::SPEED)]
        speed: f32,
        /// Size of the largest swirl in metres, above 0.
        #[schemars(transform = &limits::LENGTH)]
        scale: f32,
        /// Each octave has half the size and half the speed of the one before; 1 to 6. Default 3.
        #[serde(default = "octaves")]
        #[schemars(transform = &limits::OCTAVES)]
        octaves: u32,
        /// How fast the swirls themselves travel, in m/s. Default `[0, 0, 0]`.
        #[serde(default)]
        drift: [f32; 3],
    },
    /// Air that turns around an axis, fastest at `radius`.
    Vortex {
        /// A place on the axis, in metres.
        center: [f32; 3],
        /// The axis; of any length above zero; it turns by the right hand. Default `[0, 1, 0]`.
        #[serde(default = "upward")]
        axis: [f32; 3],
        /// Where it is fastest, in metres, above 0.
        #[schemars(transform = &limits::LENGTH)]
        radius: f32,
        /// Speed there, in m/s.
        #[schemars(transform = &limits::SPEED)]
        speed: f32,
    },
    /// Pull toward a place, or away from it.
    Attract {
        /// The place, in metres.
        center: [f32; 3],
        /// Where the pull is strongest, in metres, above 0.
        #[schemars(transform = &limits::LENGTH)]
        radius: f32,
        /// The strongest pull, in m/s²; negative repels.
        #[schemars(transform = &limits::ACCELERATION)]
        acceleration: f32,
    },
}

fn gravity() -> [f32; 3] {
    [0.0, -9.81, 0.0]
}

fn gust_secs() -> f32 {
    2.0
}

fn octaves() -> u32 {
    3
}
