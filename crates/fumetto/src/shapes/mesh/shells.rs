//! Shells: the connected surfaces of models, and the edges at which their shadow volumes may have sides.
//!
//! Vertices that lie at the same place of the same part, or of parts that move together, are one here,
//! whatever their normals: a crease is no end of a surface.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use super::{
    geometry::{Geometry, Triangle},
    near::Near,
    sets::Sets,
    weld::weld,
};

/// `Edge` of `shells.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
pub(crate) struct Edge {
    pub(crate) ends: [u32; 2],
    /// The first triangle runs along the edge from its first end to its second.
    pub(crate) sides: [u32; 2],
}

/// No second triangle.
const NO_SIDE: u32 = u32::MAX;

/// The second triangle runs along the edge as the first one does.
const SAME_WAY: u32 = 1 << 31;

/// A triangle throws a shadow when light falls on its front, and when it falls on its back. Also in
/// `shells.wgsl`.
const LIT_CASTS: u32 = 1;
const UNLIT_CASTS: u32 = 2;

/// What a scene's shadow volumes are made of.
#[derive(Debug, Default)]
pub(crate) struct Shells {
    /// An edge of more than two triangles is in here several times; the order is that of the model.
    pub(crate) edges: Vec<Edge>,
    /// When each of the scene's triangles throws a shadow.
    pub(crate) casting: Vec<u32>,
    /// Whether each of the surfaces does that the device makes.
    pub(crate) surfaces: Vec<bool>,
}

/// One triangle at one of its edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct HalfEdge {
    /// The lower vertex first.
    ends: [u32; 2],
    backward: bool,
    triangle: u32,
}

impl Shells {
    /// The shells of the objects that `casts` names by their numbers.
    pub(crate) fn new(geometry: &Geometry, casts: impl Fn(u32) -> bool) -> Self {
        let surfaces = geometry.reservations.iter().map(|surface| casts(surface.object as u32)).collect();
        let mut shells = Self { edges: Vec::new(), casting: vec![0; geometry.triangles.len()], surfaces };
        let welded = weld(&geometry.sources, &geometry.groups);
        let group = |triangle: &Triangle| geometry.groups[triangle.part as usize];
        let mut first = 0;
        for triangles in geometry.triangles.chunk_by(|a, b| group(a) == group(b)) {
            if casts(geometry.parts[triangles[0].part as usize].object) {
                shells.add(geometry, &welded, first, triangles);
            }
            first += triangles.len();
        }
        shells
    }

    /// Adds triangles that move together; `first` is the number of the first.
    fn add(&mut self, geometry: &Geometry, welded: &[usize], first: usize, triangles: &[Triangle]) {
        let mut surfaces = Sets::new(triangles.len());
        let mut rims = Vec::new();
        for around in half_edges(welded, first as u32, triangles).chunk_by(|a, b| a.ends == b.ends) {
            surfaces.join_all(around.iter().map(|half| half.triangle as usize - first));
            self.add_edge(around, &mut rims);
        }
        let mut is_open = vec![false; triangles.len()];
        for triangle in ends(geometry, &rims, first, &mut surfaces) {
            is_open[triangle] = true;
        }
        let (mut open, mut volumes) = (vec![false; triangles.len()], vec![0.0; triangles.len()]);
        for (number, triangle) in triangles.iter().enumerate() {
            let surface = surfaces.find(number);
            open[surface] |= is_open[number];
            volumes[surface] += volume(geometry, triangles[surface].corners[0], triangle);
        }
        for number in 0..triangles.len() {
            let surface = surfaces.find(number);
            self.casting[first + number] = match (open[surface], volumes[surface] < 0.0) {
                (true, _) => LIT_CASTS | UNLIT_CASTS,
                // What looks away from the light bounds the same shadow, and starts it where the shading is
                // dark by itself: no facet throws a shadow on its neighbours at the border of light.
                (false, false) => UNLIT_CASTS,
                (false, true) => LIT_CASTS,
            };
        }
    }

    /// Adds what lies `around` one edge, two triangles at a time. What runs along it one way without another
    /// that runs the other way is a rim.
    fn add_edge(&mut self, around: &[HalfEdge], rims: &mut Vec<HalfEdge>) {
        let (forward, backward) = around.split_at(around.partition_point(|half| !half.backward));
        let paired = forward.len().min(backward.len());
        let [low, high] = around[0].ends;
        for (forward, backward) in forward.iter().zip(backward) {
            self.edges.push(Edge { ends: [low, high], sides: [forward.triangle, backward.triangle] });
        }
        for (rest, ends) in [(&forward[paired..], [low, high]), (&backward[paired..], [high, low])] {
            rims.extend(rest);
            for two in rest.chunks(2) {
                let second = two.get(1).map_or(NO_SIDE, |half| half.triangle | SAME_WAY);
                self.edges.push(Edge { ends, sides: [two[0].triangle, second] });
            }
        }
    }
}

impl HalfEdge {
    fn new([from, to]: [u32; 2], triangle: u32) -> Self {
        Self { ends: [from.min(to), from.max(to)], backward: from > to, triangle }
    }
}

/// All edges of triangles, those between the same two places together, forward ones first.
fn half_edges(welded: &[usize], first: u32, triangles: &[Triangle]) -> Vec<HalfEdge> {
    let numbered = (first..).zip(triangles);
    let mut halves: Vec<_> = numbered
        .flat_map(|(number, triangle)| {
            let [a, b, c] = triangle.corners.map(|corner| welded[corner as usize] as u32);
            [[a, b], [b, c], [c, a]].map(|ends| HalfEdge::new(ends, number))
        })
        .collect();
    halves.sort_unstable();
    halves
}

