//! The noise itself, probed by a kernel of the tests' own, against double precision.

use std::sync::PoisonError;

use fumetto_scene::{Colour, Profile, Volume, VolumeNoise};

use super::BENCH;
use crate::{
    gpu::{Frame, Slot, kernels, read_buffer, workgroups},
    shapes::volume::recipe::Recipe,
};

const WGSL: &str = concat!(
    include_str!("../../../gpu/random.wgsl"),
    include_str!("../../../gpu/noise.wgsl"),
    include_str!("../recipe.wgsl"),
    include_str!("../fbm.wgsl"),
    include_str!("noise.wgsl")
);

const COUNT: u32 = 4096;

fn recipe(noise: VolumeNoise) -> Recipe {
    let volume = Volume {
        extinction_per_m: 1.0,
        profile: Profile::Constant,
        edge: 0.0,
        size: 1.0,
        noise: Some(noise),
        colours: vec![Colour { linear: [1.0; 3] }],
        glow: 0.0,
        soft: 1.0,
        surface: 0.5,
        relief: 0.5,
        shadow: 0.0,
        cells: 8,
        light_cells: 4,
        step_m: None,
        step_cells: 0.5,
        pixels: 1,
        lobe_m: None,
    };
    Recipe { volume, puffs: 0..1, moves: false, shadows: false, casts: false }
}

/// Places off the lattice, on both sides of the origin.
fn places() -> Vec<[f32; 4]> {
    let part = |index: u32, axis: u32| {
        let bits = index.wrapping_mul(3).wrapping_add(axis).wrapping_mul(0x9e37_79b1);
        (bits >> 8) as f32 / 16_777_216.0 * 40.0 - 20.0
    };
    (0..COUNT).map(|index| [part(index, 0), part(index, 1), part(index, 2), 0.0]).collect()
}

fn probed(noise: VolumeNoise) -> Vec<f32> {
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let gpu = bench.engine.gpu();
    let program =
        wgpu::ShaderModuleDescriptor { label: Some("noise"), source: wgpu::ShaderSource::Wgsl(WGSL.into()) };
    let [pipeline] = kernels(gpu, program, &[Slot::Uniform, Slot::Read, Slot::Write], ["main"]);
    let mut frame = Frame::new(gpu, &bench.pool, "noise");
    let uniform = frame.uniform("noise.recipe", &recipe(noise).uniform(0.0));
    let places = frame.storage("noise.places", &places());
    let found = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("noise.found"),
        size: u64::from(COUNT) * 4,
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    let bindings = [&uniform, &places, &found].map(wgpu::Buffer::as_entire_binding);
    frame.compute("noise", &pipeline, &bindings, workgroups(COUNT));
    frame.submit();
    read_buffer(gpu, &found).expect("the device lives")
}

/// O'Neill's PCG-RXS-M-XS-32.
fn pcg(input: u32) -> u32 {
    let state = input.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// Perlin's improved noise (2002), with gradients to the corners of a cube.
fn perlin(p: [f64; 3], seed: u32) -> f64 {
    let cell = p.map(f64::floor);
    let part = [0, 1, 2].map(|axis| p[axis] - cell[axis]);
    let fade = part.map(|w| w * w * w * (w * (w * 6.0 - 15.0) + 10.0));
    let mut sum = 0.0;
    for corner in 0..8_u32 {
        let step = [corner & 1, (corner >> 1) & 1, corner >> 2];
        let [x, y, z] = [0, 1, 2].map(|axis| (cell[axis] as i64 + i64::from(step[axis])) as u32);
        let key = pcg(x.wrapping_add(pcg(y.wrapping_add(pcg(z.wrapping_add(seed))))));
        let mut value = 0.0;
        let mut weight = 1.0;
        for axis in 0..3 {
            let gradient = f64::from((key >> axis) & 1) * 2.0 - 1.0;
            value += gradient * (part[axis] - f64::from(step[axis]));
            weight *= if step[axis] == 1 { fade[axis] } else { 1.0 - fade[axis] };
        }
        sum += weight * value;
    }
    sum
}

fn oracle(p: [f64; 3], noise: VolumeNoise) -> f64 {
    let (mut sum, mut most, mut strength, mut scale) = (0.0, 0.0, 1.0, 1.0);
    for octave in 0..noise.octaves {
        let value = perlin(p.map(|x| x * scale), noise.seed + octave);
        sum += strength * if noise.billow { value.abs() } else { value };
        most += strength;
        strength *= f64::from(noise.persistence);
        scale *= f64::from(noise.lacunarity);
    }
    (1.5 * sum / most).clamp(-1.0, 1.0)
}

#[test]
fn octaves_are_what_double_precision_makes_of_them() {
    let plain = VolumeNoise {
        amplitude: 1.0,
        frequency: 1.0,
        octaves: 1,
        persistence: 0.5,
        lacunarity: 2.0,
        seed: 3,
        drift: [0.0; 3],
        billow: false,
    };
    let rough = VolumeNoise { octaves: 5, persistence: 0.6, lacunarity: 2.0, billow: true, ..plain };
    for noise in [plain, rough] {
        let found = probed(noise);
        let mut spread = 0.0_f64;
        for (&found, place) in found.iter().zip(places()) {
            let expected = oracle([0, 1, 2].map(|axis| f64::from(place[axis])), noise);
            // The finest octave stretches what rounding its place loses.
            assert!((f64::from(found) - expected).abs() < 3e-4, "{found} at {place:?}, should be {expected}");
            spread = spread.max(expected.abs());
        }
        assert!(spread > 0.5, "there is noise");
    }
}
