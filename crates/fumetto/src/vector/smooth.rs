//! Borders between samples to smooth curves in pixels.
//!
//! A border runs along the sides of samples, in steps. The middles of these sides lie within half a sample of the
//! line that the samples were taken of: they are smoothed a little, cut at corners and fitted with curves. Each
//! border is fitted once, and both regions take the same curves: so they have neither a gap nor an overlap.

use kurbo::{PathSeg, Point, Vec2};
use rayon::prelude::*;

use super::{
    borders::{BEYOND, Border, Borders},
    fit::{fit, unit},
};

/// How freely borders are drawn; lengths are in samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hand {
    /// How far curves may leave the middles of sides. These lie up to half a sample beside the line.
    tolerance: f64,
    /// Places to each side over which a border's direction is found, to tell corners.
    reach: usize,
    /// Times that each place moves to between its neighbours.
    smoothing: usize,
}

impl Hand {
    /// For tones: corners are told within one and a half pixels of four samples.
    pub(super) const TONES: Self = Self { tolerance: 0.75, reach: 6, smoothing: 3 };
    /// For lines, whose sides have notches of a sample or two where billboards end.
    pub(super) const INK: Self = Self { tolerance: 1.1, reach: 10, smoothing: 8 };
}

/// A border turns by at least this much at a corner, in radians: 50 degrees. Steps of a straight line look like
/// turns of up to 20.
const CORNER: f64 = 0.87;

/// Two borders that meet head-on within this angle (the cosine of 30 degrees) go on as one line, whatever ends there.
const HEAD_ON: f64 = 0.866;

/// The end of a border at a junction: its number, and whether it is the last.
type End = (usize, bool);

/// What a junction asks of the borders that meet there.
#[derive(Clone, Debug)]
struct Meeting {
    place: Point,
    /// Directions in which some of them leave.
    smooth: Vec<(End, Vec2)>,
}

/// The curves of each border, in pixels of `per_px` samples across and down.
pub(super) fn curves(borders: &Borders, per_px: [f64; 2], hand: Hand) -> Vec<Vec<PathSeg>> {
    let middles: Vec<Vec<Point>> = borders.list.par_iter().map(middles).collect();
    let meetings = meetings(borders, &middles, hand.reach);
    let to_px = kurbo::Affine::scale_non_uniform(1.0 / per_px[0], 1.0 / per_px[1]);
    let curve = |(number, border): (usize, &Border)| {
        let places = &middles[number];
        let curve = match border.ends {
            _ if border.left == BEYOND || border.right == BEYOND => edge(border),
            None => hand.closed(places),
            Some(ends) => {
                let at = |index: usize| &meetings[ends[index]];
                let leaves = |index: usize| {
                    let end = (number, index == 1);
                    at(index).smooth.iter().find(|(known, _)| *known == end).map(|(_, way)| *way)
                };
                let places = [&[at(0).place], &places[..], &[at(1).place]].concat();
                hand.open(&places, [leaves(0), leaves(1)])
            }
        };
        curve.into_iter().map(|segment| to_px * segment).collect()
    };
    borders.list.par_iter().enumerate().map(curve).collect()
}

fn point([x, y]: [i32; 2]) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

/// The middles of a border's sides.
fn middles(border: &Border) -> Vec<Point> {
    let corners = &border.corners;
    let close = border.ends.is_none().then(|| (corners[corners.len() - 1], corners[0]));
    let pairs = corners.windows(2).map(|pair| (pair[0], pair[1])).chain(close);
    pairs.map(|(from, to)| point(from).midpoint(point(to))).collect()
}

/// The picture's edge is straight.
fn edge(border: &Border) -> Vec<PathSeg> {
    let (first, last) = (border.corners[0], border.corners[border.corners.len() - 1]);
    vec![PathSeg::Line(kurbo::Line::new(point(first), point(last)))]
}

/// Where borders meet, and how they go on there. Two that are about one line decide where it runs; the others end
/// on it.
fn meetings(borders: &Borders, middles: &[Vec<Point>], reach: usize) -> Vec<Meeting> {
    let place = |corner: &[i32; 2]| Meeting { place: point(*corner), smooth: Vec::new() };
    let mut meetings: Vec<Meeting> = borders.junctions.iter().map(place).collect();
    let mut ends: Vec<Vec<End>> = vec![Vec::new(); meetings.len()];
    let mut is_edge = vec![false; meetings.len()];
    for (number, border) in borders.list.iter().enumerate() {
        let Some([first, last]) = border.ends else { continue };
        ends[first].push((number, false));
        ends[last].push((number, true));
        if border.left == BEYOND || border.right == BEYOND {
            is_edge[first] = true;
            is_edge[last] = true;
        }
    }
    for (junction, meeting) in meetings.iter_mut().enumerate() {
        if !is_edge[junction] {
            join_head_on(meeting, &ends[junction], middles, reach);
        }
    }
    meetings
}

