//! How large a surface's cells are, and how much room it is given: asked for in advance, because nobody
//! reads back how much it took.

use std::f32::consts::PI;

use super::surface_spread::Spread;
use crate::{Emitter, Particle, Resolution, Smoke, Surface};

/// Cells along a block's side. Also in the engine's `lattice.wgsl`.
pub(super) const BLOCK: u64 = 4;
/// Also in the engine's `lattice.wgsl`.
const POINTS: u64 = BLOCK * BLOCK * BLOCK;
/// Blocks along a region's side. Also in the engine's `lattice.wgsl`.
const REGION: u64 = 8;
/// Cells along it.
pub(super) const REGION_CELLS: u64 = BLOCK * REGION;
/// Blocks in a region.
const IN_REGION: u64 = REGION * REGION * REGION;
/// A table of this many regions is 4 MiB. Where the box around everything has more, cells are made larger.
const MOST_REGIONS: u64 = 1 << 20;
/// Regions that there is room for in the table where nobody can tell how far particles go.
const FAR_REGIONS: u32 = 1 << 16;
/// Fewer regions than this do not even have room for one small particle: it may touch as many.
const LEAST_REGIONS: u64 = 8;
/// A table of this many blocks is 16 MiB; cells that would need more are made larger.
const MOST_BLOCKS: u64 = 1 << 22;
/// Cells along the longest side that there is room for where nobody can tell how far particles go.
const FAR_CELLS: u32 = 128;
/// Where the picture says how large cells are: so many times more along the longest side than along the picture's
/// height. A ball that fills a picture of 60 degrees has 1.7 times as many, counted where it is nearest.
const FILLING: f32 = 2.0;
/// Likewise the most cells along the longest side: room for two such surfaces is within WebGPU's default limits.
const MOST_CELLS: f32 = 256.0;
/// Likewise the least, so that something is left to sample of what is far away. Also in the engine's `bounds.wgsl`.
const LEAST_CELLS: f32 = 8.0;
/// Of smoke, so many particles may be as wide as all of it is.
const WIDE_PARTICLES: u64 = 64;
/// Blocks on whose lists these may be together: beyond, cells are made larger.
const MOST_WIDE_ENTRIES: u64 = 1 << 22;
/// Of particles that have fewer cells to their radius than this, and overlap as many as `OVERLAP`, the engine's
/// `blocks.wgsl` cannot tell without sampling that they fill a block: its corners are 3.5 cells from its middle.
const UNSURE_CELLS: f64 = 9.0;
/// Of many particles, so many may overlap everywhere.
const OVERLAP: f32 = 8.0;

/// What a surface is made with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePlan {
    /// How finely the density is sampled.
    pub spacing: Spacing,
    /// Room for what comes of it.
    pub room: SurfaceRoom,
}

/// How finely the density is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spacing {
    /// The side of a cell, in metres.
    Cell(f32),
    /// Cells along the longest side of what there is at the moment. Cells come in steps of a quarter of an
    /// octave, rounded up, so that they seldom change while smoke grows.
    Subdivisions(f32),
    /// The picture says: cells appear as large as asked for where the object is nearest to the camera. They come in
    /// the same steps.
    Picture {
        /// The side of a cell over the picture's height.
        share: f32,
        /// No more cells than these along the longest side of what there is at the moment.
        most: f32,
    },
}

/// Room for one surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SurfaceRoom {
    /// Particles that it is made of.
    pub particles: u32,
    /// Regions of 8³ blocks in the box around all particles. Where more would be needed, cells are made larger.
    pub regions: u32,
    /// Blocks of 4³ cells in those regions that particles touch. Likewise.
    pub blocks: u32,
    /// Particles on the lists of all blocks together. Likewise.
    pub entries: u32,
    /// Blocks that the surface may cross, for all that is known before they are sampled. What is beyond is left
    /// out, as are vertices and triangles.
    pub active: u32,
    /// Corners of triangles.
    pub vertices: u32,
    /// Triangles.
    pub triangles: u32,
}

impl Surface {
    /// For particles that stay as they are.
    #[must_use]
    pub fn plan(&self, particles: &[Particle]) -> SurfacePlan {
        let longest_m = self.longest_m(particles);
        let cell_m = match self.resolution {
            Resolution::Subdivisions(cells) => longest_m / cells as f32,
            Resolution::Cell(cell_m) => cell_m,
            Resolution::PerRadius(cells) => self.mean_m(particles) / cells,
            Resolution::Picture(share) => longest_m / most_cells(share),
        };
        // Without any extent there is nothing to sample.
        let cell_m = if cell_m > 0.0 { cell_m } else { 1.0 };
        let cells = (longest_m / cell_m).ceil() as u32;
        let radii = particles.iter().map(|particle| (1, particle.radius * self.size / cell_m));
        let mut room = SurfaceRoom::of(radii, cells);
        let spacing = match self.resolution {
            Resolution::Picture(share) => Spacing::Picture { share, most: most_cells(share) },
            _ => Spacing::Cell(cell_m),
        };
        // Where cells stay as they are, it is known what particles touch.
        if let (Spacing::Cell(_), Some(spread)) = (spacing, Spread::of(particles, self.size, cell_m)) {
            room = room.within(spread);
        }
        SurfacePlan { spacing, room }
    }

