//! The outline of a line whose width changes along it.

use kurbo::{
    Arc, BezPath, ParamCurve as _, ParamCurveArclen as _, ParamCurveDeriv as _, PathEl, PathSeg, Point, Vec2,
};

use crate::vector::fit::{fit, unit};

/// Exactness of what is worked out, in pixels.
const TOLERANCE_PX: f64 = 0.04;

/// Distance of places along a line at which its sides are worked out, in pixels.
const STEP_PX: f64 = 1.5;

/// Directions of curves that meet within this angle (its sine) have no corner.
const SMOOTH: f64 = 0.15;

/// A place on a line's middle.
#[derive(Clone, Copy, Debug)]
struct Knot {
    place: Point,
    /// Of length 1, to the left of the way.
    aside: Vec2,
    half: f64,
}

/// The outline of a line along `middle` whose half width is given at shares of its length, round at its ends and
/// corners. It goes round so that what is filled lies on one side.
pub(super) fn outline(middle: &[PathSeg], halves: &[(f64, f64)], is_closed: bool) -> BezPath {
    let pieces = pieces(middle, halves);
    if pieces.is_empty() {
        return BezPath::new();
    }
    let mut path = BezPath::new();
    let forth = side(&pieces, 1.0, is_closed);
    let back: Vec<Vec<Knot>> =
        pieces.iter().rev().map(|piece| piece.iter().rev().copied().collect()).collect();
    let back = side(&back, -1.0, is_closed);
    if is_closed {
        add_ring(&mut path, &forth);
        add_ring(&mut path, &back);
        return path;
    }
    let (first, last) = (pieces[0][0], pieces[pieces.len() - 1][pieces[pieces.len() - 1].len() - 1]);
    let mut around = forth;
    around.extend(arc(last.place, last.half, last.aside, -last.aside));
    around.extend(back);
    around.extend(arc(first.place, first.half, -first.aside, first.aside));
    add_ring(&mut path, &around);
    path
}

fn add_ring(path: &mut BezPath, around: &[PathSeg]) {
    let Some(first) = around.first() else { return };
    path.move_to(first.start());
    around.iter().for_each(|segment| path.push(segment.as_path_el()));
    path.close_path();
}

/// Places along a line, cut at its corners.
fn pieces(middle: &[PathSeg], halves: &[(f64, f64)]) -> Vec<Vec<Knot>> {
    let lengths: Vec<f64> = middle.iter().map(|segment| segment.arclen(TOLERANCE_PX)).collect();
    let all: f64 = lengths.iter().sum::<f64>().max(1e-9);
    let half_at = |share: f64| {
        let after = halves.partition_point(|(known, _)| *known < share).clamp(1, halves.len().max(2) - 1);
        let (Some(&(from, a)), Some(&(to, b))) = (halves.get(after - 1), halves.get(after)) else {
            return 0.5;
        };
        // A line that is thinner than this would break on the screen.
        (a + (b - a) * ((share - from) / (to - from).max(1e-9)).clamp(0.0, 1.0)).max(0.1)
    };
    let mut pieces: Vec<Vec<Knot>> = Vec::new();
    let mut before = 0.0;
    for (segment, length) in middle.iter().zip(lengths) {
        let steps = (length / STEP_PX).ceil().clamp(4.0, 4096.0) as u32;
        let knots: Vec<Knot> = (0..=steps)
            .filter_map(|step| {
                let share = f64::from(step) / f64::from(steps);
                let way = direction(segment, share)?;
                let half = half_at((before + share * length) / all);
                Some(Knot { place: segment.eval(share), aside: Vec2::new(way.y, -way.x), half })
            })
            .collect();
        before += length;
        let goes_on = |last: &Knot, next: &Knot| {
            last.aside.cross(next.aside).abs() < SMOOTH && last.aside.dot(next.aside) > 0.0
        };
        let (Some(next), last) = (knots.first(), pieces.last_mut()) else { continue };
        match last {
            Some(piece) if piece.last().is_some_and(|last| goes_on(last, next)) => piece.extend(&knots[1..]),
            _ => pieces.push(knots),
        }
    }
    pieces
}

