//! Ways that strokes run, and what they stay with.

use std::{collections::BTreeSet, fmt::Write as _};

use crate::{
    hatching::{FROM_CAMERA, INK, PLAIN, files, paper, sheet},
    shadings::stage,
    stage::{BACKGROUND, Files, PX_PER_METRE, Picture, SIDE, Stage, engine, picture_at},
};

/// A sheet that has moved by 64 pixels to the right, and as it was.
fn moved(follow: &str) -> [Picture; 2] {
    [0.0, 64.0 / PX_PER_METRE].map(|x| {
        let keys = format!("{PLAIN}, follow = \"{follow}\", angle = 60, smooth = {{ px = 0 }}");
        let stage = stage(paper(&keys), FROM_CAMERA);
        let stage =
            Stage { light: "kind = \"sun\", direction = [0, 0, -1], intensity = 0.4".into(), ..stage };
        stage
            .mesh("sheet", "sheet.obj", &format!("transform = {{ position = [{x}, 0, 0] }}"))
            .picture_with(files())
    })
}

/// Share of the pixels that differ between one picture and the other, `right` pixels aside.
fn different([before, after]: &[Picture; 2], right: u32) -> f32 {
    let places: Vec<_> = before.places().filter(|&(x, _)| (80..SIDE - 80).contains(&x)).collect();
    let differs = |&&(x, y): &&(u32, u32)| before.rgb(x, y) != after.rgb(x + right, y);
    places.iter().filter(differs).count() as f32 / places.len() as f32
}

#[test]
fn strokes_stay_with_what_they_follow() {
    let object = moved("object");
    assert!(different(&object, 64) < 0.01 && different(&object, 0) > 0.1, "they move with the sheet");
    for follow in ["form", "screen"] {
        let stays = moved(follow);
        assert!(different(&stays, 0) < 0.01 && different(&stays, 64) > 0.1, "{follow} stays");
    }
}

#[test]
fn strokes_on_a_puff_move_with_it() {
    // Of the middle column, how much differs when the puff has risen by 16 pixels.
    let changed = |follow: &str| {
        let keys =
            format!("{PLAIN}, follow = \"{follow}\", layers = 1, angle = 0, tilt = 0, smooth = {{ px = 0 }}");
        let column = |y: f32| {
            // From so far away that all of the ball is seen at one scale.
            let camera = "eye = [0, 0, 100], target = [0, 0, 0], fov = 5.7248".into();
            let stage = Stage { camera, ..stage(paper(&keys), [1.0, 0.0, 0.0]) };
            let picture = stage.balls("ball", &[[0.0, y, 0.0, 3.0]], "").picture();
            (0..SIDE).map(|y| picture.rgb(SIDE / 2, y) == INK).collect::<Vec<_>>()
        };
        let (still, risen) = (column(0.0), column(16.0 / PX_PER_METRE));
        assert!(still.iter().filter(|&&inked| inked).count() > 40);
        still[16..].iter().zip(&risen).filter(|(a, b)| a != b).count()
    };
    let (object, form) = (changed("object"), changed("form"));
    assert!(object < 24 && form > 3 * object, "{object} and {form}");
}

#[test]
fn strokes_run_as_they_are_told() {
    // Of neighbours along a direction, those that differ: few along the strokes, many across.
    let changes = |keys: &str, light: &str| {
        let stage = sheet(paper(&format!("{PLAIN}, layers = 1, tilt = 0, {keys}")), 0.4);
        let picture = Stage { light: light.into(), ..stage }.picture_with(files());
        let count = |dx: u32, dy: u32| {
            let differs = |&(x, y): &(u32, u32)| picture.rgb(x, y) != picture.rgb(x + dx, y + dy);
            picture.places().filter(|&(x, y)| x + dx < SIDE && y + dy < SIDE).filter(differs).count()
        };
        (count(1, 0), count(0, 1))
    };
    let dim = "kind = \"sun\", direction = [0, 0, -1], intensity = 0.4";
    for follow in ["form", "screen"] {
        let (across, down) = changes(&format!("angle = 0, follow = \"{follow}\""), dim);
        assert!(down > 10 * across, "level: {across} and {down}");
        let (across, down) = changes(&format!("angle = 90, follow = \"{follow}\""), dim);
        assert!(across > 10 * down, "upright: {across} and {down}");
    }
    let from_right = "kind = \"sun\", direction = [-1, 0, -0.3]";
    let (across, down) = changes("along = \"shade\"", from_right);
    assert!(across > 10 * down, "the border of shade is upright: {across} and {down}");
    let (across, down) = changes("along = \"light\"", from_right);
    assert!(down > 10 * across, "light comes from the right: {across} and {down}");
}

