//! What strokes leave on paper: textures that run along them, from the hand's pressure alone (1 is all ink), before the
//! paper's tooth takes its share.

use std::collections::BTreeMap;

use fumetto_formats::Image;
use fumetto_scene::{StrokeTexture, limits::MAX_STROKE_PICTURES};

use super::paper::{TOOTH_SIDE, tooth, value_noise};
use crate::gpu::Gpu;

/// Texels along a texture and across it. The latter also in `polygon.wgsl`.
const SIZE: [u32; 2] = [1024, 64];

/// Heights along a named texture: bristles leave long streaks.
const LENGTH: f32 = 32.0;

const _: () = assert!(
    StrokeTexture::NAMED.len() + MAX_STROKE_PICTURES <= 256,
    "WebGPU's default for layers of an array"
);

/// All textures of a scene's strokes, and the paper that they are drawn on.
#[derive(Debug)]
pub(crate) struct StrokeTextures {
    pub(super) strokes: wgpu::TextureView,
    pub(super) tooth: wgpu::TextureView,
    /// Paths of those that come from files, and how often they are as long as high; their layers follow the named ones.
    files: Vec<(String, f32)>,
}

impl StrokeTextures {
    /// The named ones, and `images` from files.
    pub(crate) fn new(gpu: &Gpu, images: &BTreeMap<String, Image>) -> Self {
        let named = StrokeTexture::NAMED.map(|(_, texture)| painted(&texture));
        let layers: Vec<_> = named.into_iter().chain(images.values().map(resampled)).collect();
        Self {
            strokes: upload(gpu, "ink.stroke.textures", SIZE, &layers),
            tooth: upload(gpu, "ink.stroke.tooth", [TOOTH_SIDE; 2], &[tooth()]),
            files: images.iter().map(|(path, image)| (path.clone(), proportion(image))).collect(),
        }
    }

    /// Number of the texture's layer, and heights along it.
    pub(super) fn layer(&self, texture: &StrokeTexture) -> (u32, f32) {
        if let StrokeTexture::File(path) = texture
            && let Some(at) = self.files.iter().position(|(file, _)| file == path)
        {
            return ((StrokeTexture::NAMED.len() + at) as u32, self.files[at].1);
        }
        let named = StrokeTexture::NAMED.iter().position(|(_, named)| named == texture);
        (named.unwrap_or_default() as u32, LENGTH)
    }
}

fn proportion(image: &Image) -> f32 {
    image.width as f32 / image.height.max(1) as f32
}

/// A named texture, row by row.
fn painted(texture: &StrokeTexture) -> Vec<u8> {
    let [columns, rows] = SIZE;
    let texel = |at: u32| {
        let along = (at % columns) as f32 + 0.5;
        let across = 2.0 * ((at / columns) as f32 + 0.5) / rows as f32 - 1.0;
        // Nothing is left at the very edges.
        let share = left_by(texture, along / columns as f32, across) * smooth(1.0, 0.9, across.abs());
        (share.clamp(0.0, 1.0) * 255.0).round() as u8
    };
    (0..columns * rows).map(texel).collect()
}

/// Noise that repeats along the stroke, in cells of so many to its length and its half height.
fn noise(along: f32, across: f32, cells: [u32; 2], seed: u32) -> f32 {
    let [columns, rows] = cells;
    value_noise([along * columns as f32, (across + 4.0) * rows as f32], [columns, 8 * rows], seed)
}

