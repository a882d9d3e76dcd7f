//! Drives Chromium: opens a page and runs scripts in it. For tests.
//!
//! It speaks the `DevTools` protocol over a pipe, so there is neither a port nor a driver program. WebGPU runs on
//! `SwiftShader`, which Chromium brings with it and which draws on the processor: pictures should be small.

mod browser;
mod connection;
mod error;
mod server;

pub use browser::Browser;
pub use error::BrowserError;
pub use server::Server;
