//! Where on a model lines may run: found once, when it is loaded.
//!
//! Real-Time Rendering, section 11.2, tells edges apart as we do. Ours: where normals are smooth, the line
//! along which the surface turns away runs through triangles and not along their edges, which would make it
//! zigzag; such triangles are candidates, too.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use super::{
    geometry::{DOUBLE_SIDED, Geometry},
    smooth::unpacked,
    weld::weld,
};

/// `Candidate` of `candidate.wgsl`: an edge with its triangles, or a triangle with a contour in it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
pub(crate) struct Candidate {
    pub(crate) left: [u32; 3],
    pub(crate) bits: u32,
    pub(crate) right: [u32; 3],
    pub(crate) pad: u32,
}

impl Candidate {
    /// Number of the object that it belongs to.
    pub(crate) fn object(&self) -> usize {
        (self.bits >> OBJECT_SHIFT) as usize
    }
}

/// Bits of a candidate, as in `candidate.wgsl`. The first four are those of the kinds of edges.
pub(crate) mod bit {
    pub(crate) const CONTOUR: u32 = 1;
    pub(crate) const CREASE: u32 = 1 << 1;
    pub(crate) const BOUNDARY: u32 = 1 << 2;
    pub(crate) const MATERIAL: u32 = 1 << 3;
    /// Normals differ from side to side.
    pub(crate) const HARD: u32 = 1 << 4;
    /// The triangles wind against each other.
    pub(crate) const FLIPPED: u32 = 1 << 5;
    pub(crate) const LEFT_ONE_SIDED: u32 = 1 << 6;
    pub(crate) const RIGHT_ONE_SIDED: u32 = 1 << 7;
    pub(crate) const PAIRED: u32 = 1 << 8;
}

/// Where a candidate's object begins among its bits.
pub(crate) const OBJECT_SHIFT: u32 = 16;

/// Square of the distance between unit normals up to which they are one: rounding, in files and by us.
pub(super) const SAME_NORMAL: f32 = 1e-6;

/// Most triangles at one edge whose neighbours are worth finding; beyond it the model is broken, and the time
/// to pair them grows with the square.
const MOST_AT_AN_EDGE: usize = 8;

/// A side of a triangle: three times its number, and which side.
type HalfEdge = u32;

/// All places of `geometry` where a line may run. `crease_degs` has for each object the angle from which on
/// edges are creases, or nothing where no lines are wanted.
pub(crate) fn candidates(geometry: &Geometry, crease_degs: &[Option<f32>]) -> Vec<Candidate> {
    let finder = Finder {
        geometry,
        welded: weld(&geometry.sources, &geometry.groups),
        normals: geometry.sources.iter().map(|source| unpacked(source.normal)).collect(),
        faces: (0..geometry.triangles.len()).map(|number| face_normal(geometry, number)).collect(),
        crease_cosines: crease_degs.iter().map(|deg| deg.map(|deg| deg.to_radians().cos())).collect(),
    };
    let mut found = Vec::new();
    for half_edges in finder.half_edges().chunk_by(|a, b| a.0 == b.0) {
        finder.add_edges(half_edges, &mut found);
    }
    found.extend((0..geometry.triangles.len() as u32).filter_map(|number| finder.contour(number)));
    found
}

struct Finder<'a> {
    geometry: &'a Geometry,
    /// The vertex that stands for all at its place.
    welded: Vec<usize>,
    /// Each vertex's.
    normals: Vec<Vec3>,
    /// Each triangle's own, of length 1.
    faces: Vec<Vec3>,
    crease_cosines: Vec<Option<f32>>,
}

/// In the world, as far as the part has not lost a dimension.
fn face_normal(geometry: &Geometry, number: usize) -> Vec3 {
    let triangle = &geometry.triangles[number];
    let world_from_part = geometry.parts[triangle.part as usize].world_from_part;
    let [a, b, c] = triangle.corners.map(|corner| Vec3::from(geometry.sources[corner as usize].position));
    let cross = |turn: &dyn Fn(Vec3) -> Vec3| turn(b - a).cross(turn(c - a)).normalize_or_zero();
    let normal = cross(&|along| world_from_part.transform_vector3(along));
    if normal == Vec3::ZERO { cross(&|along| along) } else { normal }
}

