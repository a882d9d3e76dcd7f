//! Ink: the lines of a drawing.

mod angle;
mod flood;
mod gather;
mod image;
mod methods;
mod outline;
mod pen;
mod shell;
#[cfg(test)]
mod tests;
mod vector;

pub(crate) use angle::Angle;
pub(crate) use gather::{Gather, InkAround};
pub(crate) use image::Image;
pub(crate) use methods::Methods;
pub(crate) use outline::Outline;
pub(crate) use pen::{MAX_PENS, Pen};
pub(crate) use shell::Shell;
pub(crate) use vector::{Lines, Vector};

use outline::INK_FORMAT;
