//! The middles of lines that are only known as samples.
//!
//! Zhang & Suen, "A Fast Parallel Algorithm for Thinning Digital Patterns", 1984: a line loses its rim again and again
//! until one sample is left of its width.

use kurbo::{PathSeg, Point};

use super::smooth::Hand;

/// Samples around one, clockwise from the one above.
const AROUND: [[i32; 2]; 8] = [[0, -1], [1, -1], [1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1]];

/// The order in which ways on are tried: straight ones first, so that no corner is cut.
const STRAIGHT_FIRST: [usize; 8] = [0, 2, 4, 6, 1, 3, 5, 7];

/// A picture of samples that are inked or not, with an empty rim.
struct Mask {
    width: usize,
    inked: Vec<bool>,
}

/// Curves along the middles of what is inked, in samples, and how wide that is on average.
pub(super) fn middles(size: [usize; 2], inked: impl Fn(usize) -> bool) -> (Vec<Vec<PathSeg>>, f64) {
    let [width, height] = size;
    let mut mask = Mask { width: width + 2, inked: vec![false; (width + 2) * (height + 2)] };
    let mut samples: Vec<usize> = Vec::new();
    for index in (0..width * height).filter(|&index| inked(index)) {
        let at = (index / width + 1) * mask.width + index % width + 1;
        mask.inked[at] = true;
        samples.push(at);
    }
    let area = samples.len() as f64;
    let middle = mask.thin(samples);
    let mean = area / (middle.len() as f64).max(1.0);
    let ways = mask.ways(&middle, (1.5 * mean) as usize);
    let point = |&at: &usize| Point::new((at % mask.width) as f64 - 0.5, (at / mask.width) as f64 - 0.5);
    let curves =
        ways.iter().map(|way| Hand::INK.open(&way.iter().map(point).collect::<Vec<_>>(), [None, None]));
    (curves.collect(), mean)
}

impl Mask {
    fn beside(&self, at: usize, way: usize) -> usize {
        let [x, y] = AROUND[way];
        at.wrapping_add_signed(x as isize + y as isize * self.width as isize)
    }

    fn around(&self, at: usize) -> [bool; 8] {
        std::array::from_fn(|way| self.inked[self.beside(at, way)])
    }

    /// Takes the rim off until nothing changes. Answers with what is left.
    fn thin(&mut self, mut samples: Vec<usize>) -> Vec<usize> {
        loop {
            let before = samples.len();
            for second in [false, true] {
                let goes: Vec<usize> =
                    samples.iter().copied().filter(|&at| is_rim(self.around(at), second)).collect();
                goes.iter().for_each(|&at| self.inked[at] = false);
                samples.retain(|&at| self.inked[at]);
            }
            if samples.len() == before {
                return samples;
            }
        }
    }

    /// Rows of samples from where lines end or meet to where they do again; ends that stick out by no more than
    /// `spur` samples are left out.
    fn ways(&self, samples: &[usize], spur: usize) -> Vec<Vec<usize>> {
        let mut is_passed = vec![false; self.inked.len()];
        let is_stop = |at: usize| self.degree(at) != 2;
        let mut ways: Vec<Vec<usize>> = Vec::new();
        for &start in samples.iter().filter(|&&at| is_stop(at)) {
            for way in STRAIGHT_FIRST {
                let next = self.beside(start, way);
                if self.inked[next] && !is_passed[next] && (!is_stop(next) || start < next) {
                    let found = self.follow(start, next, &mut is_passed);
                    let sticks_out =
                        [found[0], found[found.len() - 1]].iter().any(|&end| self.degree(end) == 1);
                    if !sticks_out || found.len() > spur {
                        ways.push(found);
                    }
                }
            }
        }
        // What is left goes round.
        for &start in samples {
            if !is_passed[start]
                && !is_stop(start)
                && let Some(way) = STRAIGHT_FIRST.into_iter().find(|&way| self.inked[self.beside(start, way)])
            {
                is_passed[start] = true;
                let mut found = self.follow(start, self.beside(start, way), &mut is_passed);
                found.push(start);
                ways.push(found);
            }
        }
        ways.retain(|way| way.len() > 2);
        ways
    }

    /// To how many others a sample leads: what is reached through a straight neighbour does not count.
    fn degree(&self, at: usize) -> usize {
        let around = self.around(at);
        let counts = |way: usize| {
            around[way] && (way.is_multiple_of(2) || !around[(way + 7) % 8] && !around[(way + 1) % 8])
        };
        (0..8).filter(|&way| counts(way)).count()
    }

    fn follow(&self, start: usize, next: usize, is_passed: &mut [bool]) -> Vec<usize> {
        let mut found = vec![start, next];
        let mut at = next;
        while self.degree(at) == 2 {
            is_passed[at] = true;
            let last = found[found.len() - 2];
            let is_on = |next: usize| {
                self.inked[next] && next != last && !is_passed[next] && !found[..2].contains(&next)
            };
            let ways = STRAIGHT_FIRST.into_iter().map(|way| self.beside(at, way));
            let Some(on) = ways.filter(|&next| is_on(next)).find(|&next| !self.are_beside(next, last)) else {
                break;
            };
            found.push(on);
            at = on;
        }
        found
    }

    fn are_beside(&self, a: usize, b: usize) -> bool {
        (0..8).step_by(2).any(|way| self.beside(a, way) == b)
    }
}

/// Whether a sample is part of the rim that one of the two passes takes off.
fn is_rim(around: [bool; 8], second: bool) -> bool {
    let count = around.iter().filter(|&&inked| inked).count();
    let begins = (0..8).filter(|&way| !around[way] && around[(way + 1) % 8]).count();
    let [up, right, down, left] = [around[0], around[2], around[4], around[6]];
    let is_free = if second { !(up && left && (right || down)) } else { !(right && down && (up || left)) };
    (2..=6).contains(&count) && begins == 1 && is_free
}

#[cfg(test)]
mod tests {
    use kurbo::{ParamCurve as _, ParamCurveArclen as _};

    use super::*;

    #[test]
    fn a_bar_has_a_straight_middle() {
        let inked = |index: usize| (20..29).contains(&(index / 100)) && (10..90).contains(&(index % 100));
        let (curves, width) = middles([100, 60], inked);
        assert_eq!(curves.len(), 1);
        assert!((width - 9.0).abs() < 1.5, "{width}");
        let ends = [curves[0][0].start(), curves[0][curves[0].len() - 1].end()];
        assert!(ends.iter().all(|end| (end.y - 24.5).abs() < 1.5), "{ends:?}");
        assert!((ends[0].x - ends[1].x).abs() > 60.0);
    }

    #[test]
    fn a_ring_goes_round() {
        let inked = |index: usize| {
            let (x, y) = ((index % 200) as f64 - 100.0, (index / 200) as f64 - 100.0);
            (56.0..64.0).contains(&x.hypot(y))
        };
        let (curves, _) = middles([200, 200], inked);
        let length: f64 = curves.iter().flatten().map(|segment| segment.arclen(0.1)).sum();
        assert!((length / (std::f64::consts::TAU * 60.0) - 1.0).abs() < 0.03, "{length} in {}", curves.len());
    }
}
