//! Kernels that are built twice: for fields with noise, and for those without.

use crate::gpu::{ComputePipeline, Gpu, Slot, kernels_with};

/// A kernel, without noise and with it.
#[derive(Debug)]
pub(super) struct Noisy([ComputePipeline; 2]);

impl Noisy {
    /// Of a program's entry `main`.
    pub(super) fn new(gpu: &Gpu, program: &wgpu::ShaderModuleDescriptor<'static>, slots: &[Slot]) -> Self {
        Self([0.0, 1.0].map(|noisy| {
            let [kernel] = kernels_with(gpu, program.clone(), slots, ["main"], &[("NOISY", noisy)]);
            kernel
        }))
    }

    pub(super) fn get(&self, noisy: bool) -> &wgpu::ComputePipeline {
        &self.0[usize::from(noisy)]
    }
}
