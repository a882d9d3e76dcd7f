//! The Fumetto editor, in a window of its own.
//!
//! ```text
//! keys, menus, panels ─▶ requests ─▶ document (text, undo) ─▶ scene ─▶ stage (engine, picture)
//!       ▲                                                                     │
//!       └────────────────── what is shown of all that ◀───────────────────────┘
//! ```
//!
//! The document is what is saved and undone; the settings are the user's; all else can be made anew from these.

mod app;
mod autosave;
mod clock;
mod commands;
mod dialogs;
mod examples;
mod files;
mod icons;
mod jobs;
mod panels;
mod project;
mod request;
mod selection;
mod settings;
mod stage;
mod view;

pub use app::App;
pub use project::Project;