/// Makes one line of the two borders that meet the most nearly head-on.
fn join_head_on(meeting: &mut Meeting, ends: &[End], middles: &[Vec<Point>], reach: usize) {
    let near = |&(number, is_last): &End, step: usize| {
        let places = &middles[number];
        let index = step.min(places.len() - 1);
        places[if is_last { places.len() - 1 - index } else { index }]
    };
    let way = |end: &End| unit(near(end, reach) - meeting.place);
    let pairs = ends.iter().enumerate().flat_map(|(at, a)| ends[at + 1..].iter().map(move |b| (a, b)));
    let meet = |(a, b): (&End, &End)| Some((-way(a)?.dot(way(b)?), *a, *b));
    let Some((how_much, a, b)) = pairs.filter_map(meet).max_by(|a, b| a.0.total_cmp(&b.0)) else { return };
    if how_much < HEAD_ON {
        return;
    }
    // As many places to both sides, so that a bend does not draw it aside.
    let steps = 1 + [a, b].iter().map(|end| middles[end.0].len() - 1).fold(reach, usize::min);
    let sum = (0..steps).map(|step| near(&a, step).to_vec2() + near(&b, step).to_vec2()).sum::<Vec2>();
    let mean = (sum / (2 * steps) as f64).to_point();
    let Some(along) = unit(near(&a, steps - 1) - near(&b, steps - 1)) else { return };
    // Aside only, and by no more than the steps do.
    let aside = (mean - meeting.place).cross(along).clamp(-1.0, 1.0);
    meeting.place += aside * Vec2::new(along.y, -along.x);
    meeting.smooth = vec![(a, along), (b, -along)];
}

impl Hand {
    /// Curves along places that begin and end at junctions.
    pub(super) fn open(self, places: &[Point], ends: [Option<Vec2>; 2]) -> Vec<PathSeg> {
        let corners = self.corners(places, false);
        let stops: Vec<usize> = std::iter::once(0).chain(corners).chain([places.len() - 1]).collect();
        let last = stops.len() - 2;
        let piece = |(index, stop): (usize, &[usize])| {
            let smoothed = self.smoothed(&places[stop[0]..=stop[1]]);
            let keeps = |is_end: bool, way: Option<Vec2>| if is_end { way } else { None };
            fit(&smoothed, [keeps(index == 0, ends[0]), keeps(index == last, ends[1])], self.tolerance)
        };
        stops.windows(2).enumerate().flat_map(piece).collect()
    }

    /// Curves around.
    fn closed(self, places: &[Point]) -> Vec<PathSeg> {
        let corners = self.corners(places, true);
        let Some(&first) = corners.first() else {
            // Anywhere is as good, if it goes on as it came.
            let (count, reach) = (places.len(), self.reach.min(places.len() / 4));
            let round: Vec<Point> = (0..=count).map(|step| places[step % count]).collect();
            let along = unit(places[reach % count] - places[(count - reach) % count]);
            let mut smoothed = self.smoothed(&round);
            let seam = smoothed[1].midpoint(smoothed[count - 1]).midpoint(smoothed[0]);
            smoothed[0] = seam;
            smoothed[count] = seam;
            return fit(&smoothed, [along, along.map(|along| -along)], self.tolerance);
        };
        let turned: Vec<Point> =
            (0..=places.len()).map(|step| places[(first + step) % places.len()]).collect();
        let stops: Vec<usize> = corners.iter().map(|corner| corner - first).chain([places.len()]).collect();
        let piece =
            |stop: &[usize]| fit(&self.smoothed(&turned[stop[0]..=stop[1]]), [None, None], self.tolerance);
        stops.windows(2).flat_map(piece).collect()
    }

    /// Numbers of the places where a border turns at once.
    fn corners(self, places: &[Point], is_closed: bool) -> Vec<usize> {
        let count = places.len();
        if count < 2 * self.reach + 1 {
            return Vec::new();
        }
        let at = |index: usize| places[index % count];
        let turn = |index: usize| {
            let (before, after) =
                (at(index) - at(index + count - self.reach), at(index + self.reach) - at(index));
            before.cross(after).atan2(before.dot(after)).abs()
        };
        let range = if is_closed { 0..count } else { self.reach..count - self.reach };
        let turns: Vec<f64> =
            (0..count).map(|index| if range.contains(&index) { turn(index) } else { 0.0 }).collect();
        let is_sharpest = |&index: &usize| {
            let around = |step: usize| {
                let other = index + count + step - self.reach;
                let is_there = is_closed || (count..2 * count).contains(&other);
                let other_turn = if is_there { turns[other % count] } else { 0.0 };
                // The first of equal ones.
                other_turn < turns[index] || (other_turn == turns[index] && step >= self.reach)
            };
            turns[index] >= CORNER && (0..=2 * self.reach).all(around)
        };
        range.filter(is_sharpest).collect()
    }

    /// Places between their neighbours; the ends stay.
    fn smoothed(self, places: &[Point]) -> Vec<Point> {
        let mut smoothed = places.to_vec();
        for _ in 0..self.smoothing {
            let before = smoothed.clone();
            for (middle, around) in smoothed.iter_mut().skip(1).zip(before.windows(3)) {
                *middle = around[0].midpoint(around[2]).midpoint(around[1]);
            }
        }
        smoothed
    }
}
