//! Runs the real `fumetto`, as a shell would, on whatever adapter there is.

#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod bad_input;
mod bake;
mod documents;
mod export;
mod interrupt;
mod output;
mod render;
mod run;
mod usage;
