//! How much room a surface is given, asked for in advance: nobody reads back how much it took.

use thiserror::Error;

use crate::gpu::Gpu;

/// Cells along a block's side. Also in `lattice.wgsl`.
const BLOCK: u64 = 4;
/// Also in `lattice.wgsl`.
const POINTS: u64 = BLOCK * BLOCK * BLOCK;
/// Items that one invocation of `scan.wgsl` looks at.
pub(super) const RUN: u32 = 32;
/// A table of this many blocks is 16 MiB; cells that would need more are made larger.
const MOST_BLOCKS: u64 = 1 << 22;

/// Room for one surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Capacity {
    pub(crate) particles: u32,
    /// Blocks of 4³ cells within the bounds. Where more would be needed, cells are made larger.
    pub(crate) blocks: u32,
    /// Particles on the lists of all blocks together. Likewise.
    pub(crate) entries: u32,
    /// Blocks that the surface may cross. What is beyond is left out, as are vertices and triangles.
    pub(crate) active: u32,
    pub(crate) vertices: u32,
    pub(crate) triangles: u32,
}

/// A surface that the device has no room for.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "a surface with room for {count} {what} needs {needed} bytes for them, and this device allows {allowed}: \
     choose fewer subdivisions or fewer particles"
)]
pub(crate) struct SurfaceTooLarge {
    what: &'static str,
    count: u64,
    needed: u64,
    allowed: u64,
}

impl Capacity {
    /// Enough for a cloud of `particles` whose radii are at most `radius_cells`, in bounds of `cells` along
    /// the longest side.
    ///
    /// What no formula can bound is how rugged the surface becomes: there is room for three times the
    /// surface of a cube around it all.
    pub(crate) fn of(particles: u32, radius_cells: f32, cells: u32) -> Self {
        let along = u64::from(cells).div_ceil(BLOCK).saturating_add(3);
        let blocks = along.saturating_pow(3).min(MOST_BLOCKS);
        let faces = along.saturating_pow(2).saturating_mul(6 * 3);
        let active = blocks.min(faces);
        // A plane crosses 1.5 edges for every square that its cells' faces are large, on average; a surface
        // without a border has two triangles for each vertex.
        let vertices = (active * POINTS).min(faces.saturating_mul(BLOCK * BLOCK * 3 / 2));
        // See `touched` in `bounds.wgsl`. What is more than that is refused by `check`.
        let touched = (0.5 * f64::from(radius_cells.max(0.0)) + 2.2).powi(3).ceil() as u64;
        let within = |count: u64| u32::try_from(count).unwrap_or(u32::MAX);
        Self {
            particles: particles.max(1),
            blocks: within(blocks),
            entries: within(u64::from(particles.max(1)).saturating_mul(touched)),
            active: within(active),
            vertices: within(vertices),
            triangles: within(vertices.saturating_mul(2)),
        }
    }

    /// Bytes of graphics memory that it takes.
    pub(crate) fn bytes(self) -> u64 {
        self.parts().iter().map(|(_, count, bytes)| count * bytes).sum()
    }

    /// Refuses what has buffers larger than the device binds.
    ///
    /// # Errors
    /// Names the first that is too large.
    pub(crate) fn check(self, gpu: &Gpu) -> Result<(), SurfaceTooLarge> {
        let limits = gpu.device.limits();
        let allowed = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        // Each of them is several buffers, one of which is nearly all of it; as one they err on the safe side.
        let too_large = self.parts().into_iter().find(|(_, count, bytes)| count * bytes > allowed);
        too_large.map_or(Ok(()), |(what, count, bytes)| {
            Err(SurfaceTooLarge { what, count, needed: count * bytes, allowed })
        })
    }

    /// What there is, how many, and bytes for each.
    fn parts(self) -> [(&'static str, u64, u64); 6] {
        [
            // A blob, and its part in a share of 64 bytes for each 256.
            ("particles", u64::from(self.particles), 33),
            // Tally, start, state, whether crossed, slot; a run for each 32.
            ("blocks of cells", u64::from(self.blocks), 21),
            ("particles on blocks' lists", u64::from(self.entries), 4),
            // A word for each point; number, signs, counts and starts.
            ("blocks that the surface crosses", u64::from(self.active), 4 * POINTS + 28),
            ("vertices", u64::from(self.vertices), 16),
            ("triangles", u64::from(self.triangles), 16),
        ]
    }
}
