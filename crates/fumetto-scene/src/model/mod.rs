//! The checked model: what the engine draws. Every value is in its range.

mod camera;
mod colour;
mod cost;
mod curve;
mod light;
mod object;
mod particle;
mod puffs;
mod scene;
mod smoke;
mod style;

pub use camera::Camera;
pub use colour::Colour;
pub use cost::ObjectCost;
pub use curve::Curve;
pub use light::{Light, LightKind};
pub use object::{Matter, Object};
pub use particle::Particle;
pub use puffs::Puffs;
pub use scene::{Background, Output, Scene, Time};
pub use smoke::{Burst, Emitter, EmitterShape, Force, Smoke};
pub use style::{Ink, Ramp, Shading, Shadow, Style, Tone, Width};
