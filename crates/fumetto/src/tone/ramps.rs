//! Ramps: rows of colours for each object, dark to light.

use std::{collections::BTreeMap, ops::Range};

use fumetto_formats::Image;
use fumetto_scene::{Object, Ramp, RampImage, RampRows, Tone};
use wgpu::util::DeviceExt as _;

use super::tones::ToneStyle;
use crate::gpu::Gpu;

/// Amounts of light that a ramp tells apart.
const COLUMNS: u32 = 1024;

/// Most rows of a ramp's picture that count: as many for every object, after one for each, fit a texture of
/// `WebGPU`'s default limits.
const MAX_ROWS: u32 = 128;

type Texel = [u8; 4];

/// All objects' ramps as a texture, sRGB as it will be in the picture.
#[derive(Debug)]
pub(crate) struct Ramps {
    /// A row for each object; below these, the rows of ramps that have more than one.
    pub(crate) view: wgpu::TextureView,
    /// `ToneStyle`s of `tones.wgsl`.
    pub(crate) tones: wgpu::Buffer,
}

impl Ramps {
    /// `images` gives the pictures that ramps name.
    pub(crate) fn new(gpu: &Gpu, objects: &[Object], images: &BTreeMap<String, Image>) -> Self {
        let mut texels: Vec<Texel> = Vec::with_capacity((objects.len() * COLUMNS as usize).max(1));
        for object in objects {
            match &object.style.ramp {
                Ramp::Tones(tones) => texels.extend(row(|amount| tone_at(tones, amount))),
                Ramp::Image(RampImage { path, .. }) => {
                    let image = image_of(images, path);
                    texels.extend(row(|amount| image_at(image, amount, 0.5)));
                }
                // Such an object has a smooth ramp, which is worked out pixel by pixel.
                Ramp::Gooch(_) => texels.extend(row(|_| [0; 4])),
            }
        }
        let rows: Vec<_> = objects.iter().map(|object| add_rows(&mut texels, object, images)).collect();
        let tones = gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("tone.tones"),
            contents: bytemuck::bytes_of(&ToneStyle::list(objects, &rows)),
            usage: wgpu::BufferUsages::UNIFORM,
        });
        Self { view: upload(gpu, &texels), tones }
    }
}

/// Adds the rows of an object's ramp where all of them count. Answers with their numbers.
fn add_rows(texels: &mut Vec<Texel>, object: &Object, images: &BTreeMap<String, Image>) -> Range<u32> {
    let first = texels.len() as u32 / COLUMNS;
    let Ramp::Image(RampImage { path, rows }) = &object.style.ramp else { return first..first };
    if *rows == RampRows::Middle {
        return first..first;
    }
    let image = image_of(images, path);
    let count = image.height.min(MAX_ROWS);
    for number in 0..count {
        let down = (number as f32 + 0.5) / count as f32;
        texels.extend(row(|amount| image_at(image, amount, down)));
    }
    first..first + count
}

fn image_of<'a>(images: &'a BTreeMap<String, Image>, path: &str) -> &'a Image {
    images.get(path).expect("a ramp image is read before its ramp is made")
}

fn row(colour: impl Fn(f32) -> Texel) -> impl Iterator<Item = Texel> {
    (0..COLUMNS).map(move |column| colour((column as f32 + 0.5) / COLUMNS as f32))
}

/// The colour of the lightest tone that begins at or before `amount`.
fn tone_at(tones: &[Tone], amount: f32) -> Texel {
    let after = tones.partition_point(|tone| tone.from <= amount);
    let [r, g, b] = tones[after.saturating_sub(1)].colour.to_srgb8();
    [r, g, b, 255]
}

/// The colour `right` of the left side and `down` from the top, as shares.
fn image_at(image: &Image, right: f32, down: f32) -> Texel {
    let at = |share: f32, count: u32| ((share * count as f32) as u32).min(count - 1);
    let at = 4 * (at(down, image.height) * image.width + at(right, image.width)) as usize;
    [image.pixels[at], image.pixels[at + 1], image.pixels[at + 2], 255]
}

fn upload(gpu: &Gpu, texels: &[Texel]) -> wgpu::TextureView {
    let rows = texels.len() as u32 / COLUMNS;
    let size = wgpu::Extent3d { width: COLUMNS, height: rows.max(1), depth_or_array_layers: 1 };
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
    if rows > 0 {
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * COLUMNS), rows_per_image: None };
        gpu.queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(texels), layout, size);
    }
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
