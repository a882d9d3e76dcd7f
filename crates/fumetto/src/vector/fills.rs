//! Regions to closed paths, so that no gap shows between neighbours.
//!
//! Neighbours share their border to the last digit, but renderers blend what covers a pixel in part, one shape
//! after the other, and so let a little of the ground through along it. Therefore tones of one object are stacked,
//! as cut paper is: a tone also lies under all that are painted later on it. Under another object, which people
//! may want to move away, it only reaches a little.

use std::collections::BTreeMap;

use kurbo::{BezPath, ParamCurve as _, PathEl, PathSeg, Point, Vec2};

use super::{
    borders::{BEYOND, Border, Borders},
    fit::fit,
    regions::{Region, Regions},
};
use crate::shapes::mesh::Sets;

/// How far a region reaches under what is painted over it later, in pixels: more than what is blended.
const OVERLAP_PX: f64 = 0.6;

/// Exactness of what lies under other shapes, in pixels.
const HIDDEN_TOLERANCE_PX: f64 = 0.1;

/// When what has a label is painted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turn {
    /// There is nothing there.
    Nothing,
    /// Pieces of one stack lie on each other: first come low stacks, and in these low ranks.
    Stacked { stack: usize, rank: usize },
    /// Light goes through it: it lies beside all others.
    Beside,
}

/// What is known of a picture's regions.
pub(super) struct Map<'a> {
    pub(super) regions: &'a Regions,
    pub(super) borders: &'a Borders,
    /// Of each border.
    pub(super) curves: &'a [Vec<PathSeg>],
    /// Of each label.
    pub(super) turns: &'a [Turn],
}

impl Map<'_> {
    fn turn(&self, region: Region) -> Turn {
        if region == BEYOND {
            return Turn::Nothing;
        }
        self.turns[usize::from(self.regions.labels[region as usize])]
    }

    fn has_label(&self, region: Region, label: u16) -> bool {
        region != BEYOND && self.regions.labels[region as usize] == label
    }

    /// The path that is filled for a label; empty where it is not to be seen.
    pub(super) fn fill(&self, label: u16) -> BezPath {
        let inside = self.inside(label);
        let is_inside = |region: Region| region != BEYOND && inside[region as usize];
        let mut sides: Vec<Side> = Vec::new();
        for (number, border) in self.borders.list.iter().enumerate() {
            match (is_inside(border.left), is_inside(border.right)) {
                (true, false) => sides.push(Side { number, is_reversed: false }),
                (false, true) => sides.push(Side { number, is_reversed: true }),
                _ => {}
            }
        }
        let mut path = self.loops(&sides);
        for side in sides {
            if self.reaches_under(side, label) {
                path.extend(strip(&self.along(side)));
            }
        }
        path
    }

    /// Which regions its path goes around: its own, and those that lie on them.
    fn inside(&self, label: u16) -> Vec<bool> {
        let count = self.regions.labels.len();
        let own = self.turns[usize::from(label)];
        let is_in = |region: usize| match (own, self.turn(region as Region)) {
            (Turn::Stacked { stack, rank }, Turn::Stacked { stack: other, rank: above }) => {
                stack == other && above >= rank
            }
            _ => self.regions.labels[region] == label && own != Turn::Nothing,
        };
        let mut inside: Vec<bool> = (0..count).map(is_in).collect();
        let mut sets = Sets::new(count);
        for border in &self.borders.list {
            if border.left != BEYOND && border.right != BEYOND {
                let (left, right) = (border.left as usize, border.right as usize);
                if inside[left] && inside[right] {
                    sets.join(left, right);
                }
            }
        }
        let mut is_ground = vec![false; count];
        for region in (0..count).filter(|&region| self.regions.labels[region] == label) {
            is_ground[sets.find(region)] = true;
        }
        for (region, inside) in inside.iter_mut().enumerate() {
            *inside &= is_ground[sets.find(region)];
        }
        inside
    }

    /// Whether another stack that is painted later lies beyond a side that is the label's own.
    fn reaches_under(&self, side: Side, label: u16) -> bool {
        let Border { left, right, .. } = self.borders.list[side.number];
        let (own, other) = if side.is_reversed { (right, left) } else { (left, right) };
        let later = match (self.turn(own), self.turn(other)) {
            (Turn::Stacked { stack, .. }, Turn::Stacked { stack: above, .. }) => above > stack,
            _ => false,
        };
        later && self.has_label(own, label)
    }

    /// A side's curves, with what it bounds on the left.
    fn along(&self, side: Side) -> Vec<PathSeg> {
        let curves = &self.curves[side.number];
        if side.is_reversed { curves.iter().rev().map(PathSeg::reverse).collect() } else { curves.clone() }
    }

    /// Closed paths along all of some sides: at each junction as many arrive as leave.
    fn loops(&self, sides: &[Side]) -> BezPath {
        let mut path = BezPath::new();
        let ends = |side: Side| {
            let [first, last] = self.borders.list[side.number].ends?;
            Some(if side.is_reversed { [last, first] } else { [first, last] })
        };
        let mut leaving: BTreeMap<usize, Vec<Side>> = BTreeMap::new();
        for &side in sides {
            match ends(side) {
                None => close(&mut path, &self.along(side)),
                Some([first, _]) => leaving.entry(first).or_default().push(side),
            }
        }
        while let Some(mut entry) = leaving.first_entry() {
            let start = *entry.key();
            let mut next = entry.get_mut().pop();
            let mut around: Vec<PathSeg> = Vec::new();
            while let Some(side) = next {
                around.extend(self.along(side));
                let at = ends(side).map_or(start, |[_, last]| last);
                next = if at == start { None } else { leaving.get_mut(&at).and_then(Vec::pop) };
            }
            close(&mut path, &around);
            leaving.retain(|_, sides| !sides.is_empty());
        }
        path
    }
}

