//! The tree's sum against the direct one.

use std::f32::consts::TAU;

use glam::{DVec3, Quat, Vec3};

use super::{Leaf, VortexState, direct, leaves, swirl_with};
use crate::{
    Gpu,
    gpu::{Frame, Slot, TexturePool, kernels, read_buffer, workgroups},
    particles::{
        tests::engine,
        vortex::{Swirl, order::Order},
    },
};

const WGSL: &str =
    concat!(include_str!("../tree.wgsl"), include_str!("../induced.wgsl"), include_str!("probe.wgsl"));

const SEGMENTS: u32 = 20;

/// Numbers from 0 to 1 (Marsaglia 2003, "Xorshift RNGs").
struct Random(u32);

impl Random {
    fn next(&mut self) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        (self.0 >> 8) as f32 / (1 << 24) as f32
    }

    fn place(&mut self) -> Vec3 {
        Vec3::new(self.next(), self.next(), self.next())
    }
}

/// Rings of any size, strength and direction in a cube with sides of 4 m; some of them are dead.
fn tangle(rings: u32, random: &mut Random) -> Vec<VortexState> {
    let ring = |_| {
        let (center, radius) = (4.0 * random.place(), 0.05 + 0.4 * random.next());
        let turn = Quat::from_scaled_axis(TAU * (random.place() - 0.5));
        let (circulation, core) = (4.0 * random.next() - 2.0, radius * (0.1 + random.next()));
        let age = if random.next() < 0.1 { 2.0 } else { 0.0 };
        (0..SEGMENTS).map(move |nth| {
            let angle = TAU * nth as f32 / SEGMENTS as f32;
            VortexState {
                position: center + turn * Vec3::new(radius * angle.cos(), radius * angle.sin(), 0.0),
                age,
                velocity: Vec3::ZERO,
                life: 1.0,
                circulation,
                core,
                length: TAU * radius / SEGMENTS as f32,
                pad: 0,
            }
        })
    };
    (0..rings).flat_map(ring).collect()
}

/// The velocity at each of `places`, by the tree.
fn by_tree(gpu: &Gpu, swirl: &Swirl, places: &[Vec3]) -> Vec<DVec3> {
    let program =
        wgpu::ShaderModuleDescriptor { label: Some("probe"), source: wgpu::ShaderSource::Wgsl(WGSL.into()) };
    let slots = [Slot::Uniform, Slot::Read, Slot::Read, Slot::Write];
    let [probe] = kernels(gpu, program, &slots, ["main"]);
    let pool = TexturePool::default();
    let mut frame = Frame::new(gpu, &pool, "probe");
    Order::new(gpu).record(&mut frame, swirl, false);
    let uniform = frame.uniform("probe.uniform", &[swirl.tree.places, places.len() as u32, 0, 0]);
    let found = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("probe.found"),
        size: places.len() as u64 * 16,
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let asked: Vec<[f32; 4]> = places.iter().map(|place| place.extend(0.0).to_array()).collect();
    gpu.queue.write_buffer(&found, 0, bytemuck::cast_slice(&asked));
    let bindings =
        [&uniform, &swirl.tree.leaves, &swirl.tree.nodes, &found].map(wgpu::Buffer::as_entire_binding);
    frame.compute("probe", &probe, &bindings, workgroups(places.len() as u32));
    frame.submit();
    let rows: Vec<[f32; 4]> = read_buffer(gpu, &found).expect("the device lives");
    rows.iter().map(|&[x, y, z, _]| Vec3::new(x, y, z).as_dvec3()).collect()
}

#[test]
fn the_trees_error_is_below_the_bound() {
    let engine = engine();
    let gpu = engine.gpu();
    let mut random = Random(7);
    // 2,400 vortices do not fit the least tree; 40 leave most of it empty.
    for (rings, error) in [(120, 1.0), (120, 0.1), (120, 0.01), (2, 0.1), (600, 0.1)] {
        let swirl = swirl_with(gpu, &tangle(rings, &mut random), SEGMENTS, error);
        let places: Vec<Vec3> = (0..400).map(|_| 6.0 * random.place() - 1.0).collect();
        let found = by_tree(gpu, &swirl, &places);
        let leaves = leaves(gpu, &swirl);
        let (mut worst, mut farthest, mut fastest) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (place, found) in places.iter().zip(found) {
            let (right, amount) = direct(&leaves, place.as_dvec3());
            worst = worst.max((found - right).length() / amount);
            farthest = farthest.max((found - right).length());
            fastest = fastest.max(right.length());
        }
        assert!(worst < f64::from(error), "{worst} is above {error}");
        assert!(farthest < 0.15 * f64::from(error) * fastest + 1e-5, "{farthest} of {fastest} m/s");
    }
}

