//! The pieces of models: surfaces that hang together, though files split their vertices for normals or
//! textures.

use super::geometry::{Source, Triangle};

/// For each vertex of an object, the lowest of those that lie where it lies and always move as it does.
/// Numbers count from the object's first vertex; `groups` tell of each part with which others it moves.
pub(super) fn weld(sources: &[Source], groups: &[usize]) -> Vec<usize> {
    let place = |source: &Source| {
        // Adding 0 makes one of the two zeros.
        (groups[source.part as usize], source.position.map(|along| (along + 0.0).to_bits()))
    };
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

/// For each triangle of an object, a number that it shares with all that it hangs together with: that of
/// one of their vertices. The object's first vertex is `first`, and `welded` are its vertices.
pub(super) fn pieces(triangles: &[Triangle], welded: &[usize], first: u32) -> Vec<u32> {
    let mut links: Vec<usize> = (0..welded.len()).collect();
    let corners = |triangle: &Triangle| triangle.corners.map(|corner| welded[(corner - first) as usize]);
    for triangle in triangles {
        let [a, b, c] = corners(triangle).map(|corner| root(&mut links, corner));
        let low = a.min(b).min(c);
        for corner in [a, b, c] {
            links[corner] = low;
        }
    }
    triangles.iter().map(|triangle| first + root(&mut links, corners(triangle)[0]) as u32).collect()
}

/// The end of a chain of links, which gets shorter on the way (union by lowest number, path halving).
fn root(links: &mut [usize], from: usize) -> usize {
    let mut at = from;
    while links[at] != at {
        links[at] = links[links[at]];
        at = links[at];
    }
    at
}

#[cfg(test)]
mod tests {
    use super::super::geometry::tests::{boxes, geometry_of};

    #[test]
    fn split_corners_of_a_box_are_one_piece() {
        let geometry = geometry_of(&boxes(&[[0.0; 3], [5.0, 0.0, 0.0]]));
        let (one, other) = geometry.pieces.split_at(12);
        assert!(one.iter().all(|piece| *piece == one[0]), "{one:?}");
        assert!(other.iter().all(|piece| *piece == other[0]), "{other:?}");
        assert_ne!(one[0], other[0]);
    }
}
