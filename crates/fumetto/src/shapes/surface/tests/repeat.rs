//! The same particles give the same bytes.

use fumetto_scene::Particle;
use glam::Vec3;

use super::{
    BENCH, Frame, Noise, PoisonError, ROOM, Recipe, Spacing, UNFADED, Workspace, extract, meshes, particle,
    puffs, read_buffer, recipe, reserved,
};

/// So dense that blocks have lists of hundreds.
fn cloud() -> Vec<Particle> {
    (0..1500_u32)
        .map(|index| {
            let [a, b, c] = [index * 37 % 101, index * 53 % 97, index * 71 % 89].map(|k| k as f32 / 50.0);
            particle(Vec3::new(a, b, c), 0.3 + 0.1 * (a * 7.0).sin(), 0.2)
        })
        .collect()
}

fn fine(count: usize) -> Recipe {
    Recipe { spacing: Spacing::Subdivisions(30.0), ..recipe(count, 0.9, 0.0) }
}

#[test]
fn runs_give_the_same_mesh_to_the_bit() {
    let cloud = cloud();
    let first = extract(&cloud, &fine(cloud.len()), ROOM);
    assert!(first.triangles.len() > 2000, "{} triangles", first.triangles.len());
    first.assert_closed();
    for _ in 0..4 {
        assert!(extract(&cloud, &fine(cloud.len()), ROOM) == first);
    }
}

#[test]
fn the_order_of_particles_does_not_matter_to_the_bit() {
    let cloud = cloud();
    let backward: Vec<_> = cloud.iter().rev().copied().collect();
    let noise = Noise { amplitude: 1.0, size_m: 0.3, octaves: 2, seed: 3, drift_m_per_s: [0.0; 3] };
    for noise in [None, Some(noise)] {
        let recipe = Recipe { noise, ..fine(cloud.len()) };
        assert!(extract(&cloud, &recipe, ROOM) == extract(&backward, &recipe, ROOM));
    }
}

#[test]
fn lists_of_hundreds_leave_no_tally_behind() {
    let cloud = cloud();
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let work = Workspace::new(&bench.gpu, ROOM);
    let mesh = meshes(&bench.gpu, ROOM);
    let mut frame = Frame::new(&bench.gpu, &bench.pool, "test");
    let puffs = puffs(&bench.gpu, &cloud, UNFADED);
    bench.surface.record(&mut frame, &puffs, &fine(cloud.len()), (ROOM, &work), (0.0, reserved(&mesh)));
    frame.submit();
    let words = |buffer| -> Vec<u32> { read_buffer(&bench.gpu, buffer).expect("the device lives") };
    let longest = words(&work.starts).windows(2).map(|ends| ends[1] - ends[0]).max();
    assert!(longest.is_some_and(|longest| longest > 200), "the longest list has {longest:?}");
    assert!(words(&work.tally).iter().all(|&left| left == 0), "tallies go back to zero");
}
