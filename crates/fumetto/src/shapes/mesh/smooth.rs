//! Normals of models, smoothed more and more, for shading that brings out relief of all sizes.

use std::ops::Range;

use glam::Vec3;

use super::{
    geometry::{Geometry, Source, Triangle, octahedral},
    weld::weld_by,
};

/// Smoothed normals of each vertex. Also in `exaggerate.wgsl`.
pub(crate) const MAX_SCALES: usize = 8;

impl Geometry {
    /// Smooths the normals of the object that was added last, whose `parts` these are, at so many `scales`.
    ///
    /// A step gives each normal half of its neighbours' mean, which spreads it by 0.7 edges. Sizes grow by √2,
    /// as in the paper, from 0.7 to 8 edges: since it is squares that add up, each takes as many steps as all
    /// before it together.
    pub(crate) fn smooth(&mut self, parts: &Range<usize>, scales: u32) {
        let first = self.sources.partition_point(|source| (source.part as usize) < parts.start);
        let first_triangle =
            self.triangles.partition_point(|triangle| (triangle.part as usize) < parts.start);
        let net = Net::new(&self.sources[first..], &self.triangles[first_triangle..], first as u32);
        let mut normals = net.gathered(&self.sources[first..]);
        self.smoothed.resize(self.sources.len(), [0; MAX_SCALES]);
        for scale in 0..(scales as usize).min(MAX_SCALES) {
            for _ in 0..(1_u32 << scale).div_ceil(2) {
                normals = net.diffused(&normals);
            }
            for (smoothed, &node) in self.smoothed[first..].iter_mut().zip(&net.node_of) {
                smoothed[scale] = octahedral(normals[node as usize].normalize_or(Vec3::Y));
            }
        }
    }
}

/// Vertices that lie in one place, and which of them are neighbours. Copies of a part, which have the same
/// places in their own space, count once.
struct Net {
    /// Number of each vertex's place.
    node_of: Vec<u32>,
    /// Neighbours of all places in a row.
    neighbours: Vec<u32>,
    /// Where the neighbours of each place begin; one more at the end.
    starts: Vec<u32>,
}

impl Net {
    /// The net of `sources`, which `triangles` number from `first`.
    fn new(sources: &[Source], triangles: &[Triangle], first: u32) -> Self {
        let mut node_of = Vec::with_capacity(sources.len());
        let mut count = 0;
        for (index, lowest) in weld_by(sources, |_| ()).into_iter().enumerate() {
            node_of.push(if lowest == index { count } else { node_of[lowest] });
            count += u32::from(lowest == index);
        }
        let mut edges: Vec<[u32; 2]> = Vec::with_capacity(6 * triangles.len());
        for triangle in triangles {
            let [a, b, c] = triangle.corners.map(|corner| node_of[(corner - first) as usize]);
            edges.extend([[a, b], [b, a], [b, c], [c, b], [c, a], [a, c]]);
        }
        edges.sort_unstable();
        edges.dedup();
        edges.retain(|[from, to]| from != to);
        let starts = (0..=count).map(|node| edges.partition_point(|&[from, _]| from < node) as u32).collect();
        Self { node_of, neighbours: edges.into_iter().map(|[_, to]| to).collect(), starts }
    }

    /// The sum of the vertices' normals at each place.
    fn gathered(&self, sources: &[Source]) -> Vec<Vec3> {
        let mut normals = vec![Vec3::ZERO; self.starts.len() - 1];
        for (source, &node) in sources.iter().zip(&self.node_of) {
            normals[node as usize] += unpacked(source.normal);
        }
        normals.into_iter().map(Vec3::normalize_or_zero).collect()
    }

