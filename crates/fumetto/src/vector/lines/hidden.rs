//! What triangles hide of lines.
//!
//! A triangle hides the part of a line that lies behind its plane and within its outline. For each triangle, the
//! lines near it on the picture are asked, and of each is noted from where to where it is hidden: exact, whatever
//! crosses whatever. Lines are few beside triangles, so they are what is sorted into tiles; nearly all triangles
//! are done with when they have looked there.

use std::ops::Range;

use rayon::prelude::*;

use super::{
    segments::Segment,
    sight::{Sight, Spot},
    solids::Solids,
};

/// Pixels along the side of a tile: about as long as a line's pieces are.
const TILE_PX: f32 = 8.0;

/// Triangles that are looked at in one go.
const BATCH: usize = 4096;

/// Distances that differ by this share are equal, as in `strip.wgsl`: models are not exact.
const TOLERANCE: f32 = 2e-4;

/// How far inside a triangle a line has to be to be hidden, in pixels: those along its sides are not.
const INSIDE_PX: f32 = 0.01;

/// A line's piece on the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) spots: [Spot; 2],
    /// As in [`Segment`].
    slack: f32,
    sheet: u32,
}

impl Piece {
    pub(crate) fn new(segment: &Segment, spots: [Spot; 2]) -> Self {
        Self { spots, slack: segment.slack, sheet: segment.sheet }
    }
}

/// Part of a piece, as shares of the way along it on the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hidden {
    pub(crate) piece: u32,
    pub(crate) from: f32,
    pub(crate) to: f32,
}

/// All parts of `pieces` that triangles hide, piece by piece.
pub(crate) fn hidden(pieces: &[Piece], solids: &Solids, sight: &Sight) -> Vec<Hidden> {
    let tiles = Tiles::new(pieces, sight);
    let spots = sight.spots(&solids.positions);
    let numbers: Vec<u32> = (0..solids.triangles.len() as u32).collect();
    let look = |asked: &mut Asked, batch: &[u32]| {
        let mut found = Vec::new();
        for &number in batch {
            let triangle = &solids.triangles[number as usize];
            let part = solids.parts[triangle.part as usize];
            if !part.hides {
                continue;
            }
            let corners = triangle.corners.map(|corner| spots[corner as usize]);
            let shown: &[[Spot; 3]] = if corners.iter().all(|corner| corner.near > 0.0) {
                &[corners]
            } else {
                &sight.cut(triangle.corners.map(|corner| solids.positions[corner as usize]))
            };
            for corners in shown {
                asked.round = (asked.round + 1) % WHOLLY;
                if let Some(face) = Face::new(*corners, part.is_double_sided, solids.sheets[number as usize])
                {
                    tiles.ask(pieces, &face, asked, &mut found);
                }
            }
        }
        found
    };
    let new = || Asked { round: 0, pieces: vec![0; pieces.len()] };
    let batches: Vec<Vec<Hidden>> = numbers.par_chunks(BATCH).map_init(new, look).collect();
    let mut found = batches.concat();
    found.par_sort_unstable_by(|a, b| {
        a.piece.cmp(&b.piece).then(a.from.total_cmp(&b.from)).then(a.to.total_cmp(&b.to))
    });
    found
}

/// The round of a piece of which nothing is seen: nobody need ask it again.
const WHOLLY: u32 = u32::MAX;

/// In which round each piece was last asked, so that none is asked twice by one triangle.
struct Asked {
    round: u32,
    pieces: Vec<u32>,
}

/// A triangle on the picture.
struct Face {
    corners: [Spot; 3],
    /// What it hangs together with.
    sheet: u32,
    /// For each side, how far inside it a place is: times x, times y, and a constant; in pixels.
    sides: [[f32; 3]; 3],
    /// Likewise one over the distance of the triangle's plane.
    near: [f32; 3],
}

impl Face {
    /// Nothing of one that is seen from behind where there is nothing to be seen, or edge-on.
    fn new(corners: [Spot; 3], is_double_sided: bool, sheet: u32) -> Option<Self> {
        let [a, b, c] = corners;
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        // Counter-clockwise from outside, where y grows upward.
        if area.abs() < 1e-6 || (area > 0.0 && !is_double_sided) {
            return None;
        }
        let sign = area.signum();
        let side = |from: Spot, to: Spot| {
            let (x, y) = (to.x - from.x, to.y - from.y);
            let scale = sign / x.hypot(y).max(1e-9);
            let (along_x, along_y) = (-y * scale, x * scale);
            [along_x, along_y, -(along_x * from.x + along_y * from.y)]
        };
        let (right, left) = (b.near - a.near, c.near - a.near);
        let along_x = (right * (c.y - a.y) - left * (b.y - a.y)) / area;
        let along_y = (left * (b.x - a.x) - right * (c.x - a.x)) / area;
        let near = [along_x, along_y, a.near - along_x * a.x - along_y * a.y];
        Some(Self { corners, sheet, sides: [side(a, b), side(b, c), side(c, a)], near })
    }

