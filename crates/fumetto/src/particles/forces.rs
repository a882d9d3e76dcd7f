//! Forces as the step kernel takes them, at one moment.

use std::f32::consts::TAU;

use fumetto_scene::Force;
use glam::Vec3;

/// `Force` of `air.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, bytemuck::Pod, bytemuck::Zeroable)]
pub(crate) struct ForceUniform {
    a: [f32; 4],
    b: [f32; 4],
    kind: u32,
    octaves: u32,
    seed: u32,
    pad: u32,
}

/// All of `forces` at `time` seconds.
pub(super) fn forces_at(forces: &[Force], seed: u32, time: f32) -> Vec<ForceUniform> {
    (0..).zip(forces).map(|(index, force)| force_at(force, index, seed, time)).collect()
}

/// `force`, the scene's `index`-th, at `time` seconds.
fn force_at(force: &Force, index: u32, seed: u32, time: f32) -> ForceUniform {
    let of = |kind, a, b| ForceUniform { a, b, kind, ..Default::default() };
    match *force {
        Force::Gravity { acceleration: [x, y, z] } => of(0, [x, y, z, 0.0], [0.0; 4]),
        Force::Buoyancy { acceleration, cooling } => of(1, [acceleration, cooling, 0.0, 0.0], [0.0; 4]),
        Force::Drag { rate } => of(2, [rate, 0.0, 0.0, 0.0], [0.0; 4]),
        Force::Wind { velocity, gust, gust_secs } => {
            of(3, blowing(velocity, gust, time / gust_secs).extend(0.0).to_array(), [0.0; 4])
        }
        Force::Turbulence { speed, scale, octaves, drift } => ForceUniform {
            octaves,
            seed: seed.wrapping_add(index.wrapping_mul(0x9e37_79b9)),
            ..of(
                4,
                [0.0, 0.0, 0.0, speed],
                (Vec3::from(drift) * (time / scale)).extend(1.0 / scale).to_array(),
            )
        },
        Force::Vortex { center: [x, y, z], axis, radius, speed } => {
            of(5, [x, y, z, radius], Vec3::from(axis).normalize_or_zero().extend(speed).to_array())
        }
        Force::Attract { center: [x, y, z], radius, acceleration } => {
            of(6, [x, y, z, radius], [acceleration, 0.0, 0.0, 0.0])
        }
    }
}

/// The velocity of all winds together at `time` seconds.
pub(super) fn wind_at(forces: &[Force], time: f32) -> Vec3 {
    let wind = |force: &Force| match *force {
        Force::Wind { velocity, gust, gust_secs } => blowing(velocity, gust, time / gust_secs),
        _ => Vec3::ZERO,
    };
    forces.iter().map(wind).sum()
}

fn blowing(velocity: [f32; 3], gust: f32, time: f32) -> Vec3 {
    Vec3::from(velocity) * (1.0 + gust * gust_at(time))
}

/// Swelling and slackening, from -1 to 1, about once in a unit of time: two waves whose periods share no
/// multiple, so that gusts do not repeat.
fn gust_at(time: f32) -> f32 {
    const GOLDEN_RATIO: f32 = 1.618_034;
    0.6 * (TAU * time).sin() + 0.4 * (TAU * GOLDEN_RATIO * time + 2.0).sin()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: ForceUniform, "Force" of "particles/step" { a, b, kind, octaves, seed });
}
