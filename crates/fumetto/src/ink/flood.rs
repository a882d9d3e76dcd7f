//! Lines of any width around seeds, by jump flooding.

use crate::gpu::{Frame, Gpu, RasterPipeline, Target, Transient, shader};

/// `Seed`s of `seed.wgsl`.
pub(super) const SEED_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Uint;

/// Pixels along the side of a tile. Also in `tiles.wgsl`.
const TILE_PX: u32 = 32;

/// The long-lived pipeline.
#[derive(Debug)]
pub(super) struct Flood {
    pipeline: wgpu::RenderPipeline,
}

/// Tiles of a picture that are wide enough for all lines to lie in.
pub(super) fn tiles(size: [u32; 2]) -> u32 {
    size[0].div_ceil(TILE_PX) * size[1].div_ceil(TILE_PX)
}

impl Flood {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let module = gpu.device.create_shader_module(shader!("ink/flood"));
        let pipeline = RasterPipeline { label: "ink.flood", targets: &[SEED_FORMAT], ..Default::default() };
        Self { pipeline: pipeline.build(&gpu.device, &module) }
    }

    /// Spreads `seeds`, of a picture of `size`, as far as `radius_px`, in the `tiles` that are not 0.
    pub(super) fn record(
        &self,
        frame: &mut Frame<'_>,
        seeds: Transient,
        size: [u32; 2],
        tiles: &wgpu::Buffer,
        radius_px: f32,
    ) -> Transient {
        let mut flooded = seeds;
        for jump in jumps(radius_px) {
            let next = frame.texture("ink.flood", size, SEED_FORMAT);
            let uniform = frame.uniform("ink.flood.uniform", &[jump, 0, 0, 0]);
            frame.raster(
                "ink.flood",
                &self.pipeline,
                Target::colour(&next, Some(wgpu::Color::TRANSPARENT)),
                &[
                    uniform.as_entire_binding(),
                    tiles.as_entire_binding(),
                    wgpu::BindingResource::TextureView(&flooded),
                ],
                |pass| pass.draw(0..6 * self::tiles(size), 0..1),
            );
            flooded = next;
        }
        flooded
    }
}

/// Halving distances that together reach `radius_px`.
fn jumps(radius_px: f32) -> impl Iterator<Item = u32> {
    let first = (radius_px.ceil() as u32 + 1).next_power_of_two() / 2;
    std::iter::successors(Some(first.max(1)), |jump| (*jump > 1).then_some(jump / 2))
}
