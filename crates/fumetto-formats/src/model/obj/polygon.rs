//! Faces of any number of corners, cut into triangles.

use earcut::Earcut;
use earcut::utils3d::project3d_to_2d;
use glam::{DVec3, Vec3};

use super::groups::Corner;

/// Faces of more corners are cut as if they were convex: taking off ears may take time that grows with
/// the square of their number, and no modelling program writes so many.
const MAX_CONCAVE_CORNERS: usize = 1000;

/// Adds the triangles of a face with at least three corners, which turn as the face does.
pub(super) fn triangulate(corners: &[Corner], positions: &[Vec3], triangles: &mut Vec<[Corner; 3]>) {
    let first = positions[corners[0].position as usize].as_dvec3();
    let place = |corner: &Corner| positions[corner.position as usize].as_dvec3() - first;
    if corners.len() > 3 && corners.len() <= MAX_CONCAVE_CORNERS {
        let outline: Vec<DVec3> = corners.iter().map(place).collect();
        let normal = normal(&outline);
        if !is_convex(&outline, normal) && cut_ears(corners, &outline, normal, triangles) {
            return;
        }
    }
    let (apex, rest) = (corners[0], &corners[1..]);
    triangles.extend(rest.windows(2).map(|pair| [apex, pair[0], pair[1]]));
}

/// A normal of an outline that need not be flat (Newell's method), as long as its area is large.
fn normal(outline: &[DVec3]) -> DVec3 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(here, next)| here.cross(*next)).sum()
}

/// Whether the outline turns the same way at every corner; true, too, for what is no number.
fn is_convex(outline: &[DVec3], normal: DVec3) -> bool {
    let count = outline.len();
    let turns_back = |i: usize| {
        let [before, here, next] = [outline[i], outline[(i + 1) % count], outline[(i + 2) % count]];
        (here - before).cross(next - here).dot(normal) < 0.0
    };
    !(0..count).any(turns_back)
}

/// Adds the triangles of a concave face; whether that was possible.
fn cut_ears(corners: &[Corner], outline: &[DVec3], normal: DVec3, triangles: &mut Vec<[Corner; 3]>) -> bool {
    let space: Vec<[f64; 3]> = outline.iter().map(DVec3::to_array).collect();
    let mut plane = Vec::new();
    if !outline.iter().all(|place| place.is_finite()) || !project3d_to_2d(&space, space.len(), &mut plane) {
        return false;
    }
    let mut ears: Vec<u32> = Vec::new();
    Earcut::new().earcut(plane, &[], &mut ears);
    for &[a, b, c] in ears.as_chunks::<3>().0 {
        let [a, b, c] = [a, b, c].map(|corner| corner as usize);
        let turn = (outline[b] - outline[a]).cross(outline[c] - outline[a]).dot(normal);
        let (b, c) = if turn < 0.0 { (c, b) } else { (b, c) };
        triangles.push([corners[a], corners[b], corners[c]]);
    }
    !ears.is_empty()
}
