//! Which triangles meet at an edge, against a search through all of them.

use std::collections::HashMap;

use fumetto_scene::Particle;

use super::{BENCH, Noise, PoisonError, ROOM, Recipe, SurfaceRoom, Workspace, particle, recipe};
use crate::{
    gpu::{Frame, read_buffer},
    shapes::mesh::{Geometry, MeshScene, Shells},
};

/// No triangle.
const NOWHERE: u32 = u32::MAX;

/// Asserts that every triangle knows its neighbours. Answers with how many it has none of.
#[track_caller]
fn assert_neighbours(cloud: &[Particle], recipe: &Recipe, room: SurfaceRoom) -> usize {
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let mut geometry = Geometry::default();
    geometry.add_surface(3, 5, false);
    geometry.add_surface(room.vertices, room.triangles, false);
    let shells = Shells { surfaces: vec![false, true], ..Shells::default() };
    let meshes = MeshScene::new(&bench.gpu, &geometry, &shells, &[], &[]).expect("the room is modest");
    let puffs = super::puffs(&bench.gpu, cloud, super::UNFADED);
    let mut frame = Frame::new(&bench.gpu, &bench.pool, "test");
    let work = Workspace::new(&bench.gpu, room);
    bench.surface.record(&mut frame, &puffs, recipe, (room, &work), (0.0, &meshes.reserved[1]));
    frame.submit();
    assert!(meshes.reserved[0].adjacent.is_none(), "the first throws no shadow");
    let adjacent = meshes.reserved[1].adjacent.as_ref().expect("the second does");
    let adjacent: Vec<u32> = read_buffer(&bench.gpu, adjacent).expect("the device lives");
    let triangles = super::read(&bench.gpu, &meshes).triangles;
    assert!(triangles.len() > 100);
    let edge = |triangle: [u32; 3], corner: usize| [triangle[corner], triangle[(corner + 1) % 3]];
    let mut owners = HashMap::new();
    for (number, &triangle) in (0..).zip(&triangles) {
        owners.extend((0..3).map(|corner| (edge(triangle, corner), number)));
    }
    let mut missing = 0;
    for (number, &triangle) in triangles.iter().enumerate() {
        for corner in 0..3 {
            let [start, end] = edge(triangle, corner);
            let expected = owners.get(&[end, start]).copied().unwrap_or(NOWHERE);
            assert_eq!(adjacent[3 * number + corner], expected, "at corner {corner} of triangle {number}");
            missing += usize::from(expected == NOWHERE);
        }
    }
    missing
}

#[test]
fn every_edge_of_a_ball_has_two_triangles() {
    let ball = [particle([0.13, -0.31, 0.07], 1.0, 8.0)];
    assert_eq!(assert_neighbours(&ball, &recipe(1, 0.05, 0.1), ROOM), 0);
}

#[test]
fn noise_has_every_case_and_every_edge_has_two_triangles() {
    let cloud: Vec<_> = (0..20)
        .map(|i| particle([0.31, 0.17, 0.23].map(|step| (step * i as f32 * 7.3).sin()), 0.6, 2.0))
        .collect();
    let noise = Some(Noise { amplitude: 4.0, size_m: 0.25, octaves: 3, seed: 1, drift_m_per_s: [0.0; 3] });
    assert_eq!(assert_neighbours(&cloud, &Recipe { noise, ..recipe(20, 0.3, 0.08) }, ROOM), 0);
}

#[test]
fn what_was_left_out_is_nobodys_neighbour() {
    let ball = [particle([0.13, -0.31, 0.07], 1.0, 8.0)];
    assert!(assert_neighbours(&ball, &recipe(1, 0.05, 0.1), SurfaceRoom { triangles: 1000, ..ROOM }) > 0);
}
