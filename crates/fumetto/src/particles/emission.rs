//! One emitter's particles on the GPU.

use fumetto_scene::{Emitter, EmitterShape, Force};
use glam::{Vec3, Vec4};

use super::{
    births::{Timetable, births_between},
    forces::forces_at,
    state::Particle,
    vortex::{Span, Tree},
};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups};

/// The long-lived kernel.
#[derive(Debug)]
pub(super) struct Motion {
    step: ComputePipeline,
    step_in_grid: ComputePipeline,
}

/// What carries particles.
#[derive(Clone, Copy, Debug)]
pub(super) enum Carrier<'a> {
    /// Their own motion, and vortices.
    Tree(&'a Tree),
    /// Air, in a box that the uniform tells of: its velocity, and what is solid.
    Air(&'a wgpu::Buffer, [&'a wgpu::Buffer; 4]),
}

/// One emitter and its particles.
#[derive(Debug)]
pub(crate) struct Emission {
    emitter: Emitter,
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
    places: u32,
    pad: u32,
}

impl Motion {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write, Slot::Read, Slot::Read];
        let [step] = kernels(gpu, shader!("particles/step"), &slots, ["main"]);
        let (uniform, read) = (Slot::Uniform, Slot::Read);
        let slots = [uniform, read, Slot::Write, uniform, read, read, read, read];
        let [step_in_grid] = kernels(gpu, shader!("particles/step_in_grid"), &slots, ["main"]);
        Self { step, step_in_grid }
    }

    /// Advances by a step.
    pub(super) fn step(
        &self,
        frame: &mut Frame<'_>,
        emission: &Emission,
        forces: &[Force],
        carrier: Carrier<'_>,
        span: Span,
    ) {
        let places = if let Carrier::Tree(tree) = carrier { tree.places } else { 0 };
        let uniform = StepUniform { places, ..emission.step_uniform(forces, span) };
        let uniform = frame.uniform("particles.step.uniform", &uniform);
        let forces = forces_at(forces, emission.seed, span.time as f32);
        let forces = frame.storage("particles.step.forces", &forces);
        let mut bindings = vec![&uniform, &forces, &emission.particles];
        let kernel = match carrier {
            Carrier::Tree(tree) => {
                bindings.extend([&tree.leaves, &tree.nodes]);
                &self.step
            }
            Carrier::Air(grid, velocity) => {
                bindings.push(grid);
                bindings.extend(velocity);
                &self.step_in_grid
            }
        };
        let bindings: Vec<_> = bindings.into_iter().map(wgpu::Buffer::as_entire_binding).collect();
        frame.compute("particles.step", kernel, &bindings, workgroups(emission.capacity));
    }
}

impl Emission {
    pub(super) fn new(gpu: &Gpu, emitter: &Emitter, seed: u32, step_secs: f64) -> Self {
        let capacity = u32::try_from(emitter.capacity(step_secs)).unwrap_or(u32::MAX);
        let particles = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("particles.state"),
            size: u64::from(capacity.max(1)) * size_of::<Particle>() as u64,
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        Self { emitter: emitter.clone(), seed, capacity, particles }
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
    pub(super) fn reset(&self, frame: &mut Frame<'_>) {
        frame.encoder.clear_buffer(&self.particles, 0, None);
    }

    fn step_uniform(&self, forces: &[Force], Span { time, dt }: Span) -> StepUniform {
        let emitter = &self.emitter;
        let births = births_between(Timetable::of(emitter), time, time + dt);
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
            forces: forces.len() as u32,
            reborn: u32::from(emitter.count.is_some()),
            stagger: emitter.life[1],
            from: emitter.active[0],
            until: emitter.active[1],
            shape,
            spread_cos: emitter.spread_deg.to_radians().cos(),
            speed_jitter: emitter.speed_jitter,
            shape_radius,
            center,
            extent,
            velocity: Vec3::from(emitter.velocity).extend(0.0),
            life: emitter.life,
            radius: emitter.radius,
            mass: emitter.mass,
            places: 0,
            pad: 0,
        }
    }
}

/// Kind, centre, extent and radius as `step.wgsl` takes them.
pub(super) fn shape_uniform(shape: EmitterShape) -> (u32, Vec4, Vec4, f32) {
    let (kind, center, extent, radius) = match shape {
        EmitterShape::Point { center } => (0, center, Vec4::ZERO, 0.0),
        EmitterShape::Disc { center, normal, radius, hole } => {
            (1, center, Vec3::from(normal).normalize_or(Vec3::Y).extend(hole), radius)
        }
        EmitterShape::Sphere { center, radius } => (2, center, Vec4::ZERO, radius),
        EmitterShape::Box { center, size } => (3, center, Vec3::from(size).extend(0.0), 0.0),
        EmitterShape::Line { from, to } => (4, from, (Vec3::from(to) - Vec3::from(from)).extend(0.0), 0.0),
    };
    (kind, Vec3::from(center).extend(0.0), extent, radius)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: StepUniform, "Step" of "particles/step" { time, dt, seed, capacity, first_birth, births, burst, forces, reborn, stagger, from as begin, until, shape, spread_cos, speed_jitter, shape_radius, center, extent, velocity, life, radius, mass, places });
}