/// A border with what is to be filled on its left, seen along the way.
#[derive(Clone, Copy, Debug)]
struct Side {
    number: usize,
    is_reversed: bool,
}

/// Adds segments that end where they begin.
fn close(path: &mut BezPath, around: &[PathSeg]) {
    let Some(first) = around.first() else { return };
    path.move_to(first.start());
    for segment in around {
        path.push(segment.as_path_el());
    }
    path.close_path();
}

/// A strip along the right of some curves, which is narrow at both ends: beyond these, other things lie there.
fn strip(along: &[PathSeg]) -> BezPath {
    let places = flattened(along);
    let length: f64 = places.windows(2).map(|pair| (pair[1] - pair[0]).hypot()).sum();
    let mut at = 0.0;
    let aside = places.iter().enumerate().map(|(index, place)| {
        let (before, after) = (places[index.saturating_sub(1)], places[(index + 1).min(places.len() - 1)]);
        at += (*place - before).hypot();
        let way = (after - before) / (after - before).hypot().max(1e-12);
        let reach = OVERLAP_PX.min(0.5 * at).min(0.5 * (length - at).max(0.0));
        *place + reach * Vec2::new(-way.y, way.x)
    });
    let aside: Vec<Point> = aside.collect();
    let mut path = BezPath::new();
    let around: Vec<PathSeg> = fit(&aside, [None, None], HIDDEN_TOLERANCE_PX)
        .into_iter()
        .chain(along.iter().rev().map(PathSeg::reverse))
        .collect();
    close(&mut path, &around);
    path
}

/// Curves as places, no farther apart than strips are narrow.
fn flattened(along: &[PathSeg]) -> Vec<Point> {
    let mut places = Vec::new();
    let first = along.first().map(|first| PathEl::MoveTo(first.start()));
    let elements = first.into_iter().chain(along.iter().map(PathSeg::as_path_el));
    kurbo::flatten(elements, HIDDEN_TOLERANCE_PX, |element| {
        let Some(to) = element.end_point() else { return };
        if let Some(&from) = places.last() {
            let steps = (((to - from) as Vec2).hypot() / (2.0 * OVERLAP_PX)).ceil().clamp(1.0, 1e4) as u32;
            let from: Point = from;
            places.extend((1..=steps).map(|step| from.lerp(to, f64::from(step) / f64::from(steps))));
        } else {
            places.push(to);
        }
    });
    places
}
