//! Vortex particles in the grid: they ride on particles of smoke, and push the air around them.

use fumetto_scene::{Eddies, Emitter, Smoke};
use glam::Vec3;

use super::Moment;
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups},
    particles::{Emission, emission::shape_uniform},
};

/// Bytes of an `Eddy` of `eddy.wgsl`.
const EDDY_BYTES: u64 = 32;

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Stir {
    ride: ComputePipeline,
    stir: ComputePipeline,
}

/// All eddies of one object.
#[derive(Debug)]
pub(crate) struct Riders {
    pub(super) list: wgpu::Buffer,
    /// For each emitter.
    groups: Vec<EddiesUniform>,
}

/// `Eddies` of `eddy.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
struct EddiesUniform {
    first: u32,
    count: u32,
    all: u32,
    particles: u32,
    center: Vec3,
    radius: f32,
    blows: Vec3,
    strength: f32,
}

impl Riders {
    pub(super) fn new(gpu: &Gpu, smoke: &Smoke, eddies: Eddies, step_secs: f64) -> Self {
        let mut groups: Vec<EddiesUniform> = Vec::with_capacity(smoke.emitters.len());
        let mut all = 0;
        for emitter in &smoke.emitters {
            let group = group(smoke, emitter, (eddies, all), step_secs);
            all += group.count;
            groups.push(group);
        }
        for group in &mut groups {
            group.all = all;
        }
        let list = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("particles.grid.eddies"),
            size: u64::from(all.max(1)) * EDDY_BYTES,
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        Self { list, groups }
    }
}

fn group(smoke: &Smoke, emitter: &Emitter, (eddies, first): (Eddies, u32), step_secs: f64) -> EddiesUniform {
    let particles = u32::try_from(emitter.capacity(step_secs)).unwrap_or(u32::MAX);
    let (_, center, extent, _) = shape_uniform(emitter.shape);
    let along_line =
        if matches!(emitter.shape, fumetto_scene::EmitterShape::Line { .. }) { 0.5 } else { 0.0 };
    EddiesUniform {
        first,
        count: smoke.eddies_of(emitter, step_secs),
        all: 0,
        particles,
        center: center.truncate() + along_line * extent.truncate(),
        radius: eddies.radius,
        blows: emitter.mouth().axis.into(),
        strength: eddies.strength,
    }
}

impl Stir {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let (uniform, read, write) = (Slot::Uniform, Slot::Read, Slot::Write);
        let slots = [uniform, read, write, uniform, read, read, read];
        let [ride] = kernels(gpu, shader!("particles/grid/ride"), &slots, ["main"]);
        let slots = [uniform, uniform, read, write, read];
        let [stir] = kernels(gpu, shader!("particles/grid/stir"), &slots, ["main"]);
        Self { ride, stir }
    }

    /// Moves the eddies to where their particles are, and adds what they push.
    pub(super) fn record(&self, frame: &mut Frame<'_>, moment: &Moment<'_>, emissions: &[Emission]) {
        let Some(riders) = &moment.air.riders else { return };
        let [u, v, w] = moment.velocity();
        let mut eddies = None;
        for (emission, group) in emissions.iter().zip(&riders.groups).filter(|(_, group)| group.count > 0) {
            let uniform = frame.uniform("particles.grid.eddies.uniform", group);
            let bindings = [&uniform, emission.particles(), &riders.list, &moment.grid, u, v, w];
            let bindings = super::entire(&bindings);
            frame.compute("particles.grid.ride", &self.ride, &bindings, workgroups(group.count));
            eddies = Some(uniform);
        }
        if let Some(eddies) = eddies {
            let bindings = [&moment.grid, &eddies, &riders.list, &moment.air.push, &moment.air.busy];
            moment.over_busy(frame, "particles.grid.stir", &self.stir, &bindings);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: EddiesUniform, "Eddies" of "particles/grid/stir" { first, count, all, particles, center, radius, blows, strength });
}