#[test]
fn a_wider_bound_is_used() {
    // Otherwise the bound could be met by summing everything.
    let engine = engine();
    let gpu = engine.gpu();
    let vortices = tangle(120, &mut Random(7));
    let place = Vec3::splat(9.0);
    let error = |error| {
        let swirl = swirl_with(gpu, &vortices, SEGMENTS, error);
        let found = by_tree(gpu, &swirl, &[place])[0];
        let (right, amount) = direct(&leaves(gpu, &swirl), place.as_dvec3());
        (found - right).length() / amount
    };
    assert!(error(1.0) > 10.0 * error(0.001), "{} and {}", error(1.0), error(0.001));
}

#[test]
fn leaves_are_the_living_vortices_in_the_order_of_their_keys() {
    let engine = engine();
    let gpu = engine.gpu();
    let vortices = tangle(250, &mut Random(3));
    let swirl = swirl_with(gpu, &vortices, SEGMENTS, 0.2);
    by_tree(gpu, &swirl, &[Vec3::ZERO]);
    let keys: Vec<[u32; 2]> = read_buffer(gpu, &swirl.tree.keys).expect("the device lives");
    assert_eq!(keys.len(), 8192, "5,000 vortices have 8,192 places");
    assert!(keys.windows(2).all(|pair| pair[0] < pair[1]), "in order, and no two alike");
    let all: Vec<Leaf> = read_buffer(gpu, &swirl.tree.leaves).expect("the device lives");
    for (leaf, [key, slot]) in all.iter().zip(keys) {
        match vortices.get(slot as usize) {
            Some(vortex) if vortex.age < vortex.life => assert_eq!(leaf.position, vortex.position),
            _ => assert_eq!((leaf.strength, key), (Vec3::ZERO, u32::MAX)),
        }
    }
    // On a curve without jumps, neighbours are near: in a random order they would be 2.6 m apart.
    let living = all.iter().filter(|leaf| leaf.strength != Vec3::ZERO).count();
    let apart = all[..living].windows(2).map(|pair| pair[0].position.distance(pair[1].position));
    let mean = apart.sum::<f32>() / living as f32;
    assert!(mean < 0.3, "{mean} m on average");
}

#[test]
fn the_air_has_no_divergence() {
    let engine = engine();
    let gpu = engine.gpu();
    let mut random = Random(11);
    let swirl = swirl_with(gpu, &tangle(60, &mut random), SEGMENTS, 0.2);
    let middles: Vec<Vec3> = (0..300).map(|_| 4.0 * random.place()).collect();
    let step = 1.0 / 128.0;
    let sides: Vec<Vec3> = middles
        .iter()
        .flat_map(|&p| Vec3::AXES.into_iter().flat_map(move |axis| [p + step * axis, p - step * axis]))
        .collect();
    let found = by_tree(gpu, &swirl, &sides);
    let (mut divergence, mut gradient) = (0.0, 0.0);
    for six in found.chunks_exact(6) {
        let slope = |axis: usize| (six[2 * axis] - six[2 * axis + 1]) / (2.0 * f64::from(step));
        let slopes = [slope(0), slope(1), slope(2)];
        divergence += (slopes[0].x + slopes[1].y + slopes[2].z).powi(2);
        gradient += slopes.iter().map(|slope| slope.length_squared()).sum::<f64>();
    }
    let share = (divergence / gradient).sqrt();
    assert!(share < 0.03, "{share} of the gradient");
}

#[test]
fn without_vortices_the_air_stands_still() {
    let engine = engine();
    let gpu = engine.gpu();
    let mut dead = tangle(3, &mut Random(5));
    dead.iter_mut().for_each(|vortex| vortex.age = 5.0);
    let swirl = swirl_with(gpu, &dead, SEGMENTS, 0.2);
    assert_eq!(by_tree(gpu, &swirl, &[Vec3::ZERO, Vec3::ONE]), [DVec3::ZERO; 2]);
}
