//! Curves through places: few smooth cubics that keep within a tolerance.
//!
//! Schneider, "An Algorithm for Automatically Fitting Digitized Curves", Graphics Gems, 1990. Ours: an end that
//! nothing asks to be smooth is free to leave in any direction, and what is straight becomes a line.

use kurbo::{CubicBez, Line, ParamCurve as _, ParamCurveDeriv as _, PathSeg, Point, Vec2};

/// Rounds of moving each place's parameter to where the curve is nearest.
const ROUNDS: usize = 8;

/// Of the tolerance, how far from a straight line places may lie that are taken for one.
const STRAIGHT: f64 = 0.8;

/// A curve within `tolerance` of `places`, from the first to the last, which leaves and arrives in the directions
/// of `ends`, where there are any: both point inward.
pub(super) fn fit(places: &[Point], ends: [Option<Vec2>; 2], tolerance: f64) -> Vec<PathSeg> {
    let mut found = Vec::new();
    let mut open = vec![(0, places.len().saturating_sub(1), ends)];
    while let Some((first, last, ends)) = open.pop() {
        if last <= first {
            continue;
        }
        let span = &places[first..=last];
        if is_straight(span, ends, STRAIGHT * tolerance) {
            found.push(PathSeg::Line(Line::new(span[0], span[span.len() - 1])));
            continue;
        }
        match fit_one(span, ends, tolerance) {
            Ok(curve) => found.push(PathSeg::Cubic(curve)),
            Err(worst) => {
                let middle = first + worst.clamp(1, span.len() - 2);
                let along = direction(places, first, middle, last);
                // The later half waits.
                open.push((middle, last, [along, ends[1]]));
                open.push((first, middle, [ends[0], along.map(|along| -along)]));
            }
        }
    }
    found
}

/// The direction of the curve at a place between two others, over as many as lie within a few of it.
fn direction(places: &[Point], first: usize, middle: usize, last: usize) -> Option<Vec2> {
    let reach = 5.min(middle - first).min(last - middle);
    unit(places[middle + reach] - places[middle - reach])
}

/// A vector's direction, if it has one.
pub(super) fn unit(vector: Vec2) -> Option<Vec2> {
    let length = vector.hypot();
    (length > 1e-9).then(|| vector / length)
}

fn is_straight(places: &[Point], ends: [Option<Vec2>; 2], tolerance: f64) -> bool {
    let (first, last) = (places[0], places[places.len() - 1]);
    let Some(along) = unit(last - first) else { return places.len() <= 2 };
    let keeps = |end: Option<Vec2>, along: Vec2| end.is_none_or(|end| end.dot(along) > 0.9986);
    let is_near = |place: &Point| {
        let from = *place - first;
        let on = from.dot(along);
        from.cross(along).abs() <= tolerance && on >= -tolerance && on <= (last - first).hypot() + tolerance
    };
    places.len() == 2 || (keeps(ends[0], along) && keeps(ends[1], -along) && places.iter().all(is_near))
}

/// One cubic, or the number of the place that is farthest from the best.
fn fit_one(places: &[Point], ends: [Option<Vec2>; 2], tolerance: f64) -> Result<CubicBez, usize> {
    let mut shares = chord_shares(places);
    let mut worst = places.len() / 2;
    for round in 0..ROUNDS {
        let curve = solve(places, &shares, ends);
        improve(&curve, places, &mut shares);
        let (error, at) = farthest(&curve, places, &shares);
        if error <= tolerance {
            return Ok(curve);
        }
        worst = at;
        // Far away, parameters are not what is wrong.
        if places.len() < 4 || error > 6.0 * tolerance || round + 1 == ROUNDS {
            break;
        }
    }
    if places.len() <= 2 { Ok(solve(places, &shares, ends)) } else { Err(worst) }
}

/// How far along each place is, by the lengths of chords, from 0 to 1.
fn chord_shares(places: &[Point]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut shares = vec![0.0];
    shares.extend(places.windows(2).map(|pair| {
        sum += (pair[1] - pair[0]).hypot();
        sum
    }));
    shares.iter_mut().for_each(|share| *share /= sum.max(1e-12));
    shares
}

/// Bernstein's polynomials.
fn weights(share: f64) -> [f64; 4] {
    let rest = 1.0 - share;
    [rest * rest * rest, 3.0 * share * rest * rest, 3.0 * share * share * rest, share * share * share]
}

