//! A scene that is being edited: its text, what a form shows of it, and what can be added to it.
//!
//! Nothing here knows a window. The text of a [`Document`] is the truth; every [`Edit`] is a change of it that a careful
//! hand could have made, with all comments where they were.
//!
//! ```
//! use fumetto_scene::edit::{Document, Edit};
//!
//! let mut scene = Document::open("[camera]\nfov = 40 # degrees\n")?;
//! scene.apply(&Edit::Set { path: "camera.fov".parse()?, value: 35.0.into() })?;
//! assert_eq!(scene.text(), "[camera]\nfov = 35 # degrees\n");
//! assert_eq!(scene.undo_label(), Some("Set camera.fov"));
//! assert!(scene.undo() && !scene.is_changed());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod apply;
mod array;
mod blocks;
mod change;
mod document;
pub mod form;
mod history;
mod inline;
mod list;
mod locate;
mod names;
mod path;
mod sections;
mod set;
mod splices;
mod syntax;
pub mod templates;
mod write;

pub use change::{Edit, EditError, Item};
pub use document::Document;
pub use path::{Path, PathError, Step};
pub use syntax::SyntaxError;
/// What a key is set to, and what is read of it.
pub use toml::{Table, Value};
