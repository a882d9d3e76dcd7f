//! The borders between regions: every one is found once, from junction to junction.
//!
//! They run between samples, so that regions have no room between them. What is beyond the picture is a region, too.

use rustc_hash::FxHashMap;

use super::regions::{Region, Regions};

/// What lies beyond the picture.
pub(crate) const BEYOND: Region = Region::MAX;

/// A corner of samples, from the picture's top left.
pub(crate) type Corner = [i32; 2];

/// A border between two regions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Border {
    /// Seen along the way, where y grows downward.
    pub(crate) left: Region,
    pub(crate) right: Region,
    /// One sample apart. A closed one does not repeat its first.
    pub(crate) corners: Vec<Corner>,
    /// Numbers of the junctions at both ends; nothing of a closed one.
    pub(crate) ends: Option<[usize; 2]>,
}

/// All borders of a picture.
#[derive(Debug, Default)]
pub(crate) struct Borders {
    pub(crate) list: Vec<Border>,
    /// Where more than two borders meet, or one reaches the picture's edge.
    pub(crate) junctions: Vec<Corner>,
}

/// Right, down, left, up.
const WAYS: [[i32; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

impl Borders {
    pub(crate) fn new(regions: &Regions) -> Self {
        let [width, height] = regions.size;
        let corners = (width + 1) * (height + 1);
        let mut walk = Walk {
            regions,
            passed: [vec![0; corners.div_ceil(64)], vec![0; corners.div_ceil(64)]],
            numbers: FxHashMap::default(),
        };
        let mut borders = Self::default();
        let crossed = walk.crossed();
        for &corner in &crossed {
            if walk.is_junction(corner) {
                walk.numbers.insert(corner, borders.junctions.len());
                borders.junctions.push(corner);
            }
        }
        for start in borders.junctions.clone() {
            for way in 0..WAYS.len() {
                borders.list.extend(walk.follow(start, way));
            }
        }
        // What is left goes round.
        for &start in &crossed {
            for way in 0..WAYS.len() {
                borders.list.extend(walk.follow(start, way));
            }
        }
        borders
    }
}

struct Walk<'a> {
    regions: &'a Regions,
    /// A bit for each side that has been followed: those to the right of a corner, and those below.
    passed: [Vec<u64>; 2],
    /// Of junctions; it is only asked, never gone through.
    numbers: FxHashMap<Corner, usize>,
}

impl Walk<'_> {
    fn region(&self, x: i32, y: i32) -> Region {
        let [width, height] = self.regions.size;
        let is_inside = x >= 0 && y >= 0 && (x as usize) < width && (y as usize) < height;
        if is_inside { self.regions.of[y as usize * width + x as usize] } else { BEYOND }
    }

    /// What lies to the left and to the right of one who leaves a corner.
    fn sides(&self, [x, y]: Corner, way: usize) -> [Region; 2] {
        let at = |[x, y]: Corner| self.region(x, y);
        let [upper_left, upper_right] = [[x - 1, y - 1], [x, y - 1]];
        let [lower_left, lower_right] = [[x - 1, y], [x, y]];
        match way {
            0 => [at(upper_right), at(lower_right)],
            1 => [at(lower_right), at(lower_left)],
            2 => [at(lower_left), at(upper_left)],
            _ => [at(upper_left), at(upper_right)],
        }
    }

    fn is_border(&self, corner: Corner, way: usize) -> bool {
        let [left, right] = self.sides(corner, way);
        left != right
    }

    /// The corners that borders go through.
    fn crossed(&self) -> Vec<Corner> {
        let [width, height] = self.regions.size;
        let mut crossed = Vec::new();
        let row = |y: usize| &self.regions.of[y * width..(y + 1) * width];
        for y in 0..=height {
            if y == 0 || y == height {
                crossed.extend((0..=width).map(|x| [x as i32, y as i32]));
                continue;
            }
            let (above, below) = (row(y - 1), row(y));
            crossed.push([0, y as i32]);
            for x in 1..width {
                let [a, b, c, d] = [above[x - 1], above[x], below[x - 1], below[x]];
                if a != b || a != c || a != d {
                    crossed.push([x as i32, y as i32]);
                }
            }
            crossed.push([width as i32, y as i32]);
        }
        crossed
    }

    fn is_junction(&self, corner: Corner) -> bool {
        let [width, height] = self.regions.size.map(|side| side as i32);
        let is_pictures = matches!(corner, [x, y] if (x == 0 || x == width) && (y == 0 || y == height));
        is_pictures || (0..WAYS.len()).filter(|&way| self.is_border(corner, way)).count() > 2
    }

    /// Marks a side; whether it had been marked.
    fn pass(&mut self, [x, y]: Corner, way: usize) -> bool {
        let [x, y] = match way {
            2 => [x - 1, y],
            3 => [x, y - 1],
            _ => [x, y],
        };
        let bit = y as usize * (self.regions.size[0] + 1) + x as usize;
        let word = &mut self.passed[way % 2][bit / 64];
        let before = *word;
        *word |= 1 << (bit % 64);
        *word == before
    }

    /// The border that leaves a corner, unless it has been followed before.
    fn follow(&mut self, start: Corner, mut way: usize) -> Option<Border> {
        if !self.is_border(start, way) || self.pass(start, way) {
            return None;
        }
        let [left, right] = self.sides(start, way);
        let mut corners = vec![start];
        let mut at = start;
        loop {
            at = [at[0] + WAYS[way][0], at[1] + WAYS[way][1]];
            if let Some(&end) = self.numbers.get(&at) {
                corners.push(at);
                let first = *self.numbers.get(&start).unwrap_or(&end);
                return Some(Border { left, right, corners, ends: Some([first, end]) });
            }
            if at == start {
                return Some(Border { left, right, corners, ends: None });
            }
            corners.push(at);
            let back = (way + 2) % 4;
            let on = (0..WAYS.len()).find(|&on| on != back && self.is_border(at, on));
            way = on?;
            self.pass(at, way);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{super::regions::tests::labels, *};

    fn borders(rows: &[&str]) -> (Regions, Borders) {
        let regions = Regions::new(labels(rows), 0);
        let borders = Borders::new(&regions);
        (regions, borders)
    }

    #[test]
    fn a_hole_goes_round() {
        let (_, borders) = borders(&["111", "101", "111"]);
        let inner: Vec<_> = borders.list.iter().filter(|border| border.ends.is_none()).collect();
        assert_eq!(inner.len(), 1);
        assert_eq!(inner[0].corners.len(), 4);
        // The picture's edge is in four pieces.
        assert_eq!(borders.list.len(), 5);
    }

    #[test]
    fn every_side_belongs_to_one_border() {
        let rows = ["11220", "13322", "13312", "00112"];
        let (regions, borders) = borders(&rows);
        let mut sides = 0;
        for y in 0..=4_i32 {
            for x in 0..=5_i32 {
                let at = |x: i32, y: i32| {
                    let inside = (0..5).contains(&x) && (0..4).contains(&y);
                    if inside { regions.of[(y * 5 + x) as usize] } else { BEYOND }
                };
                sides += usize::from(at(x, y) != at(x - 1, y)) + usize::from(at(x, y) != at(x, y - 1));
            }
        }
        let steps = |border: &Border| border.corners.len() - usize::from(border.ends.is_some());
        assert_eq!(borders.list.iter().map(steps).sum::<usize>(), sides);
        assert!(borders.list.iter().all(|border| border.left != border.right));
    }
}