    /// One step of smoothing. Lengths stay as they come out: short normals, of places where they disagree,
    /// count less.
    fn diffused(&self, normals: &[Vec3]) -> Vec<Vec3> {
        let around =
            |node: usize| &self.neighbours[self.starts[node] as usize..self.starts[node + 1] as usize];
        let smooth = |(node, &normal): (usize, &Vec3)| {
            let around = around(node);
            let sum: Vec3 = around.iter().map(|&other| normals[other as usize]).sum();
            if around.is_empty() { normal } else { 0.5 * (normal + sum / around.len() as f32) }
        };
        normals.iter().enumerate().map(smooth).collect()
    }
}

/// As `octahedral_unpacked` of `octahedral.wgsl`.
pub(crate) fn unpacked(packed: u32) -> Vec3 {
    let share = |bits: u32| f32::from(bits as u16 as i16) / 32767.0;
    let (u, v) = (share(packed), share(packed >> 16));
    let z = 1.0 - u.abs() - v.abs();
    let fold = |a: f32, b: f32| (1.0 - b.abs()) * if a >= 0.0 { 1.0 } else { -1.0 };
    let (x, y) = if z < 0.0 { (fold(u, v), fold(v, u)) } else { (u, v) };
    Vec3::new(x, y, z).normalize_or_zero()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row of places along x, with a copy of each, as a strip of triangles.
    fn strip(normals: &[Vec3]) -> Geometry {
        let mut geometry = Geometry::default();
        for (i, &normal) in normals.iter().enumerate() {
            for side in [0.0, 1.0] {
                let mut source: Source = bytemuck::Zeroable::zeroed();
                source.position = [i as f32, side, 0.0];
                source.normal = octahedral(normal);
                geometry.sources.push(source);
            }
        }
        for i in 0..2 * (normals.len() as u32 - 1) {
            geometry.triangles.push(Triangle { corners: [i, i + 1, i + 2], part: 0 });
        }
        geometry
    }

    #[test]
    fn packing_is_undone() {
        for normal in [Vec3::X, -Vec3::Z, Vec3::new(0.48, -0.6, -0.64), Vec3::new(-0.36, 0.48, 0.8)] {
            assert!(unpacked(octahedral(normal)).distance(normal) < 1e-4, "{normal}");
        }
    }

    #[test]
    fn a_flat_surface_stays_as_it_is() {
        let normal = Vec3::new(0.36, -0.48, 0.8);
        let mut geometry = strip(&[normal; 20]);
        geometry.smooth(&(0..1), 8);
        for smoothed in geometry.smoothed.iter().flatten() {
            assert!(unpacked(*smoothed).distance(normal) < 1e-3);
        }
    }

    #[test]
    fn relief_vanishes_from_the_finest_to_the_coarsest() {
        let tilt = |i: usize| 0.5 * (i as f32 * std::f32::consts::TAU / 12.0).sin();
        let normals: Vec<_> = (0..120).map(|i| Vec3::new(tilt(i), 0.0, 1.0).normalize_or(Vec3::Z)).collect();
        let mut geometry = strip(&normals);
        geometry.smooth(&(0..1), 8);
        let swing = |scale: usize| {
            let inner = geometry.smoothed[80..160].iter();
            inner.map(|smoothed| unpacked(smoothed[scale]).x.abs()).fold(0.0, f32::max)
        };
        let swings: Vec<_> = (0..8).map(swing).collect();
        assert!(swings.windows(2).all(|pair| pair[1] < pair[0]), "{swings:?}");
        assert!(swings[0] > 0.4 && swings[7] < 0.1, "{swings:?}");
    }

    #[test]
    fn vertices_in_one_place_share_their_smoothed_normal() {
        let mut geometry = strip(&[Vec3::Z; 4]);
        // A second strip with other normals on the first one's edge.
        let mut twin = geometry.sources[1];
        twin.normal = octahedral(Vec3::X);
        geometry.sources.push(twin);
        geometry.smooth(&(0..1), 1);
        assert_eq!(geometry.smoothed[1], geometry.smoothed[8]);
        assert!(unpacked(geometry.smoothed[1][0]).x > 0.1);
    }
}
