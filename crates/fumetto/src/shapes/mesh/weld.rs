//! Vertices that files split, for normals or textures, put together again.

use super::geometry::{Part, Source, Triangle};

/// For each vertex of an object, the lowest of those that lie where it lies, and stay there however parts
/// move: they stand in the same frame. Numbers count from the object's first vertex.
pub(super) fn weld(sources: &[Source], parts: &[Part]) -> Vec<usize> {
    let bits = |part: &Part| part.world_from_part.to_cols_array().map(bits);
    let mut order: Vec<usize> = (0..parts.len()).collect();
    order.sort_by_key(|&part| bits(&parts[part]));
    let mut frames = vec![0; parts.len()];
    for same in order.chunk_by(|&a, &b| bits(&parts[a]) == bits(&parts[b])) {
        for &part in same {
            frames[part] = same[0];
        }
    }
    weld_within(sources, &frames)
}

/// The same for vertices whose parts have the same of the `groups`.
pub(super) fn weld_within(sources: &[Source], groups: &[usize]) -> Vec<usize> {
    let mut places: Vec<([u32; 4], usize)> = sources
        .iter()
        .enumerate()
        .map(|(number, source)| {
            let [x, y, z] = source.position.map(bits);
            ([groups[source.part as usize] as u32, x, y, z], number)
        })
        .collect();
    places.sort_unstable();
    let mut welded = vec![0; places.len()];
    for same in places.chunk_by(|a, b| a.0 == b.0) {
        for &(_, number) in same {
            welded[number] = same[0].1;
        }
    }
    welded
}

/// Adding 0 makes one of the two zeros.
fn bits(number: f32) -> u32 {
    (number + 0.0).to_bits()
}

/// For each triangle of an object, a number that it shares with all that it hangs together with: that of
/// one of their vertices. The object's first vertex is `first`, and `welded` are its vertices.
pub(super) fn bodies(triangles: &[Triangle], welded: &[usize], first: u32) -> Vec<u32> {
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
    fn split_corners_of_a_box_are_one_body() {
        let geometry = geometry_of(&boxes(&[[0.0; 3], [5.0, 0.0, 0.0]]));
        let (one, other) = geometry.bodies.split_at(12);
        assert!(one.iter().all(|body| *body == one[0]), "{one:?}");
        assert!(other.iter().all(|body| *body == other[0]), "{other:?}");
        assert_ne!(one[0], other[0]);
    }
}
