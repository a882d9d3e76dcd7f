//! Smoke among vortices.

use glam::Vec3;

use crate::particles::tests::{Particle, engine, play_smoke, slots_after};

/// A ring of 1 m²/s around a particle at its middle, and two emitters that shed their own.
const SMOKE: &str = "vortex = { decay = 0, core = 0.2, segments = 128, error = 0.005 }\n\
    [[object.emitter]]\nshape = { point = { center = [0, 0, 0] } }\nbursts = [{ at = 0, count = 1 }]\nlife = 1000\n\
    rings = { at = [0], circulation = 1, radius = 1, wobble = 0 }\n";

#[test]
fn a_ring_carries_what_is_in_its_middle() {
    let engine = engine();
    let mut player = play_smoke(&engine, 1, 240.0, SMOKE);
    let particle = slots_after(&engine, &mut player, 1)[0];
    // Biot and Savart at the middle of a ring: Γ/(2R) for a thin one, times r³ of the kernel.
    let kernel = (1.0 + 2.5 * 0.04) / (1.0_f32 + 0.04).powf(2.5);
    let expected = Vec3::new(0.0, 0.5 * kernel, 0.0);
    assert!(particle.carried.distance(expected) < 2e-3, "{} should be {expected}", particle.carried);
    assert!(particle.position.distance(expected / 240.0) < 1e-4, "{}", particle.position);
}

#[test]
fn by_forces_alone_nothing_is_carried() {
    let engine = engine();
    let mut player = play_smoke(&engine, 1, 24.0, &format!("solver = \"forces\"\n{SMOKE}"));
    let particle = slots_after(&engine, &mut player, 24)[0];
    assert_eq!((particle.carried, particle.position), (Vec3::ZERO, Vec3::ZERO));
}

/// Two jets that blow against each other, with more vortices than the least tree has room for.
const JETS: &str = "vortex = { segments = 64 }\n\
    force = [{ kind = \"turbulence\", speed = 0.5, scale = 1 }, { kind = \"drag\", rate = 1 }]\n\
    [[object.emitter]]\nshape = { disc = { center = [-1, 0, 0], radius = 0.2 } }\nrate = 300\nlife = 3\n\
    velocity = [3, 0, 0]\nspread = 10\nrings = { rate = 12, circulation = 0.5 }\n\
    [[object.emitter]]\nshape = { disc = { center = [1, 0, 0], radius = 0.2 } }\nrate = 300\nlife = 3\n\
    velocity = [-3, 0, 0]\nspread = 10\n";

fn bytes(frames: &[u32]) -> Vec<u8> {
    let engine = engine();
    let mut player = play_smoke(&engine, 3, 24.0, JETS);
    let mut slots: Vec<Particle> = Vec::new();
    for &frame in frames {
        slots = slots_after(&engine, &mut player, frame);
    }
    assert!(slots.iter().any(|particle| particle.carried.length() > 0.3), "the vortices do carry");
    bytemuck::cast_slice(&slots).to_vec()
}

#[test]
fn the_same_seed_gives_the_same_bytes_whichever_way_time_goes() {
    let straight = bytes(&[40]);
    assert!(straight == bytes(&[40]), "twice");
    assert!(straight == bytes(&[7, 8, 40]), "with stops");
    assert!(straight == bytes(&[50, 40]), "and back");
}
