//! The same seed gives the same bytes, whichever way time goes.

use super::{engine, play_seeded, slots_after};

const EMITTER: &str = "shape = { sphere = { center = [0, 0, 0], radius = 1 } }\nrate = 2000\nlife = [0.5, 1.5]\n\
                       velocity = [0, 1, 0]\nspread = 30\nspeed_jitter = 0.3";
const FORCES: [&str; 3] = [
    "{ kind = \"turbulence\", speed = 1, scale = 0.7, drift = [0.3, 0, 0] }",
    "{ kind = \"drag\", rate = 2 }",
    "{ kind = \"vortex\", center = [0, 0, 0], radius = 1, speed = 2 }",
];

/// The state's bytes at the last of `frames`, all of which are sought in turn.
fn bytes(seed: u32, frames: &[u32]) -> Vec<u8> {
    let engine = engine();
    let mut player = play_seeded(&engine, seed, 24.0, EMITTER, &FORCES);
    let mut slots = Vec::new();
    for &frame in frames {
        slots = slots_after(&engine, &mut player, frame);
    }
    assert!(
        slots.iter().filter(|particle| !particle.is_dead()).count() > 1500,
        "there is something to compare"
    );
    bytemuck::cast_slice(&slots).to_vec()
}

#[test]
fn two_runs_give_the_same_bytes() {
    assert!(bytes(7, &[50]) == bytes(7, &[50]));
}

#[test]
fn stops_on_the_way_change_nothing() {
    assert!(bytes(7, &[50]) == bytes(7, &[10, 11, 37, 50]));
}

#[test]
fn going_back_and_forth_changes_nothing() {
    assert!(bytes(7, &[50]) == bytes(7, &[60, 50]));
    assert!(bytes(7, &[50]) == bytes(7, &[50, 3, 50]));
}

#[test]
fn another_seed_gives_another_state() {
    assert!(bytes(7, &[50]) != bytes(8, &[50]));
}
