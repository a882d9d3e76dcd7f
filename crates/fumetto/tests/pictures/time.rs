//! Drawing on twos, and stillness.

use std::fmt::Write as _;

use crate::stage::{Files, Stage, engine, picture_at};

fn smoke(time: &str) -> Stage {
    let mut stage = Stage { time: time.into(), ..Stage::default() };
    write!(
        stage.objects,
        "[[object]]\nname = \"smoke\"\nkind = \"smoke\"\n[object.emitter]\n\
         shape = {{ sphere = {{ center = [0, -2, 0], radius = 0.5 }} }}\nrate = 20\nlife = 4\nradius = 0.6\n\
         velocity = [0, 2, 0]\nspread = 20\n"
    )
    .unwrap();
    stage
}

#[test]
fn on_twos_every_drawing_is_held_for_two_frames() {
    let mut engine = engine();
    let mut player = smoke("frames = [0, 50], hold = 2").play(&engine, Files::default()).unwrap();
    let [a, b, c] = [24, 25, 26].map(|frame| picture_at(&mut engine, &mut player, frame).unwrap());
    assert!(a == b, "frame 25 shows what 24 does");
    assert!(a != c, "frame 26 does not");
}

#[test]
fn the_simulation_goes_on_while_a_drawing_is_held() {
    let mut engine = engine();
    let mut held = smoke("frames = [0, 50], hold = 3").play(&engine, Files::default()).unwrap();
    let mut ones = smoke("frames = [0, 50]").play(&engine, Files::default()).unwrap();
    let held = picture_at(&mut engine, &mut held, 26).unwrap();
    assert!(held == picture_at(&mut engine, &mut ones, 24).unwrap());
}

#[test]
fn a_frame_looks_the_same_whichever_way_it_is_reached() {
    let mut engine = engine();
    let mut player = smoke("frames = [0, 50]").play(&engine, Files::default()).unwrap();
    let first = picture_at(&mut engine, &mut player, 20).unwrap();
    picture_at(&mut engine, &mut player, 40).unwrap();
    assert!(first == picture_at(&mut engine, &mut player, 20).unwrap());
}
