//! The air's velocity itself, probed by a kernel of the tests' own.

use super::engine;
use crate::gpu::{Frame, Slot, TexturePool, kernels, read_buffer, workgroups};

const WGSL: &str = concat!(
    include_str!("../../gpu/random.wgsl"),
    include_str!("../../gpu/noise.wgsl"),
    include_str!("../air.wgsl"),
    include_str!("air.wgsl")
);

#[derive(Clone, Copy)]
enum Air {
    Turbulence { octaves: u32 },
    Vortex,
}

/// Root mean squares over `count` places.
struct Probed {
    speed: f64,
    divergence: f64,
    gradient: f64,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct ProbeUniform {
    kind: u32,
    octaves: u32,
    step: f32,
    count: u32,
}

fn probe(air: Air, count: u32) -> Probed {
    let engine = engine();
    let gpu = engine.gpu();
    let program =
        wgpu::ShaderModuleDescriptor { label: Some("air"), source: wgpu::ShaderSource::Wgsl(WGSL.into()) };
    let [pipeline] = kernels(gpu, program, &[Slot::Uniform, Slot::Read, Slot::Write], ["main"]);
    let (kind, octaves) = match air {
        Air::Turbulence { octaves } => (0, octaves),
        Air::Vortex => (1, 0),
    };
    let pool = TexturePool::default();
    let mut frame = Frame::new(gpu, &pool, "air");
    let uniform = frame.uniform("air.uniform", &ProbeUniform { kind, octaves, step: 1.0 / 256.0, count });
    let forces = frame.storage("air.forces", &[[0_u32; 12]]);
    let found = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("air.found"),
        size: u64::from(count) * 32,
        usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    let bindings = [uniform.as_entire_binding(), forces.as_entire_binding(), found.as_entire_binding()];
    frame.compute("air", &pipeline, &bindings, workgroups(count));
    frame.submit();
    let rows: Vec<[[f32; 4]; 2]> = read_buffer(gpu, &found).expect("the device lives");
    let mean_square = |value: &dyn Fn(&[[f32; 4]; 2]) -> f64| {
        (rows.iter().map(|row| value(row).powi(2)).sum::<f64>() / rows.len() as f64).sqrt()
    };
    Probed {
        speed: mean_square(&|[velocity, _]| {
            velocity.iter().map(|&component| f64::from(component).powi(2)).sum::<f64>().sqrt()
        }),
        divergence: mean_square(&|[_, derivatives]| f64::from(derivatives[0])),
        gradient: mean_square(&|[_, derivatives]| f64::from(derivatives[1])),
    }
}

#[test]
fn curl_has_a_root_mean_square_of_one() {
    for octaves in [1, 3] {
        let speed = probe(Air::Turbulence { octaves }, 1 << 20).speed;
        assert!((speed - 1.0).abs() < 0.03, "{speed} with {octaves} octaves");
    }
}

#[test]
fn curl_has_no_divergence() {
    for octaves in [1, 2, 4] {
        let Probed { divergence, gradient, .. } = probe(Air::Turbulence { octaves }, 1 << 16);
        assert!(gradient > 1.0, "the air does swirl: {gradient}");
        assert!(divergence < 0.01 * gradient, "{divergence} of {gradient} with {octaves} octaves");
    }
}

#[test]
fn a_vortex_has_no_divergence() {
    let Probed { divergence, gradient, .. } = probe(Air::Vortex, 1 << 16);
    assert!(gradient > 0.2, "the air does turn: {gradient}");
    assert!(divergence < 0.01 * gradient, "{divergence} of {gradient}");
}
