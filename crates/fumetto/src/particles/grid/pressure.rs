//! The pressure that takes divergence from the air, by geometric multigrid: a fixed number of V-cycles with one
//! red-black sweep down and up, beginning with the pressure of the step before (cf. `McAdams`, Sifakis & Teran 2010).

use fumetto_scene::GridPlan;
use glam::UVec3;
use wgpu::util::DeviceExt as _;

use super::Moment;
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Pressure {
    divergence: ComputePipeline,
    smooth: ComputePipeline,
    coarsen: ComputePipeline,
    refine: ComputePipeline,
    coarsest: ComputePipeline,
    project: ComputePipeline,
}

/// All levels of one object's pressure.
#[derive(Debug)]
pub(crate) struct Levels {
    /// Finest first.
    levels: Vec<Level>,
    pub(super) wanted: wgpu::Buffer,
    pub(super) pressure: wgpu::Buffer,
}

#[derive(Debug)]
struct Level {
    cells: [u32; 3],
    /// For its even cells, and for its odd ones.
    uniforms: [wgpu::Buffer; 2],
}

/// `Level` of `level.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
struct LevelUniform {
    cells: UVec3,
    first: u32,
    coarser: u32,
    open: u32,
    colour: u32,
    pad: u32,
}

const EVEN: usize = 0;
const ODD: usize = 1;

impl Levels {
    pub(super) fn new(gpu: &Gpu, plan: &GridPlan, open: u32) -> Self {
        let mut first = 0;
        let levels = plan.levels().map(|cells| {
            let coarser = first + cells.iter().product::<u32>();
            let uniforms = [0, 1].map(|colour| {
                let uniform = LevelUniform { cells: cells.into(), first, coarser, open, colour, pad: 0 };
                gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                    label: Some("particles.grid.level"),
                    contents: bytemuck::bytes_of(&uniform),
                    usage: wgpu::BufferUsages::UNIFORM,
                })
            });
            first = coarser;
            Level { cells, uniforms }
        });
        let levels = levels.collect();
        let list = |label| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: 4 * plan.level_cells(),
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_DST
                    | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            })
        };
        Self { levels, wanted: list("particles.grid.wanted"), pressure: list("particles.grid.pressure") }
    }
}

impl Pressure {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let (uniform, read, write) = (Slot::Uniform, Slot::Read, Slot::Write);
        let slots = [uniform, read, read, read, write, write];
        let [divergence] = kernels(gpu, shader!("particles/grid/divergence"), &slots, ["main"]);
        let slots = [uniform, write, write];
        let [smooth] = kernels(gpu, shader!("particles/grid/smooth"), &slots, ["main"]);
        let [coarsen] = kernels(gpu, shader!("particles/grid/coarsen"), &slots, ["main"]);
        let [refine] = kernels(gpu, shader!("particles/grid/refine"), &slots, ["main"]);
        let [coarsest] = kernels(gpu, shader!("particles/grid/coarsest"), &slots, ["main"]);
        let slots = [uniform, write, write, write, write, read];
        let [project] = kernels(gpu, shader!("particles/grid/project"), &slots, ["main"]);
        Self { divergence, smooth, coarsen, refine, coarsest, project }
    }

    /// Pushes the air, and takes its divergence from it.
    pub(super) fn record(&self, frame: &mut Frame<'_>, moment: &Moment<'_>) {
        let (air, [u, v, w]) = (moment.air, moment.velocity());
        let (cells, levels) = (air.plan.cells, &air.levels);
        let bindings = [&moment.grid, u, v, w, &air.push, &levels.wanted];
        Moment::over_all(frame, "particles.grid.divergence", &self.divergence, &bindings, cells);
        for _ in 0..air.plan.cycles {
            self.cycle(frame, levels);
        }
        let bindings = [&moment.grid, u, v, w, &air.push, &levels.pressure];
        let faces = cells.map(|count| count + 1);
        Moment::over_all(frame, "particles.grid.project", &self.project, &bindings, faces);
    }

    fn cycle(&self, frame: &mut Frame<'_>, levels: &Levels) {
        let Some((last, finer)) = levels.levels.split_last() else { return };
        for level in finer {
            self.sweep(frame, levels, level);
            let coarse = level.cells.map(|count| count / 2);
            let bindings = [&level.uniforms[EVEN], &levels.wanted, &levels.pressure];
            Moment::over_all(frame, "particles.grid.coarsen", &self.coarsen, &bindings, coarse);
        }
        let bindings = [&last.uniforms[EVEN], &levels.wanted, &levels.pressure];
        frame.compute("particles.grid.coarsest", &self.coarsest, &super::entire(&bindings), [1, 1, 1]);
        for level in finer.iter().rev() {
            let bindings = [&level.uniforms[ODD], &levels.wanted, &levels.pressure];
            Moment::over_all(frame, "particles.grid.refine", &self.refine, &bindings, pairs(level));
            self.sweep(frame, levels, level);
        }
    }

    fn sweep(&self, frame: &mut Frame<'_>, levels: &Levels, level: &Level) {
        for uniform in &level.uniforms {
            let bindings = [uniform, &levels.wanted, &levels.pressure];
            Moment::over_all(frame, "particles.grid.smooth", &self.smooth, &bindings, pairs(level));
        }
    }
}

/// Cells of one colour.
fn pairs(level: &Level) -> [u32; 3] {
    let [x, y, z] = level.cells;
    [x.div_ceil(2), y, z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: LevelUniform, "Level" of "particles/grid/smooth" { cells, first, coarser, open, colour });
}
