//! The checked model: what the engine draws. Every value is in its range.

mod camera;
mod colour;
mod cost;
mod curve;
mod ink;
mod light;
mod mesh;
mod morph;
mod object;
mod particle;
mod puffs;
mod scene;
mod shape;
mod smoke;
mod style;
mod surface;
mod surface_plan;
mod tones;

pub use camera::Camera;
pub use colour::Colour;
pub use cost::ObjectCost;
pub use curve::Curve;
pub use ink::{EdgeKind, HiddenLines, Ink, InkMethod, Pen, Width};
pub use light::{Light, LightKind};
pub use mesh::{Mesh, Transform};
pub use morph::{Ease, Given, Metamorphosis, Morph};
pub use object::{Matter, Object};
pub use particle::Particle;
pub use puffs::Puffs;
pub use scene::{Background, Output, Scene, Time};
pub use shape::Shape;
pub use smoke::{Burst, Emitter, EmitterShape, Force, Smoke};
pub use style::{Shading, Shadow, Style};
pub use surface::{Detail, Noise, Resolution, Surface};
pub use surface_plan::{Spacing, SurfacePlan, SurfaceRoom};
pub use tones::{Exaggerate, Gooch, Highlight, Ramp, RampImage, RampRows, Rim, Tone};
