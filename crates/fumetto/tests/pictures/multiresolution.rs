//! Surfaces whose cells are lengths on the picture.

use fumetto::{Engine, Player, Shot};

use crate::stage::{BACKGROUND, Files, Picture, SIDE, Stage, engine};

/// Lobes that hide each other, with noise on them.
const LOBES: [[f32; 4]; 5] = [
    [0.0, 0.0, 2.0, 2.0],
    [1.4, 0.6, 0.0, 2.2],
    [-1.6, 0.4, -1.0, 2.0],
    [0.2, -1.2, 0.5, 1.6],
    [0.3, 1.6, -2.0, 2.4],
];

fn cloud(shape: &str) -> Stage {
    let shape = format!("{shape}, noise = {{ amplitude = 1, size = 0.9 }}");
    Stage::default().surface("cloud", &LOBES, &shape, "")
}

fn shot_from(player: &Player, z: f32) -> Shot {
    let mut shot = Shot::of(player.scene());
    shot.camera.eye[2] = z;
    shot
}

fn picture_from(engine: &mut Engine, player: &Player, z: f32) -> Picture {
    Picture(engine.picture(player, &shot_from(player, z)).unwrap())
}

/// Pixels that one shows and the other does not.
fn changed(a: &Picture, b: &Picture) -> usize {
    a.places().filter(|&(x, y)| (a.rgb(x, y) == BACKGROUND) != (b.rgb(x, y) == BACKGROUND)).count()
}

/// Pixels within two of the mask's border.
fn border(mask: &Picture) -> usize {
    let inside = |x: u32, y: u32| mask.rgb(x, y) != BACKGROUND;
    let is_near = |&(x, y): &(u32, u32)| {
        let around = || (y - 2..=y + 2).flat_map(|y| (x - 2..=x + 2).map(move |x| (x, y)));
        around().any(|(x, y)| inside(x, y)) && !around().all(|(x, y)| inside(x, y))
    };
    mask.places().filter(|&(x, y)| x.min(y) > 1 && x.max(y) < SIDE - 2).filter(is_near).count()
}

/// Seen from so far along z.
fn drawn(engine: &mut Engine, stage: &Stage, z: f32) -> Picture {
    let mut player = stage.play(engine, Files::default()).unwrap();
    engine.seek(&mut player, 0).unwrap();
    picture_from(engine, &player, z)
}

#[test]
fn a_step_of_cells_is_less_to_see_than_the_move_that_brings_it() {
    let mut engine = engine();
    for (px, most) in [(4.0, 0.01), (6.0, 0.015)] {
        for z in [10.0, 14.0] {
            let mut drawn = |px: f32, z: f32| drawn(&mut engine, &cloud(&format!("pixels = {px}")), z);
            let [fine, coarse, moved] = [drawn(px, z), drawn(1.19 * px, z), drawn(px, 0.999 * z)];
            let [step, a_little] = [changed(&fine, &coarse), changed(&fine, &moved)];
            let share = step as f32 / border(&fine) as f32;
            eprintln!(
                "{px} px from {z} m: a step changes {step} pixels, {share} of the border; a move {a_little}"
            );
            assert!(step > 0 && share < most, "{share} of the border");
            // A step comes with a sixth of the distance: 160 of such moves.
            assert!(step < a_little, "{step} pixels change with a step, {a_little} with a move");
        }
    }
}

#[test]
fn the_same_camera_sees_the_same_however_it_came_there() {
    let mut engine = engine();
    let stage = cloud("pixels = 6");
    let mut player = stage.play(&engine, Files::default()).unwrap();
    engine.seek(&mut player, 0).unwrap();
    let first = picture_from(&mut engine, &player, 12.0);
    assert!(first == picture_from(&mut engine, &player, 12.0));
    assert!(first != picture_from(&mut engine, &player, 6.0));
    assert!(first == picture_from(&mut engine, &player, 12.0));
    assert!(first == drawn(&mut engine, &stage, 12.0));
}

#[test]
fn an_export_is_what_the_first_camera_sees_whatever_was_drawn() {
    let mut engine = engine();
    let solid = |engine: &Engine, player: &Player| engine.solid(player, 0).unwrap().unwrap().solid;
    let stage = cloud("pixels = 8");
    let mut player = stage.play(&engine, Files::default()).unwrap();
    engine.seek(&mut player, 0).unwrap();
    let exported = solid(&engine, &player);
    picture_from(&mut engine, &player, 5.0);
    assert!(exported == solid(&engine, &player));
    // Cells are as large on a print as on its preview.
    let print = Stage { output: format!("size = [{}, {}], antialias = 1", 3 * SIDE, 2 * SIDE), ..stage };
    let mut printed = print.play(&engine, Files::default()).unwrap();
    engine.seek(&mut printed, 0).unwrap();
    assert!(exported == solid(&engine, &printed));
    let farther = Stage { camera: "eye = [0, 0, 16], target = [0, 0, 0], fov = 53.130102".into(), ..print };
    let mut farther = farther.play(&engine, Files::default()).unwrap();
    engine.seek(&mut farther, 0).unwrap();
    let times = solid(&engine, &farther).positions.len() as f32 / exported.positions.len() as f32;
    // Twice as far from what is nearest, at z = 4.
    assert!((0.2..0.3).contains(&times), "{times} times the vertices");
}

#[test]
fn smoke_is_seen_anew_by_every_camera() {
    let objects = "[[object]]\nname = \"plume\"\nkind = \"smoke\"\nshape = { surface = { pixels = 12 } }\n\
         emitter = { shape = { disc = { center = [0, -3, 0], radius = 0.4 } }, rate = 40, velocity = [0, 3, 0], \
         spread = 20, life = [0.6, 1], radius = [0.4, 0.8] }\n";
    let stage = Stage { objects: objects.into(), ..Stage::default() };
    let mut engine = engine();
    let mut player = stage.play(&engine, Files::default()).unwrap();
    engine.seek(&mut player, 20).unwrap();
    let [far, near] = [20.0, 6.0].map(|z| picture_from(&mut engine, &player, z));
    let first = engine.surfaces(&player).unwrap()[0];
    assert!(far.drawn() > 100 && near.drawn() > 5 * far.drawn());
    engine.seek(&mut player, 21).unwrap();
    assert!(near != picture_from(&mut engine, &player, 6.0), "it has moved");
    engine.seek(&mut player, 20).unwrap();
    assert!(near == picture_from(&mut engine, &player, 6.0));
    assert_eq!(first, engine.surfaces(&player).unwrap()[0]);
}
