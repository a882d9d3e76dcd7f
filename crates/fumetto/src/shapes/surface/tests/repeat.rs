//! The same particles give the same bytes.

use glam::Vec3;

use super::{ROOM, Recipe, Spacing, extract, particle, recipe};

#[test]
fn runs_give_the_same_mesh_to_the_bit() {
    // Lists of a few hundred, in whatever order they are filled.
    let cloud: Vec<_> = (0..1500_u32)
        .map(|index| {
            let [a, b, c] = [index * 37 % 101, index * 53 % 97, index * 71 % 89].map(|k| k as f32 / 50.0);
            particle(Vec3::new(a, b, c), 0.3 + 0.1 * (a * 7.0).sin(), 0.2)
        })
        .collect();
    let recipe = Recipe { spacing: Spacing::Subdivisions(30.0), ..recipe(cloud.len(), 0.9, 0.0) };
    let first = extract(&cloud, &recipe, ROOM);
    assert!(first.triangles.len() > 2000, "{} triangles", first.triangles.len());
    first.assert_closed();
    for _ in 0..4 {
        assert!(extract(&cloud, &recipe, ROOM) == first);
    }
}
