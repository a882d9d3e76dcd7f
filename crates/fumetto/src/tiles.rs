//! How a picture is cut that is too large to be drawn at once.
//!
//! Every tile is drawn with a margin around it, as wide as passes look around a pixel, and counts pixels from
//! the picture's top left where that matters. So it shows what the whole picture would show there.

use crate::{gpu::Region, ink::InkAround};

/// Samples along a side of what is drawn at once, unless margins ask for more: 4096 by 4096 take 1 GB or so.
const SIDE: u32 = 4096;

/// More samples than this are not drawn at once: a picture of 3840 by 2160 pixels is, with 2 by 2 samples each.
const MOST_SAMPLES: u64 = 1 << 25;

/// Tiles begin at multiples of this many samples: where whole pixels do that have 1 to 4 samples along a side,
/// and texels of the layers that are coarser than the picture.
const ALIGNED: u32 = 48;

/// Samples along the longer side of a survey.
const SURVEY_SIDE: u32 = 2048;

/// What is drawn of a picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part<'a> {
    pub(crate) region: Region,
    pub(crate) survey: Option<&'a Survey>,
}

/// How much ink there is around in the whole picture, from a smaller drawing of it: which lines are too short to
/// read cannot be told from a tile.
#[derive(Debug)]
pub(crate) struct Survey {
    /// Of the drawing, in samples.
    pub(crate) height: u32,
    /// Of each cel.
    pub(crate) arounds: Vec<InkAround>,
}

impl Survey {
    /// What is known of a cel, and the side of a cell in samples of the picture that `region` is of.
    pub(crate) fn around(&self, cel: usize, region: Region) -> Option<(&InkAround, f32)> {
        let scale = region.picture[1] as f32 / self.height as f32;
        self.arounds.get(cel).map(|around| (around, around.cell as f32 * scale))
    }

    /// The size of the drawing that tells of a picture of `size` samples.
    pub(crate) fn size(size: [u32; 2]) -> [u32; 2] {
        let longer = size[0].max(size[1]);
        let scaled = |side: u32| (u64::from(side) * u64::from(SURVEY_SIDE) / u64::from(longer)).max(1) as u32;
        if longer <= SURVEY_SIDE { size } else { size.map(scaled) }
    }
}

/// How large a piece of a picture may be that is drawn at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tiling {
    /// Most samples along a side, margins included; more where the margins ask for it.
    pub side: u32,
    /// Most samples in all of a picture that is not cut.
    pub most: u64,
}

impl Default for Tiling {
    fn default() -> Self {
        Self { side: SIDE, most: MOST_SAMPLES }
    }
}

impl Tiling {
    /// Whether a picture of `samples` is drawn at once, on a device whose textures may be `allowed` long.
    #[must_use]
    pub fn takes(&self, samples: [u32; 2], allowed: u32) -> bool {
        let [width, height] = samples;
        u64::from(width) * u64::from(height) <= self.most && width.max(height) <= allowed
    }
}

/// The tiles of a picture, row after row from the top left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Tiles {
    /// All sizes count samples.
    picture: [u32; 2],
    /// Of a tile without its margin; a last one may be smaller.
    inner: [u32; 2],
    margin: u32,
}

/// A tile: what is drawn for it, and what of that is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Tile {
    pub(crate) region: Region,
    /// Where in the picture it begins.
    pub(crate) first: [u32; 2],
    pub(crate) size: [u32; 2],
}

impl Tiles {
    /// Cuts a picture of `picture` samples whose pixels depend on others up to `reach_px` away, on a device whose
    /// textures may be `allowed` long. `None` where the margins would not fit.
    pub(crate) fn new(tiling: Tiling, picture: [u32; 2], reach_px: f32, allowed: u32) -> Option<Self> {
        if tiling.takes(picture, allowed) {
            return Some(Self { picture, inner: picture, margin: 0 });
        }
        let margin = (reach_px.ceil() as u32).min(allowed).next_multiple_of(ALIGNED);
        // Margins at most double what is drawn.
        let side = tiling.side.max(margin.saturating_mul(7)).min(allowed);
        let inner = side.checked_sub(margin.saturating_mul(2))? / ALIGNED * ALIGNED;
        // A row of tiles that is a little too long is not worth a tile more.
        let even = |side: u32| side.div_ceil(side.div_ceil(inner.max(1))).next_multiple_of(ALIGNED);
        (inner > 0).then(|| Self { picture, inner: picture.map(even), margin })
    }

    /// Tiles in a row, and rows.
    pub(crate) fn grid(&self) -> [u32; 2] {
        [0, 1].map(|axis| self.picture[axis].div_ceil(self.inner[axis]))
    }

    /// Whether the picture is drawn at once.
    pub(crate) fn is_whole(&self) -> bool {
        self.grid() == [1, 1]
    }

    pub(crate) fn tile(&self, column: u32, row: u32) -> Tile {
        let first = [column * self.inner[0], row * self.inner[1]];
        let end = [0, 1].map(|axis| (first[axis] + self.inner[axis]).min(self.picture[axis]));
        let low = first.map(|side| side.saturating_sub(self.margin));
        let high = [0, 1].map(|axis| (end[axis] + self.margin).min(self.picture[axis]));
        let between = |low: [u32; 2], high: [u32; 2]| [high[0] - low[0], high[1] - low[1]];
        let region = Region { picture: self.picture, first: low, size: between(low, high) };
        Tile { region, first, size: between(first, end) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALLOWED: u32 = 8192;

    fn cut(picture: [u32; 2], reach_px: f32) -> Tiles {
        Tiles::new(Tiling::default(), picture, reach_px, ALLOWED).expect("its margins fit")
    }

    #[test]
    fn what_fits_is_not_cut() {
        assert!(cut([7680, 4320], 900.0).is_whole());
        assert!(cut([8192, 4096], 0.0).is_whole());
        assert!(!cut([8192, 8192], 0.0).is_whole());
        assert!(!cut([8193, 8], 0.0).is_whole());
    }

    #[test]
    fn tiles_cover_the_picture_once_and_their_margins_lie_in_it() {
        for (picture, reach_px) in [([24_000, 18_000], 390.0), ([8193, 17], 1.0), ([36_001, 131_072], 1300.0)]
        {
            let tiles = cut(picture, reach_px);
            let [columns, rows] = tiles.grid();
            let mut end = [0, 0];
            for row in 0..rows {
                for column in 0..columns {
                    let Tile { region, first, size } = tiles.tile(column, row);
                    assert_eq!(first[0], if column == 0 { 0 } else { end[0] });
                    assert!(row == 0 || first[1] > 0);
                    end = [first[0] + size[0], first[1] + size[1]];
                    for axis in [0, 1] {
                        let region_end = region.first[axis] + region.size[axis];
                        assert!(region.first[axis] % ALIGNED == 0 && region.size[axis] <= ALLOWED);
                        let margins = [first[axis] - region.first[axis], region_end - end[axis]];
                        let room = [first[axis], picture[axis] - end[axis]];
                        for (margin, room) in margins.into_iter().zip(room) {
                            assert!(margin == room || margin as f32 >= reach_px, "{margin} of {room}");
                        }
                    }
                }
                assert_eq!(end[0], picture[0]);
            }
            assert_eq!(end, picture);
        }
    }

    #[test]
    fn margins_that_leave_nothing_are_refused() {
        assert_eq!(Tiles::new(Tiling::default(), [9000, 9000], 4096.0, ALLOWED), None);
        assert_eq!(Tiles::new(Tiling::default(), [9000, 9000], f32::INFINITY, ALLOWED), None);
    }
}