/// The triangles at which surfaces end, counted from `first`. Where `rims` match up to rounding, surfaces do
/// not end, and are joined.
fn ends(geometry: &Geometry, rims: &[HalfEdge], first: usize, surfaces: &mut Sets) -> Vec<usize> {
    let places = rims.iter().flat_map(|half| half.ends);
    let mut near =
        Near::new(places.map(|vertex| (vertex, geometry.sources[vertex as usize].position.into())));
    let mut halves: Vec<_> = rims
        .iter()
        .map(|half| {
            let [a, b] = half.ends.map(|vertex| near.of(vertex));
            HalfEdge::new(if half.backward { [b, a] } else { [a, b] }, half.triangle)
        })
        .filter(|half| half.ends[0] != half.ends[1])
        .collect();
    halves.sort_unstable();
    let mut found = Vec::new();
    for around in halves.chunk_by(|a, b| a.ends == b.ends) {
        let triangles = || around.iter().map(|half| half.triangle as usize - first);
        surfaces.join_all(triangles());
        if 2 * around.partition_point(|half| !half.backward) != around.len() {
            found.extend(triangles());
        }
    }
    found
}

/// Six times the signed volume between a triangle and the vertex `origin`; those of a closed surface sum up
/// to more than zero where its fronts look outward.
fn volume(geometry: &Geometry, origin: u32, triangle: &Triangle) -> f64 {
    let place = |vertex: u32| Vec3::from(geometry.sources[vertex as usize].position).as_dvec3();
    let [a, b, c] = triangle.corners.map(|corner| place(corner) - place(origin));
    let mirrored = geometry.parts[triangle.part as usize].world_from_part.determinant() < 0.0;
    a.dot(b.cross(c)) * if mirrored { -1.0 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;
    use crate::gpu::layout_test;
    use fumetto_formats::{ModelOptions, read_model};
    use fumetto_scene::{Mesh, Transform};

    layout_test!(edges_lie_as_their_twin: Edge, "Edge" of "light/extrude" { ends, sides });

    const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

    fn shells(obj: &str, copies: Vec<Transform>) -> Shells {
        let model = read_model("a.obj", obj.as_bytes(), ModelOptions::default(), &mut |_| {
            Err(std::io::ErrorKind::NotFound.into())
        });
        let mesh = Mesh { model: "a.obj".into(), z_up: false, smooth_deg: None, copies, obstacle: false };
        let mut geometry = Geometry::default();
        geometry.add(&mesh, &model.unwrap());
        Shells::new(&geometry, |_| true)
    }

    fn one(obj: &str) -> Shells {
        shells(obj, vec![Transform::default()])
    }

    fn is_paired(edge: &Edge) -> bool {
        edge.sides[1] != NO_SIDE && edge.sides[1] & SAME_WAY == 0
    }

    #[test]
    fn a_closed_surface_casts_with_what_looks_away_from_the_light() {
        let shells = one(TETRAHEDRON);
        assert_eq!(shells.edges.len(), 6);
        assert!(shells.edges.iter().all(is_paired), "creases join, though their normals differ");
        assert_eq!(shells.casting, [UNLIT_CASTS; 4]);
    }

    #[test]
    fn inside_out_it_casts_with_the_others() {
        let turned =
            TETRAHEDRON.replace("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4", "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3");
        assert_eq!(one(&turned).casting, [LIT_CASTS; 4]);
    }

    #[test]
    fn a_mirror_turns_nothing_inside_out() {
        let mirrored = Transform { scale: [-1.0, 1.0, 1.0], ..Transform::default() };
        let shells = shells(TETRAHEDRON, vec![mirrored, Transform::default()]);
        assert_eq!(shells.casting, [UNLIT_CASTS; 8]);
        assert_eq!(shells.edges.len(), 12, "copies that touch stay apart");
    }

    #[test]
    fn materials_do_not_end_a_surface() {
        let parts = TETRAHEDRON.replace("f 1 4 3", "usemtl other\nf 1 4 3");
        assert_eq!(one(&parts).casting, [UNLIT_CASTS; 4]);
    }

    #[test]
    fn rounding_does_not_end_a_surface() {
        let split =
            TETRAHEDRON.replace("f 2 3 4", "v 0.9999999 0 0.0000001\nv 0.0000001 1 -0.0000001\nf 5 6 4");
        let shells = one(&split);
        assert_eq!(shells.casting, [UNLIT_CASTS; 4]);
        assert_eq!(shells.edges.iter().filter(|edge| !is_paired(edge)).count(), 6, "volumes go by the bits");
    }

    #[test]
    fn an_open_surface_casts_with_both() {
        let open = TETRAHEDRON.replace("f 2 3 4\n", "");
        let shells = one(&open);
        assert_eq!(shells.casting, [LIT_CASTS | UNLIT_CASTS; 3]);
        assert_eq!(shells.edges.iter().filter(|edge| edge.sides[1] == NO_SIDE).count(), 3);
    }

    #[test]
    fn an_edge_of_three_triangles_counts_each() {
        let shells = one("v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 2 1 5\n");
        let hub: Vec<_> = shells.edges.iter().filter(|edge| edge.ends[0].max(edge.ends[1]) == 1).collect();
        assert_eq!(hub.len(), 2, "{hub:?}");
        assert_eq!(hub.iter().filter(|edge| is_paired(edge)).count(), 1);
        assert_eq!(shells.casting, [LIT_CASTS | UNLIT_CASTS; 3]);
    }
}
