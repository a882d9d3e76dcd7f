//! Tone: light turned into flat colour, and the picture put together.

mod backdrop;
mod compose;
mod flat;
mod ramps;

pub(crate) use backdrop::Backdrop;
pub(crate) use compose::{Compose, Under};
pub(crate) use flat::{CEL_FORMAT, Flat};
pub(crate) use ramps::Ramps;