/// The cubic with the least squares of distances.
fn solve(places: &[Point], shares: &[f64], ends: [Option<Vec2>; 2]) -> CubicBez {
    let (first, last) = (places[0], places[places.len() - 1]);
    let third = (last - first).hypot() / 3.0;
    // Sums over what the two inner points have to explain.
    let (mut a, mut b, mut c) = (0.0, 0.0, 0.0);
    let (mut left, mut right) = (Vec2::ZERO, Vec2::ZERO);
    for (place, &share) in places.iter().zip(shares) {
        let [w0, w1, w2, w3] = weights(share);
        let rest = place.to_vec2() - (w0 + w1) * first.to_vec2() - (w2 + w3) * last.to_vec2();
        (a, b, c) = (a + w1 * w1, b + w1 * w2, c + w2 * w2);
        left += w1 * rest;
        right += w2 * rest;
    }
    let det = a * c - b * b;
    let free = |det: f64| [(c * left - b * right) / det, (a * right - b * left) / det];
    let default = |end: Option<Vec2>, other: Vec2| end.map_or(other / 3.0, |end| third * end);
    let fallback = [default(ends[0], last - first), default(ends[1], first - last)];
    let is_solid = det.abs() > 1e-9 * a * c && places.len() > 3;
    let [out, back] = match (is_solid, ends) {
        (false, _) => fallback,
        (true, [None, None]) => free(det),
        (true, [Some(start), None]) => {
            let reach = free(det)[0].dot(start);
            if reach > 1e-3 * third { [reach * start, (right - b * reach * start) / c] } else { fallback }
        }
        (true, [None, Some(end)]) => {
            let reach = free(det)[1].dot(end);
            if reach > 1e-3 * third { [(left - b * reach * end) / a, reach * end] } else { fallback }
        }
        (true, [Some(start), Some(end)]) => {
            let turned = b * start.dot(end);
            let det = a * c - turned * turned;
            let (x, y) = (left.dot(start), right.dot(end));
            let reach = [(c * x - turned * y) / det, (a * y - turned * x) / det];
            let is_good = det.abs() > 1e-9 * a * c && reach.iter().all(|&reach| reach > 1e-3 * third);
            if is_good { [reach[0] * start, reach[1] * end] } else { fallback }
        }
    };
    CubicBez::new(first, first + out, last + back, last)
}

/// The greatest distance of a place, and its number.
fn farthest(curve: &CubicBez, places: &[Point], shares: &[f64]) -> (f64, usize) {
    let apart = places.iter().zip(shares).map(|(&place, &share)| (curve.eval(share) - place).hypot());
    let found = apart.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
    found.map_or((0.0, 0), |(at, apart)| (apart, at))
}

/// One step of Newton's toward where the curve is nearest to each place.
fn improve(curve: &CubicBez, places: &[Point], shares: &mut [f64]) {
    let (speed, bend) = (curve.deriv(), curve.deriv().deriv());
    for (&place, share) in places.iter().zip(shares) {
        let from = curve.eval(*share) - place;
        let (first, second) = (speed.eval(*share).to_vec2(), bend.eval(*share).to_vec2());
        let slope = first.dot(first) + from.dot(second);
        if slope.abs() > 1e-12 {
            *share = (*share - from.dot(first) / slope).clamp(0.0, 1.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn arc(turn: f64, count: usize) -> Vec<Point> {
        let angle = |step: usize| turn * TAU * step as f64 / (count - 1) as f64;
        (0..count).map(|step| Point::ORIGIN + 100.0 * Vec2::from_angle(angle(step))).collect()
    }

    #[test]
    fn a_quarter_of_a_circle_is_one_curve() {
        assert_eq!(fit(&arc(0.25, 90), [None, None], 0.5).len(), 1);
    }

    #[test]
    fn curves_keep_within_the_tolerance_and_go_on_smoothly() {
        let places = arc(0.9, 400);
        for tolerance in [0.5, 0.05, 0.005] {
            let curve = fit(&places, [None, None], tolerance);
            for place in
                curve.iter().flat_map(|segment| (0..=50).map(|step| segment.eval(f64::from(step) / 50.0)))
            {
                let off = (place.to_vec2().hypot() - 100.0).abs();
                assert!(off <= tolerance + 0.01, "{off} at {tolerance}");
            }
            for pair in curve.windows(2) {
                let (PathSeg::Cubic(a), PathSeg::Cubic(b)) = (pair[0], pair[1]) else { panic!("a line") };
                let (before, after) =
                    (unit(a.p3 - a.p2).expect("a direction"), unit(b.p1 - b.p0).expect("a direction"));
                assert!(before.dot(after) > 0.9999, "a corner");
            }
        }
    }

    #[test]
    fn what_is_straight_is_a_line() {
        let places: Vec<Point> =
            (0..50).map(|step| Point::new(f64::from(step), f64::from(step % 2) * 0.1)).collect();
        let found = fit(&places, [None, None], 0.5);
        assert!(matches!(found[..], [PathSeg::Line(_)]), "{found:?}");
    }

    #[test]
    fn nothing_comes_of_nothing() {
        assert!(fit(&[], [None, None], 0.5).is_empty());
        assert!(fit(&[Point::ZERO], [None, None], 0.5).is_empty());
        let same = [Point::ZERO; 5];
        assert!(fit(&same, [None, None], 0.5).iter().all(|segment| segment.eval(0.5).is_finite()));
    }
}
