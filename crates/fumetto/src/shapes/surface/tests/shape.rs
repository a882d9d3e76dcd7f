//! What a mesh is as a shape: closed or not, how many pieces, how large.

use std::collections::HashMap;

use glam::{DVec3, Vec3};

use super::Mesh;

impl Mesh {
    /// Panics unless every edge has two triangles that run along it in opposite directions, and every
    /// vertex is used.
    #[track_caller]
    pub(super) fn assert_closed(&self) {
        let mut runs = HashMap::new();
        let mut used = vec![false; self.places.len()];
        for &triangle in &self.triangles {
            for index in 0..3 {
                let [from, to] = [triangle[index], triangle[(index + 1) % 3]];
                assert_ne!(from, to, "{triangle:?} has two corners at one vertex");
                *runs.entry([from, to]).or_insert(0) += 1;
                used[from as usize] = true;
            }
        }
        for (&[from, to], &count) in &runs {
            let back = runs.get(&[to, from]).copied().unwrap_or(0);
            assert_eq!((count, back), (1, 1), "triangles along {from}–{to}");
        }
        assert!(used.iter().all(|&used| used), "every vertex belongs to a triangle");
        assert!(self.places.iter().all(|place| place.is_finite()), "every vertex has a place");
        assert_eq!(self.draw, [3 * self.triangles.len() as u32, 1, 0, 0]);
    }

    /// V − E + F.
    pub(super) fn euler_characteristic(&self) -> i64 {
        let [vertices, faces] = [self.places.len() as i64, self.triangles.len() as i64];
        vertices - faces * 3 / 2 + faces
    }

    /// Pieces that hang together.
    pub(super) fn pieces(&self) -> usize {
        let mut parent: Vec<_> = (0..self.places.len()).collect();
        for &[a, b, c] in &self.triangles {
            for to in [b, c] {
                let [from, to] = [root(&mut parent, a as usize), root(&mut parent, to as usize)];
                parent[from] = to;
            }
        }
        (0..parent.len()).filter(|&vertex| parent[vertex] == vertex).count()
    }

    pub(super) fn corners(&self) -> impl Iterator<Item = [Vec3; 3]> {
        self.triangles.iter().map(|triangle| triangle.map(|vertex| self.places[vertex as usize]))
    }

    /// Positive where triangles face outward.
    pub(super) fn volume(&self) -> f64 {
        let signed = |corners: [Vec3; 3]| {
            let [a, b, c] = corners.map(DVec3::from);
            a.dot(b.cross(c)) / 6.0
        };
        self.corners().map(signed).sum()
    }

    pub(super) fn area(&self) -> f64 {
        self.corners().map(|[a, b, c]| f64::from((b - a).cross(c - a).length()) / 2.0).sum()
    }

    /// The smallest angle of each triangle, in degrees, the smallest first.
    pub(super) fn sharpest_angles(&self) -> Vec<f32> {
        let sharpest = |corners: [Vec3; 3]| {
            (0..3)
                .map(|i| {
                    let [at, next, last] = [corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]];
                    (next - at).angle_between(last - at).to_degrees()
                })
                .fold(180.0, f32::min)
        };
        let mut angles: Vec<_> = self.corners().map(sharpest).collect();
        angles.sort_by(f32::total_cmp);
        angles
    }
}

fn root(parent: &mut [usize], mut vertex: usize) -> usize {
    while parent[vertex] != vertex {
        parent[vertex] = parent[parent[vertex]];
        vertex = parent[vertex];
    }
    vertex
}
