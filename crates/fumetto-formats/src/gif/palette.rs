//! From true colour to a palette, with the colours of the drawing kept exact.

use std::cmp::Reverse;

use color_quant::NeuQuant;
use rustc_hash::FxHashSet;

use super::histogram::{CLEAR, Histogram};
use crate::Image;

/// Entries of a GIF's palette.
const PALETTE_SIZE: usize = 256;

/// Pixels that the quantiser learns from, at least if there are as many: enough for colours between
/// flat tones, and a few milliseconds.
const LEARNT_PIXELS: usize = 10_000;

/// The coarsest sampling that the quantiser takes: every so many-th pixel.
const MAX_SAMPLE_STEP: i32 = 30;

/// A picture as a GIF stores it.
pub(super) struct Indexed {
    /// Colours, from the first entry on.
    pub(super) palette: Vec<[u8; 3]>,
    /// For every pixel its entry.
    pub(super) indices: Vec<u8>,
    /// The entry of pixels that are not drawn.
    pub(super) transparent: Option<u8>,
}

/// Finds a palette for `image` in which the colours of `keep` are exact, and indexes the pixels.
pub(super) fn index(image: &Image, transparent: bool, keep: &[[u8; 3]]) -> Indexed {
    let histogram = Histogram::new(image, transparent);
    // The first entry stands for transparency; its colour is never seen.
    let mut palette = if transparent { vec![[0; 3]] } else { Vec::new() };
    let first = palette.len();
    let room = PALETTE_SIZE - first;
    if histogram.colours.len() <= room {
        palette.extend_from_slice(&histogram.colours);
        let indices = histogram.of_pixel.iter().map(|&place| entry(place, |place| place + first)).collect();
        return Indexed { palette, indices, transparent: transparent.then_some(0) };
    }
    palette.extend(reduced(&histogram, keep, room));
    let nearest = Nearest::new(&palette[first..]);
    let entries: Vec<usize> = histogram.colours.iter().map(|&colour| nearest.find(colour) + first).collect();
    let indices = histogram.of_pixel.iter().map(|&place| entry(place, |place| entries[place])).collect();
    Indexed { palette, indices, transparent: transparent.then_some(0) }
}

/// The palette entry of a pixel: the first one if it is not drawn.
fn entry(place: u32, of_colour: impl Fn(usize) -> usize) -> u8 {
    if place == CLEAR { 0 } else { of_colour(place as usize) as u8 }
}

/// At most `room` colours for a picture that has more: first those of `keep` that appear in it.
fn reduced(histogram: &Histogram, keep: &[[u8; 3]], room: usize) -> Vec<[u8; 3]> {
    let keep: FxHashSet<_> = keep.iter().copied().collect();
    let is_kept: Vec<bool> = histogram.colours.iter().map(|colour| keep.contains(colour)).collect();
    let mut kept: Vec<usize> = (0..is_kept.len()).filter(|&place| is_kept[place]).collect();
    kept.sort_by_key(|&place| Reverse(histogram.counts[place]));
    kept.truncate(room);
    let mut colours: Vec<[u8; 3]> = kept.into_iter().map(|place| histogram.colours[place]).collect();

    let rest: Vec<u8> = histogram
        .of_pixel
        .iter()
        .filter(|&&place| place != CLEAR && !is_kept[place as usize])
        .flat_map(|&place| {
            let [r, g, b] = histogram.colours[place as usize];
            [r, g, b, u8::MAX]
        })
        .collect();
    let room = room - colours.len();
    if room > 0 && !rest.is_empty() {
        let step = (rest.len() / 4 / LEARNT_PIXELS).clamp(1, MAX_SAMPLE_STEP as usize) as i32;
        let learnt = NeuQuant::new(step, room, &rest).color_map_rgb();
        colours.extend_from_slice(learnt.as_chunks().0);
    }
    colours
}

/// Finds the nearest of a few colours.
///
/// One channel beside the other, so that the compiler measures several distances at a time.
struct Nearest {
    r: Vec<i32>,
    g: Vec<i32>,
    b: Vec<i32>,
}

impl Nearest {
    fn new(palette: &[[u8; 3]]) -> Self {
        let channel = |c: usize| palette.iter().map(|colour| i32::from(colour[c])).collect();
        Self { r: channel(0), g: channel(1), b: channel(2) }
    }

    /// The place of the colour nearest to `colour` in sRGB; the first of several.
    fn find(&self, colour: [u8; 3]) -> usize {
        let [r, g, b] = colour.map(i32::from);
        let distances = self.r.iter().zip(&self.g).zip(&self.b);
        // Distance and place in one number: the smallest of all is the answer.
        let key = |(place, ((pr, pg), pb)): (usize, ((&i32, &i32), &i32))| {
            let distance = (pr - r).pow(2) + (pg - g).pow(2) + (pb - b).pow(2);
            distance * PALETTE_SIZE as i32 + place as i32
        };
        let least = distances.enumerate().map(key).min().unwrap_or(0);
        least as usize % PALETTE_SIZE
    }
}
