//! What lies behind everything.

use fumetto_formats::Image;
use fumetto_scene::{Background, Colour};

use crate::{
    gpu::Gpu,
    ink::{TOOTH_SIDE, tooth},
};

/// Share of its light that paper's deepest pore loses.
const PORE_SHADE: f32 = 0.06;

/// Rows of a gradient: more than there are bytes' worth of steps in one.
const GRADIENT_ROWS: u32 = 1024;

/// A scene's background, ready to draw.
#[derive(Debug)]
pub(crate) enum Backdrop {
    Transparent,
    /// One colour, also as an image.
    Colour(wgpu::Color, wgpu::TextureView),
    /// Stretched over the picture.
    Gradient(wgpu::TextureView),
    /// Scaled to cover the picture, centred.
    Image(wgpu::TextureView),
    /// Repeated.
    Paper(wgpu::TextureView),
}

impl Backdrop {
    /// `image` is the background's, where it is one.
    pub(crate) fn new(gpu: &Gpu, background: &Background, image: Option<&Image>) -> Self {
        match (background, image) {
            (_, Some(image)) => Self::Image(upload(gpu, image)),
            (Background::Transparent, None) => Self::Transparent,
            (&Background::Colour(colour), None) => {
                let [r, g, b] = colour.to_srgb8().map(|channel| f64::from(channel) / 255.0);
                let clear = wgpu::Color { r, g, b, a: 1.0 };
                Self::Colour(clear, upload(gpu, &gradient(colour, colour)))
            }
            (&Background::Gradient { top, bottom }, None) => {
                Self::Gradient(upload(gpu, &gradient(top, bottom)))
            }
            (&Background::Paper(colour), None) => Self::Paper(upload(gpu, &paper(colour))),
            (Background::Image(_), None) => unreachable!("a background image is read before it is drawn"),
        }
    }
}

/// Paper whose pores are in the shade.
fn paper(colour: Colour) -> Image {
    let pixels = tooth().into_iter().flat_map(|depth| {
        let light = 1.0 - PORE_SHADE * f32::from(depth) / 255.0;
        let [r, g, b] = Colour { linear: colour.linear.map(|channel| light * channel) }.to_srgb8();
        [r, g, b, 255]
    });
    Image { width: TOOTH_SIDE, height: TOOTH_SIDE, pixels: pixels.collect() }
}

/// A column of pixels from `top` to `bottom`, mixed in linear light.
fn gradient(top: Colour, bottom: Colour) -> Image {
    let colour = |row: u32| {
        let down = row as f32 / (GRADIENT_ROWS - 1) as f32;
        let mix =
            |channel: usize| top.linear[channel] + (bottom.linear[channel] - top.linear[channel]) * down;
        Colour { linear: [mix(0), mix(1), mix(2)] }
    };
    let pixels = (0..GRADIENT_ROWS).flat_map(|row| {
        let [r, g, b] = colour(row).to_srgb8();
        [r, g, b, 255]
    });
    Image { width: 1, height: GRADIENT_ROWS, pixels: pixels.collect() }
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
