//! Matter: particles on the GPU, where they come from and what moves them.

mod births;
mod emission;
mod forces;
mod plume;
mod vortex;

pub(crate) use emission::Emission;
pub(crate) use plume::{Particles, Plume};

#[cfg(test)]
mod tests;
