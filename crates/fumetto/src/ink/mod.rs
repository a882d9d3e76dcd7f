//! Ink: the lines of a drawing.

mod angle;
mod flood;
mod gather;
mod image;
mod inner;
mod methods;
mod outline;
mod pen;
mod shell;
mod stroke;
#[cfg(test)]
mod tests;
mod vector;

pub(crate) use angle::Angle;
pub(crate) use gather::{Gather, InkAround};
pub(crate) use image::Image;
pub(crate) use inner::Inner;
pub(crate) use methods::Methods;
pub(crate) use outline::Outline;
pub(crate) use pen::{MAX_PENS, Pen, follows_edges};
pub(crate) use shell::Shell;
pub(crate) use stroke::{Drawing, Moment, StrokeStyle, StrokeTextures, Strokes, TOOTH_SIDE, reach_px, tooth};
pub(crate) use vector::Vector;

/// Number of the pen + 1, 0 where there is no ink; opacity of the line, 0 to 255.
pub(crate) const INK_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg8Uint;
