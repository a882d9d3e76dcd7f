//! From the wire shape to the checked model: whether a scene that reads well also makes sense.
//!
//! "Parse, don't validate": every function here takes a part of [`crate::file`] and the place where it
//! stood, and gives the part of the model. What makes no sense is reported and the next thing is
//! looked at; whoever calls throws the result away if an error was reported.

mod at;
mod grid;
mod hatching;
mod imported;
mod ink;
mod light;
mod mesh;
mod morph;
mod object;
mod paint;
mod ramp;
mod scene;
mod shape;
mod smoke;
mod stain;
mod stroke;
mod style;
mod tones;
mod values;
mod volume;
mod vortex;

pub(crate) use at::At;
pub(crate) use object::is_key_of;
pub(crate) use scene::scene;
pub(crate) use style::Styles;
