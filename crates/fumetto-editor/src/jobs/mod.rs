//! Renderings and exports, done by the `fumetto` program beside the editor, while editing goes on.
//!
//! Another process has a device and a simulation of its own, can be stopped at any time and leaves whole files only.

mod child;
mod order;

pub(crate) use child::{Job, State};
pub(crate) use order::{LAST_FRAME, LAYERS, Order, Work, name_for};
