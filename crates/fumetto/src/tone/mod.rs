//! Tone: light turned into flat colour, and the picture put together.

mod backdrop;
mod canvas;
mod compose;
mod copied;
mod flat;
mod ground;
mod hatching;
mod ramps;
mod reveal;
mod sprites;
mod tones;
mod turns;
mod veil;

pub(crate) use backdrop::Backdrop;
pub(crate) use canvas::Canvas;
pub(crate) use compose::{Compose, Inked, Sheet, Under};
pub(crate) use copied::Copied;
pub(crate) use flat::{CEL_FORMAT, Flat};
pub(crate) use ground::Ground;
pub(crate) use hatching::{HatchStyle, HatchStyles, Hatched, Sheeted};
pub(crate) use ramps::Ramps;
pub(crate) use reveal::Reveal;
pub(crate) use sprites::{MAX_OBJECTS, Sprites};
pub(crate) use tones::Features;
pub(crate) use turns::{TURNS_PX, Turns};
pub(crate) use veil::Veil;
