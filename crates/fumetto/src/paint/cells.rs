//! Paint that is poured: cells of a grid over the ground, which spill into each other when full.

use bytemuck::{Pod, Zeroable};
use fumetto_scene::{Cells, Paint, Pour};
use wgpu::util::DeviceExt as _;

use super::{
    floor::{NOTHING, corner, floors},
    group::Ordered,
    orders::Order,
};
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader},
    shapes::mesh::Geometry,
};

/// Bytes of a `Cell` of `cells.wgsl`, and of what it gives to its neighbours.
const CELL_BYTES: u64 = 16;
const FLOW_BYTES: u64 = 16;

/// Invocations of a workgroup of all kernels.
const LANES: u32 = 64;

/// The largest share of what it has too much that a cell gives to each of four neighbours in a round: more, and paint
/// would slosh.
const LARGEST_SHARE: f64 = 0.2;

/// Most rounds in a step: paint that is faster runs as fast as these let it.
const MOST_ROUNDS: u32 = 64;

/// How far a volume may stand from its cell's middle, as a share of the side.
const JITTER: f32 = 0.2;

/// Over how much of a cell's side its volume runs into its neighbours', so that all together are one pool.
const BLEND: f32 = 0.3;

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Pouring {
    give: ComputePipeline,
    take: ComputePipeline,
    order: ComputePipeline,
    settle: ComputePipeline,
}

/// The grid of one paint on the device.
#[derive(Debug)]
pub(super) struct Grid {
    cells: Cells,
    pours: Vec<Pour>,
    seed: u32,
    /// `Floor`s of `cells.wgsl`.
    floors: wgpu::Buffer,
    /// `Cell`s of `cells.wgsl`.
    states: wgpu::Buffer,
    flows: wgpu::Buffer,
    /// For each wash how large its volumes are, and what they are to do.
    washes: Vec<(f32, wgpu::Buffer)>,
    /// Whether there is any ground.
    pub(super) has_floor: bool,
}

/// `Grid` of `cells.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct GridUniform {
    columns: u32,
    rows: u32,
    corner: [f32; 2],
    cell: f32,
    share: f32,
    dt: f32,
    speed: f32,
    pours: u32,
    seed: u32,
    scale: f32,
    jitter: f32,
}

/// `Pour` of `cells.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
struct PourEntry {
    cell: u32,
    depth: f32,
}