impl Finder<'_> {
    /// All sides of triangles that have lines, those between the same two places together.
    fn half_edges(&self) -> Vec<(u64, HalfEdge)> {
        let triangles = (0..).zip(&self.geometry.triangles);
        let mut half_edges: Vec<_> = triangles
            .filter(|(number, _)| self.crease_cosines[self.object(3 * number) as usize].is_some())
            .flat_map(|(number, triangle)| {
                let [a, b, c] = triangle.corners.map(|corner| self.welded[corner as usize] as u64);
                let key = |from: u64, to: u64| (from.min(to) << 32) | from.max(to);
                [(key(a, b), 3 * number), (key(b, c), 3 * number + 1), (key(c, a), 3 * number + 2)]
            })
            .collect();
        half_edges.sort_unstable();
        half_edges
    }

    /// The half-edge's first and last vertex, and the corner opposite.
    fn corners(&self, half_edge: HalfEdge) -> [u32; 3] {
        let [a, b, c] = self.geometry.triangles[half_edge as usize / 3].corners;
        [[a, b, c], [b, c, a], [c, a, b]][half_edge as usize % 3]
    }

    fn part(&self, half_edge: HalfEdge) -> usize {
        self.geometry.triangles[half_edge as usize / 3].part as usize
    }

    fn object(&self, half_edge: HalfEdge) -> u32 {
        self.geometry.parts[self.part(half_edge)].object
    }

    fn face(&self, half_edge: HalfEdge) -> Vec3 {
        self.faces[half_edge as usize / 3]
    }

    /// Whether the two triangles wind against each other, and so pass their edge the same way.
    fn is_flipped(&self, left: HalfEdge, right: HalfEdge) -> bool {
        let first = |half_edge| self.welded[self.corners(half_edge)[0] as usize];
        first(left) == first(right)
    }

    /// The cosine of the angle by which the surface turns at the edge.
    fn turn(&self, left: HalfEdge, right: HalfEdge) -> f32 {
        let cosine = self.face(left).dot(self.face(right));
        if self.is_flipped(left, right) { -cosine } else { cosine }
    }

    /// Adds the edges that run between two places.
    fn add_edges(&self, half_edges: &[(u64, HalfEdge)], found: &mut Vec<Candidate>) {
        match half_edges {
            &[(_, only)] => found.push(self.single(only, bit::BOUNDARY)),
            &[(_, left), (_, right)] => found.extend(self.pair(left, right)),
            &[(_, first), ..] if half_edges.len() > MOST_AT_AN_EDGE => {
                found.push(self.single(first, bit::CREASE));
            }
            many => {
                // Sheets that meet: the straightest neighbours belong together, the others end at a joint.
                let mut open: Vec<HalfEdge> = many.iter().map(|&(_, half_edge)| half_edge).collect();
                while let Some((left, right)) = self.straightest(&open) {
                    open.retain(|&half_edge| half_edge != left && half_edge != right);
                    found.extend(self.pair(left, right));
                }
                found.extend(open.into_iter().map(|half_edge| self.single(half_edge, bit::CREASE)));
            }
        }
    }

    /// The two of `open` that wind alike between which the surface turns the least.
    fn straightest(&self, open: &[HalfEdge]) -> Option<(HalfEdge, HalfEdge)> {
        let pairs = open
            .iter()
            .enumerate()
            .flat_map(|(at, &left)| open[at + 1..].iter().map(move |&right| (left, right)));
        pairs
            .filter(|&(left, right)| !self.is_flipped(left, right))
            .max_by(|&a, &b| self.turn(a.0, a.1).total_cmp(&self.turn(b.0, b.1)))
    }

    fn single(&self, half_edge: HalfEdge, kind: u32) -> Candidate {
        Candidate {
            left: self.corners(half_edge),
            bits: kind | self.common_bits(half_edge, half_edge),
            right: [0; 3],
            pad: 0,
        }
    }

    /// The edge between two triangles, if a line may run there.
    fn pair(&self, left: HalfEdge, right: HalfEdge) -> Option<Candidate> {
        let flipped = self.is_flipped(left, right);
        let [a, b, left_apex] = self.corners(left);
        let [c, d, right_apex] = self.corners(right);
        let [c, d] = if flipped { [c, d] } else { [d, c] };
        let apart = [[a, c], [b, d]].map(|[left, right]| {
            let right = if flipped { -self.normal(right) } else { self.normal(right) };
            self.normal(left).distance_squared(right)
        });
        let crease_cosine = self.crease_cosines[self.object(left) as usize]?;
        // A chord between unit vectors tells the cosine of their angle.
        let turns = apart.iter().all(|apart| 1.0 - 0.5 * apart < crease_cosine);
        let material = |half_edge| self.geometry.parts[self.part(half_edge)].material;
        let bits = [
            (turns || self.turn(left, right) < crease_cosine, bit::CREASE),
            (material(left) != material(right), bit::MATERIAL),
            (apart.iter().any(|&apart| apart > SAME_NORMAL), bit::HARD),
        ];
        let kinds = bits.iter().filter(|(on, _)| *on).fold(0, |bits, (_, bit)| bits | bit);
        let flip = if flipped { bit::FLIPPED } else { 0 };
        (kinds != 0).then(|| Candidate {
            left: [a, b, left_apex],
            bits: kinds | flip | bit::PAIRED | self.common_bits(left, right),
            right: [c, d, right_apex],
            pad: 0,
        })
    }

    /// A triangle in which the surface may turn away, for its normals differ.
    fn contour(&self, number: u32) -> Option<Candidate> {
        self.crease_cosines[self.object(3 * number) as usize]?;
        let corners = self.corners(3 * number);
        let [a, b, c] = corners.map(|corner| self.normal(corner));
        let bends = |from: Vec3, to: Vec3| from.distance_squared(to) > SAME_NORMAL;
        (bends(a, b) || bends(b, c) || bends(c, a)).then(|| Candidate {
            left: corners,
            bits: bit::CONTOUR | self.common_bits(3 * number, 3 * number),
            right: [0; 3],
            pad: 0,
        })
    }

    fn normal(&self, vertex: u32) -> Vec3 {
        self.normals[vertex as usize]
    }

    fn common_bits(&self, left: HalfEdge, right: HalfEdge) -> u32 {
        let one_sided = |half_edge, bit| {
            let double_sided = self.geometry.parts[self.part(half_edge)].look & DOUBLE_SIDED != 0;
            if double_sided { 0 } else { bit }
        };
        one_sided(left, bit::LEFT_ONE_SIDED)
            | one_sided(right, bit::RIGHT_ONE_SIDED)
            | (self.object(left) << OBJECT_SHIFT)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: Candidate, "Candidate" of "ink/edges" { left, bits, right });
}
