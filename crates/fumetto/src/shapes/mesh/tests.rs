//! Edges of models, counted and timed.

use std::{fmt::Write as _, io, time::Instant};

use fumetto_formats::{ModelOptions, read_model};
use fumetto_scene::{Mesh, Transform};

use super::{Candidate, Geometry, bit, candidates};

fn geometry(name: &str, bytes: &[u8], copies: usize) -> Geometry {
    let model =
        read_model(name, bytes, ModelOptions::default(), &mut |_| Err(io::ErrorKind::NotFound.into()))
            .expect("the model can be read");
    let copies = vec![Transform::default(); copies];
    let mesh = Mesh { model: name.into(), z_up: false, smooth_deg: None, copies, obstacle: false };
    let mut geometry = Geometry::default();
    geometry.add(&mesh, &model);
    geometry
}

fn of_kind(found: &[Candidate], kind: u32) -> Vec<&Candidate> {
    found.iter().filter(|candidate| candidate.bits & kind != 0).collect()
}

/// How many of the edges are creases, boundaries and borders of materials.
fn counts(found: &[Candidate]) -> [usize; 3] {
    [bit::CREASE, bit::BOUNDARY, bit::MATERIAL].map(|kind| of_kind(found, kind).len())
}

#[test]
fn a_box_has_edges_of_all_kinds() {
    let geometry = geometry("box.glb", include_bytes!("../../../../../scenes/box.glb"), 1);
    let found = candidates(&geometry, &[Some(60.0)]);
    assert_eq!(counts(&found), [21, 12, 24], "as `tools/scenes/box.py` counts them");

    let height = |vertex: u32| geometry.sources[vertex as usize].position[1];
    let is_at = |candidate: &Candidate, heights: &[f32]| {
        heights.iter().any(|&y| candidate.left[..2].iter().all(|&vertex| (height(vertex) - y).abs() < 1e-6))
    };
    assert!(of_kind(&found, bit::BOUNDARY).iter().all(|edge| is_at(edge, &[1.25])), "the rim");
    assert!(of_kind(&found, bit::MATERIAL).iter().all(|edge| is_at(edge, &[0.5, 0.85])), "the stripe");
    let floor = of_kind(&found, bit::CREASE).into_iter().filter(|edge| is_at(edge, &[0.0])).count();
    assert_eq!(floor, 12);
    // Contours are looked for at the round corner only, where normals differ.
    let is_round = |&vertex: &u32| {
        let [x, _, z] = geometry.sources[vertex as usize].position;
        x > 0.3 && z < -0.1
    };
    let contours = of_kind(&found, bit::CONTOUR);
    assert!(!contours.is_empty() && contours.iter().all(|contour| contour.left.iter().any(is_round)));
}

#[test]
fn creases_begin_at_the_angle_that_is_asked_for() {
    // A roof whose sides slope by 40 degrees: the ridge turns by 80.
    let (x, y) = (40_f32.to_radians().cos(), -40_f32.to_radians().sin());
    let roof = format!("v 0 0 0\nv 0 0 1\nv {x} {y} 0\nv -{x} {y} 0\nf 1 2 3\nf 2 1 4\n");
    let geometry = geometry("roof.obj", roof.as_bytes(), 1);
    for (crease_deg, creases) in [(79.0, 1), (81.0, 0)] {
        assert_eq!(counts(&candidates(&geometry, &[Some(crease_deg)])), [creases, 4, 0]);
    }
    assert_eq!(candidates(&geometry, &[None]), []);
}

#[test]
fn copies_at_one_place_are_not_sewn_together() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    for copies in [1, 3] {
        let found = candidates(&geometry("square.obj", square.as_bytes(), copies), &[Some(60.0)]);
        assert_eq!(counts(&found), [0, 4 * copies, 0]);
    }
    let two = format!("{square}v 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 5 6 7 8\n");
    let found = candidates(&geometry("two.obj", two.as_bytes(), 1), &[Some(60.0)]);
    assert_eq!(counts(&found), [0, 6, 0], "within a body, equal places are");
}

#[test]
fn sheets_that_meet_make_a_joint() {
    // Two squares in one plane and one upright, all at one edge.
    let sheets = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv -1 0 0\nv 0 1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";
    let found = candidates(&geometry("sheets.obj", sheets.as_bytes(), 1), &[Some(60.0)]);
    assert_eq!(counts(&found), [1, 6, 0]);
}

#[test]
fn a_broken_fan_takes_no_time() {
    // Every triangle has the same edge: to pair them would take a square of the number.
    let mut fan = "v 0 0 0\nv 0 0 1\n".to_owned();
    for step in 0..50_000 {
        let angle = step as f32 * 1e-4;
        writeln!(fan, "v {} {} 0\nf 1 2 {}", angle.cos(), angle.sin(), step + 3).expect("strings grow");
    }
    let geometry = geometry("fan.obj", fan.as_bytes(), 1);
    let begin = Instant::now();
    assert_eq!(counts(&candidates(&geometry, &[Some(60.0)]))[0], 1);
    assert!(begin.elapsed().as_secs() < 5, "{:?}", begin.elapsed());
}
