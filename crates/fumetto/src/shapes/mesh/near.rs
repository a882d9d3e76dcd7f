//! Places that are one but for rounding.

use glam::Vec3;

use super::sets::Sets;

/// Places nearer than this share of all their extent may be one: a program that works out the same corner
/// twice in single precision comes about this close.
const ROUNDING: f32 = 1e-5;

/// Vertices by their places.
pub(super) struct Near {
    /// Rising.
    vertices: Vec<u32>,
    same: Sets,
}

impl Near {
    pub(super) fn new(places: impl Iterator<Item = (u32, Vec3)>) -> Self {
        let mut places: Vec<_> = places.collect();
        places.sort_by_key(|&(vertex, _)| vertex);
        places.dedup_by_key(|&mut (vertex, _)| vertex);
        let least = places.iter().fold(Vec3::INFINITY, |least, &(_, place)| least.min(place));
        let most = places.iter().fold(Vec3::NEG_INFINITY, |most, &(_, place)| most.max(place));
        let cell = ROUNDING * (most - least).max_element().max(f32::MIN_POSITIVE);
        let mut same = Sets::new(places.len());
        // Of two places side by side, a border runs between them in one grid at most, or it is bad luck.
        for shift in [0.0, 0.5] {
            let cell_of =
                |at: usize| ((places[at].1 - least) / cell + shift).floor().to_array().map(f32::to_bits);
            let mut order: Vec<_> = (0..places.len()).map(|at| (cell_of(at), at)).collect();
            order.sort_unstable();
            for cell in order.chunk_by(|a, b| a.0 == b.0) {
                same.join_all(cell.iter().map(|&(_, at)| at));
            }
        }
        Self { vertices: places.iter().map(|&(vertex, _)| vertex).collect(), same }
    }

    /// The vertex that stands for all that are where a known one is.
    pub(super) fn of(&mut self, vertex: u32) -> u32 {
        let at = self.vertices.partition_point(|&other| other < vertex);
        self.vertices[self.same.find(at)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_within_rounding_are_one_and_others_are_not() {
        let places = [
            Vec3::ZERO,
            Vec3::new(1.0, 1.0, 1.0),
            Vec3::new(-1e-7, 1e-7, -1e-7),
            Vec3::new(0.999_999_9, 1.0, 1.000_000_1),
            Vec3::new(1.0, 0.999, 1.0),
        ];
        let mut near = Near::new((7..).zip(places));
        assert_eq!([7, 8, 9, 10, 11].map(|vertex| near.of(vertex)), [7, 8, 7, 8, 11]);
    }
}
