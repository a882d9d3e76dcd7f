//! Normals of a surface that comes without, or with ones that are not wanted.

use glam::{DVec3, Vec3};
use rustc_hash::FxHashMap;

use super::mend::Surface;

/// How far apart two angles' cosines must be to differ: a prism's edges of exactly the angle that is
/// asked for come out alike in spite of rounding.
const SAME_COSINE: f32 = 1e-4;

/// Up to this many triangles at one edge are compared each with each; where more meet, nobody can say
/// which belong together, and every one is compared with its next, so that the work stays linear.
const MAX_COMPARED: usize = 6;

/// Computes the normals of `surface` anew: smooth across edges at which triangles meet with less than
/// `smooth_degrees`, sharp across the others. A vertex on a sharp edge becomes several.
///
/// Vertices in the same place count as one, whatever else is different about them. Each triangle weighs
/// as much as its angle at the vertex (Thürmer and Wüthrich 1998, "Computing vertex normals from
/// polygonal facets"), so that the way in which faces are cut into triangles does not show.
pub(super) fn compute(surface: &mut Surface, smooth_degrees: f32) {
    let faces: Vec<Vec3> = surface.triangles.iter().map(|&corners| face_normal(surface, corners)).collect();
    let mut fans = Fans::new(3 * surface.triangles.len());
    join_smooth_edges(surface, &faces, smooth_degrees, &mut fans);

    let mut sums = vec![Vec3::ZERO; 3 * surface.triangles.len()];
    for (face, &corners) in surface.triangles.iter().enumerate() {
        for corner in 0..3 {
            sums[fans.of(3 * face + corner)] += angle(surface, corners, corner) * faces[face];
        }
    }
    split(surface, &faces, &sums, &mut fans);
}

/// The mean of the normals of the triangles at each vertex, without splitting any.
pub(super) fn mean(surface: &Surface) -> Vec<Vec3> {
    let mut sums = vec![Vec3::ZERO; surface.positions.len()];
    for &corners in &surface.triangles {
        let normal = face_normal(surface, corners);
        for corner in 0..3 {
            sums[corners[corner] as usize] += angle(surface, corners, corner) * normal;
        }
    }
    sums.into_iter().map(|sum| sum.normalize_or(Vec3::Y)).collect()
}

/// The corner of `triangle`, in double precision: squares of distances may leave the single one's range.
fn corner(surface: &Surface, vertex: u32) -> DVec3 {
    surface.positions[vertex as usize].as_dvec3()
}

fn face_normal(surface: &Surface, [a, b, c]: [u32; 3]) -> Vec3 {
    let [a, b, c] = [a, b, c].map(|vertex| corner(surface, vertex));
    (b - a).cross(c - a).normalize_or(DVec3::Y).as_vec3()
}

/// The angle of a triangle at one of its corners, in radians.
fn angle(surface: &Surface, triangle: [u32; 3], at: usize) -> f32 {
    let [here, next, last] = [0, 1, 2].map(|step| corner(surface, triangle[(at + step) % 3]));
    (next - here).angle_between(last - here) as f32
}

/// Puts the corners on both sides of every smooth edge into one fan.
fn join_smooth_edges(surface: &Surface, faces: &[Vec3], smooth_degrees: f32, fans: &mut Fans) {
    let least_cosine = smooth_degrees.to_radians().cos() + SAME_COSINE;
    let edges = edges(surface);
    for edge in edges.chunk_by(|a, b| a.ends == b.ends) {
        let reach = if edge.len() <= MAX_COMPARED { edge.len() } else { 2 };
        for (i, one) in edge.iter().enumerate() {
            for other in edge[i + 1..].iter().take(reach - 1) {
                let cosine = faces[one.corners[0] as usize / 3].dot(faces[other.corners[0] as usize / 3]);
                if cosine > least_cosine {
                    fans.join(one.corners[0] as usize, other.corners[0] as usize);
                    fans.join(one.corners[1] as usize, other.corners[1] as usize);
                }
            }
        }
    }
}

/// A triangle's side.
struct Edge {
    /// The places that it joins, the smaller number first.
    ends: [u32; 2],
    /// The triangle's corners there: three times its number, and which of the three.
    corners: [u32; 2],
}

/// The sides of all triangles, those between the same places one after another.
fn edges(surface: &Surface) -> Vec<Edge> {
    let mut numbers = FxHashMap::default();
    // Adding zero makes one zero of the two, which have different bits.
    let bits = |position: Vec3| (position + Vec3::ZERO).to_array().map(f32::to_bits);
    let places: Vec<u32> = surface
        .positions
        .iter()
        .map(|&position| {
            let next = numbers.len() as u32;
            *numbers.entry(bits(position)).or_insert(next)
        })
        .collect();

    let mut edges = Vec::with_capacity(3 * surface.triangles.len());
    for (face, triangle) in surface.triangles.iter().enumerate() {
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            let place = |corner: usize| places[triangle[corner] as usize];
            let (from, to) = if place(from) <= place(to) { (from, to) } else { (to, from) };
            let corners = [from, to].map(|corner| (3 * face + corner) as u32);
            edges.push(Edge { ends: [place(from), place(to)], corners });
        }
    }
    edges.sort_unstable_by_key(|edge| (edge.ends, edge.corners));
    edges
}

/// Gives every fan at a vertex a vertex of its own, with the fan's normal.
fn split(surface: &mut Surface, faces: &[Vec3], sums: &[Vec3], fans: &mut Fans) {
    let mut numbers = FxHashMap::default();
    let mut kept = Vec::new();
    let mut normals = Vec::new();
    for (face, triangle) in surface.triangles.iter_mut().enumerate() {
        for (corner, vertex) in triangle.iter_mut().enumerate() {
            let fan = fans.of(3 * face + corner);
            *vertex = *numbers.entry((*vertex, fan)).or_insert_with(|| {
                kept.push(*vertex);
                normals.push(sums[fan].normalize_or(faces[face]));
                kept.len() as u32 - 1
            });
        }
    }
    surface.gather(&kept);
    surface.normals = normals;
}

/// Corners that share a normal: disjoint sets, each known by one of its members.
struct Fans {
    toward: Vec<u32>,
}

impl Fans {
    /// Every one of `corners` corners for itself.
    fn new(corners: usize) -> Self {
        Self { toward: (0..corners as u32).collect() }
    }

    /// The corner by which the fan of `corner` is known.
    fn of(&mut self, corner: usize) -> usize {
        let mut at = corner;
        while self.toward[at] as usize != at {
            // Halving the path as it is walked keeps all paths short.
            self.toward[at] = self.toward[self.toward[at] as usize];
            at = self.toward[at] as usize;
        }
        at
    }

    /// Makes one fan of two.
    fn join(&mut self, one: usize, other: usize) {
        let (one, other) = (self.of(one), self.of(other));
        let (first, second) = (one.min(other), one.max(other));
        self.toward[second] = first as u32;
    }
}
