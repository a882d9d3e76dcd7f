//! Runs as smooth lines, and these as outlines.

use fumetto_scene::{Object, Width};
use kurbo::{BezPath, Cap, Join, PathSeg, Point, Stroke, StrokeOpts, Vec2};

use super::{
    outline::outline,
    visible::{Run, Stop},
};
use crate::vector::fit::{fit, unit};

/// How far curves may leave the line's places, in pixels.
const TOLERANCE_PX: f64 = 0.12;

/// Distance of places that curves are held to, in pixels.
const STEP_PX: f64 = 3.0;

/// Lengths along a line over which its direction is found, in pixels.
const REACH_PX: f64 = 2.0;

/// A line turns by at least this much at a corner, in radians: 35 degrees.
const CORNER: f64 = 0.6;

/// Lengths of dashes and gaps of hidden lines, in widths, where the pen has no others. Also in `strip.wgsl`.
const HIDDEN_DASH: [f64; 2] = [4.0, 3.0];

/// Share of a pen's width under which a line that the light thins is gone. Also in `pen.wgsl`.
pub(crate) const FINEST: f32 = 0.25;

/// How a kind of edge of an object is drawn on a picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nib {
    pub(crate) width: Width,
    /// Pixels of the picture for each that the style means.
    pub(crate) scale: f32,
    pub(crate) focal_px: f32,
    pub(crate) lit_thinning: f32,
    pub(crate) dash_px: Option<[f32; 2]>,
    /// Only the middles of lines are wanted.
    pub(crate) plotter: bool,
}

impl Nib {
    pub(crate) fn width_px(&self, stop: &Stop) -> f64 {
        let width = match self.width {
            Width::Px(px) => px * self.scale,
            Width::World(metres) => metres * self.focal_px * stop.spot.near,
        };
        f64::from(width * (1.0 - self.lit_thinning * stop.lit))
    }

    fn varies(&self) -> bool {
        self.lit_thinning > 0.0 || matches!(self.width, Width::World(_))
    }

    /// Dashes and gaps of a run, where it has any.
    fn dashes(&self, run: &Run, width_px: f64) -> Option<[f64; 2]> {
        let own = self.dash_px.map(|dash| dash.map(|px| f64::from(px * self.scale)));
        let hidden = run.is_hidden.then(|| HIDDEN_DASH.map(|widths| widths * width_px.max(1.0)));
        own.or(hidden).filter(|dash| dash[0] + dash[1] > 0.05)
    }

    /// What is drawn of a run: an outline to be filled, or the middle of a line.
    pub(crate) fn draw(&self, run: &Run) -> BezPath {
        let middle = middle(run);
        let widths: Vec<f64> = run.stops.iter().map(|stop| self.width_px(stop)).collect();
        let width = widths.iter().sum::<f64>() / widths.len().max(1) as f64;
        let dashes = self.dashes(run, width);
        let mut path = BezPath::from_path_segments(middle.iter().copied());
        if run.is_closed {
            path.close_path();
        }
        match dashes {
            Some(dashes) if self.plotter => kurbo::dash(path.into_iter(), 0.0, &dashes).collect(),
            None if self.plotter => path,
            None if self.varies() => outline(&middle, &halves(run, &widths), run.is_closed),
            _ => {
                let style = Stroke::new(width).with_caps(Cap::Round).with_join(Join::Round);
                let style = match dashes {
                    Some(dashes) => style.with_dashes(0.0, dashes),
                    None => style,
                };
                kurbo::stroke(path, &style, &StrokeOpts::default(), 0.02)
            }
        }
    }
}

/// Half of a line's width at shares of its length.
fn halves(run: &Run, widths: &[f64]) -> Vec<(f64, f64)> {
    let places = places(run);
    let mut at = 0.0;
    let mut lengths = vec![0.0];
    lengths.extend(places.windows(2).map(|pair| {
        at += (pair[1] - pair[0]).hypot();
        at
    }));
    lengths
        .into_iter()
        .map(|length| length / at.max(1e-9))
        .zip(widths.iter().map(|width| 0.5 * width))
        .collect()
}

fn places(run: &Run) -> Vec<Point> {
    run.stops.iter().map(|stop| Point::new(f64::from(stop.spot.x), f64::from(stop.spot.y))).collect()
}

