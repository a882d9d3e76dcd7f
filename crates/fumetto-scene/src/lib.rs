//! The Fumetto document: what a scene is, how it is written down, and what is wrong with it.
//!
//! A scene's text becomes a checked [`Scene`] on one way, [`Scene::load`], which finds everything
//! that is wrong before it gives up:
//!
//! ```text
//! TOML ─▶ tree with places ─▶ fits the schema? ─▶ wire shape ─▶ makes sense? ─▶ Scene
//!         text/  (--set)      fit/                file/         check/          model/
//!                     └──────── every problem, with its place, to report/ ────────┘
//! ```
//!
//! This crate knows no GPU and opens no file.

mod check;
pub mod edit;
pub mod file;
mod fit;
pub mod limits;
mod load;
mod model;
pub mod presets;
mod report;
mod schema;
pub mod starts;
mod text;

pub use load::{FORMAT, Resolve, SceneText, StyleChoice};
pub use model::*;
pub use report::{Problem, Report, Severity};
pub use schema::schema;
