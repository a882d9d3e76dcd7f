//! Which cells of a grid lie in obstacles: how far from their surface each is, and how fast that moves.

use fumetto_scene::GridPlan;
use glam::{UVec3, Vec3};

/// Distances are told up to so many cells.
const FARTHEST: f32 = 4.0;
/// Larger triangles are cut, so that each is near few cells only; in cells.
const LARGEST: f32 = 4.0;
/// Rows are looked along a little beside the middles of cells, which edges of models like to meet; in cells.
const ASIDE: [f32; 2] = [1.37e-3, 2.91e-3];
/// Most meetings of triangles with rows of cells, and as many of their pieces with cells near them: some seconds of
/// work.
const MOST_MEETINGS: u64 = 1 << 28;

/// A triangle of an obstacle, and how fast it moves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Facet {
    pub(crate) corners: [Vec3; 3],
    pub(crate) velocity: Vec3,
}

/// One number of each for every cell.
#[derive(Clone, Debug)]
pub(crate) struct Voxels {
    cells: UVec3,
    /// In cells; below zero inside.
    pub(crate) distances: Vec<f32>,
    pub(crate) velocities: Vec<Vec3>,
    /// Whether some row of cells goes in and never comes out.
    pub(crate) leaks: bool,
}

/// Why obstacles cannot be made into cells.
#[derive(Clone, Copy, Debug, thiserror::Error, PartialEq, Eq)]
#[error("{triangles} triangles are too many and too large for {cells} cells: use a simpler model")]
pub struct TooManyFacets {
    triangles: usize,
    cells: u64,
}

struct Nearest<'a> {
    facets: &'a [Facet],
    cells: UVec3,
    which: Vec<u32>,
    square: Vec<f32>,
    /// How often pieces of facets may still meet cells.
    meetings: u64,
}

impl Voxels {
    /// Of `facets`, in metres.
    pub(crate) fn new(plan: &GridPlan, facets: &[Facet]) -> Result<Self, TooManyFacets> {
        let facets: Vec<Facet> = facets.iter().map(|facet| in_cells(plan, facet)).collect();
        let cells = UVec3::from(plan.cells);
        let too_many = TooManyFacets { triangles: facets.len(), cells: plan.cell_count() };
        let (inside, leaks) = insides(cells, &facets).ok_or(too_many)?;
        let nearest = Nearest::of(&facets, cells, &inside, MOST_MEETINGS).ok_or(too_many)?;
        let distance = |(&square, &inside): (&f32, &bool)| {
            let distance = square.sqrt().min(FARTHEST);
            if inside { -distance } else { distance }
        };
        let velocity = |&which: &u32| facets.get(which as usize).map_or(Vec3::ZERO, |facet| facet.velocity);
        Ok(Self {
            cells,
            distances: nearest.square.iter().zip(&inside).map(distance).collect(),
            velocities: nearest.which.iter().map(velocity).collect(),
            leaks,
        })
    }

    /// Whether a place, in cells, lies inside.
    pub(crate) fn holds(&self, place: Vec3) -> bool {
        let cell = place.floor();
        let fits = cell.cmpge(Vec3::ZERO).all() && cell.cmplt(self.cells.as_vec3()).all();
        fits && self.distances[index(self.cells, cell.as_uvec3())] < 0.0
    }
}

fn in_cells(plan: &GridPlan, facet: &Facet) -> Facet {
    let corners = facet.corners.map(|corner| (corner - Vec3::from(plan.origin)) / plan.side);
    Facet { corners, velocity: facet.velocity }
}

fn index(cells: UVec3, cell: UVec3) -> usize {
    ((cell.z * cells.y + cell.y) * cells.x + cell.x) as usize
}

/// For each cell whether it lies inside, by how often a row along x crosses facets before it; and whether any row
/// does so an odd number of times. Nothing where that would take too long.
fn insides(cells: UVec3, facets: &[Facet]) -> Option<(Vec<bool>, bool)> {
    let rows = (cells.y * cells.z) as usize;
    let mut crossings: Vec<Vec<f32>> = vec![Vec::new(); rows];
    let mut meetings = 0;
    for facet in facets {
        let [a, b, c] = facet.corners;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let first = |low: f32| (low - 1.0).max(0.0) as u32;
        let last = |high: f32, count: u32| (high + 1.0).clamp(0.0, count as f32) as u32;
        let (ys, zs) = (first(low.y)..last(high.y, cells.y), first(low.z)..last(high.z, cells.z));
        meetings += ys.len() as u64 * zs.len() as u64;
        if meetings > MOST_MEETINGS {
            return None;
        }
        for z in zs {
            for y in ys.clone() {
                let place = [y as f32 + 0.5 + ASIDE[0], z as f32 + 0.5 + ASIDE[1]];
                crossings[(z * cells.y + y) as usize].extend(crossing(facet.corners, place));
            }
        }
    }
    let mut inside = vec![false; rows * cells.x as usize];
    let mut leaks = false;
    for (row, crossed) in inside.chunks_exact_mut(cells.x as usize).zip(&mut crossings) {
        crossed.sort_by(f32::total_cmp);
        if crossed.len() % 2 == 1 {
            // There is no telling what is inside: the row is left as air.
            leaks = true;
            continue;
        }
        for pair in crossed.chunks_exact(2) {
            let end = |x: f32| (x + 0.5).clamp(0.0, cells.x as f32) as usize;
            row[end(pair[0])..end(pair[1])].fill(true);
        }
    }
    Some((inside, leaks))
}

