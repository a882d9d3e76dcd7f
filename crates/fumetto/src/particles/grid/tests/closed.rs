//! What walls keep.

use glam::Vec3;

use super::{heat_now, velocity_after};
use crate::particles::tests::{Particle, engine, play_smoke, slots_after};

/// A jet that is blown at the floor of a closed box.
const JET: &str = "solver = \"grid\"\n\
    grid = { box = { center = [0, 0, 0], size = [1, 1, 1] }, cells = 24, walls = { x = [\"closed\", \"closed\"], y = [\"closed\", \"closed\"], z = [\"closed\", \"closed\"] }, dissipation = 0 }\n\
    [object.emitter]\nshape = { sphere = { center = [0, 0, 0], radius = 0.12 } }\nrate = 400\nlife = 100\n\
    active = [0, 0.5]\nvelocity = [0.3, -3, 0]\n";

#[test]
fn closed_walls_let_nothing_through() {
    let engine = engine();
    let mut player = play_smoke(&engine, 1, 24.0, JET);
    let slots = slots_after(&engine, &mut player, 100);
    let alive: Vec<&Particle> = slots.iter().filter(|particle| !particle.is_dead()).collect();
    assert_eq!(alive.len(), 200);
    assert!(alive.iter().all(|particle| particle.position.abs().max_element() <= 0.5 + 1e-6));
    assert!(alive.iter().any(|particle| particle.position.y < -0.4), "it reaches the floor");
    let velocity = velocity_after(&engine, &mut player, 100);
    for (axis, field) in velocity.iter().enumerate() {
        let end = [0, 1, 2].map(|other| if other == axis { 24 } else { 11 });
        assert_eq!(field.at(end[0], end[1], end[2]), 0.0, "air goes through the wall");
    }
}

#[test]
fn smoke_in_a_closed_box_stays() {
    let engine = engine();
    let mut player = play_smoke(&engine, 1, 24.0, JET);
    let mut total = |step| {
        engine.seek(&mut player, step).expect("there are no files to miss");
        heat_now(&engine, &player, 1).values.iter().map(|&smoke| f64::from(smoke)).sum::<f64>()
    };
    let (soon, late) = (total(14), total(60));
    // Semi-Lagrangian schemes do not conserve by themselves.
    assert!((late / soon - 1.0).abs() < 0.1, "{soon} becomes {late}");
}

fn bytes(frames: &[u32]) -> Vec<u8> {
    let engine = engine();
    let keys = format!(
        "{JET}[[object.force]]\nkind = \"turbulence\"\nspeed = 1\nscale = 0.4\n\
        [[object.force]]\nkind = \"drag\"\nrate = 2\n"
    )
    .replace("dissipation = 0", "eddies = { count = 16, radius = 0.15, strength = 3 }");
    let mut player = play_smoke(&engine, 3, 24.0, &keys);
    let mut slots: Vec<Particle> = Vec::new();
    for &frame in frames {
        slots = slots_after(&engine, &mut player, frame);
    }
    assert!(slots.iter().any(|particle| particle.carried != Vec3::ZERO), "the air does carry");
    bytemuck::cast_slice(&slots).to_vec()
}

#[test]
fn the_same_seed_gives_the_same_bytes_whichever_way_time_goes() {
    let straight = bytes(&[20]);
    assert!(straight == bytes(&[20]), "again");
    assert!(straight == bytes(&[3, 4, 11, 20]), "with stops");
    assert!(straight == bytes(&[25, 20]), "back");
}

#[test]
fn however_hard_air_is_pushed_it_stays_a_number() {
    let engine = engine();
    let keys = JET
        .replace(
            "dissipation = 0 }",
            "confinement = 1e6, eddies = { count = 64, radius = 0.1, strength = 1e6 } }\n\
            force = [{ kind = \"buoyancy\", acceleration = 1e6 }, { kind = \"gravity\" }]",
        )
        .replace(
            "velocity = [0.3, -3, 0]",
            "velocity = [1e4, -1e6, 0]\nsource = { heat = 1e6, smoke = 1e6 }",
        );
    let mut player = play_smoke(&engine, 1, 24.0, &keys);
    let velocity = velocity_after(&engine, &mut player, 5);
    assert!(velocity.iter().all(|field| field.values.iter().all(|speed| speed.is_finite())));
    let slots = slots_after(&engine, &mut player, 5);
    assert!(slots.iter().all(|particle| particle.position.is_finite()));
}
