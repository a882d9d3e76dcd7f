//! The air of one object, on the GPU.

use fumetto_scene::{Force, Grid, GridPlan, Smoke};
use glam::{UVec3, Vec3};

use super::{
    Moment,
    eddies::Riders,
    pressure::Levels,
    solids::Solids,
    sources::{SourceUniform, sources_at},
};
use crate::{
    gpu::{Frame, Gpu},
    particles::{
        forces::{forces_at, wind_at},
        vortex::Span,
    },
};

/// Air in a box of cells.
#[derive(Debug)]
pub(crate) struct Air {
    pub(super) grid: Grid,
    pub(crate) plan: GridPlan,
    smoke: Smoke,
    /// Of both moments, each component on the faces across its axis.
    pub(super) velocity: [[wgpu::Buffer; 3]; 2],
    /// Likewise heat and smoke, two numbers a cell.
    pub(super) heat: [wgpu::Buffer; 2],
    /// What was corrected, before it takes its place.
    pub(super) fixed: wgpu::Buffer,
    pub(super) push: wgpu::Buffer,
    /// Vorticity.
    pub(super) spin: wgpu::Buffer,
    /// Which blocks hold smoke, and the list of those that are busy.
    pub(super) smoky: wgpu::Buffer,
    pub(super) busy: wgpu::Buffer,
    pub(super) levels: Levels,
    pub(super) riders: Option<Riders>,
    pub(crate) solids: Solids,
}

/// `Grid` of `grid.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct GridUniform {
    origin: Vec3,
    side: f32,
    cells: UVec3,
    open: u32,
    outside: Vec3,
    dt: f32,
    gust: Vec3,
    pub(super) begins: u32,
    fade: [f32; 2],
    sources: u32,
    forces: u32,
    lift: f32,
    pub(super) confinement: f32,
    viscosity: f32,
    solids: u32,
}

impl Air {
    /// The air of `smoke`, if a grid carries it.
    pub(crate) fn new(gpu: &Gpu, smoke: &Smoke, step_secs: f64, has_obstacles: bool) -> Option<Self> {
        let (grid, plan) = (smoke.grid?, smoke.grid_plan(step_secs)?);
        let buffer = |label, bytes: u64, more| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: bytes,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_DST
                    | wgpu::BufferUsages::COPY_SRC
                    | more,
                mapped_at_creation: false,
            })
        };
        let none = wgpu::BufferUsages::empty();
        let (cells, faces) = (plan.cell_count(), plan.face_count());
        let blocks = cells / 512;
        let velocity = || [(); 3].map(|()| buffer("particles.grid.velocity", 4 * faces, none));
        let heat = || buffer("particles.grid.heat", 8 * cells, none);
        Some(Self {
            grid,
            plan,
            smoke: smoke.clone(),
            velocity: [velocity(), velocity()],
            heat: [heat(), heat()],
            fixed: buffer("particles.grid.fixed", (4 * faces).max(8 * cells), none),
            push: buffer("particles.grid.push", 8 * cells, none),
            spin: buffer("particles.grid.spin", 8 * cells, none),
            smoky: buffer("particles.grid.smoky", 4 * blocks, none),
            busy: buffer("particles.grid.busy", 4 * (4 + blocks), wgpu::BufferUsages::INDIRECT),
            levels: Levels::new(gpu, &plan, open_bits(&grid)),
            solids: Solids::new(gpu, cells, has_obstacles),
            riders: grid.eddies.map(|eddies| Riders::new(gpu, smoke, eddies, step_secs)),
        })
    }

    /// A place, in cells from the lowest corner.
    pub(crate) fn in_cells(&self, place: [f32; 3]) -> Vec3 {
        (Vec3::from(place) - Vec3::from(self.plan.origin)) / self.plan.side
    }

    /// Back to before the first step. Velocity needs nothing: the first step begins with that outside.
    pub(crate) fn reset(&self, frame: &mut Frame<'_>) {
        for buffer in [&self.heat[0], &self.smoky, &self.levels.pressure] {
            frame.encoder.clear_buffer(buffer, 0, None);
        }
        if let Some(riders) = &self.riders {
            frame.encoder.clear_buffer(&riders.list, 0, None);
        }
    }

    /// What the next step needs.
    pub(crate) fn state(&self) -> impl Iterator<Item = &wgpu::Buffer> {
        let fields = self.velocity.as_flattened().iter().chain(&self.heat);
        let eddies = self.riders.iter().map(|riders| &riders.list);
        fields.chain([&self.smoky, &self.levels.pressure, &self.solids.cells]).chain(eddies)
    }

    /// What particles need to move in the air after so many sub-steps.
    pub(crate) fn after(&self, frame: &Frame<'_>, sub_steps: u64) -> (wgpu::Buffer, [&wgpu::Buffer; 4]) {
        let uniform = self.uniform(Span { time: 0.0, dt: 1.0 }, 1);
        let [u, v, w] = &self.velocity[(sub_steps & 1) as usize];
        (frame.uniform("particles.grid.place", &uniform), [u, v, w, &self.solids.cells])
    }

    fn uniform(&self, span: Span, number: u64) -> GridUniform {
        let Span { time, dt } = span;
        let forces = &self.smoke.forces;
        let outside = wind_at(forces, time as f32);
        let before = wind_at(forces, (time - dt) as f32);
        let (lift, cooling) = lift_and_cooling(forces);
        let left = |rate: f32| (-rate * dt as f32).exp();
        GridUniform {
            origin: self.plan.origin.into(),
            side: self.plan.side,
            cells: self.plan.cells.into(),
            open: open_bits(&self.grid),
            outside,
            dt: dt as f32,
            gust: outside - before,
            begins: u32::from(number == 0),
            fade: [left(cooling), left(self.grid.dissipation)],
            sources: 0,
            forces: 0,
            lift,
            confinement: self.grid.confinement,
            viscosity: self.grid.viscosity,
            solids: u32::from(self.solids.are_there),
        }
    }
}