/// Where a line along x meets a triangle, at `[y, z]`.
fn crossing([a, b, c]: [Vec3; 3], [y, z]: [f32; 2]) -> Option<f32> {
    let side = |p: Vec3, q: Vec3| {
        let (p, q) = ([f64::from(p.y - y), f64::from(p.z - z)], [f64::from(q.y - y), f64::from(q.z - z)]);
        p[0] * q[1] - p[1] * q[0]
    };
    let sides = [side(b, c), side(c, a), side(a, b)];
    let sum: f64 = sides.iter().sum();
    let meets = sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0);
    let x = sides.iter().zip([a, b, c]).map(|(side, corner)| side * f64::from(corner.x)).sum::<f64>() / sum;
    (meets && x.is_finite()).then_some(x as f32)
}

impl<'a> Nearest<'a> {
    /// Facets look for the cells near them; then cells that are inside, or near, ask their neighbours whose they are.
    /// Nothing where that would take more than so many `meetings`.
    fn of(facets: &'a [Facet], cells: UVec3, inside: &[bool], meetings: u64) -> Option<Self> {
        let count = inside.len();
        let (which, square) = (vec![u32::MAX; count], vec![f32::INFINITY; count]);
        let mut nearest = Self { facets, cells, which, square, meetings };
        for (number, facet) in (0..).zip(facets) {
            nearest.scatter(number, facet.corners)?;
        }
        for _ in 0..2 {
            for forth in [true, false] {
                nearest.sweep(forth, inside);
            }
        }
        Some(nearest)
    }

    /// Cut into pieces that are small, as far as they are in the grid.
    fn scatter(&mut self, number: u32, corners: [Vec3; 3]) -> Option<()> {
        let mut pieces = vec![corners];
        let end = self.cells.as_vec3() + 1.0;
        while let Some([a, b, c]) = pieces.pop() {
            self.meetings = self.meetings.checked_sub(1)?;
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            if high.cmplt(Vec3::splat(-1.0)).any() || low.cmpgt(end).any() || !(high - low).is_finite() {
                continue;
            }
            let edges = [[b, c, a], [c, a, b], [a, b, c]];
            let longest = edges
                .into_iter()
                .max_by(|x, y| x[0].distance_squared(x[1]).total_cmp(&y[0].distance_squared(y[1])));
            match longest {
                Some([p, q, other]) if p.distance(q) > LARGEST => {
                    let middle = p.midpoint(q);
                    pieces.extend([[p, middle, other], [middle, q, other]]);
                }
                _ => self.reach(number, low, high)?,
            }
        }
        Some(())
    }

    fn reach(&mut self, number: u32, low: Vec3, high: Vec3) -> Option<()> {
        let first = (low - 1.5).max(Vec3::ZERO).as_uvec3();
        let last = (high + 1.5).max(Vec3::ZERO).as_uvec3().min(self.cells);
        let reached = last.saturating_sub(first).to_array().map(u64::from).into_iter().product();
        self.meetings = self.meetings.checked_sub(reached)?;
        for z in first.z..last.z {
            for y in first.y..last.y {
                for x in first.x..last.x {
                    self.offer(UVec3::new(x, y, z), number);
                }
            }
        }
        Some(())
    }

    fn offer(&mut self, cell: UVec3, number: u32) {
        let at = index(self.cells, cell);
        if number == self.which[at] {
            return;
        }
        let place = cell.as_vec3() + 0.5;
        let square = closest(self.facets[number as usize].corners, place).distance_squared(place);
        if square < self.square[at] {
            (self.square[at], self.which[at]) = (square, number);
        }
    }

    fn sweep(&mut self, forth: bool, inside: &[bool]) {
        let cells = self.cells;
        let order = |count: u32, step: u32| if forth { step } else { count - 1 - step };
        for k in 0..cells.z {
            for j in 0..cells.y {
                for i in 0..cells.x {
                    let cell = UVec3::new(order(cells.x, i), order(cells.y, j), order(cells.z, k));
                    for axis in 0..3 {
                        let mut next = cell;
                        next[axis] = if forth { cell[axis].wrapping_sub(1) } else { cell[axis] + 1 };
                        if next[axis] >= cells[axis] {
                            continue;
                        }
                        let (number, square) =
                            (self.which[index(cells, next)], self.square[index(cells, next)]);
                        let near = square < FARTHEST * FARTHEST || inside[index(cells, cell)];
                        if number != u32::MAX && near {
                            self.offer(cell, number);
                        }
                    }
                }
            }
        }
    }
}

/// The place of a triangle that is nearest to `p` (Ericson 2005, "Real-Time Collision Detection", 5.1.5).
fn closest([a, b, c]: [Vec3; 3], p: Vec3) -> Vec3 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let inverse = 1.0 / (va + vb + vc);
    a + ab * (vb * inverse) + ac * (vc * inverse)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn facets_that_reach_too_many_cells_are_refused() {
        let cells = UVec3::splat(16);
        // Few rows along x are met, many cells are near.
        let corners = [Vec3::new(0.0, 8.0, 8.0), Vec3::new(16.0, 8.0, 8.0), Vec3::new(16.0, 8.5, 8.5)];
        let facets = [Facet { corners, velocity: Vec3::ZERO }; 100];
        let inside = vec![false; 16 * 16 * 16];
        assert!(Nearest::of(&facets, cells, &inside, 1_000_000).is_some());
        assert!(Nearest::of(&facets, cells, &inside, 10_000).is_none());
    }
}
