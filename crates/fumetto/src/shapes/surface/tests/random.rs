//! Random clouds stay closed, ambiguous cells and all.

use fumetto_scene::Particle;
use proptest::prelude::*;

use super::{Noise, ROOM, Recipe, extract, particle, recipe};

fn any_particle() -> impl Strategy<Value = Particle> {
    let place = prop::array::uniform3(-1.5_f32..1.5);
    // Some are smaller than a cell.
    (place, 0.02_f32..0.9, 0.1_f32..9.0).prop_map(|(center, radius, mass)| particle(center, radius, mass))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_clouds_are_closed(
        cloud in prop::collection::vec(any_particle(), 1..60),
        threshold in 0.02_f32..2.0,
        cell in 0.05_f32..0.4,
        amplitude in prop::option::of(0.1_f32..4.0),
    ) {
        let noise = amplitude.map(|amplitude| Noise { amplitude, size_m: 1.0 / 3.0, octaves: 3, seed: 1, drift_m_per_s: [0.0; 3] });
        let mesh = extract(&cloud, &Recipe { noise, ..recipe(cloud.len(), threshold, cell) }, ROOM);
        mesh.assert_closed();
        prop_assert_eq!(mesh.overflow, 0);
        prop_assert!(mesh.triangles.is_empty() || mesh.volume() > 0.0);
        // Closed surfaces bound something: their characteristic is even.
        prop_assert_eq!(mesh.euler_characteristic() % 2, 0);
    }
}
