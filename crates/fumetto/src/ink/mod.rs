//! Ink: the lines of a drawing.

mod gather;
mod outline;

pub(crate) use gather::{Gather, InkAround};
pub(crate) use outline::Outline;
