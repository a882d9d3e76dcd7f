//! Where lines on models go on, though files split vertices there for textures.

use glam::Vec3;

use super::{edges::SAME_NORMAL, geometry::Geometry, smooth::unpacked, weld::weld};

/// Normals in one place that are told apart; beyond it the model is broken.
const MOST_NORMALS: usize = 16;

/// What stands for each vertex of `geometry`: for all in its place, and for those of them that have its normal, too.
pub(crate) fn seams(geometry: &Geometry) -> Vec<[u32; 2]> {
    let welded = weld(&geometry.sources, &geometry.groups);
    let normal = |vertex: usize| unpacked(geometry.sources[vertex].normal);
    let mut order: Vec<(usize, usize)> = welded.iter().copied().zip(0..).collect();
    order.sort_unstable();
    let mut seams = vec![[0; 2]; welded.len()];
    for same in order.chunk_by(|a, b| a.0 == b.0) {
        let mut normals: Vec<(Vec3, usize)> = Vec::new();
        for &(place, vertex) in same {
            let own = normal(vertex);
            let known = normals.iter().find(|(known, _)| known.distance_squared(own) <= SAME_NORMAL);
            let stands = known.map_or(vertex, |&(_, first)| first);
            if known.is_none() && normals.len() < MOST_NORMALS {
                normals.push((own, vertex));
            }
            seams[vertex] = [place, stands].map(|vertex| vertex as u32);
        }
    }
    seams
}
