//! Which colours a picture has, and which of them every pixel is.

use rustc_hash::FxHashMap;

use crate::Image;

/// Alpha from which on a pixel is drawn.
const OPAQUE_ALPHA: u8 = 128;

/// The colours of a picture, each once, in the order in which they appear.
pub(super) struct Histogram {
    pub(super) colours: Vec<[u8; 3]>,
    /// How many pixels each colour fills.
    pub(super) counts: Vec<u32>,
    /// For every pixel its place in `colours`, or [`CLEAR`].
    pub(super) of_pixel: Vec<u32>,
}

/// Stands for a pixel that is not drawn.
pub(super) const CLEAR: u32 = u32::MAX;

impl Histogram {
    /// Counts the colours of `image`; if it may be `transparent`, only of what is drawn.
    pub(super) fn new(image: &Image, transparent: bool) -> Self {
        let mut colours = Vec::new();
        let mut counts = Vec::new();
        let mut places = FxHashMap::default();
        // Drawings hold long runs of one colour: those are looked up once.
        let mut run = None;
        let mut of_pixel = Vec::with_capacity(image.pixels.len() / 4);
        for [r, g, b, alpha] in image.rgba() {
            if transparent && alpha < OPAQUE_ALPHA {
                of_pixel.push(CLEAR);
                continue;
            }
            let colour = [r, g, b];
            let place = match run {
                Some((same, place)) if same == colour => place,
                _ => *places.entry(colour).or_insert_with(|| {
                    colours.push(colour);
                    counts.push(0);
                    colours.len() as u32 - 1
                }),
            };
            run = Some((colour, place));
            counts[place as usize] += 1;
            of_pixel.push(place);
        }
        Self { colours, counts, of_pixel }
    }
}
