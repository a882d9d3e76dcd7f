//! Ink: the lines of a drawing.

mod gather;
mod outline;
mod pen;

pub(crate) use gather::{Gather, InkAround};
pub(crate) use outline::Outline;
pub(crate) use pen::{MAX_PENS, Pen};
