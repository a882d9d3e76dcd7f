//! Obstacles in the air of one object, on the GPU.

use glam::Vec3;
use half::f16;

use super::{Moment, voxels::Voxels};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader};

/// Nothing moves faster, in m/s: half floats end at 65504.
const FASTEST: f32 = 6e4;

/// The long-lived kernel.
#[derive(Debug)]
pub(super) struct Hold {
    main: ComputePipeline,
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

    /// Puts obstacles to where they are from what is next submitted on.
    pub(crate) fn set(&self, gpu: &Gpu, voxels: &Voxels) {
        let cells = voxels.velocities.iter().zip(&voxels.distances);
        let packed: Vec<[u32; 2]> = cells.map(|(&velocity, &distance)| packed(velocity, distance)).collect();
        gpu.queue.write_buffer(&self.cells, 0, bytemuck::cast_slice(&packed));
    }
}

/// A cell as `solid.wgsl` reads it. What moves at no speed that there is stands still.
fn packed(velocity: Vec3, distance: f32) -> [u32; 2] {
    let [x, y, z] =
        velocity.to_array().map(|speed| if speed.is_finite() { speed.clamp(-FASTEST, FASTEST) } else { 0.0 });
    let pack =
        |a: f32, b: f32| u32::from(f16::from_f32(a).to_bits()) | u32::from(f16::from_f32(b).to_bits()) << 16;
    [pack(x, y), pack(z, distance)]
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_speed_is_too_much_for_half_floats() {
        let speeds = |velocity| {
            let [xy, z] = packed(velocity, 1.0);
            [xy, xy >> 16, z].map(|bits| f16::from_bits(bits as u16).to_f32())
        };
        assert_eq!(speeds(Vec3::new(0.5, -2.0, 3.0)), [0.5, -2.0, 3.0]);
        assert_eq!(speeds(Vec3::new(1e9, f32::NAN, f32::NEG_INFINITY)), [6e4, 0.0, 0.0]);
    }
}
