//! Vertices that lie in one place: files split them for normals or textures.

use super::geometry::Source;

/// For each vertex of an object, the lowest of those that lie where it lies and always move as it does.
/// Numbers count from the object's first vertex; `groups` tell of each part with which others it moves.
pub(super) fn weld(sources: &[Source], groups: &[usize]) -> Vec<usize> {
    weld_by(sources, |source| groups[source.part as usize])
}

/// For each vertex, the lowest of those that lie where it lies and have the same `key`.
pub(super) fn weld_by<Key: Ord>(sources: &[Source], key: impl Fn(&Source) -> Key) -> Vec<usize> {
    // Adding 0 makes one of the two zeros.
    let place = |source: &Source| (key(source), source.position.map(|along| (along + 0.0).to_bits()));
    let mut order: Vec<_> = sources.iter().map(place).zip(0..).collect();
    order.sort_unstable();
    let mut welded = vec![0; sources.len()];
    for same in order.chunk_by(|a, b| a.0 == b.0) {
        for &(_, vertex) in same {
            welded[vertex] = same[0].1;
        }
    }
    welded
}
