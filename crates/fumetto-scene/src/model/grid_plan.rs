//! How large the grid around smoke is, and in how many sub-steps its air moves.

use crate::limits::{MAX_COARSEST_CELLS, MAX_GRID_CELLS};
use crate::{Emitter, EmitterShape, Force, Grid, Matter, Scene, Smoke};

/// Cells that air may cross in a sub-step. The scheme stays stable beyond, but its limiter then flattens what it
/// carries.
const COURANT: f32 = 4.0;
/// Cells are in blocks of this many along every side, and levels of the pressure have half as many as the one before.
const BLOCK: u32 = 8;
/// What is left of the divergence after one cycle of the pressure's multigrid is at most this share (measured over
/// boxes of many sides and all kinds of walls: 0.06 to 0.19).
const CYCLE: f32 = 0.2;
/// After so many, 32 bits tell no difference.
const MAX_CYCLES: f32 = 12.0;
/// Explicit viscosity is stable below 1/6 of a cell's square in a sub-step.
const VISCOUS: f32 = 0.125;
/// More sub-steps are not made.
pub const MAX_SUB_STEPS: u32 = 32;

/// Bytes of what an obstacle is in a cell, and of an eddy.
const SOLID_BYTES: u64 = 8;
const EDDY_BYTES: u64 = 32;

/// The box of cells that a smoke's air is in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridPlan {
    /// Lowest corner, in metres.
    pub origin: [f32; 3],
    /// Side of a cell, in metres.
    pub side: f32,
    /// Along each axis: multiples of 8.
    pub cells: [u32; 3],
    /// In which every step is made.
    pub sub_steps: u32,
    /// Of the pressure's multigrid in every sub-step.
    pub cycles: u32,
    /// Vortex particles of all emitters.
    pub eddies: u64,
    /// Whether there is room for obstacles in every cell: only the scene tells (see [`Scene::has_obstacles`]).
    pub has_obstacles: bool,
}

impl Smoke {
    /// The grid of `solver = "grid"`, stepped by `step_secs`; nothing by other solvers.
    #[must_use]
    pub fn grid_plan(&self, step_secs: f64) -> Option<GridPlan> {
        let grid = self.grid.as_ref()?;
        let (low, high) = grid.bounds.map_or_else(|| self.reach(), corners);
        let sides = [0, 1, 2].map(|axis| f64::from(high[axis]) - f64::from(low[axis]));
        let longest = sides.into_iter().fold(0.0, f64::max);
        let mut unit = BLOCK;
        while grid.cells.div_ceil(unit) > MAX_COARSEST_CELLS {
            unit *= 2;
        }
        let most = grid.cells.next_multiple_of(unit);
        let side = longest / f64::from(most);
        // What rounding added to the longest side by way of 32 bits is no cell.
        let along = |extent: f64| ((extent / side - 1e-3).ceil().max(1.0) as u32).next_multiple_of(unit);
        let cells = sides.map(along);
        let origin = [0, 1, 2].map(|axis: usize| {
            let extra = f64::from(cells[axis]) * side - sides[axis];
            // It grows evenly to the sides, and upward.
            let below = if axis == 1 { 0.0 } else { 0.5 * extra };
            (f64::from(low[axis]) - below) as f32
        });
        let height = cells[1] as f32 * side as f32;
        let crossed = self.speed(grid, height) * step_secs as f32 / (COURANT * side as f32);
        let diffused = grid.viscosity * step_secs as f32 / (VISCOUS * (side * side) as f32);
        let sub_steps = crossed.max(diffused).ceil().clamp(1.0, MAX_SUB_STEPS as f32) as u32;
        let cycles = (grid.residual.ln() / CYCLE.ln()).ceil().clamp(1.0, MAX_CYCLES) as u32;
        let eddies = self.emitters.iter().map(|emitter| u64::from(self.eddies_of(emitter, step_secs))).sum();
        Some(GridPlan { origin, side: side as f32, cells, sub_steps, cycles, eddies, has_obstacles: false })
    }

    /// Vortex particles that an emitter brings into the grid: no more than there are particles to ride on.
    #[must_use]
    pub fn eddies_of(&self, emitter: &Emitter, step_secs: f64) -> u32 {
        let particles = u32::try_from(emitter.capacity(step_secs)).unwrap_or(u32::MAX);
        self.grid.and_then(|grid| grid.eddies).map_or(0, |eddies| eddies.count.min(particles))
    }

    /// Lowest and highest corner of where smoke is likely to go: half as far as it would fly, be blown and be lifted,
    /// and not less than a few widths of its mouth.
    fn reach(&self) -> ([f32; 3], [f32; 3]) {
        let (mut low, mut high) = ([f32::MAX; 3], [f32::MIN; 3]);
        let wind = self.winds();
        for emitter in &self.emitters {
            let (from, to) = extent(emitter.shape);
            let secs = emitter.life[1];
            let width = 2.0 * emitter.mouth().radius.max(emitter.radius[1]);
            let lift = 0.5 * self.lift().max(0.0) * secs * secs;
            let flies = [0, 1, 2].map(|axis: usize| {
                let lifted = if axis == 1 { lift.min(10.0 * width) } else { 0.0 };
                0.5 * (emitter.velocity[axis] + wind[axis]) * secs + lifted
            });
            let longest = flies.iter().fold(0.0_f32, |most, fly| most.max(fly.abs()));
            let margin = 1.5 * width + 0.25 * longest;
            for axis in 0..3 {
                low[axis] = low[axis].min(from[axis] - margin + flies[axis].min(0.0));
                high[axis] = high[axis].max(to[axis] + margin + flies[axis].max(0.0));
            }
        }
        (low, high)
    }

