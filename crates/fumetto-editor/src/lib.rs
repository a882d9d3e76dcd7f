//! The Fumetto editor: the same code in a window and in a browser tab.
//!
//! ```text
//! keys, menus, panels ─▶ requests ─▶ document (text, undo) ─▶ scene ─▶ stage (engine, picture)
//!       ▲                                                                     │
//!       └────────────────── what is shown of all that ◀───────────────────────┘
//! ```
//!
//! The document is what is saved and undone; the settings are the user's; all else can be made anew from these.

mod app;
#[cfg(not(target_arch = "wasm32"))]
mod autosave;
mod clock;
mod commands;
#[cfg(not(target_arch = "wasm32"))]
mod dialogs;
mod examples;
mod files;
mod icons;
#[cfg(not(target_arch = "wasm32"))]
mod jobs;
mod panels;
mod project;
mod request;
mod selection;
mod settings;
mod stage;
mod view;

pub use app::App;
