//! How many particles there are, and where they begin.

use std::collections::HashSet;

use glam::Vec3;

use super::{Particle, alive_after, engine, play, slots_after};

#[test]
fn the_living_are_the_births_of_the_schedule_less_the_deaths() {
    let engine = engine();
    // 37 a second for ever, 50 at once at 0.33 s; all live half a second; 20 steps a second.
    let emitter = "shape = { point = { center = [0, 0, 0] } }\n\
                   rate = 37\nlife = 0.5\nbursts = [{ at = 0.33, count = 50 }]";
    let mut player = play(&engine, 20.0, emitter, &[]);
    let streamed = |steps: u32| (37 * steps) / 20;
    for step in [1, 5, 6, 7, 10, 11, 15, 17, 18, 40, 60] {
        let stream = streamed(step) - streamed(step.saturating_sub(10));
        // The burst comes in the seventh step, and has gone half a second after that step began.
        let burst = if (7..16).contains(&step) { 50 } else { 0 };
        let alive = alive_after(&engine, &mut player, step).len();
        assert_eq!(alive, (stream + burst) as usize, "after step {step}");
    }
}

#[test]
fn as_many_live_as_are_born_in_a_mean_life() {
    let engine = engine();
    let emitter = "shape = { point = { center = [0, 0, 0] } }\nrate = 8000\nlife = [0.5, 1.5]";
    let alive = alive_after(&engine, &mut play(&engine, 24.0, emitter, &[]), 60).len() as f64;
    assert!((alive / 8000.0 - 1.0).abs() < 0.02, "{alive} live");
}

#[test]
fn a_count_is_kept_by_new_births_in_the_place_of_the_dead() {
    let engine = engine();
    let emitter = "shape = { sphere = { center = [0, 0, 0], radius = 1 } }\ncount = 100\nlife = [0.4, 0.8]";
    let mut player = play(&engine, 20.0, emitter, &[]);
    let mut before = slots_after(&engine, &mut player, 16);
    let mut births: HashSet<u32> = before.iter().map(|particle| particle.birth).collect();
    let mut reborn = 0;
    for step in 17..60 {
        let now = slots_after(&engine, &mut player, step);
        assert_eq!(now.iter().filter(|particle| !particle.is_dead()).count(), 100, "after step {step}");
        for (old, new) in before.iter().zip(&now) {
            if new.age > old.age {
                assert_eq!((new.birth, new.position), (old.birth, old.position));
            } else {
                assert!(births.insert(new.birth), "birth {} comes once", new.birth);
                assert_ne!((new.position, new.life), (old.position, old.life));
                reborn += 1;
            }
        }
        before = now;
    }
    // 100 particles that live 0.6 s on average, for 2.15 s.
    assert!((300..420).contains(&reborn), "{reborn} were reborn");
}

#[test]
fn a_count_dies_out_when_the_emitter_stops() {
    let engine = engine();
    let emitter = "shape = { point = { center = [0, 0, 0] } }\ncount = 100\nlife = 0.4\nactive = [0.0, 1.0]";
    let mut player = play(&engine, 20.0, emitter, &[]);
    assert_eq!(alive_after(&engine, &mut player, 19).len(), 100);
    assert_eq!(alive_after(&engine, &mut player, 29).len(), 0);
}

/// Places of 4,000 births.
fn born_in(shape: &str) -> Vec<Vec3> {
    let engine = engine();
    let emitter = format!("shape = {{ {shape} }}\nbursts = [{{ at = 0, count = 4000 }}]\nlife = 9");
    let alive = alive_after(&engine, &mut play(&engine, 24.0, &emitter, &[]), 1);
    assert_eq!(alive.len(), 4000);
    alive.iter().map(|particle| particle.position).collect()
}

fn mean(values: impl ExactSizeIterator<Item = f32>) -> f32 {
    let count = values.len() as f32;
    values.sum::<f32>() / count
}

#[test]
fn a_point_gives_birth_in_one_place() {
    assert!(born_in("point = { center = [1, 2, 3] }").iter().all(|&place| place == Vec3::new(1.0, 2.0, 3.0)));
}

#[test]
fn a_disc_is_filled_evenly_and_nothing_leaves_its_plane() {
    let center = Vec3::new(1.0, 2.0, 3.0);
    let normal = Vec3::new(1.0, 1.0, -2.0).normalize_or_zero();
    let places = born_in("disc = { center = [1, 2, 3], normal = [1, 1, -2], radius = 2 }");
    assert!(places.iter().all(|&place| (place - center).dot(normal).abs() < 1e-5));
    assert!(places.iter().all(|&place| place.distance(center) <= 2.0 + 1e-5));
    // Of an even disc, the mean square of the distance is half the radius squared.
    let spread = mean(places.iter().map(|place| place.distance_squared(center)));
    assert!((spread - 2.0).abs() < 0.06, "mean square {spread}");
    assert!(
        mean(places.iter().map(|place| (place - center).dot(normal.any_orthonormal_vector()))).abs() < 0.06
    );
}

