//! Álvarez's implicit surface: all particles of an object become one closed skin of triangles.
//!
//! Álvarez et al., "Interactive Cartoon Rendering and Sketching of Clouds and Smoke", 2007, sections 3
//! and 5. Every particle has a density that falls from its mass at the centre to zero at its radius; the
//! surface is where the sum of all is the threshold.
//!
//! ```text
//! puffs ─▶ bounds ─▶ regions ─▶ bins ─▶ blocks ─▶ cells ─▶ mesh
//!          lattice   where      who      which     inside   vertices on the true
//!          around    there      touches  can the   or not,  surface, triangles,
//!          them      is any     which    surface   which    arguments of
//!                    matter     block    cross     case     the draw
//! ```
//!
//! All of it happens on the GPU, every frame, and nothing is read back. Where cells are lengths on the picture, it
//! happens when the picture is drawn, and again only where the camera has come so much nearer, or the matter moved
//! (`sight.rs`). Work is linear in what blocks have on their lists and in the area of the surface: the inside of a
//! thick cloud is never sampled, and the air between two clouds has no blocks.
//!
//! **Marching cubes**, with cases that only look at signs (`polygons.rs`), for this is watertight by
//! construction and needs no look at neighbours. What it is known for, slivers, is avoided by keeping
//! vertices away from lattice points and on the true surface (`vertices.wgsl`). Dual methods have better
//! triangles yet, as many of them, and need neighbours to be manifold.
//!
//! **Every run gives the same bytes**: lists are in no order, and what is summed over them are whole numbers
//! (`units.wgsl`); vertices and triangles come in the order of blocks and cells.
//!
//! **Files** tell a density, too. Balls that cover their bricks of voxels stand for them until the lattice is laid; from
//! there on the bricks are asked in place of particles (`bricks.rs`).
//!
//! **What does not fit** is never written out of bounds. Cells are made larger until blocks and lists fit,
//! which keeps the surface closed; vertices and triangles beyond their room are left out. Either is told in
//! the mesh's counters.

mod adjacent;
mod bins;
mod blocks;
mod bounds;
mod bricks;
mod buffers;
mod cells;
mod mesh;
mod noisy;
mod order;
mod peak;
mod polygons;
mod recipe;
mod refusal;
mod regions;
mod scan;
mod scene;
mod sight;
mod size;
#[cfg(test)]
mod tests;

pub(crate) use peak::{is_outside, peak_of_nothing};
pub(crate) use refusal::{SurfaceTooLarge, shortage};
pub(crate) use scene::{SurfaceObject, SurfaceScene};
pub(crate) use sight::Sight;
pub use size::SurfaceSize;

use buffers::Workspace;
use fumetto_scene::SurfaceRoom;
use order::are_many;
use recipe::Recipe;

use crate::{
    gpu::{Frame, Gpu},
    shapes::mesh::Reserved,
};

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Surface {
    bounds: bounds::Bounds,
    order: order::Order,
    scan: scan::Scan,
    regions: regions::Regions,
    bins: bins::Bins,
    blocks: blocks::Blocks,
    bricks: bricks::Bricks,
    cells: cells::Cells,
    meshing: mesh::Meshing,
    adjacent: adjacent::Adjacent,
}

impl Surface {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        Self {
            bounds: bounds::Bounds::new(gpu),
            order: order::Order::new(gpu),
            scan: scan::Scan::new(gpu),
            regions: regions::Regions::new(gpu),
            bins: bins::Bins::new(gpu),
            blocks: blocks::Blocks::new(gpu),
            bricks: bricks::Bricks::new(gpu),
            cells: cells::Cells::new(gpu),
            meshing: mesh::Meshing::new(gpu),
            adjacent: adjacent::Adjacent::new(gpu),
        }
    }

    /// Makes the surface of the recipe's `puffs` at the moment `secs`; its `room` is within that of `work`.
    ///
    /// Puffs beyond the room are not looked at.
    fn record(
        &self,
        frame: &mut Frame<'_>,
        puffs: &wgpu::Buffer,
        recipe: &Recipe,
        (room, work): (SurfaceRoom, &Workspace),
        (secs, mesh): (f32, &Reserved),
    ) {
        let uniform = frame.uniform("shapes.surface.recipe", &recipe.uniform(secs, room, mesh));
        let count = (recipe.puffs.len() as u32).min(room.particles);
        let noisy = recipe.noise.is_some_and(|noise| noise.amplitude > 0.0);
        let job = Job { recipe: &uniform, count, noisy, room, work };
        self.bounds.record(frame, job, puffs);
        if are_many(count) {
            self.order.record(frame, job, &self.scan);
        }
        self.regions.record(frame, job, &self.scan);
        match &recipe.bricks {
            Some(field) => self.bricks.classify(frame, job, field),
            None => {
                self.bins.record(frame, job, &self.scan);
                self.blocks.classify(frame, job);
            }
        }
        self.blocks.list(frame, job, &self.scan);
        match &recipe.bricks {
            Some(field) => self.bricks.signs(frame, job, field),
            None => self.cells.signs(frame, job),
        }
        self.cells.sort(frame, job, &self.scan);
        self.meshing.count(frame, job, mesh);
        match &recipe.bricks {
            Some(field) => self.bricks.vertices(frame, job, field, mesh),
            None => self.meshing.vertices(frame, job, mesh),
        }
        self.meshing.triangles(frame, job, mesh);
        if let Some(adjacent) = &mesh.adjacent {
            self.adjacent.record(frame, job, adjacent);
        }
    }
}

/// What all steps of an extraction share.
#[derive(Clone, Copy)]
struct Job<'a> {
    /// `Recipe` of `recipe.wgsl`.
    recipe: &'a wgpu::Buffer,
    /// Particles.
    count: u32,
    /// Whether noise is added to the field.
    noisy: bool,
    room: SurfaceRoom,
    work: &'a Workspace,
}
