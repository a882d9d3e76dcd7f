//! The parts of the window round the picture. Each reads the state and asks for changes; none makes any.

pub(crate) mod inspector;
pub(crate) mod menu;
pub(crate) mod output;
pub(crate) mod palette;
pub(crate) mod problems;
pub(crate) mod styles;
pub(crate) mod text;
pub(crate) mod timeline;
pub(crate) mod tree;
