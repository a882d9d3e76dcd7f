//! How particles move, where it can be said in a formula.

use glam::Vec3;

use super::{Particle, alive_after, assert_close, engine, play};

/// One particle, born at the origin at time 0 with velocity (1, 2, 3), after `steps` steps.
fn lone(fps: f32, steps: u32, forces: &[&str]) -> Particle {
    let engine = engine();
    let emitter = "shape = { point = { center = [0, 0, 0] } }\nbursts = [{ at = 0, count = 1 }]\n\
                   life = 1000\nvelocity = [1, 2, 3]";
    let alive = alive_after(&engine, &mut play(&engine, fps, emitter, forces), steps);
    assert_eq!(alive.len(), 1);
    alive[0]
}

const BIRTH: Vec3 = Vec3::new(1.0, 2.0, 3.0);
const GRAVITY: &str = "{ kind = \"gravity\", acceleration = [0, -9.81, 0] }";
const DRAG: &str = "{ kind = \"drag\", rate = 2.5 }";

#[test]
fn without_forces_a_particle_flies_straight() {
    let particle = lone(24.0, 48, &[]);
    assert_close(particle.velocity, BIRTH, 0.0);
    assert_close(particle.position, BIRTH * 2.0, 1e-4);
    assert!((particle.age - 2.0).abs() < 1e-4);
}

#[test]
fn without_drag_a_fall_is_free_whatever_the_step() {
    for fps in [6.0, 24.0, 96.0] {
        let particle = lone(fps, fps as u32 * 2, &[GRAVITY]);
        let fall = Vec3::new(0.0, -9.81, 0.0);
        assert_close(particle.velocity, BIRTH + fall * 2.0, 1e-4);
        assert_close(particle.position, BIRTH * 2.0 + 0.5 * fall * 4.0, 2e-4);
    }
}

#[test]
fn with_drag_a_fall_ends_at_gravity_over_rate() {
    let particle = lone(24.0, 240, &[GRAVITY, DRAG]);
    assert_close(particle.velocity, Vec3::new(0.0, -9.81 / 2.5, 0.0), 1e-4);
}

#[test]
fn with_drag_a_rise_ends_at_buoyancy_over_rate() {
    let particle = lone(24.0, 240, &["{ kind = \"buoyancy\", acceleration = 3.5 }", DRAG]);
    assert_close(particle.velocity, Vec3::new(0.0, 3.5 / 2.5, 0.0), 1e-4);
}

#[test]
fn a_cooled_particle_is_lifted_no_more() {
    let hot = "{ kind = \"buoyancy\", acceleration = 3.5, cooling = 4.0 }";
    let particle = lone(24.0, 240, &[hot, DRAG]);
    assert_close(particle.velocity, Vec3::ZERO, 1e-4);
    assert!(particle.position.y > 2.0 / 2.5 + 0.1, "it was lifted before");
}

#[test]
fn drag_slows_exponentially_whatever_the_step() {
    for fps in [6.0, 24.0, 96.0] {
        let particle = lone(fps, fps as u32, &[DRAG]);
        let left = (-2.5_f32).exp();
        assert_close(particle.velocity, BIRTH * left, 1e-4);
        assert_close(particle.position, BIRTH * ((1.0 - left) / 2.5), 1e-4);
    }
}

#[test]
fn drag_takes_particles_along_with_the_wind() {
    let particle = lone(24.0, 240, &["{ kind = \"wind\", velocity = [2, 0, -1] }", DRAG]);
    assert_close(particle.velocity, Vec3::new(2.0, 0.0, -1.0), 1e-4);
}

#[test]
fn wind_without_drag_moves_nothing() {
    let particle = lone(24.0, 24, &["{ kind = \"wind\", velocity = [2, 0, -1] }"]);
    assert_close(particle.velocity, BIRTH, 0.0);
}

#[test]
fn gusts_swell_and_slacken_within_their_share() {
    let engine = engine();
    let emitter = "shape = { point = { center = [0, 0, 0] } }\nbursts = [{ at = 0, count = 1 }]\nlife = 1000";
    let forces = [
        "{ kind = \"wind\", velocity = [2, 0, 0], gust = 0.3, gust_secs = 1 }",
        "{ kind = \"drag\", rate = 1e4 }",
    ];
    let mut player = play(&engine, 24.0, emitter, &forces);
    let speeds: Vec<_> = (1..96).map(|step| alive_after(&engine, &mut player, step)[0].velocity.x).collect();
    let (least, most) = speeds.iter().fold((9.0_f32, 0.0_f32), |(a, b), &x| (a.min(x), b.max(x)));
    assert!((1.4..1.6).contains(&least) && (2.4..2.6001).contains(&most), "from {least} to {most}");
}

#[test]
fn a_particle_that_air_holds_tight_follows_the_vortex() {
    let engine = engine();
    for (place, expected) in [
        // By the right hand about +y: +x goes to -z, +z to +x. At the radius it is as fast as said.
        ("[3, 0, 0]", Vec3::new(0.0, 0.0, -5.0)),
        ("[0, 7, 3]", Vec3::new(5.0, 0.0, 0.0)),
        // Half as far and twice as far it is slower: 2 a / (1 + a²) with a = 1/2 and 2.
        ("[1.5, 0, 0]", Vec3::new(0.0, 0.0, -4.0)),
        ("[6, 0, 0]", Vec3::new(0.0, 0.0, -4.0)),
        ("[0, 1, 0]", Vec3::ZERO),
    ] {
        let emitter = format!(
            "shape = {{ point = {{ center = {place} }} }}\nbursts = [{{ at = 0, count = 1 }}]\nlife = 9"
        );
        let forces = [
            "{ kind = \"vortex\", center = [0, -4, 0], axis = [0, 2, 0], radius = 3, speed = 5 }",
            "{ kind = \"drag\", rate = 1e6 }",
        ];
        let alive = alive_after(&engine, &mut play(&engine, 1000.0, &emitter, &forces), 1);
        assert_close(alive[0].velocity, expected, 1e-4);
    }
}

#[test]
fn turbulence_is_as_fast_as_said_on_average() {
    let engine = engine();
    let emitter = "shape = { box = { center = [0, 0, 0], size = [90, 90, 90] } }\n\
                   bursts = [{ at = 0, count = 60000 }]\nlife = 9";
    let forces = ["{ kind = \"turbulence\", speed = 4, scale = 1.7 }", "{ kind = \"drag\", rate = 1e6 }"];
    let alive = alive_after(&engine, &mut play(&engine, 1000.0, emitter, &forces), 1);
    let square: f64 = alive.iter().map(|p| f64::from(p.velocity.length_squared())).sum();
    let speed = (square / alive.len() as f64).sqrt();
    assert!((speed / 4.0 - 1.0).abs() < 0.03, "root mean square {speed}");
}
