//! How much lines flicker: what changes from one picture to the next and is not explained by motion.
//!
//! Around each place on a line, a patch is looked for in the other picture, as far as matter may have moved. What
//! remains of the difference at the best place is flicker. Lines that only move leave next to nothing.

/// Ink that counts as a line, of 255.
const LINE: u8 = 48;

/// Pixels to each side of a patch's middle.
const PATCH: i64 = 3;

/// Pixels in a row and column of which one is looked at.
const EVERY: usize = 2;

/// The share of the ink around lines that changes between two pictures of dark lines on white, both ways, where
/// nothing moves farther than `motion` pixels.
pub(crate) fn flicker(before: &Ink, after: &Ink, motion: i64) -> f64 {
    let ways = [before.unexplained(after, motion), after.unexplained(before, motion)];
    let [changed, all] =
        ways.into_iter().fold([0.0; 2], |[changed, all], way| [changed + way[0], all + way[1]]);
    if all > 0.0 { changed / all } else { 0.0 }
}

/// How dark a picture is.
pub(crate) struct Ink {
    size: [i64; 2],
    dark: Vec<u8>,
}

impl Ink {
    /// Of a picture of four bytes a pixel.
    pub(crate) fn new(size: [u32; 2], pixels: &[u8]) -> Self {
        let dark = pixels.chunks_exact(4).map(|pixel| 255 - pixel[1]).collect();
        Self { size: size.map(i64::from), dark }
    }

    fn at(&self, x: i64, y: i64) -> u8 {
        let [width, height] = self.size;
        let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
        if is_inside { self.dark[(y * width + x) as usize] } else { 0 }
    }

    /// What changes and what there is, around places on lines.
    fn unexplained(&self, other: &Self, motion: i64) -> [f64; 2] {
        let [width, height] = self.size;
        let mut sums = [0.0; 2];
        for y in (0..height).step_by(EVERY) {
            for x in (0..width).step_by(EVERY) {
                if self.at(x, y) >= LINE {
                    let [changed, all] = self.best(other, [x, y], motion);
                    sums = [sums[0] + f64::from(changed), sums[1] + f64::from(all)];
                }
            }
        }
        sums
    }

    /// Likewise of the patch around a place, moved to where it fits best.
    fn best(&self, other: &Self, [x, y]: [i64; 2], motion: i64) -> [u32; 2] {
        let patch = || (-PATCH..=PATCH).flat_map(|v| (-PATCH..=PATCH).map(move |u| (u, v)));
        let all = patch().map(|(u, v)| u32::from(self.at(x + u, y + v))).sum();
        let mut best = u32::MAX;
        for down in -motion..=motion {
            for right in -motion..=motion {
                let mut changed = 0;
                for (u, v) in patch() {
                    let there = other.at(x + right + u, y + down + v);
                    changed += u32::from(self.at(x + u, y + v).abs_diff(there));
                    if changed >= best {
                        break;
                    }
                }
                best = best.min(changed);
            }
        }
        [best, all]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ring with a mark every so many degrees, somewhere on a white picture.
    fn ring(middle: [f64; 2], turned_deg: f64) -> Ink {
        let pixel = |index: usize| {
            let [x, y] = [(index % 80) as f64 - middle[0], (index / 80) as f64 - middle[1]];
            let on_ring = (x.hypot(y) - 25.0).abs() < 2.0;
            let on_mark = (y.atan2(x).to_degrees() + turned_deg).rem_euclid(30.0) < 12.0;
            let light = if on_ring && on_mark { 0 } else { 255 };
            [light, light, light, 255]
        };
        Ink::new([80, 80], &(0..80 * 80).flat_map(pixel).collect::<Vec<_>>())
    }

    #[test]
    fn motion_is_no_flicker_and_change_is() {
        let still = ring([40.0, 40.0], 0.0);
        assert!(flicker(&still, &still, 4) == 0.0);
        assert!(flicker(&still, &ring([43.0, 38.0], 0.0), 4) < 1e-9);
        let unlike = flicker(&still, &ring([40.0, 40.0], 15.0), 1);
        assert!(unlike > 0.3, "{unlike}");
    }
}