    /// For particles of which every frame has others.
    #[must_use]
    pub fn plan_sequence(&self, particles: &[Particle]) -> SurfacePlan {
        let largest_m = particles.iter().map(|particle| particle.radius).fold(0.0, f32::max) * self.size;
        self.plan_moving(particles.len() as u64, self.mean_m(particles), largest_m)
    }

    /// For particles that become those of the next of `sets`, and so on.
    ///
    /// Cells stay as they are all the while, unless the picture says how large they are: those of the set that wants
    /// the largest.
    #[must_use]
    pub fn plan_morph(&self, sets: &[&[Particle]]) -> SurfacePlan {
        if matches!(self.resolution, Resolution::Picture(_)) {
            return self.plan_sequence(&sets.concat());
        }
        let cells_m = sets.iter().filter(|set| !set.is_empty()).map(|set| match self.plan(set).spacing {
            Spacing::Cell(cell_m) => cell_m,
            Spacing::Subdivisions(_) | Spacing::Picture { .. } => 0.0,
        });
        let cell_m = cells_m.reduce(f32::max).unwrap_or(1.0);
        // Between two sets particles are between two places, and as large as one of two.
        let all: Vec<Particle> = sets.concat();
        let cells = (self.longest_m(&all) / cell_m).ceil() as u32;
        let radii = all.iter().map(|particle| (1, particle.radius * self.size / cell_m));
        SurfacePlan { spacing: Spacing::Cell(cell_m), room: SurfaceRoom::of(radii, cells) }
    }

    /// For the most particles that `smoke` has at once, simulated in steps of `step_secs`.
    #[must_use]
    pub fn plan_smoke(&self, smoke: &Smoke, step_secs: f64) -> SurfacePlan {
        let emitters = &smoke.emitters;
        let count = emitters.iter().map(|emitter| emitter.capacity(step_secs)).fold(0, u64::saturating_add);
        let mean = |emitter: &Emitter| {
            0.5 * (emitter.radius[0] + emitter.radius[1]) * emitter.radius_over_life.mean()
        };
        let largest_m = emitters.iter().map(Emitter::largest_radius).fold(0.0, f32::max) * self.size;
        let mean_m = emitters.iter().map(mean).sum::<f32>() / emitters.len().max(1) as f32 * self.size;
        self.plan_moving(count, mean_m, largest_m)
    }

    fn plan_moving(&self, count: u64, mean_m: f32, largest_m: f32) -> SurfacePlan {
        let of_cell = |cell_m: f32| {
            let cell_m = if cell_m > 0.0 { cell_m } else { 1.0 };
            let mut room = SurfaceRoom::of([(count, largest_m / cell_m)], FAR_CELLS);
            room.regions = FAR_REGIONS;
            SurfacePlan { spacing: Spacing::Cell(cell_m), room }
        };
        let along = |cells: f32, spacing| {
            let wide = WIDE_PARTICLES.min(count);
            // Balls that fill a cube of side 1 so many times.
            let share = (OVERLAP * 0.75 / (PI * count.max(1) as f32)).cbrt().min(0.5);
            let mut room = SurfaceRoom::of([(count - wide, share * cells)], cells as u32);
            let wide_room = SurfaceRoom::of([(wide, 0.5 * cells)], cells as u32);
            let wide_entries = u64::from(wide_room.entries).min(MOST_WIDE_ENTRIES) as u32;
            room.particles = u32::try_from(count.max(1)).unwrap_or(u32::MAX);
            room.entries = room.entries.saturating_add(wide_entries);
            SurfacePlan { spacing, room }
        };
        match self.resolution {
            Resolution::Cell(cell_m) => of_cell(cell_m),
            Resolution::PerRadius(cells) => of_cell(mean_m / cells),
            Resolution::Subdivisions(cells) => along(cells as f32, Spacing::Subdivisions(cells as f32)),
            Resolution::Picture(share) => {
                let most = most_cells(share);
                along(most, Spacing::Picture { share, most })
            }
        }
    }

    /// The longest side of the box around all particles.
    fn longest_m(&self, particles: &[Particle]) -> f32 {
        let side = |axis: usize| {
            let ends = particles.iter().map(|particle| {
                let radius_m = particle.radius * self.size;
                [particle.center[axis] - radius_m, particle.center[axis] + radius_m]
            });
            ends.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]).map_or(0.0, |[low, high]| high - low)
        };
        side(0).max(side(1)).max(side(2))
    }

    fn mean_m(&self, particles: &[Particle]) -> f32 {
        let sum: f32 = particles.iter().map(|particle| particle.radius).sum();
        self.size * sum / particles.len().max(1) as f32
    }
}

/// The most cells along the longest side where one covers this `share` of the picture's height.
fn most_cells(share: f32) -> f32 {
    (FILLING / share).ceil().clamp(LEAST_CELLS, MOST_CELLS)
}

