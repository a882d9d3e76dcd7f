//! Paint that spreads: volumes that grow over the scene, and change how all that lies in them is drawn.
//!
//! After M. ten Bosch, "Real-Time Non Photorealistic Paint Spreading using Stencil Volumes".
//!
//! ```text
//! drops, strokes ─▶ orders ──────┐
//!  (by the clock)   of each step ├▶ spread ──▶ measure ─▶ mask ─────▶ reveal
//! pours ─▶ cells ─▶ orders ──────┤  vertices   least     what the    which look, which washes,
//!          spill                 │  move       and most  layers show  whose line
//! particles ─▶ touch ─▶ orders ──┘             radius    lies in
//!   the ground
//! ```
//!
//! **A volume is a radius in every direction.** The paper's vertices are particles on a ball; so are ours, and each
//! moves along its own ray. What the paper then counts in the stencil buffer we ask: is what a pixel shows nearer
//! than the radius in its direction? That is exact from wherever it is seen, also from inside; it needs no count, and
//! the radius is smooth between the vertices, so that a border is smooth however near it is seen.
//! A drop that runs and a stroke of a brush are the same about an axis in place of a point. What lies on models may be
//! drawn down along them: see `downhill.wgsl`.
//!
//! **Most places need not ask.** A tile of the picture looks at those volumes that come near the box around all that
//! it shows, and a place that is nearer than the least radius, or farther than the largest, is known without a look
//! at any vertex. So a thousand volumes cost a few comparisons a tile, and only pixels near borders cost more.

mod cells;
mod coat;
mod floor;
mod ground;
mod group;
mod mask;
mod orders;
mod scene;
mod sphere;
mod spread;
mod stains;
#[cfg(test)]
mod tests;

pub(crate) use mask::{Marks, Mask};
pub(crate) use scene::{PaintScene, Surroundings};
pub(crate) use spread::Spreading;
