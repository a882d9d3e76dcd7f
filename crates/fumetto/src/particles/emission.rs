//! One emitter's particles on the GPU.

use fumetto_scene::{Emitter, EmitterShape, Force};
use glam::{Vec3, Vec4};

use super::{births::births_between, forces::force_at};
use crate::gpu::{Frame, Gpu, Slot, kernels, shader, workgroups};

/// Bytes of a `Particle` of `state.wgsl`.
const PARTICLE_BYTES: u64 = 48;

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Particles {
    step: wgpu::ComputePipeline,
}

/// One emitter and its particles.
#[derive(Debug)]
pub(crate) struct Emission {
    emitter: Emitter,
    forces: Vec<Force>,
    seed: u32,
    capacity: u32,
    particles: wgpu::Buffer,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct StepUniform {
    time: f32,
    dt: f32,
    seed: u32,
    capacity: u32,
    first_birth: u32,
    births: u32,
    burst: u32,
    forces: u32,
    reborn: u32,
    stagger: f32,
    from: f32,
    until: f32,
    shape: u32,
    spread_cos: f32,
    speed_jitter: f32,
    shape_radius: f32,
    center: Vec4,
    extent: Vec4,
    velocity: Vec4,
    life: [f32; 2],
    radius: [f32; 2],
    mass: [f32; 2],
    pad: [f32; 2],
}

impl Particles {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write];
        let [step] = kernels(gpu, shader!("particles/step"), &slots, ["main"]);
        Self { step }
    }

    /// Advances by the step from `step · dt` to `(step + 1) · dt`.
    pub(crate) fn step(&self, frame: &mut Frame<'_>, emission: &Emission, step: u64, dt: f64) {
        let time = step as f64 * dt;
        let forces: Vec<_> = (0..)
            .zip(&emission.forces)
            .map(|(index, force)| force_at(force, index, emission.seed, time as f32))
            .collect();
        let uniform = frame.uniform("particles.step.uniform", &emission.step_uniform(time, dt));
        let forces = frame.storage("particles.step.forces", &forces);
        frame.compute(
            "particles.step",
            &self.step,
            &[
                uniform.as_entire_binding(),
                forces.as_entire_binding(),
                emission.particles.as_entire_binding(),
            ],
            workgroups(emission.capacity),
        );
    }
}

impl Emission {
    pub(crate) fn new(gpu: &Gpu, emitter: &Emitter, forces: &[Force], seed: u32, step_secs: f64) -> Self {
        let capacity = u32::try_from(emitter.capacity(step_secs)).unwrap_or(u32::MAX);
        let particles = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("particles.state"),
            size: u64::from(capacity.max(1)) * PARTICLE_BYTES,
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        Self { emitter: emitter.clone(), forces: forces.to_vec(), seed, capacity, particles }
    }

    /// What emits.
    pub(crate) fn emitter(&self) -> &Emitter {
        &self.emitter
    }

    /// Particles that there is room for.
    pub(crate) fn capacity(&self) -> u32 {
        self.capacity
    }

    /// `Particle`s of `state.wgsl`, dead ones among them.
    pub(crate) fn particles(&self) -> &wgpu::Buffer {
        &self.particles
    }

    /// Back to before the first birth.
    pub(crate) fn reset(&self, frame: &mut Frame<'_>) {
        frame.encoder.clear_buffer(&self.particles, 0, None);
    }

    fn step_uniform(&self, time: f64, dt: f64) -> StepUniform {
        let emitter = &self.emitter;
        let births = births_between(emitter, time, time + dt);
        let (shape, center, extent, shape_radius) = shape_uniform(emitter.shape);
        StepUniform {
            time: time as f32,
            dt: dt as f32,
            seed: self.seed,
            capacity: self.capacity,
            // Only the place in the ring and the random numbers come of it: both may wrap.
            first_birth: births.first as u32,
            births: births.count as u32,
            burst: births.burst as u32,
            forces: self.forces.len() as u32,
            reborn: u32::from(emitter.count.is_some()),
            stagger: emitter.life[1],
            from: emitter.active[0],
            until: emitter.active[1],
            shape,
            spread_cos: emitter.spread_deg.to_radians().cos(),
            speed_jitter: emitter.speed_jitter,
            shape_radius,
            center: center.extend(0.0),
            extent: extent.extend(0.0),
            velocity: Vec3::from(emitter.velocity).extend(0.0),
            life: emitter.life,
            radius: emitter.radius,
            mass: emitter.mass,
            pad: [0.0; 2],
        }
    }
}

/// Kind, centre, extent and radius as `step.wgsl` takes them.
fn shape_uniform(shape: EmitterShape) -> (u32, Vec3, Vec3, f32) {
    match shape {
        EmitterShape::Point { center } => (0, center.into(), Vec3::ZERO, 0.0),
        EmitterShape::Disc { center, normal, radius } => {
            (1, center.into(), Vec3::from(normal).normalize_or(Vec3::Y), radius)
        }
        EmitterShape::Sphere { center, radius } => (2, center.into(), Vec3::ZERO, radius),
        EmitterShape::Box { center, size } => (3, center.into(), size.into(), 0.0),
        EmitterShape::Line { from, to } => (4, from.into(), Vec3::from(to) - Vec3::from(from), 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: StepUniform, "Step" of "particles/step" { time, dt, seed, capacity, first_birth, births, burst, forces, reborn, stagger, from as begin, until, shape, spread_cos, speed_jitter, shape_radius, center, extent, velocity, life, radius, mass });
}
