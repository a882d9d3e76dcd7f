//! Sums of all that comes before each item of a list.

use crate::gpu::{Frame, Gpu, Slot, kernels, shader, workgroups};

/// Items that one invocation of `scan.wgsl` looks at.
pub(super) const RUN: u32 = 32;

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Scan {
    reduce: wgpu::ComputePipeline,
    sum_runs: wgpu::ComputePipeline,
    spread: wgpu::ComputePipeline,
}

impl Scan {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write, Slot::Write];
        let entries = ["reduce", "sum_runs", "spread"];
        let [reduce, sum_runs, spread] = kernels(gpu, shader!("shapes/surface/scan"), &slots, entries);
        Self { reduce, sum_runs, spread }
    }

    /// Writes `items + 1` sums to `starts`: the last is that of all `values`. `runs` is scratch.
    pub(super) fn record(
        &self,
        frame: &mut Frame<'_>,
        items: u32,
        [values, runs, starts]: [&wgpu::Buffer; 3],
    ) {
        let uniform = frame.uniform("shapes.surface.scan.uniform", &[items, 0, 0, 0]);
        let bindings = [&uniform, values, runs, starts].map(wgpu::Buffer::as_entire_binding);
        let groups = workgroups(items.div_ceil(RUN));
        frame.compute("shapes.surface.scan.reduce", &self.reduce, &bindings, groups);
        frame.compute("shapes.surface.scan.runs", &self.sum_runs, &bindings, [1, 1, 1]);
        frame.compute("shapes.surface.scan.spread", &self.spread, &bindings, groups);
    }
}
