//! The mesh of a volume: an icosahedron whose edges are cut into pieces, and the radius between its vertices.
//!
//! A vertex is a direction. The radius in any other one is a weighted mean of the vertices around: each weighs
//! (1 - d²/ρ²)³ at the distance d, and ρ is as far as just those triangles reach that know of it. So the radius is
//! smooth, up to its second derivative, wherever triangles meet: a border has no corners however near it is seen.
//! And it lies between the least and the largest radius of all vertices, so that most places need not ask.

use std::collections::{BTreeMap, BTreeSet};

use bytemuck::{Pod, Zeroable};
use glam::{Mat3, Vec3, Vec4};

/// Vertices that weigh in a triangle: its corners, and those next to them. Also in `sphere.wgsl`.
pub(super) const PATCH: usize = 12;

/// Stands for no vertex: at the corners of the icosahedron one fewer meet. Also in `sphere.wgsl`.
const NO_VERTEX: u32 = u32::MAX;

const PHI: f32 = 1.618_034;

/// Faces of an icosahedron.
const FACES: usize = 20;

/// The same for all volumes: `Icosahedron` of `sphere.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Icosahedron {
    /// Of each face, what turns a direction into shares of its corners: the rows of a matrix.
    shares: [[Vec4; 3]; FACES],
    /// By the sort of a direction (see `face_of` in `sphere.wgsl`), its face.
    faces: [u32; 32],
}

/// An icosahedron whose edges are cut into so many pieces.
#[derive(Clone, Debug, Default)]
pub(super) struct Sphere {
    /// Unit vectors, and 1/ρ².
    pub(super) directions: Vec<Vec4>,
    /// Of each triangle, the vertices that weigh in it.
    pub(super) patches: Vec<[u32; PATCH]>,
}

/// All corners: cyclic permutations of (0, ±1, ±φ).
fn corners() -> Vec<Vec3> {
    let mut corners = Vec::with_capacity(12);
    for turn in 0..3 {
        for (one, phi) in [(1.0, PHI), (-1.0, PHI), (1.0, -PHI), (-1.0, -PHI)] {
            let mut corner = [0.0; 3];
            corner[(turn + 1) % 3] = one;
            corner[(turn + 2) % 3] = phi;
            corners.push(Vec3::from(corner).normalize_or_zero());
        }
    }
    corners
}

