//! Straight pieces of lines: contours of triangles, and edges. As `segment.wgsl` finds them for pictures.

use fumetto_scene::{EdgeKind, LightKind, Scene};
use glam::Vec3;
use rayon::prelude::*;

use super::{sight::Sight, solids::Solids};
use crate::shapes::mesh::{Candidate, bit};

/// A straight piece of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Segment {
    /// In the world; neighbours share an end bit by bit.
    pub(crate) ends: [Vec3; 2],
    /// Share of the first light that falls on the surface there.
    pub(crate) lit: [f32; 2],
    pub(crate) object: u32,
    pub(crate) kind: EdgeKind,
    /// Whether nothing of the surface at the line is seen, because it shows its unseen side, or bends the wrong way.
    pub(crate) is_behind: bool,
    /// Of a contour: one over the distance up to which the surface that it belongs to does not hide it, for triangles
    /// lie a little beside where that is smooth. Else 0.
    pub(crate) slack: f32,
    /// Of a contour: which surface that is.
    pub(crate) sheet: u32,
}

/// Pens of each object, by kinds, that draw along triangles.
pub(crate) type Draws = [bool; 4];

/// Square of the distance between unit normals up to which they are one. Also in `edges.rs`.
const SAME_NORMAL: f32 = 1e-6;

/// The light that thins lines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FirstLight(Option<LightKind>);

impl FirstLight {
    pub(crate) fn of(scene: &Scene) -> Self {
        Self(scene.lights.first().map(|light| light.kind))
    }

    /// Where nothing thins lines.
    #[cfg(test)]
    pub(super) fn none() -> Self {
        Self(None)
    }

    /// Share of it that falls on a surface.
    fn on(self, place: Vec3, normal: Vec3) -> f32 {
        let toward = match self.0 {
            None => return 0.0,
            Some(LightKind::Sun { direction }) => -Vec3::from(direction),
            Some(LightKind::Point { position }) => Vec3::from(position) - place,
        };
        normal.normalize_or_zero().dot(toward.normalize_or_zero()).max(0.0)
    }
}

/// What a view makes of a moment's vertices.
pub(crate) struct Finder<'a> {
    pub(crate) solids: &'a Solids,
    pub(crate) sight: &'a Sight,
    /// Of each object.
    pub(crate) draws: &'a [Draws],
    light: FirstLight,
    /// How far the surface is turned to the viewer at each vertex; below zero, it is turned away.
    turned: Vec<f32>,
}

impl<'a> Finder<'a> {
    pub(crate) fn new(solids: &'a Solids, sight: &'a Sight, draws: &'a [Draws], light: FirstLight) -> Self {
        let places = solids.positions.par_iter().zip(&solids.normals);
        let turned = places.map(|(&place, normal)| normal.dot(sight.eye - place)).collect();
        Self { solids, sight, draws, light, turned }
    }

    /// All pieces that a view has, in front of things or behind.
    pub(crate) fn segments(&self) -> Vec<Segment> {
        let contours =
            self.solids.triangles.par_iter().enumerate().filter_map(|(number, _)| self.contour(number));
        let edges = self.solids.candidates.par_iter().filter_map(|candidate| self.edge(candidate));
        contours.chain(edges).collect()
    }

    fn vertex(&self, number: u32) -> (Vec3, Vec3, f32) {
        let at = number as usize;
        (self.solids.positions[at], self.solids.normals[at], self.turned[at])
    }

    /// The line in a triangle along which the surface turns away.
    fn contour(&self, number: usize) -> Option<Segment> {
        let triangle = &self.solids.triangles[number];
        let [a, b, c] = triangle.corners;
        let away = [a, b, c].map(|corner| self.turned[corner as usize] < 0.0);
        if away[0] == away[1] && away[1] == away[2] {
            return None;
        }
        let part = self.solids.parts[triangle.part as usize];
        if !self.draws[part.object as usize][EdgeKind::Silhouette as usize] {
            return None;
        }
        let corners = [a, b, c].map(|corner| self.vertex(corner));
        let bends = |from: usize, to: usize| corners[from].1.distance_squared(corners[to].1) > SAME_NORMAL;
        if !bends(0, 1) && !bends(1, 2) && !bends(2, 0) {
            return None;
        }
        // Two sides are crossed: those at the corner that differs from the others.
        let odd = (0..3).find(|&at| away[at] != away[(at + 1) % 3] && away[at] != away[(at + 2) % 3])?;
        let (here, next, last) = (corners[odd], corners[(odd + 1) % 3], corners[(odd + 2) % 3]);
        let crossing = |from: (Vec3, Vec3, f32), to: (Vec3, Vec3, f32)| {
            let place = turning_point(from, to);
            (place, self.light.on(place, from.1.lerp(to.1, turning_share(from.2, to.2))))
        };
        let (start, end) = (crossing(last, here), crossing(here, next));
        let spots = corners.map(|corner| self.sight.spot(corner.0).near);
        let nearest = spots.into_iter().fold(0.0, f32::max);
        let farthest = spots.into_iter().fold(f32::MAX, f32::min);
        Some(Segment {
            ends: [start.0, end.0],
            lit: [start.1, end.1],
            object: part.object,
            kind: EdgeKind::Silhouette,
            is_behind: !part.is_double_sided && self.bends_inward(corners),
            // The neighbours in front of it are about as deep.
            slack: nearest + (nearest - farthest),
            sheet: self.solids.sheets[number],
        })
    }

