//! Draws puffs into the depth and id layers.

use super::{
    bins::{Bins, WALK_SLOTS},
    scene::Subject,
};
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, RasterPipeline, RenderPipeline, Slot, kernels, shader},
    layers::{self, Layers},
};

/// Long-lived pipelines.
#[derive(Debug)]
pub(crate) struct Body {
    alone: ComputePipeline,
    among: ComputePipeline,
    fill: RenderPipeline,
}

impl Body {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let slots: Vec<_> = WALK_SLOTS.into_iter().chain([Slot::Depth]).collect();
        let [alone, among] = kernels(gpu, shader!("shapes/puffs/nearest"), &slots, ["alone", "among"]);
        let module = gpu.module(shader!("shapes/puffs/fill"));
        let fill = RasterPipeline {
            label: "shapes.puffs.fill",
            targets: &[layers::ID_FORMAT],
            depth: Some(layers::nearest_wins()),
            ..Default::default()
        };
        Self { alone, among, fill: fill.build(&module) }
    }

    /// Draws what `bins` lists; `is_empty` tells that there is nothing in `layers` yet.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        bins: &Bins,
        layers: &Layers,
        is_empty: bool,
    ) {
        let mut bindings = bins.walk(subject);
        bindings.push(wgpu::BindingResource::TextureView(&layers.depth));
        let nearest = if is_empty { &self.alone } else { &self.among };
        frame.compute_indirect("shapes.puffs.nearest", nearest, &bindings, &bins.dispatch);
        frame.raster("shapes.puffs.fill", &self.fill, layers.target(), &bins.covered(), |pass| {
            bins.draw(pass);
        });
    }
}
