//! The Fumetto document: what a scene is, how it is written down, and what is wrong with it.
//!
//! This crate knows no GPU and opens no file.

mod model;

pub use model::*;