    /// Whether the surface, seen from outside, is hollow along the line of sight: then a contour lies behind what
    /// it belongs to (radial curvature below zero; `DeCarlo` et al., "Suggestive Contours", 2003).
    fn bends_inward(&self, corners: [(Vec3, Vec3, f32); 3]) -> bool {
        let [a, b, c] = corners;
        let (right, left) = (b.0 - a.0, c.0 - a.0);
        let normal = right.cross(left);
        let toward = self.sight.eye - a.0;
        let along_right = toward.cross(left).dot(normal);
        let along_left = right.cross(toward).dot(normal);
        along_right * (b.2 - a.2) + along_left * (c.2 - a.2) < 0.0
    }

    /// The line along an edge, if it has one in this view.
    fn edge(&self, candidate: &Candidate) -> Option<Segment> {
        let object = candidate.object();
        let [a, b, _] = candidate.left;
        let (start, end) = (self.vertex(a), self.vertex(b));
        let has = |bit: u32| candidate.bits & bit != 0;
        let kinds = candidate.bits & (bit::CREASE | bit::BOUNDARY | bit::MATERIAL);
        let otherwise = self.pen(object, kinds);
        let left = [start.2, end.2];
        let left_unseen = has(bit::LEFT_ONE_SIDED) && left[0] + left[1] < 0.0;
        let found = |kind: EdgeKind, is_behind: bool, ends: [Vec3; 2]| Segment {
            ends,
            lit: [start, end].map(|(place, normal, _)| self.light.on(place, normal)),
            object: object as u32,
            kind,
            is_behind,
            slack: 0.0,
            sheet: u32::MAX,
        };
        let whole = [start.0, end.0];
        if !has(bit::PAIRED) {
            return Some(found(otherwise?, left_unseen, whole));
        }
        let [c, d, _] = candidate.right;
        let right = [self.turned[c as usize], self.turned[d as usize]];
        let is_behind = left_unseen && has(bit::RIGHT_ONE_SIDED) && right[0] + right[1] < 0.0;
        let sign = if has(bit::FLIPPED) { -1.0 } else { 1.0 };
        let facing = right.map(|turned| sign * turned);
        let differs = [0, 1].map(|end| (left[end] < 0.0) != (facing[end] < 0.0));
        let in_the_middle = (left[0] + left[1] < 0.0) != (facing[0] + facing[1] < 0.0);
        if !has(bit::HARD) || !(differs[0] || differs[1] || in_the_middle) {
            return Some(found(otherwise?, is_behind, whole));
        }
        let silhouette = self.draws[object][EdgeKind::Silhouette as usize].then_some(EdgeKind::Silhouette);
        if let Some(kind) = otherwise {
            let kind = silhouette.filter(|_| in_the_middle).unwrap_or(kind);
            return Some(found(kind, is_behind, whole));
        }
        // From where the contour of one side ends to where that of the other does.
        let kind = silhouette?;
        let place =
            |turned: [f32; 2]| turning_point((start.0, start.1, turned[0]), (end.0, end.1, turned[1]));
        let crossing = if (left[0] < 0.0) != (left[1] < 0.0) { place(left) } else { place(facing) };
        Some(match differs {
            [true, true] => found(kind, is_behind, whole),
            [true, false] => found(kind, is_behind, [start.0, crossing]),
            [false, true] => found(kind, is_behind, [crossing, end.0]),
            [false, false] => found(kind, is_behind, [place(left), place(facing)]),
        })
    }

    /// The first kind that a pen draws.
    fn pen(&self, object: usize, kinds: u32) -> Option<EdgeKind> {
        let order = [EdgeKind::Boundary, EdgeKind::Crease, EdgeKind::Material];
        order.into_iter().find(|&kind| kinds & (1 << kind as u32) != 0 && self.draws[object][kind as usize])
    }
}

fn turning_share(from: f32, to: f32) -> f32 {
    from / (from - to)
}

/// Where a surface turns away between two vertices. Both triangles at an edge ask from the same end, and so get the
/// same answer bit by bit.
fn turning_point(a: (Vec3, Vec3, f32), b: (Vec3, Vec3, f32)) -> Vec3 {
    let (from, to) = if a.2 < 0.0 { (a, b) } else { (b, a) };
    from.0.lerp(to.0, turning_share(from.2, to.2))
}
