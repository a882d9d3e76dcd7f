//! What emitters bring into the air at one moment.

use fumetto_scene::Emitter;
use glam::{Vec3, Vec4};

use crate::particles::{emission::shape_uniform, vortex::Span};

/// `Source` of `source.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct SourceUniform {
    center: Vec3,
    radius: f32,
    extent: Vec4,
    velocity: Vec3,
    shape: u32,
    heat: f32,
    smoke: f32,
    expansion: f32,
    drives: u32,
}

/// Those that emit in the step.
pub(super) fn sources_at(emitters: &[Emitter], span: Span) -> Vec<SourceUniform> {
    emitters.iter().filter(|emitter| emits(emitter, span)).map(source).collect()
}

fn emits(emitter: &Emitter, Span { time, dt }: Span) -> bool {
    let meets = |from: f64, until: f64| time < until && from < time + dt;
    let streams = emitter.count.is_some_and(|count| count > 0) || emitter.rate > 0.0;
    let [from, until] = emitter.active.map(f64::from);
    if streams && meets(from, until) {
        return true;
    }
    let secs = f64::from(emitter.source.secs);
    let bursts = emitter.bursts.iter().filter(|burst| burst.count > 0);
    emitter.count.is_none() && bursts.map(|burst| f64::from(burst.at)).any(|at| meets(at, at + secs))
}

fn source(emitter: &Emitter) -> SourceUniform {
    let (shape, center, extent, radius) = shape_uniform(emitter.shape);
    let velocity = Vec3::from(emitter.velocity);
    SourceUniform {
        center: center.truncate(),
        radius,
        extent,
        velocity,
        shape,
        heat: emitter.source.heat,
        smoke: emitter.source.smoke,
        expansion: emitter.source.expansion,
        drives: u32::from(velocity != Vec3::ZERO),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: SourceUniform, "Source" of "particles/grid/push" { center, radius, extent, velocity, shape, heat, smoke, expansion, drives });
}