impl<'a> Moment<'a> {
    pub(super) fn new(
        frame: &Frame<'_>,
        air: &'a Air,
        (forces, seed): (&[Force], u32),
        (number, span): (u64, Span),
    ) -> Self {
        let sources: Vec<SourceUniform> = sources_at(&air.smoke.emitters, span);
        // Heat lifts in place of age.
        let others: Vec<Force> =
            forces.iter().filter(|force| !matches!(force, Force::Buoyancy { .. })).copied().collect();
        let uniform = GridUniform {
            sources: sources.len() as u32,
            forces: others.len() as u32,
            ..air.uniform(span, number)
        };
        Self {
            air,
            before: (number & 1) as usize,
            uniform,
            grid: frame.uniform("particles.grid.uniform", &uniform),
            sources: frame.storage("particles.grid.sources", &sources),
            forces: frame.storage("particles.grid.forces", &forces_at(&others, seed, span.time as f32)),
        }
    }
}

/// A bit for each open wall.
fn open_bits(grid: &Grid) -> u32 {
    grid.open.iter().flatten().zip(0..).map(|(&open, bit)| u32::from(open) << bit).sum()
}

/// What lifts the hottest air, and how fast it cools: the mean of all that lifts it.
fn lift_and_cooling(forces: &[Force]) -> (f32, f32) {
    let mut sums = [0.0_f32; 3];
    for force in forces {
        if let Force::Buoyancy { acceleration, cooling } = *force {
            sums[0] += acceleration;
            sums[1] += acceleration.abs();
            sums[2] += acceleration.abs() * cooling;
        }
    }
    let [lift, amount, cooled] = sums;
    (lift, if amount > 0.0 { cooled / amount } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: GridUniform, "Grid" of "particles/grid/push" { origin, side, cells, open, outside, dt, gust, begins, fade, sources, forces, lift, confinement, viscosity, solids });

    #[test]
    fn the_stronger_lift_says_how_fast_air_cools() {
        let lift = |acceleration, cooling| Force::Buoyancy { acceleration, cooling };
        assert_eq!(lift_and_cooling(&[lift(3.0, 1.0), lift(-1.0, 0.2)]), (2.0, 0.8));
        assert_eq!(lift_and_cooling(&[Force::Drag { rate: 1.0 }]), (0.0, 0.0));
    }
}
