//! Paint that feels the surface it lies on.

use glam::{Vec3, Vec4Swizzles as _};

use super::{bodies_at, engine, play, vertices_at};
use crate::paint::sphere::Sphere;

/// It falls to the right, by 45 degrees.
const SLOPE: &str = "v -9 9 -9\nv -9 9 9\nv 9 -9 9\nv 9 -9 -9\nf 1 2 3 4\n";

/// Both halves fall away from the middle.
const ROOF: &str = "v -9 -9 -9\nv -9 -9 9\nv 0 0 9\nv 0 0 -9\nv 9 -9 9\nv 9 -9 -9\nf 1 2 3 4\nf 4 3 5 6\n";

/// It falls to the right, and is level from the middle on.
const FOOT: &str = "v -9 9 -9\nv -9 9 9\nv 0 0 9\nv 0 0 -9\nv 19 0 9\nv 19 0 -9\nf 1 2 3 4\nf 4 3 5 6\n";

const LEVEL: &str = "v -9 0 -9\nv -9 0 9\nv 9 0 9\nv 9 0 -9\nf 1 2 3 4\n";

/// A drop of radius 1 that falls at once with half of that.
fn drop(at: [f32; 3], spread: &str) -> String {
    format!("drop = {{ at = {at:?}, radius = 1, start = 0.5 }}\nspread = {{ grain = 0, {spread} }}")
}

#[test]
fn on_a_slope_its_middle_runs_as_far_as_elasticity_lets_it() {
    let engine = engine();
    let mut player = play(&engine, &drop([0.0; 3], "elasticity = 5, downhill = 4"), SLOPE);
    let [body] = bodies_at(&engine, &mut player, 480)[..] else { panic!("there is one volume") };
    assert_eq!(body.start, [0.0; 3]);
    let along = 4.0 * 45_f32.to_radians().sin() / 5.0;
    let expected = along * Vec3::new(1.0, -1.0, 0.0).normalize_or_zero();
    assert!(Vec3::from(body.end).distance(expected) < 1e-3, "{:?} should be {expected}", body.end);
}

#[test]
fn vertices_that_lie_on_a_slope_are_drawn_along_it() {
    let engine = engine();
    let mut player = play(&engine, &drop([0.0; 3], "elasticity = 5, downhill = 4"), SLOPE);
    let vertices = vertices_at(&engine, &mut player, 480);
    let directions = Sphere::new(8).directions;
    assert_eq!(vertices.len(), directions.len());
    let (normal, down) = (Vec3::new(1.0, 1.0, 0.0).normalize_or_zero(), Vec3::new(0.5, -0.5, 0.0));
    let mut drawn = 0;
    for ([radius, _], direction) in vertices.iter().zip(&directions) {
        let direction = direction.xyz();
        // It feels the slope up to a quarter of the radius away.
        let nearness = (1.0 - radius * direction.dot(normal).abs() / 0.25).max(0.0);
        drawn += u32::from(nearness > 0.0);
        let force = 16.0 * (1.0 - radius) + 5.0 * (0.5 - radius) + 4.0 * nearness * down.dot(direction);
        assert!(force.abs() < 0.01, "{force} at {direction}");
    }
    assert!((50..400).contains(&drawn), "{drawn} of {} lie near the slope", vertices.len());
}

#[test]
fn it_reaches_down_both_sides_of_a_roof_and_gathers_in_a_ditch() {
    let engine = engine();
    let ditch: &'static str = ROOF.replace("-9 -9 ", "-9 9 ").replace("v 9 -9", "v 9 9").leak();
    for (model, sign) in [(ROOF, 1.0), (ditch, -1.0)] {
        // Its middle would slide off on one side.
        let keys =
            drop([0.0; 3], "downhill = 4") + "\nkeep = { center = [0, 0, 0], size = [1e-3, 1e-3, 1e-3] }";
        let mut player = play(&engine, &keys, model);
        let vertices = vertices_at(&engine, &mut player, 240);
        let directions = Sphere::new(8).directions;
        let radius_toward = |toward: Vec3| {
            let angle = |at: &usize| directions[*at].xyz().dot(toward.normalize_or_zero());
            (0..directions.len()).max_by(|a, b| angle(a).total_cmp(&angle(b))).map(|at| vertices[at][0])
        };
        let [left, right, along] = [Vec3::new(-1.0, -sign, 0.0), Vec3::new(1.0, -sign, 0.0), Vec3::Z]
            .map(|way| sign * (radius_toward(way).expect("there are vertices") - 1.0));
        assert!(left > 0.03 && right > 0.03, "{left} and {right} on {model}");
        assert!(along.abs() < 0.02, "{along} on {model}");
    }
}

#[test]
fn its_middle_keeps_to_a_surface_that_bends() {
    let engine = engine();
    let keys = drop([-1.0, 1.0, 0.0], "downhill = 20, subdivisions = 2");
    let mut player = play(&engine, &keys, FOOT);
    let mut farthest = -1.0_f32;
    for frame in (0..=240).step_by(8).skip(1) {
        let [x, y, z] = bodies_at(&engine, &mut player, frame)[0].end;
        assert!((y - (-x).max(0.0)).abs() < 2e-3 && z.abs() < 1e-3, "frame {frame}: {x} {y} {z}");
        farthest = farthest.max(x);
    }
    assert!((0.0..3.0).contains(&farthest), "it comes to rest on what is level: {farthest}");
}

#[test]
fn on_what_is_level_or_far_away_nothing_draws_it() {
    let engine = engine();
    for (at, model) in [([0.0; 3], LEVEL), ([9.0, 9.0, 9.0], SLOPE), ([0.0; 3], "")] {
        let [without, with] = ["downhill = 0", "downhill = 9"].map(|spread| {
            let mut player = play(&engine, &drop(at, spread), model);
            (vertices_at(&engine, &mut player, 100), bodies_at(&engine, &mut player, 100)[0].end)
        });
        assert_eq!(without, with, "{model}");
    }
}
