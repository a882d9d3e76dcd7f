//! Volumes out of files: voxels in bricks, of which only those with matter are kept.
//!
//! ```text
//! file ─▶ grids ─▶ samples ─▶ map ─────────▶ field
//!                  density    table: where    the same on the GPU,
//!                  and heat   each brick is;  and light in it
//!                             atlas: bricks
//!                             lobes
//! ```
//!
//! Memory goes by what there is and not by how far it is apart: a brick of 8³ voxels takes 729 numbers, a node of 16³
//! bricks one word for each, and nothing at all one word for 128³ voxels. Bricks that are the same all over are kept
//! once, so the inside of a level set is almost free.
//!
//! **Where a sample sits.** A file says where the middle of each voxel lies in the world, and so does this: voxels
//! have whole numbers at their middles, and what is drawn between them is linear.
//!
//! **Lobes.** Style knows puffs: how large the masses are that light turns around, and how far one stands before
//! another. A file has none, so its matter is gathered into balls of the size of lobes, which are never drawn.

mod cover;
mod error;
mod field;
mod lobes;
mod map;
mod samples;
mod table;

pub use error::ImportError;
pub(crate) use field::BrickField;
pub(crate) use lobes::MAX_LOBES;
pub(crate) use map::BrickMap;
pub(crate) use samples::Samples;
