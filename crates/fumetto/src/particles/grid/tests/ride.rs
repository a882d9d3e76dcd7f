//! How smoke goes with the air.

use std::f32::consts::TAU;

use glam::Vec3;

use super::{air_of, set_velocity};
use crate::{
    gpu::{Frame, TexturePool},
    particles::{
        emission::{Carrier, Motion},
        tests::{engine, play_smoke, slots_after},
        vortex::Span,
    },
};

#[test]
fn rigid_rotation_carries_a_particle_round_a_closed_circle() {
    let engine = engine();
    let keys = "solver = \"grid\"\ngrid = { box = { center = [0, 0, 0], size = [1, 1, 1] }, cells = 16 }\n\
        [object.emitter]\nshape = { point = { center = [0.3, 0, 0] } }\nbursts = [{ at = 0, count = 1 }]\nlife = 1000\n";
    let mut player = play_smoke(&engine, 1, 24.0, keys);
    let start = slots_after(&engine, &mut player, 1)[0].position;
    set_velocity(&engine, &player, |place| Vec3::Z.cross(place) * TAU);
    let motion = Motion::new(engine.gpu());
    let pool = TexturePool::default();
    let plume = player.plumes().next().expect("there is smoke");
    let place = |step: u32, steps: u32| {
        let span = Span { time: 1.0 + f64::from(step) / f64::from(steps), dt: 1.0 / f64::from(steps) };
        let mut frame = Frame::new(engine.gpu(), &pool, "test");
        let (grid, velocity) = air_of(&player).after(&frame, player.steps);
        motion.step(&mut frame, &plume.emissions[0], &[], Carrier::Air(&grid, velocity), span);
        frame.submit();
        let slots: Vec<crate::particles::tests::Particle> =
            crate::gpu::read_buffer(engine.gpu(), plume.emissions[0].particles()).expect("the device lives");
        slots[0].position
    };
    let mut path = Vec::new();
    for step in 0..48 {
        path.push(place(step, 48));
    }
    assert!(path[23].distance(-start) < 0.01, "half-way it is opposite, not at {}", path[23]);
    assert!(path[47].distance(start) < 0.01, "it comes back to {start}, not to {}", path[47]);
    assert!(path.iter().all(|place| (place.length() / start.length() - 1.0).abs() < 0.01));
}
