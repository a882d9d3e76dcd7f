//! Particles become puffs: what is drawn of them at their age.

use bytemuck::{Pod, Zeroable};
use fumetto_scene::{Emitter, Particle};

use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups},
    particles::Emission,
};

/// Intervals of a curve's table. Also in `present.wgsl`.
const CURVE_INTERVALS: usize = 32;

/// `Puff` of `puff.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub(crate) struct Puff {
    pub(crate) center: [f32; 3],
    pub(crate) radius: f32,
    pub(crate) look: u32,
    pub(crate) fade: u32,
    pub(crate) mass: f32,
    pub(crate) pad: f32,
}

/// Where puffs go, and what they look like.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placement {
    /// The first of them in the list of all.
    pub(crate) first: u32,
    /// Number of their object.
    pub(crate) object: u32,
    /// The atlas's tiles that they choose from.
    pub(crate) first_variant: u32,
    pub(crate) variants: u32,
    /// The puff's radius over the particle's.
    pub(crate) size: f32,
    pub(crate) seed: u32,
}

/// The long-lived kernel.
#[derive(Debug)]
pub(crate) struct Present {
    pipeline: ComputePipeline,
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct PresentUniform {
    capacity: u32,
    first: u32,
    object: u32,
    first_variant: u32,
    variants: u32,
    size: f32,
    seed: u32,
    pad: u32,
    curves: [[f32; 4]; CURVE_INTERVALS + 1],
}

impl Present {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write];
        let [pipeline] = kernels(gpu, shader!("shapes/puffs/present"), &slots, ["main"]);
        Self { pipeline }
    }

    /// Writes an emission's puffs to their place in `puffs`.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        emission: &Emission,
        placement: Placement,
        puffs: &wgpu::Buffer,
    ) {
        let uniform = present_uniform(emission.emitter(), emission.capacity(), placement);
        let uniform = frame.uniform("shapes.puffs.present.uniform", &uniform);
        frame.compute(
            "shapes.puffs.present",
            &self.pipeline,
            &[
                uniform.as_entire_binding(),
                emission.particles().as_entire_binding(),
                puffs.as_entire_binding(),
            ],
            workgroups(emission.capacity()),
        );
    }
}

/// The puffs of particles that stand still.
pub(crate) fn still_puffs(particles: &[Particle], placement: Placement) -> Vec<Puff> {
    (0..)
        .zip(particles)
        .map(|(index, particle)| Puff {
            center: particle.center,
            radius: particle.radius * placement.size,
            look: look(index, placement),
            fade: 0xffff_0000,
            mass: particle.mass,
            pad: 0.0,
        })
        .collect()
}

/// As `puff_look` of `puff.wgsl`.
fn look(birth: u32, placement: Placement) -> u32 {
    let key = pcg(birth.wrapping_add(pcg(placement.seed)));
    let variant = placement.first_variant + key % placement.variants;
    variant | (placement.object << 8) | (pcg(key) & 0xffff_0000)
}

/// As `pcg` of `random.wgsl`.
fn pcg(input: u32) -> u32 {
    let state = input.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

fn present_uniform(emitter: &Emitter, capacity: u32, placement: Placement) -> PresentUniform {
    let mut curves = [[0.0; 4]; CURVE_INTERVALS + 1];
    for (index, sample) in curves.iter_mut().enumerate() {
        let age = index as f32 / CURVE_INTERVALS as f32;
        *sample = [
            emitter.radius_over_life.at(age),
            emitter.mass_over_life.at(age),
            emitter.erosion_over_life.at(age),
            emitter.opacity_over_life.at(age),
        ];
    }
    PresentUniform {
        capacity,
        first: placement.first,
        object: placement.object,
        first_variant: placement.first_variant,
        variants: placement.variants,
        size: placement.size,
        seed: placement.seed,
        pad: 0,
        curves,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(puffs_lie_as_their_twin: Puff, "Puff" of "shapes/puffs/present" { center, radius, look, fade, mass });

    layout_test!(the_uniform_lies_as_its_twin: PresentUniform, "Present" of "shapes/puffs/present" { capacity, first, object, first_variant, variants, size, seed, curves });
}
