//! Paint that particles leave on what they touch: for each particle a volume where it does.

use bytemuck::{Pod, Zeroable};
use fumetto_scene::{Curve, Paint, Stain, StainRoom};

use super::{ground::Ground, group::Ordered, orders::Order};
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups},
    particles::Emission,
};

/// Bytes of a `Stain` of `touch.wgsl`.
const STAIN_BYTES: u64 = 48;

/// Samples of a radius over life. Also in `touch.wgsl`.
const RADII: usize = 32;

/// A stain begins with this share of its radius.
const FIRST: f32 = 0.1;

/// Over what share of the largest particle's radius stains run into each other.
const BLEND: f32 = 0.15;

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Touching {
    touch: ComputePipeline,
    order: ComputePipeline,
}

/// What the particles of one emitter leave, on the device.
#[derive(Debug)]
pub(super) struct Stains {
    uniform: TouchingUniform,
    room: StainRoom,
    /// Over which length they run into each other.
    blend_m: f32,
    particles: wgpu::Buffer,
    /// `Stain`s of `touch.wgsl`.
    stains: wgpu::Buffer,
    /// For each wash how large its volumes are, and what they are to do.
    washes: Vec<(f32, wgpu::Buffer)>,
}

/// `Touching` of `touch.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct TouchingUniform {
    capacity: u32,
    every: u32,
    particles: u32,
    rounds: u32,
    step: u32,
    dt: f32,
    ends: u32,
    size: f32,
    first: f32,
    scale: f32,
    pad: [u32; 2],
    radii: [f32; RADII],
}

impl Stains {
    /// What the particles of `emissions` leave of `paint`, emitter by emitter.
    pub(super) fn of(gpu: &Gpu, paint: &Paint, stain: &Stain, emissions: &[Emission]) -> Vec<Self> {
        let rooms = stain.rooms.iter().zip(emissions);
        rooms.map(|(room, emission)| Self::new(gpu, paint, stain, *room, emission)).collect()
    }

    fn new(gpu: &Gpu, paint: &Paint, stain: &Stain, room: StainRoom, emission: &Emission) -> Self {
        let buffer = |label, bytes: u64| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: room.volumes() * bytes,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_DST
                    | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            })
        };
        let wash = |layer| (paint.wash_scale(layer), buffer("paint.orders", size_of::<Order>() as u64));
        Self {
            uniform: TouchingUniform {
                capacity: emission.capacity(),
                every: stain.every,
                particles: room.particles,
                rounds: room.rounds,
                step: 0,
                dt: 0.0,
                ends: stain.ends.into(),
                size: stain.size,
                first: FIRST,
                scale: 1.0,
                pad: [0; 2],
                radii: radii(&emission.emitter().radius_over_life),
            },
            room,
            blend_m: BLEND * stain.size * emission.emitter().largest_radius(),
            particles: emission.particles().clone(),
            stains: buffer("paint.stains", STAIN_BYTES),
            washes: (0..paint.layers()).map(wash).collect(),
        }
    }

    fn count(&self) -> u32 {
        self.room.volumes() as u32
    }

    /// The volumes of a wash.
    pub(super) fn ordered(&self, layer: u32) -> Ordered<'_> {
        Ordered { count: self.count(), orders: &self.washes[layer as usize].1, blend_m: self.blend_m }
    }

    /// What has been touched so far: `Stain`s of `touch.wgsl`.
    pub(super) fn states(&self) -> &wgpu::Buffer {
        &self.stains
    }

    /// Back to before anything was touched.
    pub(super) fn reset(&self, frame: &mut Frame<'_>) {
        frame.encoder.clear_buffer(&self.stains, 0, None);
    }
}

impl Touching {
    pub(super) fn new(gpu: &Gpu) -> Self {
        use Slot::{Read, Uniform, Write};
        let slots = [Uniform, Uniform, Read, Read, Write, Write, Write];
        let [touch, order] = kernels(gpu, shader!("paint/touch"), &slots, ["touch", "order"]);
        Self { touch, order }
    }

    /// Finds what the particles touch after a step, and says what their stains' volumes are to do in it.
    pub(super) fn step(
        &self,
        frame: &mut Frame<'_>,
        stains: &Stains,
        ground: &Ground,
        (step, dt): (u64, f64),
    ) {
        let place = frame.uniform("paint.ground", &ground.uniform);
        for (layer, (scale, orders)) in stains.washes.iter().enumerate() {
            // Steps are only told apart from the one before; they may wrap.
            let step = (step as u32).wrapping_add(1);
            let uniform = TouchingUniform { step, dt: dt as f32, scale: *scale, ..stains.uniform };
            let uniform = frame.uniform("paint.touching", &uniform);
            let bindings =
                [&uniform, &place, &ground.cells, &ground.corners, &stains.particles, &stains.stains, orders]
                    .map(wgpu::Buffer::as_entire_binding);
            if layer == 0 {
                let groups = workgroups(stains.room.particles);
                frame.compute("paint.touch", &self.touch, &bindings, groups);
            }
            frame.compute("paint.stains", &self.order, &bindings, workgroups(stains.count()));
        }
    }
}

fn radii(over_life: &Curve) -> [f32; RADII] {
    std::array::from_fn(|index| over_life.at(index as f32 / (RADII - 1) as f32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: TouchingUniform, "Touching" of "paint/touch" { capacity, every, particles, rounds, step, dt, ends, size, first, scale, radii });
}
