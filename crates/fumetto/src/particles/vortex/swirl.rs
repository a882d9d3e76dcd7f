//! The vortices of one object, on the GPU.

use fumetto_scene::{Emitter, RingPlan, Smoke, Vortex};

use super::Tree;
use crate::gpu::{Frame, Gpu};

/// Bytes of a `Vortex` of `vortex.wgsl`.
const VORTEX_BYTES: u64 = 48;

/// All vortices that move one object's smoke.
#[derive(Debug)]
pub(crate) struct Swirl {
    pub(super) vortex: Vortex,
    pub(super) sources: Vec<Source>,
    /// Vortex particles that there is room for.
    pub(super) count: u32,
    pub(crate) vortices: wgpu::Buffer,
    /// Where they are in the middle of a step.
    pub(super) halfway: wgpu::Buffer,
    pub(crate) tree: Tree,
}

/// An emitter that sheds rings.
#[derive(Debug)]
pub(super) struct Source {
    pub(super) emitter: Emitter,
    pub(super) plan: RingPlan,
    pub(super) seed: u32,
    /// Its first vortex in the list of all, and how many it has.
    pub(super) first: u32,
    pub(super) count: u32,
}

impl Swirl {
    /// The vortices of `smoke`; each emitter's random choices come from its own of `seeds`.
    pub(crate) fn new(gpu: &Gpu, smoke: &Smoke, seeds: &[u32], step_secs: f64) -> Option<Self> {
        let vortex = smoke.vortex?;
        let mut sources = Vec::new();
        let mut count = 0;
        for ((emitter, plan), &seed) in smoke.emitters.iter().zip(smoke.ring_plans(step_secs)).zip(seeds) {
            let Some(plan) = plan else { continue };
            let own = plan.capacity as u32 * vortex.segments;
            sources.push(Source { emitter: emitter.clone(), plan, seed, first: count, count: own });
            count += own;
        }
        if count == 0 {
            return None;
        }
        let buffer = |label, bytes: u64| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: u64::from(count) * bytes,
                usage: wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_DST
                    | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            })
        };
        Some(Self {
            vortex,
            sources,
            count,
            vortices: buffer("particles.vortex.state", VORTEX_BYTES),
            halfway: buffer("particles.vortex.halfway", 16),
            tree: Tree::new(gpu, count),
        })
    }

    /// Back to before the first birth.
    pub(crate) fn reset(&self, frame: &mut Frame<'_>) {
        frame.encoder.clear_buffer(&self.vortices, 0, None);
    }
}
