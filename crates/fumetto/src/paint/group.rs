//! Volumes that move by one law: those of one layer of a paint.

use bytemuck::{Pod, Zeroable};
use fumetto_scene::{Paint, Spread};

use super::{coat::Coat, orders::Source};
use crate::gpu::Frame;

/// `Group` of `spread.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct GroupUniform {
    pub(super) volumes: u32,
    pub(super) vertices: u32,
    pub(super) first_body: u32,
    pub(super) first_vertex: u32,
    pub(super) first_direction: u32,
    substeps: u32,
    dt: f32,
    stiffness: f32,
    gravity: [f32; 3],
    elasticity: f32,
    damping: f32,
    grain: f32,
    grain_frequency: f32,
    seed: u32,
    keep_low: [f32; 3],
    downhill: f32,
    keep_high: [f32; 3],
    pad_end: u32,
}

/// Volumes of one layer of a paint.
#[derive(Debug)]
pub(super) struct Group {
    pub(super) uniform: GroupUniform,
    /// Over which length its volumes run into each other.
    pub(super) blend_m: f32,
    kind: Kind,
}

/// Where its volumes come from.
#[derive(Debug)]
enum Kind {
    /// From drops and strokes, whose radii are multiplied.
    Listed(Vec<Source>, f32),
    /// From cells or particles, which say themselves what their volumes are to do.
    Ordered(wgpu::Buffer),
}

/// Volumes that are told what to do on the device.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ordered<'a> {
    pub(super) count: u32,
    /// `Order`s of `order.wgsl`.
    pub(super) orders: &'a wgpu::Buffer,
    /// Over which length they run into each other.
    pub(super) blend_m: f32,
}

/// Where a group's volumes begin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Firsts {
    pub(super) body: u32,
    pub(super) vertex: u32,
    pub(super) direction: u32,
}

impl Group {
    /// The `layer`-th wash of a paint's drops and strokes; steps take `step_secs`.
    pub(super) fn listed(
        paint: &Paint,
        coat: &Coat,
        layer: u32,
        firsts: Firsts,
        (seed, step_secs): (u32, f64),
    ) -> Self {
        let sources = Source::of(paint);
        let uniform = uniform(paint, coat, sources.len() as u32, firsts, (seed_of(seed, layer), step_secs));
        Self { uniform, blend_m: 0.0, kind: Kind::Listed(sources, paint.wash_scale(layer)) }
    }

    /// The `layer`-th wash of what says itself what its volumes are to do.
    pub(super) fn ordered(
        paint: &Paint,
        coat: &Coat,
        (ordered, layer): (Ordered<'_>, u32),
        firsts: Firsts,
        (seed, step_secs): (u32, f64),
    ) -> Self {
        let uniform = uniform(paint, coat, ordered.count, firsts, (seed_of(seed, layer), step_secs));
        Self { uniform, blend_m: ordered.blend_m, kind: Kind::Ordered(ordered.orders.clone()) }
    }

    /// What its volumes do between two moments: `Order`s of `order.wgsl`.
    pub(super) fn orders(&self, frame: &Frame<'_>, secs: [f64; 2]) -> wgpu::Buffer {
        match &self.kind {
            Kind::Listed(sources, scale) => {
                let orders: Vec<_> = sources.iter().map(|source| source.order(secs, *scale)).collect();
                frame.storage("paint.orders", &orders)
            }
            Kind::Ordered(orders) => orders.clone(),
        }
    }

    /// Vertices of all its volumes.
    pub(super) fn vertices(&self) -> u32 {
        self.uniform.volumes * self.uniform.vertices
    }
}

/// Three octaves of noise have three seeds, one after the other.
fn seed_of(seed: u32, layer: u32) -> u32 {
    seed.wrapping_add(layer.wrapping_mul(0x9e37_79b9))
}

fn uniform(
    paint: &Paint,
    coat: &Coat,
    volumes: u32,
    firsts: Firsts,
    (seed, step_secs): (u32, f64),
) -> GroupUniform {
    let Spread { stiffness, elasticity, gravity, downhill, grain, grain_m, .. } = paint.spread;
    let substeps = paint.spread.substeps(step_secs);
    GroupUniform {
        volumes,
        vertices: paint.spread.vertices(),
        first_body: firsts.body,
        first_vertex: firsts.vertex,
        first_direction: firsts.direction,
        substeps,
        dt: (step_secs / f64::from(substeps)) as f32,
        stiffness,
        gravity,
        elasticity,
        damping: paint.spread.damping_per_s(),
        grain,
        grain_frequency: 1.0 / grain_m,
        seed,
        keep_low: coat.keep_low,
        downhill,
        keep_high: coat.keep_high,
        pad_end: 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: GroupUniform, "Group" of "paint/spread" { volumes, vertices, first_body, first_vertex, first_direction, substeps, dt, stiffness, gravity, elasticity, damping, grain, grain_frequency, seed, keep_low, downhill, keep_high });
}
