//! What hangs together in a picture of labels: its regions.

use crate::shapes::mesh::Sets;

/// Number of a region.
pub(crate) type Region = u32;

/// A picture in which every sample has a label, row by row from the top.
#[derive(Clone, Debug)]
pub(crate) struct Labels {
    pub(crate) size: [usize; 2],
    pub(crate) of: Vec<u16>,
}

/// The regions of one.
#[derive(Debug)]
pub(crate) struct Regions {
    pub(crate) size: [usize; 2],
    /// Of each sample.
    pub(crate) of: Vec<Region>,
    /// Of each region.
    pub(crate) labels: Vec<u16>,
    /// How many samples each has.
    areas: Vec<usize>,
}

/// Times that specks are given to their surroundings: two that touch each other can become one that is large
/// enough.
const SWEEPS: usize = 2;

impl Regions {
    /// Those of `labels`. Ones of fewer than `least` samples have joined what they share most of their border
    /// with.
    pub(crate) fn new(mut labels: Labels, least: usize) -> Self {
        let mut regions = Self::of(&labels);
        for _ in 0..SWEEPS {
            if !regions.join_specks(least) {
                break;
            }
            let (of, kinds) = (&regions.of, &regions.labels);
            labels.of.iter_mut().zip(of).for_each(|(label, &region)| *label = kinds[region as usize]);
            regions = Self::of(&labels);
        }
        regions
    }

    /// By runs of one label in each row, joined to those that they touch in the row above.
    fn of(labels: &Labels) -> Self {
        let [width, height] = labels.size;
        let mut sets = Sets::default();
        let mut runs: Vec<Run> = Vec::new();
        let mut above = 0..0;
        for row in 0..height {
            let first = runs.len();
            let samples = &labels.of[row * width..(row + 1) * width];
            let mut start = 0;
            for same in samples.chunk_by(|a, b| a == b) {
                let end = start + same.len();
                runs.push(Run { start, end, label: same[0], set: sets.add() });
                start = end;
            }
            join_rows(&runs, above, first..runs.len(), &mut sets);
            above = first..runs.len();
        }
        let mut regions = Self {
            size: labels.size,
            of: Vec::with_capacity(labels.of.len()),
            labels: Vec::new(),
            areas: Vec::new(),
        };
        let mut numbers = vec![Region::MAX; runs.len()];
        for run in &runs {
            let number = &mut numbers[sets.find(run.set)];
            if *number == Region::MAX {
                *number = regions.labels.len() as Region;
                regions.labels.push(run.label);
                regions.areas.push(0);
            }
            regions.areas[*number as usize] += run.end - run.start;
            regions.of.extend(std::iter::repeat_n(*number, run.end - run.start));
        }
        regions
    }

    /// Gives regions of fewer than `least` samples the label that they share most of their border with. Whether
    /// there were any.
    fn join_specks(&mut self, least: usize) -> bool {
        let [width, height] = self.size;
        let is_speck = |region: Region| self.areas[region as usize] < least;
        let mut borders: Vec<[Region; 2]> = Vec::new();
        let mut touch = |a: Region, b: Region| {
            if a != b {
                if is_speck(a) {
                    borders.push([a, b]);
                }
                if is_speck(b) {
                    borders.push([b, a]);
                }
            }
        };
        for row in 0..height {
            let samples = &self.of[row * width..(row + 1) * width];
            samples.windows(2).for_each(|pair| touch(pair[0], pair[1]));
            if row + 1 < height {
                let below = &self.of[(row + 1) * width..];
                samples.iter().zip(below).for_each(|(&a, &b)| touch(a, b));
            }
        }
        borders.sort_unstable();
        // The largest first: the smaller ones on them go with them.
        let mut specks: Vec<&[[Region; 2]]> = borders.chunk_by(|a, b| a[0] == b[0]).collect();
        specks.sort_by_key(|borders| std::cmp::Reverse(self.areas[borders[0][0] as usize]));
        for borders in &specks {
            let shared = borders.chunk_by(|a, b| a[1] == b[1]).max_by_key(|shared| shared.len());
            if let Some(&[[speck, other], ..]) = shared {
                self.labels[speck as usize] = self.labels[other as usize];
            }
        }
        !specks.is_empty()
    }
}

struct Run {
    start: usize,
    end: usize,
    label: u16,
    set: usize,
}

/// Joins the runs of two rows that touch and have the same label.
fn join_rows(runs: &[Run], above: std::ops::Range<usize>, below: std::ops::Range<usize>, sets: &mut Sets) {
    let (mut upper, mut lower) = (above.start, below.start);
    while upper < above.end && lower < below.end {
        let (a, b) = (&runs[upper], &runs[lower]);
        if a.label == b.label && a.start < b.end && b.start < a.end {
            sets.join(a.set, b.set);
        }
        if a.end < b.end { upper += 1 } else { lower += 1 }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A picture drawn with digits.
    pub(in super::super) fn labels(rows: &[&str]) -> Labels {
        let digits = rows.iter().flat_map(|row| row.bytes().map(|digit| u16::from(digit - b'0')));
        Labels { size: [rows[0].len(), rows.len()], of: digits.collect() }
    }

    #[test]
    fn regions_hang_together_along_sides() {
        let regions = Regions::new(labels(&["1101", "1001", "0111"]), 0);
        assert_eq!(regions.labels, [1, 0, 1, 0]);
        assert_eq!(regions.of, [0, 0, 1, 2, 0, 1, 1, 2, 3, 2, 2, 2]);
        assert_eq!(regions.areas, [3, 3, 5, 1]);
    }

    #[test]
    fn specks_join_what_is_around_them() {
        let regions = Regions::new(labels(&["11111", "12111", "11113", "11111"]), 2);
        assert_eq!(regions.labels, [1]);
        let kept = Regions::new(labels(&["11111", "12211", "11113", "11111"]), 2);
        assert_eq!(kept.labels, [1, 2]);
    }
}
