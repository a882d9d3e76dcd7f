//! Models: triangles from files, drawn into the layers that smoke fills too.

mod body;
mod geometry;
mod pieces;
mod place;
mod push;
mod scene;
mod shells;
mod smooth;
mod textures;

pub(crate) use body::Body;
pub(crate) use geometry::Geometry;
pub(crate) use place::Place;
pub(crate) use scene::{Casters, MeshError, MeshScene};
pub(crate) use shells::Shells;