fn direction(segment: &PathSeg, share: f64) -> Option<Vec2> {
    let along = match segment {
        PathSeg::Line(line) => line.p1 - line.p0,
        PathSeg::Quad(quad) => quad.deriv().eval(share).to_vec2(),
        PathSeg::Cubic(cubic) => cubic.deriv().eval(share).to_vec2(),
    };
    let chord = || segment.eval((share + 1e-3).min(1.0)) - segment.eval((share - 1e-3).max(0.0));
    unit(along).or_else(|| unit(chord()))
}

/// One side of a line: to the left of the way, or with `sign` -1 of a way that is gone back.
fn side(pieces: &[Vec<Knot>], sign: f64, is_closed: bool) -> Vec<PathSeg> {
    let off = |knot: &Knot| knot.place + sign * knot.half * knot.aside;
    let mut found = Vec::new();
    for (index, piece) in pieces.iter().enumerate() {
        let places: Vec<Point> = piece.iter().map(off).collect();
        found.extend(fit(&places, [None, None], TOLERANCE_PX));
        let next = if index + 1 < pieces.len() { index + 1 } else { 0 };
        if (index + 1 < pieces.len() || is_closed) && pieces.len() > 1 {
            let (last, first) = (piece[piece.len() - 1], pieces[next][0]);
            found.extend(join(&last, &first, sign));
        }
    }
    found
}

/// From the side of one place to that of another at a corner.
fn join(last: &Knot, next: &Knot, sign: f64) -> Vec<PathSeg> {
    let (from, to) = (sign * last.aside, sign * next.aside);
    // With the side on the left of the way, a turn to the right opens a gap there.
    if from.cross(to) > 0.0 {
        return arc(last.place, last.half, from, to);
    }
    let [start, end] = [last.place + last.half * from, next.place + next.half * to];
    vec![PathSeg::Line(kurbo::Line::new(start, last.place)), PathSeg::Line(kurbo::Line::new(last.place, end))]
}

/// A piece of a circle, the way in which outlines go round.
fn arc(middle: Point, radius: f64, from: Vec2, to: Vec2) -> Vec<PathSeg> {
    let start = from.atan2();
    let sweep = (to.atan2() - start).rem_euclid(std::f64::consts::TAU);
    let arc = Arc::new(middle, (radius, radius), start, sweep, 0.0);
    let first = PathEl::MoveTo(middle + radius * from);
    kurbo::segments(std::iter::once(first).chain(arc.append_iter(TOLERANCE_PX))).collect()
}

#[cfg(test)]
mod tests {
    use kurbo::{CubicBez, Line, Shape as _};

    use super::*;

    #[test]
    fn a_straight_line_gets_round_ends() {
        let line = [PathSeg::Line(Line::new((0.0, 0.0), (100.0, 0.0)))];
        let path = outline(&line, &[(0.0, 2.0), (1.0, 2.0)], false);
        let expected = 100.0 * 4.0 + std::f64::consts::PI * 4.0;
        assert!((path.area().abs() - expected).abs() < 0.2, "{}", path.area());
        assert!(path.contains((50.0, 1.9).into()) && !path.contains((50.0, 2.1).into()));
    }

    #[test]
    fn corners_are_round_outside_and_full_inside() {
        let lines = [
            PathSeg::Line(Line::new((0.0, 0.0), (50.0, 0.0))),
            PathSeg::Line(Line::new((50.0, 0.0), (50.0, 50.0))),
        ];
        for (turned, inside) in [(lines, (49.0, 1.0)), (lines.map(|line| line.reverse()), (49.0, 1.0))] {
            let mut turned = turned;
            if turned[0].start() == Point::new(50.0, 0.0) {
                turned.reverse();
            }
            let path = outline(&turned, &[(0.0, 3.0), (1.0, 3.0)], false);
            assert!(path.winding(inside.into()) != 0);
            assert!(path.winding((51.9, -1.9).into()) != 0, "the outer corner is open");
            assert!(path.winding((52.5, -2.5).into()) == 0, "the outer corner is sharp");
        }
    }

    #[test]
    fn widths_swell_along_a_curve() {
        let curve = [PathSeg::Cubic(CubicBez::new((0.0, 0.0), (30.0, 40.0), (70.0, 40.0), (100.0, 0.0)))];
        let path = outline(&curve, &[(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)], false);
        assert!(path.contains((50.0, 33.5).into()) && path.contains((50.0, 26.5).into()));
        assert!(!path.contains((50.0, 34.5).into()) && !path.contains((50.0, 25.5).into()));
    }
}