impl SurfaceRoom {
    /// Enough for particles, given as numbers of them and their radius in cells, in bounds of `cells` along
    /// the longest side.
    ///
    /// What no formula can bound is how rugged the surface becomes: there is room for three times the
    /// surface of a cube around it all.
    #[must_use]
    pub fn of(particles: impl IntoIterator<Item = (u64, f32)>, cells: u32) -> Self {
        let (mut count, mut sum, mut most, mut usual) = (0_u64, 0.0_f64, 0.0_f64, 0.0_f64);
        for (more, radius_cells) in particles {
            // See `touched` in the engine's `bounds.wgsl`.
            let touched = |wider: f64| (0.5 * f64::from(radius_cells.max(0.0)) + wider).powi(3);
            count = count.saturating_add(more);
            sum += more as f64 * f64::from(radius_cells.max(0.0));
            most += more as f64 * touched(2.2);
            usual += more as f64 * touched(1.125);
        }
        // Several standard deviations of a sum of so many, for those that lie anywhere. The cast saturates.
        let entries = most.min(usual * (1.0 + 4.0 / (count.max(1) as f64).sqrt())).ceil() as u64;
        let regions_along = u64::from(cells).div_ceil(REGION_CELLS).saturating_add(2);
        let regions = regions_along.saturating_pow(3).clamp(LEAST_REGIONS, MOST_REGIONS);
        let along = u64::from(cells).div_ceil(BLOCK).saturating_add(3);
        let blocks = regions.saturating_mul(IN_REGION).min(MOST_BLOCKS);
        let faces = along.saturating_pow(2).saturating_mul(6 * 3);
        let is_unsure = sum < UNSURE_CELLS * count as f64;
        let active = blocks.min(if is_unsure { along.saturating_pow(3) } else { faces });
        // A plane crosses 1.5 edges for every square that its cells' faces are large, on average; a surface
        // without a border has two triangles for each vertex.
        let vertices = (active * POINTS).min(faces.saturating_mul(BLOCK * BLOCK * 3 / 2));
        let within = |count: u64| u32::try_from(count).unwrap_or(u32::MAX);
        Self {
            particles: within(count.max(1)),
            regions: within(regions),
            blocks: within(blocks),
            entries: within(entries.max(1)),
            active: within(active),
            vertices: within(vertices),
            triangles: within(vertices.saturating_mul(2)),
        }
    }

    /// No more than for particles of which this is known.
    fn within(self, spread: Spread) -> Self {
        let within = |count: u64| u32::try_from(count).unwrap_or(u32::MAX);
        let blocks = within(spread.regions.max(LEAST_REGIONS) * IN_REGION).min(self.blocks);
        let entries = within(spread.entries.max(1));
        let faces = spread.faces.saturating_mul(REGION * REGION * 3);
        let active = self.active.min(blocks).min(entries);
        let vertices = self.vertices.min(within(faces.saturating_mul(BLOCK * BLOCK * 3 / 2))).max(1);
        let regions = within(spread.boxed.clamp(LEAST_REGIONS, u64::from(self.regions)));
        Self { regions, blocks, entries, active, vertices, triangles: vertices.saturating_mul(2), ..self }
    }

    /// Bytes of graphics memory that it takes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.parts().iter().map(|(_, count, bytes)| count * bytes).sum()
    }

    /// Bytes that it takes besides, to throw shadows: for each triangle three neighbours, how it stands to the
    /// light, its cap, and one side for every two triangles.
    #[must_use]
    pub fn shadow_bytes(&self) -> u64 {
        u64::from(self.triangles) * (12 + 4 + 4 + 4)
    }

    /// What there is, how many, and bytes for each.
    #[must_use]
    pub fn parts(&self) -> [(&'static str, u64, u64); 8] {
        [
            // A blob, one more where there are very many, and its part in a share of 48 bytes for each 1024.
            ("particles", u64::from(self.particles), 65),
            // Where it is in the table, whether it is touched, and how many are before it.
            ("regions of blocks", u64::from(self.regions), 12),
            // Tally, start, state, whether crossed, slot; a run for each 32.
            ("blocks of cells", u64::from(self.blocks), 21),
            ("particles on blocks' lists", u64::from(self.entries), 4),
            // What is crossed.
            ("blocks that the surface crosses", u64::from(self.active), 64),
            // Signs, place and number, counts and starts; a run for each 32.
            ("blocks that are sampled", u64::from(self.active), 57),
            // And its place on the list of those that need care.
            ("vertices", u64::from(self.vertices), 20),
            ("triangles", u64::from(self.triangles), 16),
        ]
    }

    /// Room for either.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self {
            particles: self.particles.max(other.particles),
            regions: self.regions.max(other.regions),
            blocks: self.blocks.max(other.blocks),
            entries: self.entries.max(other.entries),
            active: self.active.max(other.active),
            vertices: self.vertices.max(other.vertices),
            triangles: self.triangles.max(other.triangles),
        }
    }
}