/// A pipe along y that is open at both ends.
fn pipe(radius: f32, half: f32, sides: u32) -> String {
    let mut obj = String::new();
    for side in 0..sides {
        let (z, x) = (std::f32::consts::TAU * side as f32 / sides as f32).sin_cos();
        for y in [-half, half] {
            writeln!(obj, "v {} {y} {}\nvn {x} 0 {z}", radius * x, radius * z).unwrap();
        }
    }
    for side in 0..sides {
        let [a, b] = [2 * side + 1, 2 * side + 2];
        let [c, d] = [a, b].map(|corner| (corner + 1) % (2 * sides) + 1);
        writeln!(obj, "f {a}//{a} {b}//{b} {d}//{d} {c}//{c}").unwrap();
    }
    obj
}

#[test]
fn strokes_run_round_what_bends_one_way() {
    for (rotation, angle) in [(0, 90), (90, 0)] {
        let keys =
            format!("{PLAIN}, layers = 1, along = \"curvature\", angle = {angle}, length = {{ px = 0 }}");
        let stage = stage(paper(&keys), FROM_CAMERA);
        let stage =
            Stage { light: "kind = \"sun\", direction = [0, 0, -1], intensity = 0.4".into(), ..stage };
        let transform = format!("transform = {{ rotation = [0, 0, {rotation}] }}");
        let files = Files::default().with("pipe.obj", pipe(3.0, 8.0, 96));
        let picture = stage.mesh("pipe", "pipe.obj", &transform).picture_with(files);
        let within = || (SIDE / 2 - 80)..(SIDE / 2 + 80);
        let changes = |dx: u32, dy: u32| {
            let places = within().flat_map(|y| within().map(move |x| (x, y)));
            places.filter(|&(x, y)| picture.rgb(x, y) != picture.rgb(x + dx, y + dy)).count()
        };
        let (round, along) = if rotation == 0 { ((1, 0), (0, 1)) } else { ((0, 1), (1, 0)) };
        let (round, along) = (changes(round.0, round.1), changes(along.0, along.1));
        assert!(along > 4 * round, "{rotation} degrees: {round} round it, {along} along it");
    }
}

#[test]
fn the_same_seed_gives_the_same_strokes() {
    let picture = |seed: u32| {
        let mut stage = sheet(paper("wobble = { px = 2 }"), 0.4);
        write!(stage.background, "\nseed = {seed}").unwrap();
        stage.picture_with(files())
    };
    assert!(picture(3) == picture(3));
    assert!(picture(3) != picture(4));
}

#[test]
fn a_paused_camera_sees_still_strokes_and_a_hidden_object_has_none() {
    let stage = sheet(paper("tooth = 0.5"), 0.4);
    let mut engine = engine();
    let mut player = stage.play(&engine, files()).unwrap();
    let first = picture_at(&mut engine, &mut player, 0).unwrap();
    assert!(picture_at(&mut engine, &mut player, 10).unwrap() == first);
    drop(engine);
    let hidden = Stage { objects: stage.objects.clone() + "visible = false\n", ..stage };
    assert_eq!(hidden.picture_with(files()).colours(), BTreeSet::from([BACKGROUND]));
}
