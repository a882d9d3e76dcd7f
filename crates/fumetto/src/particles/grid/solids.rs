//! Obstacles in the air of one object, on the GPU.

use half::f16;
use wgpu::util::DeviceExt as _;

use super::{Moment, voxels::Voxels};
use crate::gpu::{Frame, Gpu, Slot, kernels, shader};

/// The long-lived kernel.
#[derive(Debug)]
pub(super) struct Hold {
    main: wgpu::ComputePipeline,
}

/// What is solid in every cell.
#[derive(Debug)]
pub(crate) struct Solids {
    pub(super) cells: wgpu::Buffer,
    /// Whether anything is.
    pub(crate) are_there: bool,
}

impl Solids {
    /// Room for `cells`, where there are obstacles.
    pub(super) fn new(gpu: &Gpu, cells: u64, are_there: bool) -> Self {
        let cells = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("particles.grid.solids"),
            size: 8 * if are_there { cells } else { 1 },
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        Self { cells, are_there }
    }

    /// Puts obstacles to where they are from the next step on.
    pub(crate) fn set(&self, frame: &mut Frame<'_>, voxels: &Voxels) {
        let pack = |a: f32, b: f32| {
            u32::from(f16::from_f32(a).to_bits()) | u32::from(f16::from_f32(b).to_bits()) << 16
        };
        let packed: Vec<[u32; 2]> = voxels
            .velocities
            .iter()
            .zip(&voxels.distances)
            .map(|(velocity, &distance)| [pack(velocity.x, velocity.y), pack(velocity.z, distance)])
            .collect();
        let staging = frame.gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("particles.grid.solids.staging"),
            contents: bytemuck::cast_slice(&packed),
            usage: wgpu::BufferUsages::COPY_SRC,
        });
        frame.encoder.copy_buffer_to_buffer(&staging, 0, &self.cells, 0, staging.size());
    }
}

impl Hold {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Write, Slot::Write, Slot::Write, Slot::Read];
        let [main] = kernels(gpu, shader!("particles/grid/hold"), &slots, ["main"]);
        Self { main }
    }

    /// Air in obstacles moves as they do.
    pub(super) fn record(&self, frame: &mut Frame<'_>, moment: &Moment<'_>) {
        if moment.air.solids.are_there {
            let [u, v, w] = moment.velocity();
            let bindings = [&moment.grid, u, v, w, &moment.air.solids.cells];
            let faces = moment.air.plan.cells.map(|count| count + 1);
            Moment::over_all(frame, "particles.grid.hold", &self.main, &bindings, faces);
        }
    }
}
