//! Which way the vertices of a model go when it gets larger all round.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use super::geometry::{Source, Triangle, octahedral};

/// Longest that a corner sticks out, in widths: a mitre's limit.
const MITRE_LIMIT: f32 = 2.5;

/// `Push` of `mesh.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub(crate) struct Push {
    outward: u32,
    outward_length: f32,
    sideways: u32,
    sideways_length: f32,
}

/// Directions round a vertex, summed up, and the sum of their weights.
#[derive(Clone, Copy, Debug, Default)]
struct Round(Vec3, f32);

impl Round {
    fn add(&mut self, direction: Vec3, weight: f32) {
        self.0 += weight * direction;
        self.1 += weight;
    }

    /// The way that takes the planes across the directions outward by about 1, so that lines keep their
    /// width round corners: the mean, lengthened as a mitre is.
    fn mitre(self) -> (u32, f32) {
        let Some(way) = self.0.try_normalize() else { return (0, 0.0) };
        (octahedral(way), (self.1 / self.0.length()).min(MITRE_LIMIT))
    }
}

/// How each vertex of an object moves, in the coordinates of its part. The object's first vertex is
/// `first`; vertices that are `welded` move as one, so that no gaps open where normals are split.
pub(super) fn pushes(sources: &[Source], triangles: &[Triangle], welded: &[usize], first: u32) -> Vec<Push> {
    let mut outward = vec![Round::default(); sources.len()];
    let mut sideways = outward.clone();
    let mut edges = Vec::with_capacity(3 * triangles.len());
    for triangle in triangles {
        let corners = triangle.corners.map(|corner| welded[(corner - first) as usize]);
        let [a, b, c] = corners.map(|corner| Vec3::from(sources[corner].position));
        let Some(normal) = (b - a).cross(c - a).try_normalize() else { continue };
        for (at, [before, here, after]) in [[c, a, b], [a, b, c], [b, c, a]].into_iter().enumerate() {
            // Weighted by angle, it is the same however a face is cut into triangles (Thürmer & Wüthrich,
            // "Computing Vertex Normals from Polygonal Facets", 1998).
            outward[corners[at]].add(normal, (before - here).angle_between(after - here));
            let [from, to] = [corners[at], corners[(at + 1) % 3]];
            edges.push(([from.min(to), from.max(to)], (after - here).cross(normal).normalize_or_zero()));
        }
    }
    edges.sort_by_key(|&(ends, _)| ends);
    for shared in edges.chunk_by(|(a, _), (b, _)| a == b) {
        // Only one triangle has it.
        if let [(ends, away)] = *shared {
            for end in ends {
                sideways[end].add(away, 1.0);
            }
        }
    }
    let push = |&vertex: &usize| {
        let (outward, outward_length) = outward[vertex].mitre();
        let (sideways, sideways_length) = sideways[vertex].mitre();
        Push { outward, outward_length, sideways, sideways_length }
    };
    welded.iter().map(push).collect()
}

#[cfg(test)]
mod tests {
    use super::super::geometry::tests::{boxes, geometry_of};
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: Push, "Push" of "ink/shell" { outward, outward_length, sideways, sideways_length });

    #[test]
    fn corners_of_a_box_move_out_by_one_on_every_side() {
        let mut geometry = geometry_of(&boxes(&[[0.0; 3]]));
        geometry.find_pushes(0);
        for (source, push) in geometry.sources.iter().zip(&geometry.pushes) {
            let corner = Vec3::from(source.position).signum().normalize_or(Vec3::Y);
            assert_eq!(push.outward, octahedral(corner), "{source:?}");
            assert!((push.outward_length - 3.0_f32.sqrt()).abs() < 1e-4, "{push:?}");
            assert_eq!(push.sideways_length, 0.0, "a box has no boundary");
        }
    }

    #[test]
    fn the_rim_of_a_square_moves_sideways() {
        let mut geometry = geometry_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
        geometry.find_pushes(0);
        for (source, push) in geometry.sources.iter().zip(&geometry.pushes) {
            let [x, y, _] = source.position;
            assert_eq!(push.sideways, octahedral(Vec3::new(x - 0.5, y - 0.5, 0.0).normalize_or(Vec3::Y)));
            assert!((push.sideways_length - 2.0_f32.sqrt()).abs() < 1e-4, "{push:?}");
            assert_eq!(push.outward, octahedral(Vec3::Z));
        }
    }
}