/// Smooth curves along a run.
fn middle(run: &Run) -> Vec<PathSeg> {
    let mut places = places(run);
    places.dedup_by(|b, a| (*b - *a).hypot() < 1e-3);
    let places = dense(&places);
    if run.is_closed {
        return ring(places);
    }
    let corners = corners(&places, false);
    let stops: Vec<usize> =
        std::iter::once(0).chain(corners).chain([places.len().saturating_sub(1)]).collect();
    let piece = |stop: &[usize]| fit(&places[stop[0]..=stop[1]], [None, None], TOLERANCE_PX);
    stops.windows(2).flat_map(piece).collect()
}

/// Places with others between those that are far apart: curves are only held to places.
fn dense(places: &[Point]) -> Vec<Point> {
    let mut dense: Vec<Point> = places.first().copied().into_iter().collect();
    for pair in places.windows(2) {
        let steps = ((pair[1] - pair[0]).hypot() / STEP_PX).ceil().clamp(1.0, 1e5) as u32;
        dense.extend((1..=steps).map(|step| pair[0].lerp(pair[1], f64::from(step) / f64::from(steps))));
    }
    dense
}

/// Likewise around.
fn ring(mut places: Vec<Point>) -> Vec<PathSeg> {
    if places.len() > 1 && (places[0] - places[places.len() - 1]).hypot() < 1e-3 {
        places.pop();
    }
    let count = places.len();
    if count < 3 {
        return fit(&places, [None, None], TOLERANCE_PX);
    }
    let corners = corners(&places, true);
    let first = corners.first().copied().unwrap_or(0);
    let turned: Vec<Point> = (0..=count).map(|step| places[(first + step) % count]).collect();
    if corners.is_empty() {
        let along = unit(places[1] - places[count - 1]);
        return fit(&turned, [along, along.map(|along| -along)], TOLERANCE_PX);
    }
    let stops: Vec<usize> = corners.iter().map(|corner| corner - first).chain([count]).collect();
    stops.windows(2).flat_map(|stop| fit(&turned[stop[0]..=stop[1]], [None, None], TOLERANCE_PX)).collect()
}

/// Numbers of the places where a line turns at once.
fn corners(places: &[Point], is_closed: bool) -> Vec<usize> {
    let count = places.len();
    let range = if is_closed { 0..count } else { 1..count.saturating_sub(1) };
    // The place some way before or after one, at most once round.
    let away = |index: usize, step: usize| {
        let mut at = index;
        let mut gone = 0.0;
        for _ in 1..count {
            if !is_closed && (at == 0 && step != 1 || at + 1 == count && step == 1) {
                break;
            }
            let next = (at + step) % count;
            gone += (places[next] - places[at]).hypot();
            at = next;
            if gone >= REACH_PX {
                break;
            }
        }
        places[at]
    };
    let turn = |index: usize| {
        let come: Vec2 = places[index] - away(index, count - 1);
        let go: Vec2 = away(index, 1) - places[index];
        come.cross(go).atan2(come.dot(go)).abs()
    };
    let mut found: Vec<(usize, f64)> = Vec::new();
    let mut since = f64::INFINITY;
    for index in range {
        let turned = turn(index);
        if index > 0 {
            since += (places[index] - places[index - 1]).hypot();
        }
        if turned < CORNER {
            continue;
        }
        match found.last_mut().filter(|_| since < REACH_PX) {
            // Of corners close to each other, the sharpest.
            Some(last) if last.1 < turned => (*last, since) = ((index, turned), 0.0),
            Some(_) => {}
            None => {
                found.push((index, turned));
                since = 0.0;
            }
        }
    }
    found.into_iter().map(|(index, _)| index).collect()
}

/// How a kind of edge of an object is drawn in a picture `height_px` high.
pub(crate) fn nib(object: &Object, kind: fumetto_scene::EdgeKind, height_px: u32, focal_px: f32) -> Nib {
    let ink = &object.style.ink;
    Nib {
        width: ink.width_of(kind),
        scale: height_px as f32 / object.style.height_px,
        focal_px,
        lit_thinning: ink.lit_thinning,
        dash_px: ink.pen(kind).dash_px,
        plotter: false,
    }
}