/// The corners of each face, anticlockwise from outside.
fn faces(corners: &[Vec3]) -> Vec<[usize; 3]> {
    // Neighbours are 63 degrees apart, all others 117 or more.
    let touch = |a: usize, b: usize| corners[a].dot(corners[b]) > 0.3;
    let mut faces = Vec::with_capacity(FACES);
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if touch(a, b) && touch(b, c) && touch(c, a) {
                    let outward = corners[a].cross(corners[b]).dot(corners[c]) > 0.0;
                    faces.push(if outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    faces
}

impl Icosahedron {
    pub(super) fn new() -> Self {
        let corners = corners();
        let faces = faces(&corners);
        let mut icosahedron: Self = Zeroable::zeroed();
        for (shares, face) in icosahedron.shares.iter_mut().zip(&faces) {
            let [a, b, c] = face.map(|corner| corners[corner]);
            let rows = Mat3::from_cols(a, b, c).inverse().transpose();
            *shares = [rows.x_axis, rows.y_axis, rows.z_axis].map(|row| row.extend(0.0));
        }
        let middle = |face: &[usize; 3]| face.iter().map(|&corner| corners[corner]).sum::<Vec3>();
        for (sort, slot) in icosahedron.faces.iter_mut().enumerate() {
            let toward = middle_of_sort(sort);
            let nearest = |a: &usize, b: &usize| {
                let share = |face: usize| middle(&faces[face]).dot(toward);
                share(*a).total_cmp(&share(*b))
            };
            *slot = (0..FACES).max_by(nearest).unwrap_or(0) as u32;
        }
        icosahedron
    }
}

/// The middles of the faces are the corners of a dodecahedron: four kinds of places, mirrored in the planes
/// between the axes. Where a kind has a 0, both signs mean the same.
fn middle_of_sort(sort: usize) -> Vec3 {
    let kind =
        [[1.0, 1.0, 1.0], [1.0 / PHI, 0.0, PHI], [PHI, 1.0 / PHI, 0.0], [0.0, PHI, 1.0 / PHI]][sort / 8];
    let sign = |axis: usize| if (sort >> axis) & 1 == 1 { -1.0 } else { 1.0 };
    Vec3::new(kind[0] * sign(0), kind[1] * sign(1), kind[2] * sign(2))
}

impl Sphere {
    /// `pieces` along each edge.
    pub(super) fn new(pieces: u32) -> Self {
        let (places, triangles) = mesh(pieces);
        let mut around = vec![BTreeSet::new(); places.len()];
        for triangle in &triangles {
            for &corner in triangle {
                around[corner as usize].extend(triangle);
            }
        }
        let patch = |triangle: &[u32; 3]| -> BTreeSet<u32> {
            triangle.iter().flat_map(|&corner| around[corner as usize].iter().copied()).collect()
        };
        let patches: Vec<_> = triangles.iter().map(patch).collect();
        let reaches = reaches(&places, &triangles, &patches);
        let list = |patch: &BTreeSet<u32>| {
            let mut list = [NO_VERTEX; PATCH];
            for (slot, &vertex) in list.iter_mut().zip(patch) {
                *slot = vertex;
            }
            list
        };
        let direction = |(place, reach): (&Vec3, &f32)| place.extend(1.0 / (reach * reach));
        Self {
            directions: places.iter().zip(&reaches).map(direction).collect(),
            patches: patches.iter().map(list).collect(),
        }
    }
}

/// The vertices, and the triangles face after face. Those of a face lie in rows from its second edge on; in each
/// row those that stand as the face does come in turn with those that stand on their heads.
fn mesh(pieces: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let corners = corners();
    let mut places = Vec::new();
    // Shares of corners tell a vertex that several faces have.
    let mut known: BTreeMap<Vec<(usize, u32)>, u32> = BTreeMap::new();
    let mut triangles = Vec::new();
    for face in faces(&corners) {
        let mut vertex = |i: u32, j: u32| {
            let shares = [i, j, pieces - i - j];
            let mut key: Vec<_> = face.into_iter().zip(shares).filter(|(_, share)| *share > 0).collect();
            key.sort_unstable();
            *known.entry(key).or_insert_with_key(|key| {
                let sum: Vec3 = key.iter().map(|&(corner, share)| corners[corner] * share as f32).sum();
                places.push(sum.normalize_or_zero());
                places.len() as u32 - 1
            })
        };
        for i in 0..pieces {
            for j in 0..pieces - i {
                triangles.push([vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)]);
                if i + j + 1 < pieces {
                    triangles.push([vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
                }
            }
        }
    }
    (places, triangles)
}

/// How far each vertex reaches: to the nearest triangle that does not know of it.
fn reaches(places: &[Vec3], triangles: &[[u32; 3]], patches: &[BTreeSet<u32>]) -> Vec<f32> {
    // Around the triangles that know of a vertex runs a ring of edges that only one of them has.
    let mut rings: Vec<BTreeSet<[u32; 2]>> = vec![BTreeSet::new(); places.len()];
    for (triangle, patch) in triangles.iter().zip(patches) {
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            let edge = [a.min(b), a.max(b)];
            for &vertex in patch {
                if !rings[vertex as usize].remove(&edge) {
                    rings[vertex as usize].insert(edge);
                }
            }
        }
    }
    let reach = |(place, ring): (&Vec3, &BTreeSet<[u32; 2]>)| {
        let distances = ring.iter().flat_map(|edge| {
            let [a, b] = edge.map(|end| places[end as usize]);
            let along = ((*place - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            // An edge is an arc, whose ends may be nearer than its middle.
            [a, b, (a + along * (b - a)).normalize_or_zero()].map(|at| place.distance(at))
        });
        // Where everybody knows of everybody there is no ring, and no two places are farther apart.
        distances.fold(2.0, f32::min)
    };
    places.iter().zip(&rings).map(reach).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: Icosahedron, "Icosahedron" of "paint/mask" { shares, faces });

    #[test]
    fn pieces_make_the_vertices_that_they_should() {
        for (pieces, vertices) in [(1, 12), (2, 42), (4, 162), (8, 642), (16, 2562)] {
            let (places, triangles) = mesh(pieces);
            assert_eq!((places.len(), triangles.len()), (vertices, 2 * vertices - 4), "Euler's formula");
            assert!(places.iter().all(|place| (place.length() - 1.0).abs() < 1e-6));
            let out = |t: &[u32; 3]| {
                let [a, b, c] = t.map(|corner| places[corner as usize]);
                a.cross(b).dot(c) > 0.0
            };
            assert!(triangles.iter().all(out), "all are seen from outside alike");
        }
    }

    #[test]
    fn every_place_has_three_vertices_or_more_in_reach_and_no_stranger() {
        for pieces in [1, 2, 3, 8] {
            let sphere = Sphere::new(pieces);
            let (places, triangles) = mesh(pieces);
            for (triangle, patch) in triangles.iter().zip(&sphere.patches) {
                for [u, v] in [[0.0, 0.0], [0.3, 0.3], [0.5, 0.0], [0.1, 0.8], [0.5, 0.5]] {
                    let [a, b, c] = triangle.map(|corner| places[corner as usize]);
                    let at = (a * (1.0 - u - v) + b * u + c * v).normalize_or_zero();
                    let in_reach =
                        |direction: &Vec4| at.distance_squared(direction.truncate()) * direction.w < 0.999;
                    let mut near = (0..).zip(&sphere.directions).filter(|(_, direction)| in_reach(direction));
                    assert!(near.clone().count() >= 3);
                    assert!(near.all(|(number, _)| patch.contains(&number)), "{pieces} pieces");
                }
            }
        }
    }

    #[test]
    fn the_sort_of_a_direction_tells_its_face() {
        let icosahedron = Icosahedron::new();
        let corners = corners();
        for (number, face) in faces(&corners).iter().enumerate() {
            let middle = face.iter().map(|&corner| corners[corner]).sum::<Vec3>();
            let shares = icosahedron.shares[number].map(|row| row.truncate().dot(middle));
            assert!(shares.iter().all(|share| (share - 1.0).abs() < 1e-5), "{shares:?}");
            let sorts = (0..32).filter(|&sort| {
                middle_of_sort(sort).normalize_or_zero().dot(middle.normalize_or_zero()) > 0.999
            });
            let mut count = 0;
            for sort in sorts {
                assert_eq!(icosahedron.faces[sort], number as u32);
                count += 1;
            }
            assert!(count >= 1, "face {number} has a sort");
        }
    }
}