    /// From where to where it hides a piece.
    fn hides(&self, piece: &Piece) -> Option<[f32; 2]> {
        let [start, end] = piece.spots;
        let at = |[x, y, constant]: [f32; 3], spot: Spot| x * spot.x + y * spot.y + constant;
        let mut range = [0.0, 1.0];
        for side in self.sides {
            keep(&mut range, at(side, start) - INSIDE_PX, at(side, end) - INSIDE_PX)?;
        }
        // Contours may lie a little behind the triangles of their own surface.
        let own = if piece.sheet == self.sheet { piece.slack } else { 0.0 };
        let before = |spot: Spot| at(self.near, spot) - spot.near.max(own) * (1.0 + TOLERANCE);
        keep(&mut range, before(start), before(end))?;
        Some(range)
    }

    fn bounds(&self) -> [[f32; 2]; 2] {
        let [a, b, c] = self.corners;
        [[a.x.min(b.x).min(c.x), a.y.min(b.y).min(c.y)], [a.x.max(b.x).max(c.x), a.y.max(b.y).max(c.y)]]
    }
}

/// Keeps of a range what is above zero where something goes from `first` to `last`; nothing if that is nothing.
fn keep(range: &mut [f32; 2], first: f32, last: f32) -> Option<()> {
    match (first > 0.0, last > 0.0) {
        (true, true) => {}
        (true, false) => range[1] = range[1].min(first / (first - last)),
        (false, true) => range[0] = range[0].max(first / (first - last)),
        (false, false) => return None,
    }
    (range[0] < range[1]).then_some(())
}

/// The pieces in each tile of the picture.
struct Tiles {
    columns: usize,
    rows: usize,
    /// Where each tile's begin in the list.
    starts: Vec<u32>,
    list: Vec<u32>,
}

impl Tiles {
    fn new(pieces: &[Piece], sight: &Sight) -> Self {
        let [columns, rows] = sight.size_px.map(|side| (side / TILE_PX).ceil().max(1.0) as usize);
        let mut tiles = Self { columns, rows, starts: vec![0; columns * rows + 1], list: Vec::new() };
        let mut touched: Vec<(u32, u32)> = Vec::new();
        for (number, piece) in (0..).zip(pieces) {
            tiles.along(piece, |tile| touched.push((tile as u32, number)));
        }
        for &(tile, _) in &touched {
            tiles.starts[tile as usize + 1] += 1;
        }
        for tile in 0..columns * rows {
            tiles.starts[tile + 1] += tiles.starts[tile];
        }
        touched.sort_unstable();
        tiles.list = touched.into_iter().map(|(_, number)| number).collect();
        tiles
    }

    /// Tiles from one place to another along an axis; none beyond the picture.
    fn range(count: usize, low: f32, high: f32) -> Range<usize> {
        let tile = |at: f32| (at / TILE_PX).floor();
        let first = tile(low).max(0.0);
        let last = tile(high).min(count as f32 - 1.0);
        if first <= last { first as usize..last as usize + 1 } else { 0..0 }
    }

    /// Every tile that a piece goes through, or nearly.
    fn along(&self, piece: &Piece, mut visit: impl FnMut(usize)) {
        let [mut top, mut bottom] = piece.spots;
        if top.y > bottom.y {
            (top, bottom) = (bottom, top);
        }
        let slope = if bottom.y - top.y > 1e-6 { (bottom.x - top.x) / (bottom.y - top.y) } else { 0.0 };
        let (left, right) = (top.x.min(bottom.x), top.x.max(bottom.x));
        for row in Self::range(self.rows, top.y, bottom.y) {
            let (low, high) = if slope == 0.0 {
                (left, right)
            } else {
                let across = |y: f32| top.x + slope * (y.clamp(top.y, bottom.y) - top.y);
                let (a, b) = (across(row as f32 * TILE_PX), across((row + 1) as f32 * TILE_PX));
                (a.min(b), a.max(b))
            };
            Self::range(self.columns, low, high).for_each(|column| visit(row * self.columns + column));
        }
    }

    /// Notes what a triangle hides of the pieces in the tiles that it may touch.
    fn ask(&self, pieces: &[Piece], face: &Face, asked: &mut Asked, found: &mut Vec<Hidden>) {
        let [low, high] = face.bounds();
        let columns = Self::range(self.columns, low[0], high[0]);
        for row in Self::range(self.rows, low[1], high[1]) {
            for tile in columns.clone().map(|column| row * self.columns + column) {
                let (start, end) = (self.starts[tile] as usize, self.starts[tile + 1] as usize);
                for &number in &self.list[start..end] {
                    let last = &mut asked.pieces[number as usize];
                    if *last == asked.round || *last == WHOLLY {
                        continue;
                    }
                    *last = asked.round;
                    if let Some([from, to]) = face.hides(&pieces[number as usize]) {
                        found.push(Hidden { piece: number, from, to });
                        if from <= 0.0 && to >= 1.0 {
                            *last = WHOLLY;
                        }
                    }
                }
            }
        }
    }
}
