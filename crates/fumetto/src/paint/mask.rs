//! Which volumes of paint what is seen lies in.

use super::{PaintScene, coat::Coats};
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader},
    layers::Layers,
};

/// Pixels of a tile along x and y. Also in `mask.wgsl`.
const TILE_PX: [u32; 2] = [16, 16];

/// The long-lived kernel.
#[derive(Debug)]
pub(crate) struct Mask {
    pipeline: ComputePipeline,
}

/// What is known of each pixel.
#[derive(Debug)]
pub(crate) struct Marks {
    /// Two pixels a word: see `marks.wgsl`.
    pub(crate) mask: wgpu::Buffer,
    /// The paints that they speak of: `Coats` of `coat.wgsl`.
    pub(crate) coats: wgpu::Buffer,
}

impl Mask {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        use Slot::{Depth, Read, Uniform, Write};
        let slots = [Uniform, Uniform, Uniform, Depth, Read, Read, Read, Read, Write];
        let [pipeline] = kernels(gpu, shader!("paint/mask"), &slots, ["main"]);
        Self { pipeline }
    }

    /// Asks of all that `layers` show in which of the paints it lies; lines are as wide as suits a picture
    /// `height_px` samples high.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        paints: &PaintScene,
        view: &wgpu::Buffer,
        layers: &Layers,
        height_px: u32,
    ) -> Marks {
        let coats: Coats = paints.coats.at_height(height_px);
        let coats = frame.uniform("paint.coats", &coats);
        let [width, height] = layers.size;
        let mask = frame.zeros("paint.mask", width.div_ceil(2) * height);
        frame.compute(
            "paint.mask",
            &self.pipeline,
            &[
                view.as_entire_binding(),
                coats.as_entire_binding(),
                paints.icosahedron.as_entire_binding(),
                wgpu::BindingResource::TextureView(&layers.depth),
                paints.bodies.as_entire_binding(),
                paints.vertices.as_entire_binding(),
                paints.directions.as_entire_binding(),
                paints.patches.as_entire_binding(),
                mask.as_entire_binding(),
            ],
            [width.div_ceil(TILE_PX[0]), height.div_ceil(TILE_PX[1]), 1],
        );
        Marks { mask, coats }
    }
}
