//! Volumes: matter that light goes through, after Tessendorf's pyroclastic puffs as Normoyle renders them.
//!
//! ```text
//! puffs ─▶ bounds ─▶ matter ───▶ occupied ─▶ transmit ──▶ march ─▶ hits ─▶ depth, id, normal ─▶ tones, ink
//!          grid      density,    blocks      how much      rays       └▶ soft ─▶ veil over the tones
//!          around    colour,     with        of each       of one
//!          them      owner       matter      light         picture
//!                                            comes
//!                                            through
//! ```
//!
//! All up to the light happens on the GPU when matter changes, and what stands still is made but once; only rays
//! are followed anew for each picture.
//!
//! **A grid, not puffs along the ray.** A step that asks every puff near it for its noise costs, with thirty
//! puffs of five octaves, a thousand times what a sample of a texture does, and light asks as often as the eye.
//! A cell is worked out once, from the puffs that touch its workgroup. What is finer than a cell is lost: with
//! 224 cells to a cloud 900 pixels wide, that is about the width of a line of ink.
//! Memory is dense, and what is seen of it is not: rays leap over blocks of 8³ cells without matter.
//!
//! **The march knows no puffs.** It is written against what a field can be asked (`cells.wgsl`), and linked once with
//! the grid of puffs and once with the bricks of a file (`bricks/bricks.wgsl`).
//!
//! **One renderer.** What is drawn flat is the same march: where the opacity along a ray reaches a threshold lies
//! the surface, and the light that was gathered before it is what tones quantise.

mod bricks;
mod field;
mod grids;
mod march;
mod recipe;
mod scene;
#[cfg(test)]
mod tests;

pub use bricks::ImportError;
pub(crate) use bricks::{BrickField, BrickMap, MAX_LOBES, Samples};
pub(crate) use field::{CellField, CellGrid, Field};
pub(crate) use grids::Volume;
pub(crate) use march::March;
pub(crate) use scene::{Source, VolumeObject, VolumeScene, VolumeTooLarge};
