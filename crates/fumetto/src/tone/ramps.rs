//! Ramps: one row of colours for each object, dark to light.

use fumetto_formats::Image;
use fumetto_scene::{Ramp, Tone};

use crate::gpu::Gpu;

/// Amounts of light that a ramp tells apart.
const COLUMNS: u32 = 1024;

/// All objects' ramps as a texture, sRGB as it will be in the picture.
#[derive(Debug)]
pub(crate) struct Ramps {
    pub(crate) view: wgpu::TextureView,
}

impl Ramps {
    /// `ramps` gives each object's, with its image where it is one.
    pub(crate) fn new(gpu: &Gpu, ramps: &[(&Ramp, Option<Image>)]) -> Self {
        let mut texels: Vec<[u8; 4]> = Vec::with_capacity(ramps.len() * COLUMNS as usize);
        for (ramp, image) in ramps {
            for column in 0..COLUMNS {
                let amount = (column as f32 + 0.5) / COLUMNS as f32;
                texels.push(match (ramp, image) {
                    (_, Some(image)) => image_at(image, amount),
                    (Ramp::Tones(tones), None) => tone_at(tones, amount),
                    (Ramp::Image(_), None) => unreachable!("a ramp image is read before its ramp is made"),
                });
            }
        }
        let size =
            wgpu::Extent3d { width: COLUMNS, height: ramps.len().max(1) as u32, depth_or_array_layers: 1 };
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("tone.ramps"),
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        if !ramps.is_empty() {
            let layout = wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(4 * COLUMNS),
                rows_per_image: None,
            };
            gpu.queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(&texels), layout, size);
        }
        Self { view: texture.create_view(&wgpu::TextureViewDescriptor::default()) }
    }
}

/// The colour of the lightest tone that begins at or before `amount`.
fn tone_at(tones: &[Tone], amount: f32) -> [u8; 4] {
    let after = tones.partition_point(|tone| tone.from <= amount);
    let [r, g, b] = tones[after.saturating_sub(1)].colour.to_srgb8();
    [r, g, b, 255]
}

fn image_at(image: &Image, amount: f32) -> [u8; 4] {
    let column = ((amount * image.width as f32) as u32).min(image.width - 1);
    let row = image.height / 2;
    let at = 4 * (row * image.width + column) as usize;
    [image.pixels[at], image.pixels[at + 1], image.pixels[at + 2], 255]
}
