//! How much room a volume's grids are given: asked for in advance, because nobody reads back where smoke
//! went.

use crate::{Particle, Volume, limits::MAX_VOLUME_BYTES};

/// Cells that lie outside the matter along each side, so that what is sampled between cells ends in nothing,
/// and the grid may lie on multiples of its cells.
const MARGIN: u32 = 3;

/// Bytes of a cell: colour and density as four halves, and the number of a puff.
const CELL_BYTES: u64 = 12;

/// Bytes of a cell of light: four halves.
const LIGHT_CELL_BYTES: u64 = 8;

/// Cells along the sides of a volume's grids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VolumeRoom {
    /// Of the density.
    pub cells: [u32; 3],
    /// Of the light.
    pub light_cells: [u32; 3],
}

impl Volume {
    /// For particles that stay as they are.
    #[must_use]
    pub fn room(&self, particles: &[Particle]) -> VolumeRoom {
        let reach = self.reach();
        let extent = |axis: usize| {
            let ends = particles.iter().map(|particle| {
                let reach_m = particle.radius * reach;
                [particle.center[axis] - reach_m, particle.center[axis] + reach_m]
            });
            ends.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).map_or(0.0, |[low, high]| high - low)
        };
        let extents = [0, 1, 2].map(extent);
        let longest = extents.into_iter().fold(f32::MIN_POSITIVE, f32::max);
        let inside = self.cells.saturating_sub(MARGIN).max(1) as f32;
        self.shared(extents.map(|side| ((side / longest * inside).ceil() as u32 + MARGIN).min(self.cells)))
    }

    /// For particles that move: nobody knows along which axis they spread.
    #[must_use]
    pub fn moving_room(&self) -> VolumeRoom {
        self.shared([self.cells; 3])
    }

    /// Cells of light share the density's box.
    fn shared(&self, cells: [u32; 3]) -> VolumeRoom {
        let ratio = (self.cells as f32 / self.light_cells as f32).max(1.0);
        VolumeRoom { cells, light_cells: cells.map(|side| (side as f32 / ratio).ceil() as u32) }
    }
}

impl VolumeRoom {
    /// Bytes of graphics memory that it takes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let product = |sides: [u32; 3]| sides.map(u64::from).iter().product::<u64>();
        product(self.cells) * CELL_BYTES + product(self.light_cells) * LIGHT_CELL_BYTES
    }

    /// Whether it is within [`MAX_VOLUME_BYTES`].
    #[must_use]
    pub fn fits(&self) -> bool {
        self.bytes() <= MAX_VOLUME_BYTES
    }
}
