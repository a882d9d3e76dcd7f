//! Lines of models and surfaces, as connected curves in sight of a camera.
//!
//! `segments.rs` finds the straight pieces of contours and edges in triangles, `chains.rs` connects them, `hidden.rs`
//! tells from where to where triangles hide each, `visible.rs` cuts chains there, and `strokes.rs` draws what is left.

mod chains;
mod hidden;
mod outline;
mod segments;
mod sight;
mod solids;
mod strokes;
#[cfg(test)]
mod tests;
mod visible;

use fumetto_scene::{EdgeKind, HiddenLines, Object};
use kurbo::BezPath;
use rayon::prelude::*;

use self::{
    chains::{Joints, chains},
    hidden::{Piece, hidden},
    segments::{Draws, Finder, Segment},
    strokes::{FINEST, Nib, nib},
    visible::{Run, View},
};
pub(crate) use self::{
    segments::FirstLight,
    sight::{Sight, Spot},
    solids::Solids,
};
use super::document::Stroke;
use crate::ink::follows_edges;

/// Gaps that are shorter than this are drawn over, in pixels: neighbouring triangles hide lines a little sooner or
/// later than the smooth surface would.
const GAP_PX: f32 = 1.0;

/// Lines that are shorter than this are crumbs, in pixels.
const CRUMB_PX: f32 = 2.0;

/// Share of a style's shortest line from which one is kept, as in `line.wgsl`.
const SHORTEST: f32 = 0.7;

/// What lines are drawn of.
pub(crate) struct Subject<'a> {
    pub(crate) solids: &'a Solids,
    pub(crate) sight: &'a Sight,
    /// All that are drawn, by number.
    pub(crate) objects: &'a [&'a Object],
    pub(crate) light: FirstLight,
    /// Whether something that is no triangle stands before a spot.
    pub(crate) covered: &'a (dyn Fn(Spot) -> bool + Sync),
}

impl Subject<'_> {
    /// Lines in sight, and hidden ones of objects whose style draws them.
    pub(crate) fn runs(&self) -> Vec<(usize, EdgeKind, Run)> {
        let draws: Vec<Draws> =
            self.objects.iter().map(|object| EdgeKind::ALL.map(|kind| follows_edges(object, kind))).collect();
        let mut segments = Finder::new(self.solids, self.sight, &draws, self.light).segments();
        segments.retain_mut(|segment| segment.ends[0] != segment.ends[1] && self.is_near(segment));
        let piece = |segment: &Segment| Piece::new(segment, segment.ends.map(|end| self.sight.spot(end)));
        let pieces: Vec<Piece> = segments.iter().map(piece).collect();
        let hidden = hidden(&pieces, self.solids, self.sight);
        let is_gone = |segment: &Segment| {
            let thinning = self.objects[segment.object as usize].style.ink.lit_thinning;
            segment.lit.iter().all(|lit| 1.0 - thinning * lit < FINEST)
        };
        let view = View {
            sight: self.sight,
            segments: &segments,
            pieces: &pieces,
            hidden: &hidden,
            covered: self.covered,
            is_gone: &is_gone,
        };
        let joints = Joints::new(&segments);
        let found: Vec<Vec<_>> = chains(&segments)
            .par_iter()
            .map(|chain| {
                let Segment { object, kind, .. } = segments[chain.links[0].0];
                let object = object as usize;
                let is_alone = joints.is_alone(chain, &segments);
                let shortest = if is_alone { self.shortest_px(object, kind) } else { 0.0 };
                let runs = view.runs(chain, shortest.max(CRUMB_PX), GAP_PX).into_iter();
                let shows = |run: &Run| {
                    !run.is_hidden || self.objects[object].style.ink.hidden == HiddenLines::Dashed
                };
                runs.filter(shows).map(|run| (object, kind, run)).collect()
            })
            .collect();
        found.into_iter().flatten().collect()
    }

    /// Cuts off what lies behind the near plane; whether the rest may be on the picture.
    fn is_near(&self, segment: &mut Segment) -> bool {
        let [start, end] = segment.ends;
        let Some([from, to]) = self.sight.in_front(start, end) else { return false };
        if from > 0.0 || to < 1.0 {
            segment.ends = [start.lerp(end, from), start.lerp(end, to)];
        }
        let [a, b] = segment.ends.map(|end| self.sight.spot(end));
        let [width, height] = self.sight.size_px;
        let on_picture = |low: f32, high: f32, size: f32| high >= 0.0 && low <= size;
        a.near > 0.0
            && b.near > 0.0
            && on_picture(a.x.min(b.x), a.x.max(b.x), width)
            && on_picture(a.y.min(b.y), a.y.max(b.y), height)
    }

    /// Length in pixels from which on a line by itself is drawn.
    fn shortest_px(&self, object: usize, kind: EdgeKind) -> f32 {
        let nib = self.nib(object, kind);
        let far = visible::Stop { spot: Spot { x: 0.0, y: 0.0, near: 0.0 }, lit: 0.0 };
        SHORTEST * self.objects[object].style.ink.shortest * nib.width_px(&far) as f32
    }

    fn nib(&self, object: usize, kind: EdgeKind) -> Nib {
        nib(self.objects[object], kind, self.sight.size_px[1] as u32, self.sight.focal_px)
    }

    /// What is drawn of all lines, a path for each object and kind.
    pub(crate) fn strokes(&self, plotter: bool) -> Vec<Stroke> {
        let mut runs = self.runs();
        runs.sort_by_key(|(object, kind, _)| (*object, *kind as u32));
        let strokes = runs.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).map(|runs| {
            let (object, kind, _) = runs[0];
            let nib = Nib { plotter, ..self.nib(object, kind) };
            let drawn: Vec<BezPath> = runs.par_iter().map(|(.., run)| nib.draw(run)).collect();
            let mut path = BezPath::new();
            drawn.iter().for_each(|drawn| path.extend(drawn.iter()));
            let width = || mean(runs.iter().flat_map(|(.., run)| &run.stops).map(|stop| nib.width_px(stop)));
            Stroke { object, kind, opacity: 1.0, path, stroke_px: plotter.then(width) }
        });
        strokes.filter(|stroke| !stroke.path.elements().is_empty()).collect()
    }
}

fn mean(numbers: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = numbers.fold((0.0, 0.0), |(sum, count), number| (sum + number, count + 1.0));
    sum / f64::max(count, 1.0)
}
