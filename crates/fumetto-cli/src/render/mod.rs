//! What a rendering consists of, and where it goes.

mod names;
mod picture;
mod plan;
mod sink;

pub(crate) use self::{
    names::with_part,
    picture::{DrawTile, Picture},
    plan::{Plan, chosen_camera},
    sink::Sink,
};

use fumetto_formats::Image;

/// A finished picture and the layers that were asked for, in their order.
pub(crate) struct Drawing {
    /// Frames of the same number look the same.
    pub(crate) number: u32,
    pub(crate) picture: Picture,
    pub(crate) layers: Vec<Image>,
}
