//! The pieces of models: surfaces that hang together, though files split their vertices for normals or
//! textures.

use super::{geometry::Triangle, sets::Sets};

/// For each triangle of an object, a number that it shares with all that it hangs together with: that of
/// one of their vertices. The object's first vertex is `first`, and `welded` are its vertices.
pub(super) fn pieces(triangles: &[Triangle], welded: &[usize], first: u32) -> Vec<u32> {
    let mut pieces = Sets::new(welded.len());
    let corners = |triangle: &Triangle| triangle.corners.map(|corner| welded[(corner - first) as usize]);
    for triangle in triangles {
        pieces.join_all(corners(triangle).into_iter());
    }
    triangles.iter().map(|triangle| first + pieces.find(corners(triangle)[0]) as u32).collect()
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
