//! Surfaces that change in time, and room for what they become.

use crate::{
    stage::{BACKGROUND, Files, Picture, Stage, engine, picture_at},
    surfaces::MIDDLE,
};

/// A plume whose skin is made anew for each frame.
fn plume() -> Stage {
    let objects = "[[object]]\nname = \"plume\"\nkind = \"smoke\"\n\
         shape = { surface = { subdivisions = 24, noise = { amplitude = 2, size = 0.5 } } }\n\
         emitter = { shape = { disc = { center = [0, -3, 0], radius = 0.4 } }, rate = 40, velocity = [0, 3, 0], \
         spread = 20, life = [0.6, 1], radius = [0.4, 0.8], erosion_over_life = [[0.5, 0], [1, 1]] }\n";
    Stage { time: "fps = 24, frames = [0, 40]".into(), objects: objects.into(), ..Stage::default() }
}

#[test]
fn smoke_has_the_same_skin_however_a_frame_is_reached() {
    let mut engine = engine();
    let mut player = plume().play(&engine, Files::default()).unwrap();
    let directly = picture_at(&mut engine, &mut player, 20).unwrap();
    let later = picture_at(&mut engine, &mut player, 33).unwrap();
    let back = picture_at(&mut engine, &mut player, 20).unwrap();
    let mut again = plume().play(&engine, Files::default()).unwrap();
    picture_at(&mut engine, &mut again, 7).unwrap();
    assert!(directly.drawn() > 1000 && directly != later);
    assert!(directly == back && directly == picture_at(&mut engine, &mut again, 20).unwrap());
}

#[test]
fn a_sequence_of_files_gets_room_as_it_grows() {
    let csv = |count: usize| {
        let lines: String = (0..count).map(|i| format!("{},0,0,1\n", i as f32 - 1.0)).collect();
        format!("x,y,z,radius\n{lines}")
    };
    let files = Files::default().with("p.0000.csv", csv(1)).with("p.0001.csv", csv(3));
    let objects = "[[object]]\nname = \"cloud\"\nkind = \"cloud\"\nparticles = \"p.####.csv\"\n\
         shape = { surface = {} }\n";
    let stage = Stage { objects: objects.into(), ..Stage::default() };
    let mut engine = engine();
    let mut player = stage.play(&engine, files).unwrap();
    let one = picture_at(&mut engine, &mut player, 0).unwrap();
    let three = picture_at(&mut engine, &mut player, 1).unwrap();
    assert!(three.drawn() > 3 * one.drawn() / 2, "{} and {} pixels", one.drawn(), three.drawn());
    assert!(one == picture_at(&mut engine, &mut player, 0).unwrap());
}

#[test]
fn what_the_device_cannot_hold_is_refused_by_name() {
    let engine = engine();
    let stage = Stage::default().surface("huge", &[[0.0, 0.0, 0.0, 1.0]], "subdivisions = 512", "");
    let message = stage.play(&engine, Files::default()).err().unwrap().to_string();
    assert!(message.contains("`huge`") && message.contains("vertices"), "{message}");
}

/// A ball at the left that becomes two at the right, from second 1 to second 2 at 10 frames a second.
fn split(shape: &str) -> Stage {
    let objects = format!(
        "[[object]]\nname = \"cloud\"\nkind = \"cloud\"\n{shape}\n\
         particles = [{{ center = [-2, 0, 0], radius = 1.5 }}]\n\
         [[object.morph]]\nduring = [1, 2]\n\
         particles = [{{ center = [2, 2, 0], radius = 1.5 }}, {{ center = [2, -2, 0], radius = 1.5 }}]\n"
    );
    Stage { time: "fps = 10, frames = [0, 30]".into(), objects, ..Stage::default() }
}

#[test]
fn a_cloud_becomes_another_in_its_time() {
    for shape in ["shape = { surface = {} }", "shape = { puffs = {} }"] {
        let mut engine = engine();
        let mut player = split(shape).play(&engine, Files::default()).unwrap();
        let mut at = |frame| picture_at(&mut engine, &mut player, frame).unwrap();
        let [first, begun, between, done, last] = [0, 10, 15, 20, 30].map(&mut at);
        assert!(first == begun && done == last && between != first && between != done, "{shape}");
        let right = |picture: &Picture| {
            picture.places().filter(|&(x, y)| x > MIDDLE && picture.rgb(x, y) != BACKGROUND).count()
        };
        assert_eq!(right(&first), 0);
        let share = right(&done) as f32 / first.drawn() as f32;
        assert!((1.8..2.2).contains(&share), "{shape}: two balls cover {share} times what one does");
        assert_eq!(done.drawn(), right(&done));
    }
}

#[test]
fn noise_that_drifts_carries_its_bumps_along() {
    // A wall so wide that only its bumps can move.
    let wall: Vec<_> = (0..7).map(|index| [0.0, 2.0 * index as f32 - 6.0, 0.0, 2.5]).collect();
    let still = "noise = { amplitude = 1, size = 1 }";
    let drifting = "noise = { amplitude = 1, size = 1, drift = [0, 0.5, 0] }";
    let mut engine = engine();
    let mut frames = |keys: &str| {
        let stage = Stage { time: "fps = 10, frames = [0, 30]".into(), ..Stage::default() };
        let mut player = stage.surface("wall", &wall, keys, "").play(&engine, Files::default()).unwrap();
        [0, 20].map(|frame| picture_at(&mut engine, &mut player, frame).unwrap())
    };
    let [start, later] = frames(still);
    assert!(start == later);
    let [start, later] = frames(drifting);
    assert!(start != later);
}
