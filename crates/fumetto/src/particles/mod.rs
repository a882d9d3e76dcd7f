//! Matter: particles on the GPU, where they come from and what moves them.

mod births;
mod emission;
mod forces;
mod grid;
mod plume;
mod state;
mod vortex;

pub(crate) use emission::Emission;
pub use grid::{AirTimes, TooManyFacets};
pub(crate) use grid::{Facet, Voxels};
pub(crate) use plume::{Particles, Plume};
pub(crate) use state::Particle;

#[cfg(test)]
mod tests;
