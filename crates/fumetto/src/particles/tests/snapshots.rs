//! What is put back goes on as if it had never been away.

use super::{engine, play_smoke, play_timed};
use crate::{Engine, Error, Extent, Player, Snapshot};

const EMITTER: &str = "[object.emitter]\nrate = 60\nvelocity = [0, 1, 0]\nradius = 0.1\nlife = 0.5\n\
                       shape = { disc = { center = [0, 0, 0], radius = 0.2 } }\n";

/// Smoke of every kind.
fn scenes() -> [(&'static str, String); 3] {
    let grid = "grid = { box = { center = [0, 0, 0], size = [1, 2, 1] }, cells = 16, \
                eddies = { count = 8, radius = 0.2, strength = 2 } }
";
    [
        ("forces", format!("solver = \"forces\"\n{EMITTER}")),
        ("vortex", format!("solver = \"vortex\"\n{EMITTER}")),
        ("grid", format!("solver = \"grid\"\n{grid}{EMITTER}")),
    ]
}

fn taken(engine: &Engine, player: &mut Player, frame: u32, extent: Extent) -> Snapshot {
    engine.seek(player, frame).expect("there are no files to miss");
    engine.snapshot(player, extent).expect("the device lives")
}

#[test]
fn what_is_put_back_goes_on() {
    let engine = engine();
    for (name, keys) in scenes() {
        let mut straight = play_smoke(&engine, 1, 30.0, &keys);
        let middle = taken(&engine, &mut straight, 7, Extent::Whole);
        let end = taken(&engine, &mut straight, 13, Extent::Whole);
        assert_ne!(middle.parts, end.parts, "{name}: something moves");

        let mut resumed = play_smoke(&engine, 1, 30.0, &keys);
        engine.recall(&mut resumed, &middle).expect("it is of the same scene");
        assert_eq!(resumed.reached(), Some(7), "{name}");
        assert_eq!(taken(&engine, &mut resumed, 13, Extent::Shown).parts, end.parts[..1], "{name}");

        // What is shown alone cannot go on: it begins anew, with the same end.
        let shown = Snapshot { frame: 7, parts: middle.parts[..1].to_vec() };
        engine.recall(&mut resumed, &shown).expect("it is of the same scene");
        assert_eq!(taken(&engine, &mut resumed, 13, Extent::Shown).parts, end.parts[..1], "{name}");
    }
}

#[test]
fn pre_roll_only_shifts_frames() {
    let engine = engine();
    for (name, keys) in scenes() {
        let mut straight = play_smoke(&engine, 1, 30.0, &keys);
        let [seventh, thirteenth] =
            [7, 13].map(|frame| taken(&engine, &mut straight, frame, Extent::Whole).parts);
        let mut rolled = play_timed(&engine, 1, "fps = 30, pre_roll = 0.2334", &keys);
        assert!(!engine.pre_roll(&mut rolled, 0, 4), "{name}: there are seven steps");
        assert_eq!(rolled.reached(), Some(0), "{name}");
        assert!(engine.pre_roll(&mut rolled, 0, 4), "{name}");
        let first = taken(&engine, &mut rolled, 0, Extent::Whole);
        assert_eq!(first.parts, seventh, "{name}");
        assert_eq!(taken(&engine, &mut rolled, 6, Extent::Whole).parts, thirteenth, "{name}");
        assert_eq!(rolled.reached(), Some(6), "{name}");

        // Back to the beginning, by itself and from a snapshot.
        assert_eq!(taken(&engine, &mut rolled, 0, Extent::Whole).parts, seventh, "{name}");
        let mut resumed = play_timed(&engine, 1, "fps = 30, pre_roll = 0.2334", &keys);
        engine.recall(&mut resumed, &first).expect("it is of the same scene");
        assert!(engine.pre_roll(&mut resumed, 6, 4), "{name}: it is behind already");
        assert_eq!(taken(&engine, &mut resumed, 6, Extent::Whole).parts, thirteenth, "{name}");
    }
}

#[test]
fn snapshots_of_something_else_are_refused() {
    let engine = engine();
    let [(_, forces), (_, vortex), _] = scenes();
    let mut other = play_smoke(&engine, 1, 30.0, &vortex);
    let snapshot = taken(&engine, &mut other, 3, Extent::Whole);
    let mut player = play_smoke(&engine, 1, 30.0, &forces);
    assert!(matches!(engine.recall(&mut player, &snapshot), Err(Error::Snapshot { frame: 3 })));
}

#[test]
fn fingerprints_tell_what_moves_differently() {
    let engine = engine();
    let fingerprint = |seed, fps, keys: &str| play_smoke(&engine, seed, fps, keys).fingerprint();
    let [(_, keys), (_, other), _] = scenes();
    let first = fingerprint(1, 30.0, &keys);
    assert_eq!(
        first,
        fingerprint(1, 30.0, &format!("opacity = 0.5\nvisible = false\n{keys}")),
        "looks do not count"
    );
    for changed in [
        fingerprint(2, 30.0, &keys),
        fingerprint(1, 25.0, &keys),
        fingerprint(1, 30.0, &other),
        play_timed(&engine, 1, "fps = 30, pre_roll = 0.5", &keys).fingerprint(),
        fingerprint(1, 30.0, &keys.replace("rate = 60", "rate = 61")),
    ] {
        assert_ne!(first, changed);
    }
}