#[test]
fn nothing_is_born_in_the_hole_of_a_disc() {
    let places = born_in("disc = { center = [0, 0, 0], radius = 2, hole = 0.5 }");
    assert!(places.iter().all(|&place| (1.0 - 1e-5..=2.0 + 1e-5).contains(&place.length())));
    // Of an even annulus, the mean square is the mean of both radii's squares.
    let spread = mean(places.iter().map(|place| place.length_squared()));
    assert!((spread - 2.5).abs() < 0.06, "mean square {spread}");
}

#[test]
fn a_sphere_is_filled_evenly() {
    let center = Vec3::new(1.0, 2.0, 3.0);
    let places = born_in("sphere = { center = [1, 2, 3], radius = 2 }");
    assert!(places.iter().all(|&place| place.distance(center) <= 2.0 + 1e-5));
    // Of an even ball, the mean square of the distance is three fifths of the radius squared.
    let spread = mean(places.iter().map(|place| place.distance_squared(center)));
    assert!((spread - 2.4).abs() < 0.06, "mean square {spread}");
    let middle = places.iter().sum::<Vec3>() / places.len() as f32;
    assert!(middle.distance(center) < 0.08, "middle {middle}");
}

#[test]
fn a_box_is_filled_evenly() {
    let (center, size) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, 0.5, 2.0));
    let places = born_in("box = { center = [1, 2, 3], size = [4, 0.5, 2] }");
    assert!(places.iter().all(|&place| ((place - center).abs() * 2.0).cmple(size + 1e-5).all()));
    for axis in 0..3 {
        let variance = mean(places.iter().map(|place| (place[axis] - center[axis]).powi(2)));
        let even = size[axis] * size[axis] / 12.0;
        assert!((variance / even - 1.0).abs() < 0.05, "variance {variance} along axis {axis}");
    }
}

#[test]
fn a_line_is_filled_evenly() {
    let (from, to) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(-1.0, 5.0, 3.0));
    let places = born_in("line = { from = [1, 2, 3], to = [-1, 5, 3] }");
    let along = |place: &Vec3| (place - from).dot(to - from) / (to - from).length_squared();
    assert!(places.iter().all(|place| (-1e-5..1.0 + 1e-5).contains(&along(place))));
    assert!(places.iter().all(|place| place.distance(from.lerp(to, along(place))) < 1e-5));
    assert!((mean(places.iter().map(along)) - 0.5).abs() < 0.02);
}

#[test]
fn velocities_keep_to_the_cone_and_to_the_range_of_speeds() {
    let engine = engine();
    let emitter = "shape = { point = { center = [0, 0, 0] } }\nbursts = [{ at = 0, count = 4000 }]\nlife = 9\n\
                   velocity = [0, 3, 4]\nspread = 20\nspeed_jitter = 0.2";
    let alive = alive_after(&engine, &mut play(&engine, 24.0, emitter, &[]), 1);
    let axis = Vec3::new(0.0, 0.6, 0.8);
    let widest = alive.iter().map(|p| p.velocity.angle_between(axis)).fold(0.0, f32::max).to_degrees();
    assert!((19.5..20.01).contains(&widest), "the widest leaves at {widest} degrees");
    let speeds = || alive.iter().map(|particle| particle.velocity.length());
    assert!(speeds().all(|speed| (4.0 - 1e-4..=6.0 + 1e-4).contains(&speed)));
    assert!((mean(speeds()) - 5.0).abs() < 0.05);
    let sideways = alive.iter().map(|p: &Particle| p.velocity - axis * p.velocity.dot(axis)).sum::<Vec3>();
    assert!(sideways.length() / 4000.0 < 0.05, "the cone leans by {sideways}");
}

#[test]
fn a_million_particles_step() {
    let engine = engine();
    let emitter = "shape = { sphere = { center = [0, 0, 0], radius = 1 } }\ncount = 1000000\nlife = 0.05";
    let forces =
        ["{ kind = \"turbulence\", speed = 1, scale = 1, octaves = 2 }", "{ kind = \"drag\", rate = 2 }"];
    let alive = alive_after(&engine, &mut play(&engine, 24.0, emitter, &forces), 2);
    assert_eq!(alive.len(), 1_000_000);
}