fn smooth(from: f32, to: f32, value: f32) -> f32 {
    let share = ((value - from) / (to - from)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// How much is left at a place: `along` from 0 to 1, `across` from -1 (outside of the body) to 1.
fn left_by(texture: &StrokeTexture, along: f32, across: f32) -> f32 {
    let edge = |cells, seed| noise(along, 0.0, [cells, 1], seed);
    match texture {
        StrokeTexture::Pencil => {
            // A blunt point: dense within, with a few lines of its own facets.
            let aside = across + 0.25 * (edge(14, 1) - 0.5);
            let body = (-(aside.abs() / 0.62).powi(3)).exp();
            let facets = 0.72 + 0.4 * noise(along, across, [30, 9], 2);
            body * facets
        }
        StrokeTexture::Brush => {
            // Edges are crisp; bristles show in a few long streaks.
            let rim = 0.8 + 0.14 * (edge(22, 3) - 0.5) + 0.04 * (edge(110, 4) - 0.5);
            let body = smooth(rim + 0.05, rim - 0.05, across.abs());
            let streaks = noise(along, across, [6, 13], 5) * (0.55 + 0.45 * across.abs());
            let dry = smooth(0.5, 0.85, edge(7, 6)) * smooth(0.52, 0.66, streaks);
            body * (1.0 - 0.85 * dry)
        }
        StrokeTexture::Charcoal => {
            // The side of a stick: one edge bites, the other fades into dust.
            let rim = 0.75 + 0.3 * (edge(160, 7) - 0.5) + 0.2 * (edge(30, 8) - 0.5);
            let bite = (-((across + 0.45) / 0.3).powi(2)).exp();
            let dust = smooth(rim + 0.25, rim - 0.35, across.abs());
            dust * (0.5 + 0.35 * bite + 0.5 * (noise(along, across, [120, 5], 9) - 0.5))
        }
        StrokeTexture::Chalk => {
            let rim = 0.86 + 0.2 * (edge(200, 10) - 0.5);
            let body = smooth(rim + 0.06, rim - 0.08, across.abs());
            body * (0.5 + 0.5 * noise(along, across, [200, 8], 11))
        }
        StrokeTexture::Dashes => {
            // Nine to a length, each thicker where it is begun.
            let share = 9.0 * along - (9.0 * along).floor();
            let ends = (smooth(0.04, 0.1, share) * smooth(0.66, 0.5, share)).sqrt();
            let rim = 0.8 * ends * (1.0 - 0.35 * share);
            if rim > 0.05 { smooth(rim + 0.08, rim - 0.08, across.abs()) } else { 0.0 }
        }
        StrokeTexture::File(_) => 0.0,
    }
}

/// A picture's ink: what is dark, or opaque where it has an alpha channel; each texel the mean of what it covers.
fn resampled(image: &Image) -> Vec<u8> {
    let has_alpha = image.pixels.chunks_exact(4).any(|pixel| pixel[3] < 255);
    let ink = |x: u32, y: u32| {
        let at = 4 * (y as usize * image.width as usize + x as usize);
        let [r, g, b, a] = [0, 1, 2, 3].map(|channel| f32::from(image.pixels[at + channel]) / 255.0);
        // Rec. 709's weights, of encoded values: near enough for how dark ink looks.
        if has_alpha { a } else { 1.0 - (0.2126 * r + 0.7152 * g + 0.0722 * b) }
    };
    let covered = |index: u32, count: u32, side: u32| {
        let first = (u64::from(index) * u64::from(side) / u64::from(count)) as u32;
        let end = (u64::from(index + 1) * u64::from(side)).div_ceil(u64::from(count)) as u32;
        first..end.max(first + 1).min(side)
    };
    let [columns, rows] = SIZE;
    let texel = |at: u32| {
        let (xs, ys) =
            (covered(at % columns, columns, image.width), covered(at / columns, rows, image.height));
        let count = (xs.len() * ys.len()) as f32;
        let sum: f32 = ys.flat_map(|y| xs.clone().map(move |x| (x, y))).map(|(x, y)| ink(x, y)).sum();
        (255.0 * sum / count).round() as u8
    };
    (0..columns * rows).map(texel).collect()
}

/// Half as large in both directions.
fn halved(texels: &[u8], [width, height]: [u32; 2]) -> Vec<u8> {
    let at = |x: u32, y: u32| u16::from(texels[(y.min(height - 1) * width + x.min(width - 1)) as usize]);
    let (columns, rows) = ((width / 2).max(1), (height / 2).max(1));
    let texel = |index: u32| {
        let (x, y) = (2 * (index % columns), 2 * (index / columns));
        ((at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1) + 2) / 4) as u8
    };
    (0..columns * rows).map(texel).collect()
}

/// As an array with all its mip levels.
fn upload(gpu: &Gpu, label: &str, size: [u32; 2], layers: &[Vec<u8>]) -> wgpu::TextureView {
    let levels = size[0].min(size[1]).ilog2() + 1;
    let extent = |[width, height]: [u32; 2]| wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { depth_or_array_layers: layers.len() as u32, ..extent(size) },
        mip_level_count: levels,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::R8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for (layer, texels) in (0..).zip(layers) {
        let (mut texels, mut size) = (texels.clone(), size);
        for mip_level in 0..levels {
            let to = wgpu::TexelCopyTextureInfo {
                mip_level,
                origin: wgpu::Origin3d { x: 0, y: 0, z: layer },
                ..texture.as_image_copy()
            };
            let layout =
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(size[0]), rows_per_image: None };
            gpu.queue.write_texture(to, &texels, layout, extent(size));
            texels = halved(&texels, size);
            size = size.map(|side| (side / 2).max(1));
        }
    }
    let dimension =
        if layers.len() > 1 { wgpu::TextureViewDimension::D2Array } else { wgpu::TextureViewDimension::D2 };
    texture.create_view(&wgpu::TextureViewDescriptor { dimension: Some(dimension), ..Default::default() })
}
