//! The puff atlas: bundles of balls, rendered once to normal, height and margin.

use fumetto_scene::Puffs;
use thiserror::Error;

use super::bundle::{Bundles, HOLES};
use crate::gpu::{Frame, Gpu, RasterPipeline, Slot, Target, TexturePool, linear_sampler, shader};

/// Half the width of a tile over the puff's radius: room for ink around it. Also in `billboard.wgsl`.
const TILE_EXTENT: f32 = 1.25;

/// Bytes: software rasterisers filter them several times faster than half floats, and puffs fill the
/// screen many times over.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

const HEIGHTS_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Uint;

/// How kernels bind [`Atlas::heights`].
pub(crate) const HEIGHTS_SLOT: Slot = Slot::ReadTexels(HEIGHTS_FORMAT);

/// All variants of a puff in one texture, side by side.
///
/// Channels: normal x and y in the tile's frame (y up) from -1 to 1, height over the puff's middle in its
/// radii from 0 to 1, and margin from -0.5 to 1: how much erosion a place outlives, or its distance from
/// the puff, negative.
#[derive(Debug)]
pub(crate) struct Atlas {
    pub(crate) texture: wgpu::Texture,
    pub(crate) view: wgpu::TextureView,
    /// Heights and margins by fours, as `heights.wgsl` tells.
    pub(crate) heights: wgpu::TextureView,
    pub(crate) sampler: wgpu::Sampler,
    pub(crate) uniform: wgpu::Buffer,
    /// How many there are.
    pub(crate) variants: u32,
    /// Width of the largest copy of each.
    pub(crate) tile_px: u32,
}

/// The puffs' pictures do not fit into one texture.
#[derive(Clone, Copy, Debug, Error)]
#[error(
    "the scene's puffs need {variants} tiles of {tile_px} pixels side by side; this device allows {allowed} \
     pixels. Lower `shape.puffs.variants` or `tile`, or give objects the same puffs"
)]
pub struct AtlasError {
    variants: u32,
    tile_px: u32,
    allowed: u32,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct BundlesUniform {
    tile_px: f32,
    extent: f32,
    balls: u32,
    holes: u32,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct AtlasUniform {
    variants: f32,
    tile_px: f32,
    levels: f32,
    pad: f32,
}

impl Atlas {
    /// Renders the variants of all `kinds`, one kind after another, in tiles of the largest size that any
    /// of them wants. The balls are not needed afterwards.
    pub(crate) fn new(gpu: &Gpu, kinds: &[Puffs]) -> Result<Self, AtlasError> {
        let variants = kinds.iter().map(|kind| kind.variants).sum::<u32>().max(1);
        let tile_px = kinds.iter().map(|kind| kind.tile_px).max().unwrap_or(16);
        // Copies of half, a quarter… the size lie below each other, all in one plain texture: software
        // rasterisers are several times slower where each pixel chooses among mip levels.
        let size = [variants * tile_px, 2 * tile_px];
        let allowed = gpu.device.limits().max_texture_dimension_2d;
        if size[0] > allowed {
            return Err(AtlasError { variants, tile_px, allowed });
        }
        // The coarsest tile is 4 pixels wide: smaller puffs are dots anyway.
        let levels = tile_px.ilog2() - 1;
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("shapes.puffs.atlas"),
            size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let pool = TexturePool::default();
        let mut frame = Frame::new(gpu, &pool, "shapes.puffs.atlas");
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        render(&mut frame, kinds, tile_px as f32, &view);
        let heights = heights(&mut frame, &view, size);
        let uniform = AtlasUniform {
            variants: variants as f32,
            tile_px: tile_px as f32,
            levels: levels as f32,
            pad: 0.0,
        };
        let uniform = frame.uniform("shapes.puffs.atlas.uniform", &uniform);
        frame.submit();
        Ok(Self { view, heights, texture, sampler: linear_sampler(gpu), uniform, variants, tile_px })
    }
}

fn render(frame: &mut Frame<'_>, kinds: &[Puffs], tile_px: f32, target: &wgpu::TextureView) {
    let bundles = Bundles::new(kinds);
    let uniform = BundlesUniform { tile_px, extent: TILE_EXTENT, balls: bundles.balls_each, holes: HOLES };
    let module = frame.gpu.module(shader!("shapes/puffs/atlas"));
    let pipeline = RasterPipeline { label: "shapes.puffs.atlas", targets: &[FORMAT], ..Default::default() }
        .build(&module);
    let uniform = frame.uniform("shapes.puffs.atlas.bundles", &uniform);
    let balls = frame.storage("shapes.puffs.atlas.balls", &bundles.balls);
    let holes = frame.storage("shapes.puffs.atlas.holes", &bundles.holes);
    frame.fullscreen(
        "shapes.puffs.atlas",
        &pipeline,
        Target::colour(target, Some(wgpu::Color::TRANSPARENT)),
        &[uniform.as_entire_binding(), balls.as_entire_binding(), holes.as_entire_binding()],
    );
}

fn heights(frame: &mut Frame<'_>, atlas: &wgpu::TextureView, size: [u32; 2]) -> wgpu::TextureView {
    let module = frame.gpu.module(shader!("shapes/puffs/heights"));
    let label = "shapes.puffs.heights";
    let pipeline = RasterPipeline { label, targets: &[HEIGHTS_FORMAT], ..Default::default() }.build(&module);
    let texture = frame.gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: HEIGHTS_FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::STORAGE_BINDING,
        view_formats: &[],
    });
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    let target = Target::colour(&view, Some(wgpu::Color::TRANSPARENT));
    frame.fullscreen(label, &pipeline, target, &[wgpu::BindingResource::TextureView(atlas)]);
    view
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(bundles_lie_as_their_twin: BundlesUniform, "Bundles" of "shapes/puffs/atlas" { tile_px, extent, balls, holes });

    layout_test!(the_atlas_lies_as_its_twin: AtlasUniform, "Atlas" of "shapes/puffs/project" { variants, tile_px, levels });
}
