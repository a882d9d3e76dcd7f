//! The editor as a person uses it: what is on the screen is found by its labels, pressed and typed into.

mod desk;
mod files;
mod output;
mod tree;
mod view;
