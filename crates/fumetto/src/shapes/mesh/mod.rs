//! Models: triangles from files, drawn into the layers that smoke fills too.

mod body;
mod edge_scene;
mod edges;
mod geometry;
mod near;
mod pieces;
mod place;
mod placements;
mod push;
mod reserved;
mod scene;
mod seams;
mod sets;
mod shells;
mod smooth;
#[cfg(test)]
mod tests;
mod textures;
mod weld;

pub(crate) use body::Body;
pub(crate) use edge_scene::LineScene;
pub(crate) use edges::candidates;
pub(crate) use edges::{Candidate, bit};
pub(crate) use geometry::{Geometry, Part, Triangle};
pub(crate) use place::Place;
pub(crate) use placements::{triangles_at, world_from_file};
pub(crate) use reserved::Reserved;
pub(crate) use scene::{Casters, MeshError, MeshScene};
pub(crate) use seams::seams;
pub(crate) use sets::Sets;
pub(crate) use shells::Shells;
pub(crate) use smooth::unpacked;

/// Bytes of a `Vertex` of `mesh.wgsl`.
const VERTEX_BYTES: u64 = 16;
