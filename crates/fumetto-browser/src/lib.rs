//! Drives Chromium as a person would: opens a page, points, drags, types, looks at what is shown. For tests.
//!
//! It speaks the `DevTools` protocol over a pipe, so there is neither a port nor a driver program. WebGPU runs on
//! `SwiftShader`, which Chromium brings with it and which draws on the processor: pictures should be small.

mod browser;
mod connection;
mod error;
mod input;
mod server;

pub use browser::Browser;
pub use error::BrowserError;
pub use server::Server;
