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
        let mut run = ([0; 4], CLEAR);
        let mut of_pixel = Vec::with_capacity(image.pixels.len() / 4);
        for rgba in image.rgba() {
            if transparent && rgba[3] < OPAQUE_ALPHA {
                of_pixel.push(CLEAR);
                continue;
            }
            if run != (rgba, run.1) || run.1 == CLEAR {
                let [r, g, b, _] = rgba;
                let place = *places.entry([r, g, b]).or_insert_with(|| {
                    colours.push([r, g, b]);
                    counts.push(0);
                    colours.len() as u32 - 1
                });
                run = (rgba, place);
            }
            counts[run.1 as usize] += 1;
            of_pixel.push(run.1);
        }
        Self { colours, counts, of_pixel }
    }
}
