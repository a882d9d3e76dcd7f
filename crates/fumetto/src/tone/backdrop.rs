//! What lies behind everything.

use fumetto_formats::Image;
use fumetto_scene::{Background, Colour};

use crate::gpu::Gpu;

/// A scene's background, ready to draw.
#[derive(Debug)]
pub(crate) enum Backdrop {
    Transparent,
    Gradient { top: [f32; 3], bottom: [f32; 3] },
    Image(wgpu::TextureView),
}

impl Backdrop {
    /// `image` is the background's, where it is one.
    pub(crate) fn new(gpu: &Gpu, background: &Background, image: Option<&Image>) -> Self {
        match (background, image) {
            (_, Some(image)) => Self::Image(upload(gpu, image)),
            (Background::Transparent, None) => Self::Transparent,
            (&Background::Colour(Colour { linear }), None) => Self::Gradient { top: linear, bottom: linear },
            (&Background::Gradient { top, bottom }, None) => {
                Self::Gradient { top: top.linear, bottom: bottom.linear }
            }
            (Background::Image(_), None) => unreachable!("a background image is read before it is drawn"),
        }
    }
}

fn upload(gpu: &Gpu, image: &Image) -> wgpu::TextureView {
    let size = wgpu::Extent3d { width: image.width, height: image.height, depth_or_array_layers: 1 };
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("tone.backdrop"),
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * image.width), rows_per_image: None };
    gpu.queue.write_texture(texture.as_image_copy(), &image.pixels, layout, size);
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
