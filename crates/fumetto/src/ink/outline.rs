//! Outlines by ink billboards behind the puffs.

use super::INK_FORMAT;
use crate::{
    gpu::{
        ComputePipeline, Frame, Gpu, RasterPipeline, RenderPipeline, Slot, Target, Transient, kernels, shader,
    },
    layers::Layers,
    shapes::puffs::{Bins, Subject, WALK_SLOTS},
};

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Outline {
    first: ComputePipeline,
    over: ComputePipeline,
    draw: RenderPipeline,
}

impl Outline {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots: Vec<_> = WALK_SLOTS.into_iter().chain([Slot::Ids, Slot::Depth]).collect();
        let [first, over] = kernels(gpu, shader!("ink/outline"), &slots, ["first", "over"]);
        let module = gpu.module(shader!("ink/outlined"));
        let draw = RasterPipeline { label: "ink.outlined", targets: &[INK_FORMAT], ..Default::default() };
        Self { first, over, draw: draw.build(&module) }
    }

    /// Inks the puffs that `bins` lists into `ink`, where they are nearer than `depth` tells.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        bins: &Bins,
        (layers, depth): (&Layers, &Transient),
        ink: &Transient,
    ) {
        let mut bindings = bins.walk(subject);
        bindings.extend([&layers.id, depth].map(|layer| wgpu::BindingResource::TextureView(layer)));
        let find = if layers.is_over { &self.over } else { &self.first };
        frame.compute_indirect("ink.outline", find, &bindings, &bins.dispatch);
        let target = Target::colour(ink, None);
        frame.raster("ink.outlined", &self.draw, target, &bins.covered(), |pass| bins.draw(pass));
    }
}
