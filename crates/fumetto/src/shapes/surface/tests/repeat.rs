//! The same particles give the same bytes.

use fumetto_scene::Particle;
use glam::Vec3;

use super::{
    BENCH, Frame, PoisonError, ROOM, Recipe, Spacing, UNFADED, Workspace, extract, meshes, particle, puffs,
    read_buffer, recipe, reserved,
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
fn lists_are_in_the_particles_order_whatever_order_they_were_filled_in() {
    let cloud = cloud();
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let work = Workspace::new(&bench.gpu, ROOM);
    let mesh = meshes(&bench.gpu, ROOM);
    let mut frame = Frame::new(&bench.gpu, &bench.pool, "test");
    let puffs = puffs(&bench.gpu, &cloud, UNFADED);
    bench.surface.record(&mut frame, &puffs, &fine(cloud.len()), (ROOM, &work), (0.0, reserved(&mesh)));
    frame.submit();
    let words = |buffer| -> Vec<u32> { read_buffer(&bench.gpu, buffer).expect("the device lives") };
    let [lattice, active] = [words(&work.lattice), words(&work.active)];
    let [starts, entries] = [words(&work.starts), words(&work.entries)];
    // `active_blocks` of `lattice.wgsl`.
    let vertices = words(&work.vertex_counts);
    let listed = active.chunks_exact(4).zip(vertices).take(lattice[7] as usize);
    let listed = listed.filter(|&(_, vertices)| vertices > 0).map(|(block, _)| block[3]);
    let mut longest = 0;
    for block in listed {
        let [start, end] = [starts[block as usize], starts[block as usize + 1]].map(|at| at as usize);
        assert!(entries[start..end].is_sorted_by(|a, b| a < b), "the list of block {block}");
        longest = longest.max(end - start);
    }
    assert!(longest > 200, "the longest list has {longest}");
    assert!(words(&work.tally).iter().all(|&left| left == 0), "tallies go back to zero");
}
