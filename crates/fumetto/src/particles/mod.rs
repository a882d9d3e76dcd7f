//! Matter: particles on the GPU, where they come from and what moves them.

mod births;
mod emission;
mod forces;

pub(crate) use emission::{Emission, Particles};

#[cfg(test)]
mod tests;
