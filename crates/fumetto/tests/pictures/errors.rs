//! What is refused, and with which words.

use fumetto::Error;

use crate::stage::{Files, Stage, engine, picture_at};

const BALL: [f32; 4] = [0.0, 0.0, 0.0, 3.0];

#[test]
fn a_picture_larger_than_the_device_is_refused_with_numbers() {
    let stage = Stage { output: "size = [8192, 2], antialias = 4".into(), ..Stage::default() };
    let stage = stage.balls("ball", &[BALL], "");
    let mut engine = engine();
    let mut player = stage.play(&engine, Files::default()).unwrap();
    let error = picture_at(&mut engine, &mut player, 0).unwrap_err();
    let most = engine.gpu().device.limits().max_texture_dimension_2d;
    let Error::TooLarge { width: 8192, height: 2, antialias: 4, needed: 32_768, allowed } = error else {
        panic!("{error:?}")
    };
    assert_eq!(allowed, most);
    let message = error.to_string();
    for part in ["8192 x 2", "32768", &most.to_string(), "output.antialias"] {
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn too_many_particles_are_refused_before_they_are_made() {
    let smoke = |name: &str| {
        format!(
            "[[object]]\nname = \"{name}\"\nkind = \"smoke\"\n[object.emitter]\n\
             shape = {{ point = {{ center = [0, 0, 0] }} }}\ncount = 1400000\n"
        )
    };
    let stage = Stage { objects: smoke("a") + &smoke("b"), ..Stage::default() };
    let error = stage.play(&engine(), Files::default()).err().unwrap();
    assert!(matches!(error, Error::TooMany { asked: 2_800_000, .. }), "{error:?}");
}

#[test]
fn an_atlas_too_wide_for_the_device_is_refused() {
    let mut stage = Stage::default();
    for seed in 0..4 {
        let shape = format!("variants = 16, tile = 512, seed = {seed}");
        stage = stage.cloud(&format!("cloud{seed}"), &[BALL], &shape, "");
    }
    let engine = engine();
    assert!(
        engine.gpu().device.limits().max_texture_dimension_2d < 4 * 16 * 512,
        "the device is an ordinary one"
    );
    let error = stage.play(&engine, Files::default()).err().unwrap();
    assert!(matches!(error, Error::Atlas(_)), "{error:?}");
    assert!(error.to_string().contains("64 tiles of 512 pixels"), "{error}");
}

fn file_cloud(path: &str) -> Stage {
    let object = format!(
        "[[object]]\nname = \"cloud\"\nkind = \"cloud\"\nparticles = \"{path}\"\n\
         shape = {{ puffs = {{ spheres = 1 }} }}\n"
    );
    Stage { objects: object, ..Stage::default() }
}

#[test]
fn a_missing_file_is_named() {
    let error = file_cloud("nowhere.csv").play(&engine(), Files::default()).err().unwrap();
    assert!(matches!(&error, Error::Asset { path, .. } if path == "nowhere.csv"), "{error:?}");
}

#[test]
fn a_broken_file_is_named() {
    let files = Files::default().with("broken.csv", "x,y,z\n1,2,three\n");
    let error = file_cloud("broken.csv").play(&engine(), files).err().unwrap();
    assert!(matches!(error, Error::Format(_)), "{error:?}");
    assert!(error.to_string().contains("broken.csv"), "{error}");
}

#[test]
fn a_sequence_shows_each_frame_its_own_particles() {
    const ONE: &str = "x,y,z,radius\n-2,0,0,1\n";
    const TWO: &str = "x,y,z,radius\n-2,0,0,1\n2,0,0,1\n";
    let files = Files::default().with("p.00.csv", ONE).with("p.01.csv", TWO).with("p.02.csv", ONE);
    let mut engine = engine();
    let mut player = file_cloud("p.##.csv").play(&engine, files).unwrap();
    let [one, two, again] = [0, 1, 2].map(|frame| picture_at(&mut engine, &mut player, frame).unwrap());
    assert!(one.drawn() > 1000);
    assert!(two.drawn().abs_diff(2 * one.drawn()) * 100 < one.drawn());
    assert!(again == one, "nothing is left of the longer frame");
    let error = picture_at(&mut engine, &mut player, 3).unwrap_err();
    assert!(matches!(&error, Error::Asset { path, .. } if path == "p.03.csv"), "{error:?}");
}

#[test]
fn a_scene_of_nothing_is_only_background() {
    let picture = Stage::default().picture();
    assert_eq!(picture.drawn(), 0);
    assert_eq!(picture.rgba(0, 0)[3], 255);
}
