//! Vortices against direct sums and closed forms, on whatever adapter there is.

mod rings;
mod smoke;
mod sum;

use fumetto_scene::Vortex;
use glam::{DVec3, Vec3};

use super::{Swirl, Tree};
use crate::{
    Engine, Gpu, Player,
    gpu::{layout_test, read_buffer},
};

/// `Vortex` of `vortex.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
struct VortexState {
    position: Vec3,
    age: f32,
    velocity: Vec3,
    life: f32,
    circulation: f32,
    core: f32,
    length: f32,
    pad: u32,
}

/// `Leaf` of `tree.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
struct Leaf {
    position: Vec3,
    core2: f32,
    strength: Vec3,
    pad: u32,
}

layout_test!(vortices_are_read_back_as_they_are: VortexState, "Vortex" of "particles/vortex/build" { position, age, velocity, life, circulation, core, length });
layout_test!(leaves_are_read_back_as_they_are: Leaf, "Leaf" of "particles/vortex/build" { position, core2, strength });

fn swirl_of(player: &Player) -> &Swirl {
    player.plumes().next().expect("there is smoke").swirl().expect("it has vortices")
}

/// The living vortices after `steps` steps.
fn vortices_after(engine: &Engine, player: &mut Player, steps: u32) -> Vec<VortexState> {
    engine.seek(player, steps).expect("there are no files to miss");
    let mut vortices: Vec<VortexState> =
        read_buffer(engine.gpu(), &swirl_of(player).vortices).expect("the device lives");
    vortices.retain(|vortex| vortex.age < vortex.life);
    vortices
}

/// The leaves of the tree in the middle of the last step.
fn leaves(gpu: &Gpu, swirl: &Swirl) -> Vec<Leaf> {
    let mut leaves: Vec<Leaf> = read_buffer(gpu, &swirl.tree.leaves).expect("the device lives");
    leaves.retain(|leaf| leaf.strength != Vec3::ZERO);
    leaves
}

/// The velocity that `leaves` give to a place, summed one by one; and the sum of what each alone gives.
fn direct(leaves: &[Leaf], place: DVec3) -> (DVec3, f64) {
    leaves.iter().fold((DVec3::ZERO, 0.0), |(velocity, amount), leaf| {
        let (offset, core2) = (place - leaf.position.as_dvec3(), f64::from(leaf.core2));
        let distance2 = offset.length_squared();
        let kernel = (distance2 + 2.5 * core2) / (distance2 + core2).powf(2.5) / (4.0 * std::f64::consts::PI);
        let strength = leaf.strength.as_dvec3();
        (velocity + kernel * strength.cross(offset), amount + kernel * strength.length() * offset.length())
    })
}

/// Vortices without a scene.
fn swirl_with(gpu: &Gpu, vortices: &[VortexState], segments: u32, error: f32) -> Swirl {
    let vortex =
        Vortex { strength: 1.0, buoyancy: 0.0, core: 0.5, viscosity: 0.0, decay: 0.0, segments, error };
    let count = vortices.len() as u32;
    let buffer = |bytes: u64| {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("vortex.test"),
            size: bytes,
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    };
    let swirl = Swirl {
        vortex,
        sources: Vec::new(),
        count,
        vortices: buffer(u64::from(count) * 48),
        halfway: buffer(u64::from(count) * 16),
        tree: Tree::new(gpu, count),
    };
    gpu.queue.write_buffer(&swirl.vortices, 0, bytemuck::cast_slice(vortices));
    swirl
}
