//! Files on a disk: the scene and what it names are read within bounds; whatever is written appears whole or not at
//! all.
//!
//! The engine opens no files. What runs in a browser goes without this crate.

mod read;
mod write;

pub use read::{SceneFolder, read_beginning, read_bytes, read_standard_input, read_text};
pub use write::{Draft, check, write};