impl Grid {
    /// The grid of `paint`, if it has one, over the models as they stand at the beginning.
    pub(super) fn new(gpu: &Gpu, paint: &Paint, geometry: &Geometry, seed: u32) -> Option<Self> {
        let cells = paint.cells?;
        let floors = floors(&cells, geometry, seed);
        let count = floors.len() as u64;
        let room = |label, bytes: u64| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: count * bytes,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_DST
                    | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            })
        };
        let wash = |layer| (paint.wash_scale(layer), room("paint.orders", size_of::<Order>() as u64));
        Some(Self {
            cells,
            pours: paint.pours.clone(),
            seed,
            has_floor: floors.iter().any(|floor| floor.height > NOTHING),
            floors: gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("paint.floors"),
                contents: bytemuck::cast_slice(&floors),
                usage: wgpu::BufferUsages::STORAGE,
            }),
            states: room("paint.cells", CELL_BYTES),
            flows: room("paint.flows", FLOW_BYTES),
            washes: (0..paint.layers()).map(wash).collect(),
        })
    }

    /// How many cells there are.
    fn count(&self) -> u32 {
        self.cells.count().iter().product()
    }

    /// The volumes of a wash.
    pub(super) fn ordered(&self, layer: u32) -> Ordered<'_> {
        let orders = &self.washes[layer as usize].1;
        Ordered { count: self.count(), orders, blend_m: BLEND * self.cells.cell_m }
    }

    /// How much paint each cell has: `Cell`s of `cells.wgsl`.
    pub(super) fn states(&self) -> &wgpu::Buffer {
        &self.states
    }

    /// Back to before anything was poured.
    pub(super) fn reset(&self, frame: &mut Frame<'_>) {
        frame.encoder.clear_buffer(&self.states, 0, None);
    }

    /// Rounds of a step, and how long each takes.
    fn rounds(&self, dt: f64) -> (u32, f64) {
        let cells_a_step = dt * f64::from(self.cells.speed_m_per_s) / f64::from(self.cells.cell_m);
        let rounds = ((cells_a_step / LARGEST_SHARE).ceil().max(1.0) as u32).min(MOST_ROUNDS);
        (rounds, dt / f64::from(rounds))
    }

    /// What is poured in each round of a step.
    fn entries(&self, [since, until]: [f64; 2], rounds: u32) -> Vec<PourEntry> {
        let [columns, rows] = self.cells.count();
        let first = corner(&self.cells);
        let area = f64::from(self.cells.cell_m).powi(2);
        let entry = |pour: &Pour| {
            let [from, to] = pour.during_secs.map(f64::from);
            let secs = until.min(to) - since.max(from);
            let column = ((pour.at[0] - first.x) / self.cells.cell_m).floor();
            let row = ((pour.at[2] - first.y) / self.cells.cell_m).floor();
            let is_beside = column < 0.0 || row < 0.0 || column >= columns as f32 || row >= rows as f32;
            (secs > 0.0 && !is_beside).then(|| PourEntry {
                cell: row as u32 * columns + column as u32,
                depth: (f64::from(pour.rate_m3_per_s) * secs / area / f64::from(rounds)) as f32,
            })
        };
        self.pours.iter().filter_map(entry).collect()
    }

    fn uniform(&self, (rounds, dt): (u32, f64), pours: usize, scale: f32) -> GridUniform {
        let [columns, rows] = self.cells.count();
        let share = f64::from(self.cells.speed_m_per_s) * dt / f64::from(self.cells.cell_m);
        debug_assert!(rounds == MOST_ROUNDS || share <= LARGEST_SHARE * 1.000_001);
        GridUniform {
            columns,
            rows,
            corner: corner(&self.cells).into(),
            cell: self.cells.cell_m,
            share: share.min(LARGEST_SHARE) as f32,
            dt: dt as f32,
            speed: self.cells.speed_m_per_s,
            pours: pours as u32,
            seed: self.seed,
            scale,
            jitter: JITTER * self.cells.cell_m,
        }
    }
}

impl Pouring {
    pub(super) fn new(gpu: &Gpu) -> Self {
        use Slot::{Read, Uniform, Write};
        let slots = [Uniform, Read, Read, Write, Write, Write];
        let entries = ["give", "take", "order", "settle"];
        let [give, take, order, settle] = kernels(gpu, shader!("paint/cells"), &slots, entries);
        Self { give, take, order, settle }
    }

    /// Advances by the step between two moments, and says what the cells' volumes are to do in it.
    pub(super) fn step(&self, frame: &mut Frame<'_>, grid: &Grid, secs: [f64; 2]) {
        let (rounds, dt) = grid.rounds(secs[1] - secs[0]);
        let entries = grid.entries(secs, rounds);
        let pours = frame.storage("paint.pours", &entries);
        let groups = [grid.count().div_ceil(LANES), 1, 1];
        let mut run = |pipeline: &wgpu::ComputePipeline, (scale, orders): &(f32, wgpu::Buffer)| {
            let uniform = frame.uniform("paint.grid", &grid.uniform((rounds, dt), entries.len(), *scale));
            let buffers = [&uniform, &grid.floors, &pours, &grid.states, &grid.flows, orders];
            frame.compute("paint.cells", pipeline, &buffers.map(wgpu::Buffer::as_entire_binding), groups);
        };
        for _ in 0..rounds {
            run(&self.give, &grid.washes[0]);
            run(&self.take, &grid.washes[0]);
        }
        for wash in &grid.washes {
            run(&self.order, wash);
        }
        run(&self.settle, &grid.washes[0]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: GridUniform, "Grid" of "paint/cells" { columns, rows, corner, cell, share, dt, speed, pours, seed, scale, jitter });
}
