//! Models' textures, as the layers of one array.

use fast_image_resize::{
    PixelType, ResizeOptions, Resizer,
    images::{Image as Picture, ImageRef},
};
use fumetto_formats::Image;

use crate::gpu::Gpu;

/// Longest side of a layer: drawn colours are flat, so that more would only cost memory.
const MAX_SIDE: u32 = 2048;

/// All layers are of the size of the largest, in powers of two, with their smaller copies.
pub(super) fn textures(gpu: &Gpu, images: &[Image]) -> (wgpu::TextureView, wgpu::Sampler) {
    let longest = |side: fn(&Image) -> u32| images.iter().map(side).max().unwrap_or(1);
    let side = |longest: u32| longest.next_power_of_two().min(MAX_SIDE);
    let (width, height) = (side(longest(|image| image.width)), side(longest(|image| image.height)));
    let levels = width.max(height).ilog2() + 1;
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("shapes.mesh.textures"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: images.len().max(1) as u32 },
        mip_level_count: levels,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8UnormSrgb,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (layer, image) in (0..).zip(images) {
        for level in 0..levels {
            let size = [(width >> level).max(1), (height >> level).max(1)];
            write_layer(gpu, &texture, [layer, level], size, &resized(image, size));
        }
    }
    let view = texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        ..Default::default()
    });
    (view, sampler(gpu))
}

/// `image` at another size; plain averages where it shrinks.
fn resized(image: &Image, [width, height]: [u32; 2]) -> Vec<u8> {
    let mut to = Picture::new(width, height, PixelType::U8x4);
    let from = ImageRef::new(image.width, image.height, &image.pixels, PixelType::U8x4);
    let done = from.map(|from| Resizer::new().resize(&from, &mut to, &ResizeOptions::default()));
    debug_assert!(matches!(done, Ok(Ok(()))), "an image has a pixel type of its own and is not empty");
    to.into_vec()
}

fn write_layer(gpu: &Gpu, texture: &wgpu::Texture, [layer, level]: [u32; 2], size: [u32; 2], texels: &[u8]) {
    let to = wgpu::TexelCopyTextureInfo {
        texture,
        mip_level: level,
        origin: wgpu::Origin3d { x: 0, y: 0, z: layer },
        aspect: wgpu::TextureAspect::All,
    };
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * size[0]), rows_per_image: None };
    let extent = wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 };
    gpu.queue.write_texture(to, texels, layout, extent);
}

fn sampler(gpu: &Gpu) -> wgpu::Sampler {
    gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("shapes.mesh.textures"),
        address_mode_u: wgpu::AddressMode::Repeat,
        address_mode_v: wgpu::AddressMode::Repeat,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        ..Default::default()
    })
}
