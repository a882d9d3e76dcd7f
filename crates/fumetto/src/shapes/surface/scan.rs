//! Sums of all that comes before each item of a list.

use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader, workgroups};

/// Items that one invocation of `scan.wgsl` looks at.
pub(super) const RUN: u32 = 32;

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Scan {
    words: Kernels,
    fours: Kernels,
}

#[derive(Debug)]
struct Kernels {
    reduce: ComputePipeline,
    sum_runs: ComputePipeline,
    spread: ComputePipeline,
}

impl Kernels {
    fn new(gpu: &Gpu, program: wgpu::ShaderModuleDescriptor<'static>) -> Self {
        let slots = [Slot::Uniform, Slot::Read, Slot::Write, Slot::Write];
        let [reduce, sum_runs, spread] = kernels(gpu, program, &slots, ["reduce", "sum_runs", "spread"]);
        Self { reduce, sum_runs, spread }
    }

    fn record(
        &self,
        frame: &mut Frame<'_>,
        items: u32,
        [values, runs, starts]: [&wgpu::Buffer; 3],
        shift: u32,
    ) {
        let uniform = frame.uniform("shapes.surface.scan.uniform", &[items, shift, 0, 0]);
        let bindings = [&uniform, values, runs, starts].map(wgpu::Buffer::as_entire_binding);
        let groups = workgroups(items.div_ceil(RUN));
        frame.compute("shapes.surface.scan.reduce", &self.reduce, &bindings, groups);
        frame.compute("shapes.surface.scan.runs", &self.sum_runs, &bindings, [1, 1, 1]);
        frame.compute("shapes.surface.scan.spread", &self.spread, &bindings, groups);
    }
}

impl Scan {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let words = Kernels::new(gpu, shader!("shapes/surface/scan_words"));
        let fours = Kernels::new(gpu, shader!("shapes/surface/scan_fours"));
        Self { words, fours }
    }

    /// Writes `items + 1` sums to `starts`: the last is that of all `values`. `runs` is scratch.
    pub(super) fn words(&self, frame: &mut Frame<'_>, items: u32, values_runs_starts: [&wgpu::Buffer; 3]) {
        self.words.record(frame, items, values_runs_starts, 0);
    }

    /// Likewise, one place further: the first is zero, and the sum of all is left out.
    pub(super) fn words_further(
        &self,
        frame: &mut Frame<'_>,
        items: u32,
        values_runs_starts: [&wgpu::Buffer; 3],
    ) {
        self.words.record(frame, items, values_runs_starts, 1);
    }

    /// As `words`, of four words each.
    pub(super) fn fours(&self, frame: &mut Frame<'_>, items: u32, values_runs_starts: [&wgpu::Buffer; 3]) {
        self.fours.record(frame, items, values_runs_starts, 0);
    }
}
