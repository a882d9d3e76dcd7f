//! Layers as pictures, for other programs and for the curious.

use std::{fmt, ops::Range, str::FromStr};

use fumetto_formats::Image;
use half::f16;

use crate::{
    gpu::{Gpu, GpuError, Transient, read_texture_async},
    shapes::puffs::Atlas,
};

/// A drawing layer that can be taken as a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// World-space normals, from -1 to 1 as 0 to 255; transparent where there is nothing.
    Normal,
    /// Distance along the line of sight, the nearest white, the farthest dark grey; transparent where
    /// there is nothing.
    Depth,
    /// A colour of its own for every puff that is seen.
    Id,
    /// White where there is something.
    Alpha,
    /// White where there is ink.
    Ink,
}

impl Layer {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Normal, Self::Depth, Self::Id, Self::Alpha, Self::Ink];

    const fn name(self) -> &'static str {
        match self {
            Self::Normal => "normal",
            Self::Depth => "depth",
            Self::Id => "id",
            Self::Alpha => "alpha",
            Self::Ink => "ink",
        }
    }
}

impl fmt::Display for Layer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// There is no layer of that name.
#[derive(Clone, Debug, thiserror::Error)]
#[error("there is no layer `{0}`; there are normal, depth, id, alpha and ink")]
pub struct UnknownLayer(String);

impl FromStr for Layer {
    type Err = UnknownLayer;

    fn from_str(name: &str) -> Result<Self, UnknownLayer> {
        Self::ALL.into_iter().find(|layer| layer.name() == name).ok_or_else(|| UnknownLayer(name.to_owned()))
    }
}

/// What was filled, to be read back.
#[derive(Debug)]
pub(crate) struct Proof {
    pub(crate) depth: Transient,
    pub(crate) id: Transient,
    pub(crate) normal: Transient,
    pub(crate) ink: Transient,
    /// Numbers of puffs that stand for one thing, each.
    pub(crate) lobes: Vec<Range<u32>>,
}

impl Proof {
    /// One of the layers as a picture.
    pub(crate) async fn picture(&self, gpu: &Gpu, layer: Layer) -> Result<Image, GpuError> {
        let texture = match layer {
            Layer::Normal => self.normal.texture(),
            Layer::Depth => self.depth.texture(),
            Layer::Id | Layer::Alpha => self.id.texture(),
            Layer::Ink => self.ink.texture(),
        };
        let bytes = read_texture_async(gpu, texture).await?;
        let pixels = match layer {
            Layer::Normal => normal_pixels(&bytes),
            Layer::Depth => depth_pixels(&bytes),
            Layer::Id => words(&bytes).flat_map(|id| id_colour(self.thing(id))).collect(),
            Layer::Alpha => words(&bytes).flat_map(|id| mask_colour(id != 0)).collect(),
            Layer::Ink => bytes.chunks_exact(2).flat_map(|mark| mask_colour(mark[0] != 0)).collect(),
        };
        Ok(Image { width: texture.width(), height: texture.height(), pixels })
    }

    /// One number for all that stand for the same.
    fn thing(&self, id: u32) -> u32 {
        let whole = self.lobes.iter().find(|lobes| id > 0 && lobes.contains(&(id - 1)));
        whole.map_or(id, |lobes| lobes.start + 1)
    }
}

fn words(bytes: &[u8]) -> impl Iterator<Item = u32> {
    bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]))
}

fn mask_colour(on: bool) -> [u8; 4] {
    if on { [255; 4] } else { [0, 0, 0, 255] }
}

/// Neighbouring numbers get colours far apart, never black.
fn id_colour(id: u32) -> [u8; 4] {
    let [r, g, b, _] = id.wrapping_mul(0x9e37_79b1).rotate_left(11).to_le_bytes();
    if id == 0 { [0; 4] } else { [r | 32, g | 32, b | 32, 255] }
}

fn normal_pixels(bytes: &[u8]) -> Vec<u8> {
    let component = |half: &[u8]| f16::from_le_bytes([half[0], half[1]]).to_f32();
    let pixel = |texel: &[u8]| {
        let normal = [0, 2, 4].map(|at| component(&texel[at..at + 2]));
        let byte = |axis: usize| (127.5 + 127.5 * normal[axis]).round() as u8;
        if normal == [0.0; 3] { [0; 4] } else { [byte(0), byte(1), byte(2), 255] }
    };
    bytes.chunks_exact(8).flat_map(pixel).collect()
}

fn depth_pixels(bytes: &[u8]) -> Vec<u8> {
    // Reverse-Z: the distance is in proportion to the inverse.
    let distances: Vec<f32> = words(bytes).map(|bits| 1.0 / f32::from_bits(bits)).collect();
    let filled = || distances.iter().copied().filter(|distance| distance.is_finite());
    let (nearest, farthest) = (filled().fold(f32::MAX, f32::min), filled().fold(0.0, f32::max));
    let span = (farthest - nearest).max(f32::MIN_POSITIVE);
    let pixel = |&distance: &f32| {
        // The farthest stays apart from black.
        let grey = (255.0 - 215.0 * (distance - nearest) / span).round() as u8;
        if distance.is_finite() { [grey, grey, grey, 255] } else { [0; 4] }
    };
    distances.iter().flat_map(pixel).collect()
}

/// The atlas's largest tiles as pictures: normals, height, and where the puffs are.
pub(crate) async fn atlas_pictures(gpu: &Gpu, atlas: &Atlas) -> Result<Vec<(&'static str, Image)>, GpuError> {
    let (width, height) = (atlas.texture.width(), atlas.tile_px);
    let bytes = read_texture_async(gpu, &atlas.texture).await?;
    let tiles = &bytes[..4 * (width * height) as usize];
    let picture = |pixel: fn([u8; 4]) -> [u8; 4]| {
        let texels = tiles.chunks_exact(4);
        Image { width, height, pixels: texels.flat_map(|t| pixel([t[0], t[1], t[2], t[3]])).collect() }
    };
    Ok(vec![
        ("normal", picture(|texel| if is_puff(texel) { atlas_normal(texel) } else { [0; 4] })),
        ("depth", picture(|texel| if is_puff(texel) { [texel[2], texel[2], texel[2], 255] } else { [0; 4] })),
        ("coverage", picture(|texel| mask_colour(is_puff(texel)))),
    ])
}

/// The margin, from -0.5 to 1 as 0 to 255, is above zero.
fn is_puff(texel: [u8; 4]) -> bool {
    texel[3] > 85
}

fn atlas_normal(texel: [u8; 4]) -> [u8; 4] {
    let [x, y] = [texel[0], texel[1]].map(|byte| f32::from(byte) / 127.5 - 1.0);
    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
    [texel[0], texel[1], (127.5 + 127.5 * z).round() as u8, 255]
}
