//! The cases of marching cubes (Lorensen & Cline 1987), worked out rather than written down.
//!
//! Which edges a polygon has on a cell's face depends on the signs of that face's four corners and on
//! nothing else, so the two cells that share a face agree on it, and the surface has no holes. Where a face
//! is ambiguous (two inside corners, diagonally opposed), the inside corners are kept apart.
//!
//! Corners and edges are numbered as in `cell.wgsl` and `triangles.wgsl`.

/// Polygons of all 256 cases, packed for `cell.wgsl`.
pub(super) fn packed() -> Vec<[u32; 2]> {
    (0..=255).map(|case| pack(&triangles(case))).collect()
}

/// Triangles of a case: three edges each, counter-clockwise as seen from outside of the surface.
pub(super) fn triangles(case: u8) -> Vec<[u8; 3]> {
    polygons(case).iter().flat_map(|polygon| fan(polygon)).collect()
}

/// The two ends of an edge, the lower first.
pub(super) const fn ends(edge: u8) -> [u8; 2] {
    let axis = edge / 4;
    let low = ((edge & 1) << ((axis + 1) % 3)) | ((edge >> 1 & 1) << ((axis + 2) % 3));
    [low, low | 1 << axis]
}

fn pack(triangles: &[[u8; 3]]) -> [u32; 2] {
    let edges = triangles.as_flattened().iter().rev().fold(0_u64, |word, &edge| word << 4 | u64::from(edge));
    let word = edges | (triangles.len() as u64) << 60;
    [word as u32, (word >> 32) as u32]
}

/// Closed polygons, each a ring of edges.
fn polygons(case: u8) -> Vec<Vec<u8>> {
    let mut next = [None; 12];
    for face in faces() {
        let crossings = crossings(case, face);
        // A polygon enters each run of inside corners and leaves at its end.
        for (index, &(edge, entering)) in crossings.iter().enumerate() {
            if entering {
                next[usize::from(edge)] = Some(crossings[(index + 1) % crossings.len()].0);
            }
        }
    }
    let mut rings = Vec::new();
    for first in 0..12 {
        let mut ring = Vec::new();
        let mut edge = first;
        while let Some(following) = next[usize::from(edge)].take() {
            ring.push(edge);
            edge = following;
        }
        if !ring.is_empty() {
            rings.push(ring);
        }
    }
    rings
}

/// The corners of each face, counter-clockwise as seen from outside the cell.
fn faces() -> [[u8; 4]; 6] {
    std::array::from_fn(|face| {
        let axis = face / 2;
        let [u, v] = [1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3)];
        if face % 2 == 0 { [0, v, u | v, u] } else { [0, u, u | v, v].map(|corner| corner | 1 << axis) }
    })
}

/// The crossed edges round a face, and whether they lead inside.
fn crossings(case: u8, face: [u8; 4]) -> Vec<(u8, bool)> {
    (0..4)
        .filter_map(|index| {
            let [from, to] = [face[index], face[(index + 1) % 4]];
            let inside = |corner: u8| case >> corner & 1 == 1;
            (inside(from) != inside(to)).then(|| (edge_between(from, to), inside(to)))
        })
        .collect()
}

fn edge_between(a: u8, b: u8) -> u8 {
    let [axis, low] = [(a ^ b).trailing_zeros() as u8, a & b];
    4 * axis + (low >> ((axis + 1) % 3) & 1) + 2 * (low >> ((axis + 2) % 3) & 1)
}

/// Triangles that share one corner of the polygon.
///
/// The corner is chosen so that no diagonal lies in a face of the cell: the cell beyond might have the same
/// diagonal, and four triangles would share it. Every case has such a corner; the tests try them all.
fn fan(polygon: &[u8]) -> Vec<[u8; 3]> {
    let count = polygon.len();
    let at = |index: usize| polygon[index % count];
    let is_clear = |&first: &usize| (2..count - 1).all(|step| !share_face(at(first), at(first + step)));
    let first = (0..count).find(is_clear).unwrap_or(0);
    (1..count - 1).map(|step| [at(first), at(first + step), at(first + step + 1)]).collect()
}

fn share_face(a: u8, b: u8) -> bool {
    let corners = [ends(a), ends(b)].concat();
    faces().iter().any(|face| corners.iter().all(|corner| face.contains(corner)))
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use super::*;

    #[test]
    fn no_diagonal_lies_in_a_face() {
        for case in 0..=255 {
            for polygon in polygons(case) {
                let sides: Vec<_> =
                    (0..polygon.len()).map(|i| [polygon[i], polygon[(i + 1) % polygon.len()]]).collect();
                for triangle in fan(&polygon) {
                    for side in [0, 1, 2].map(|i| [triangle[i], triangle[(i + 1) % 3]]) {
                        let is_side = sides.contains(&side) || sides.contains(&[side[1], side[0]]);
                        assert!(is_side || !share_face(side[0], side[1]), "case {case}: {side:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn every_crossed_edge_has_a_corner_and_no_other_has() {
        for case in 0..=255_u8 {
            let mut used: Vec<_> = polygons(case).concat();
            used.sort_unstable();
            let crossed = |&edge: &u8| {
                let [low, high] = ends(edge).map(|corner| case >> corner & 1);
                low != high
            };
            assert_eq!(used, (0..12).filter(crossed).collect::<Vec<_>>(), "case {case}");
        }
    }

    #[test]
    fn a_single_inside_corner_is_cut_off_and_faces_away() {
        // Corner 0: edges along x, y and z. Seen from the far corner they are counter-clockwise.
        assert_eq!(triangles(1), [[0, 4, 8]]);
        assert!(triangles(0).is_empty() && triangles(255).is_empty());
    }

    #[test]
    fn cells_of_any_two_cases_agree_on_the_face_between_them() {
        // Sides that lie in the face beyond +x of one cell, and in the face at -x of the other.
        let sides_in = |case: u8, face: [u8; 4]| {
            let within = |edge: u8| ends(edge).iter().all(|corner| face.contains(corner));
            let mut count = HashMap::new();
            for triangle in triangles(case) {
                for [a, b] in [0, 1, 2].map(|i| [triangle[i], triangle[(i + 1) % 3]]) {
                    if within(a) && within(b) {
                        *count.entry([a, b].map(|edge| ends(edge).map(|corner| corner & 6))).or_insert(0) +=
                            1;
                    }
                }
            }
            count
        };
        let [low, high] = [faces()[0], faces()[1]];
        for left in 0..=255_u8 {
            // The face's signs, then all that the other cell may have beyond.
            let shared = left >> 1 & 0x55;
            for beyond in 0..16_u8 {
                let far = (0..4).fold(0, |bits, i| bits | (beyond >> i & 1) << (2 * i + 1));
                let there = sides_in(shared | far, low);
                let here = sides_in(left, high);
                let turned: HashMap<_, _> = there.iter().map(|(&[a, b], &count)| ([b, a], count)).collect();
                assert_eq!(here, turned, "cases {left} and {}", shared | far);
            }
        }
    }

    #[test]
    fn a_packed_case_holds_its_triangles() {
        for case in 0..=255 {
            let [low, high] = packed()[usize::from(case)];
            let word = u64::from(high) << 32 | u64::from(low);
            let edges: Vec<_> = triangles(case)
                .concat()
                .iter()
                .enumerate()
                .map(|(i, _)| (word >> (4 * i) & 15) as u8)
                .collect();
            assert_eq!(edges, triangles(case).concat());
            assert_eq!((word >> 60) as usize, triangles(case).len());
        }
    }
}