    fn winds(&self) -> [f32; 3] {
        let mut sum = [0.0; 3];
        for force in &self.forces {
            if let Force::Wind { velocity, .. } = force {
                sum = [0, 1, 2].map(|axis: usize| sum[axis] + velocity[axis]);
            }
        }
        sum
    }

    /// A speed that the air is unlikely to exceed, in a box of this height.
    fn speed(&self, grid: &Grid, height: f32) -> f32 {
        let emitted = |emitter: &Emitter| {
            let (from, to) = extent(emitter.shape);
            let widest = (0..3).map(|axis| to[axis] - from[axis]).fold(0.0, f32::max);
            // What appears in a ball leaves it through its surface.
            let expanding = emitter.source.expansion.abs() * 0.5 * widest / 3.0;
            size(emitter.velocity) * (1.0 + emitter.speed_jitter) + expanding
        };
        let emitted = self.emitters.iter().map(emitted).fold(0.0, f32::max);
        // What falls freely over half of the box.
        let falling = |acceleration: f32| (acceleration.abs() * height).sqrt();
        let moved = |force: &Force| match *force {
            Force::Gravity { acceleration } => falling(size(acceleration)),
            Force::Buoyancy { acceleration, .. } => falling(acceleration),
            Force::Attract { acceleration, radius, .. } => (2.0 * acceleration.abs() * radius).sqrt(),
            Force::Wind { velocity, gust, .. } => size(velocity) * (1.0 + gust),
            Force::Turbulence { speed, .. } => 2.0 * speed.abs(),
            Force::Vortex { speed, .. } => speed.abs(),
            Force::Drag { .. } => 0.0,
        };
        let turned = grid.eddies.map_or(0.0, |eddies| (2.0 * eddies.strength * eddies.radius).sqrt());
        emitted + turned + self.forces.iter().map(moved).sum::<f32>()
    }
}

impl Scene {
    /// Whether air has to go round any object.
    #[must_use]
    pub fn has_obstacles(&self) -> bool {
        self.objects.iter().any(|object| matches!(&object.matter, Matter::Mesh(mesh) if mesh.obstacle))
    }
}

impl GridPlan {
    /// Of them all.
    #[must_use]
    pub fn cell_count(&self) -> u64 {
        self.cells.into_iter().map(u64::from).product()
    }

    /// Of the lists of one component of the velocity.
    #[must_use]
    pub fn face_count(&self) -> u64 {
        self.cells.into_iter().map(|cells| u64::from(cells) + 1).product()
    }

    /// Of all levels of the pressure.
    #[must_use]
    pub fn level_cells(&self) -> u64 {
        self.levels().map(|cells| cells.into_iter().map(u64::from).product::<u64>()).sum()
    }

    /// Cells along each axis of every level of the pressure, finest first.
    pub fn levels(&self) -> impl Iterator<Item = [u32; 3]> + use<> {
        std::iter::successors(Some(self.cells), |cells| {
            let even = cells.iter().all(|count| count % 2 == 0);
            (even && cells.iter().any(|&count| count > 4)).then(|| cells.map(|count| count / 2))
        })
    }

    /// Whether there are no more cells than a list may hold.
    #[must_use]
    pub fn fits(&self) -> bool {
        self.cell_count() <= MAX_GRID_CELLS
    }

    /// On the GPU.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        // Velocity now and after the step; heat with smoke likewise; what was corrected, pushes and vorticity; what
        // pressure is and has to be; blocks; obstacles; eddies.
        let (cells, faces) = (self.cell_count(), self.face_count());
        let air = 6 * 4 * faces + 2 * 8 * cells + 3 * 8 * cells + 2 * 4 * self.level_cells() + cells / 64;
        air + if self.has_obstacles { SOLID_BYTES * cells } else { 0 } + EDDY_BYTES * self.eddies
    }
}

fn corners([center, size]: [[f32; 3]; 2]) -> ([f32; 3], [f32; 3]) {
    let corner = |sign: f32| [0, 1, 2].map(|axis: usize| center[axis] + sign * 0.5 * size[axis]);
    (corner(-1.0), corner(1.0))
}

/// Lowest and highest corner of an emitter's shape.
pub(crate) fn extent(shape: EmitterShape) -> ([f32; 3], [f32; 3]) {
    match shape {
        EmitterShape::Point { center } => (center, center),
        EmitterShape::Disc { center, radius, .. } | EmitterShape::Sphere { center, radius } => {
            corners([center, [2.0 * radius; 3]])
        }
        EmitterShape::Box { center, size } => corners([center, size]),
        EmitterShape::Line { from, to } => {
            let end = |pick: fn(f32, f32) -> f32| [0, 1, 2].map(|axis: usize| pick(from[axis], to[axis]));
            (end(f32::min), end(f32::max))
        }
    }
}

fn size([x, y, z]: [f32; 3]) -> f32 {
    (x * x + y * y + z * z).sqrt()
}
