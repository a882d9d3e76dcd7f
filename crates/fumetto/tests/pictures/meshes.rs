//! Models from files: where they are, and what they look like.

use std::f32::consts::PI;

use fumetto_formats::{Image, write_png};

use crate::{
    models::{ball, square},
    stage::{BACKGROUND, Files, PX_PER_METRE, Picture, Rgb, SIDE, Stage, style},
};

const DARK: Rgb = [0x30, 0x30, 0x40];
const LIGHT: Rgb = [0xf0, 0xe0, 0xd0];

fn two_tones(threshold: f32) -> String {
    let light = format!("{{ colour = \"#f0e0d0\", from = {threshold} }}");
    style(&[], "").replace("tones = []", &format!("tones = [{{ colour = \"#303040\", from = 0 }}, {light}]"))
}

fn lit_ball(direction: [f32; 3], threshold: f32) -> Picture {
    let light = format!("kind = \"sun\", direction = {direction:?}");
    let stage = Stage { light, style: two_tones(threshold), ..Stage::default() };
    stage.mesh("ball", "ball.obj", "").picture_with(Files::default().with("ball.obj", ball(4.0, 64)))
}

fn lit_share(direction: [f32; 3], threshold: f32) -> f32 {
    let picture = lit_ball(direction, threshold);
    picture.count(LIGHT) as f32 / (picture.count(LIGHT) + picture.count(DARK)) as f32
}

#[track_caller]
fn assert_close(actual: f32, expected: f32, tolerance: f32) {
    assert!((actual - expected).abs() < tolerance, "{actual}, should be {expected}");
}

#[test]
fn a_ball_covers_its_silhouette() {
    // Seen from 10 m a ball of 4 m shows a cone of half angle asin(0.4).
    let radius_px = PX_PER_METRE * 10.0 * 0.4_f32.asin().tan();
    let covered = lit_ball([0.0, 0.0, -1.0], 0.5).drawn() as f32;
    assert_close(covered / (PI * radius_px * radius_px), 1.0, 0.003);
}

#[test]
fn two_tones_split_a_ball_where_theory_says() {
    // From d = 10 m the normal at a ray's hit makes n·l = T on a circle round the axis, whose projected
    // radius over the silhouette's is tan of the angle between ray and axis.
    for threshold in [0.5, 0.7, 0.9_f32] {
        let (distance, radius) = (10.0, 4.0);
        let (along, across) = (radius * threshold, radius * (1.0 - threshold * threshold).sqrt());
        let edge = across / (distance - along);
        let silhouette = (radius / distance).asin().tan();
        assert_close(lit_share([0.0, 0.0, -1.0], threshold), (edge / silhouette).powi(2), 0.004);
    }
}

#[test]
fn light_from_the_side_lights_half_a_ball() {
    for direction in [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]] {
        // A ramp tells a thousandth of the light apart: half of the ball, less a sliver.
        assert_close(lit_share(direction, 0.01), 0.4936, 0.004);
    }
}

/// A white square of 2 by 2 metres.
fn one_square(more: &str, obj: &str, mtl: &str) -> Picture {
    let stage = Stage::default().mesh("square", "models/square.obj", more);
    stage.picture_with(Files::default().with("models/square.obj", obj).with("models/paint.mtl", mtl))
}

/// Left, top, right and bottom of what is drawn, from the middle of the picture, in metres.
fn bounds(picture: &Picture) -> [f32; 4] {
    let drawn = || picture.places().filter(|&(x, y)| picture.rgb(x, y) != BACKGROUND);
    let metres = |px: u32| (px as f32 - 0.5 * SIDE as f32) / PX_PER_METRE;
    [
        metres(drawn().map(|(x, _)| x).min().unwrap()),
        metres(drawn().map(|(_, y)| y).min().unwrap()),
        metres(drawn().map(|(x, _)| x + 1).max().unwrap()),
        metres(drawn().map(|(_, y)| y + 1).max().unwrap()),
    ]
}

#[test]
fn transforms_scale_then_turn_then_move() {
    let quarter = "transform = { position = [2, 1, 0], rotation = [0, 0, 90], scale = [2, 0.5, 1] }";
    let [left, top, right, bottom] = bounds(&one_square(quarter, &square(1.0), ""));
    for (edge, expected) in [(left, 1.5), (right, 2.5), (top, -3.0), (bottom, 1.0)] {
        assert_close(edge, expected, 0.03);
    }
}

#[test]
fn a_file_with_z_up_stands_up() {
    // What lies flat in the file's plane z = 0 is the ground: from in front it has no height.
    let lying = one_square("up = \"z\"", &square(1.0), "");
    assert!(lying.drawn() <= 2 * SIDE as usize, "{} pixels", lying.drawn());
    let standing = one_square("up = \"z\"\ntransform = { rotation = [90, 0, 0] }", &square(1.0), "");
    assert_close(standing.drawn() as f32, (2.0 * PX_PER_METRE).powi(2), 2.0 * PX_PER_METRE);
}

#[test]
fn every_copy_is_drawn() {
    let copies = "transform = [{ position = [-2, 0, 0] }, { position = [2, 0, 0] }, { scale = -1 }]";
    let picture = one_square(copies, &square(0.5), "");
    assert_close(picture.drawn() as f32, 3.0 * PX_PER_METRE.powi(2), 4.0 * PX_PER_METRE);
    assert_eq!(picture.count([255; 3]), picture.drawn(), "a mirrored copy is lit from its front too");
}

#[test]
fn materials_multiply_tones() {
    let obj = format!("mtllib paint.mtl\nusemtl red\n{}", square(1.0));
    let mtl = "newmtl red\nKd 1 0.25 0\n";
    // Colours of an OBJ file are sRGB.
    assert_eq!(one_square("", &obj, mtl).rgb(SIDE / 2, SIDE / 2), [255, 64, 0]);
    let plain = one_square("style = { material = 0 }", &obj, mtl);
    assert_eq!(plain.rgb(SIDE / 2, SIDE / 2), [255; 3]);
}

/// A square of 8 by 8 metres with four pixels on it, of which the last has a hole.
fn painted_square(mtl: &str) -> Picture {
    let colours = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 0]];
    let pixels = (0..64).flat_map(|at: usize| colours[2 * (at / 32) + at % 8 / 4]).collect();
    let mut png = Vec::new();
    write_png(&Image { width: 8, height: 8, pixels }, &mut png).unwrap();
    let obj = format!("mtllib paint.mtl\nusemtl paint\n{}", square(4.0));
    let files = Files::default().with("square.obj", obj).with("paint.mtl", mtl).with("paint.png", png);
    Stage::default().mesh("square", "square.obj", "").picture_with(files)
}

#[test]
fn textures_lie_as_in_their_file() {
    let picture = painted_square("newmtl paint\nmap_Kd paint.png\n");
    let (left, right) = (SIDE / 4, 3 * SIDE / 4);
    let corners =
        [(left, left), (right, left), (left, right), (right, right)].map(|(x, y)| picture.rgb(x, y));
    assert_eq!(corners, [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255; 3]]);
}

#[test]
fn textures_cut_holes() {
    let picture = painted_square("newmtl paint\nmap_Kd paint.png\nmap_d paint.png\n");
    let (left, right) = (SIDE / 4, 3 * SIDE / 4);
    assert_eq!(picture.rgb(left, right), [0, 0, 255]);
    assert_eq!(picture.rgb(right, right), BACKGROUND);
}

#[test]
fn a_single_sided_surface_is_seen_from_its_front() {
    // The file says that its square has two sides, until the key is one that nobody knows.
    let mut glb =
        include_bytes!("../../../fumetto-formats/tests/fixtures/models/trimesh-square.glb").to_vec();
    let key = b"doubleSided";
    let at = glb.windows(key.len()).position(|window| window == key).unwrap();
    glb[at..at + key.len()].copy_from_slice(b"doubleSidez");
    let drawn = |degrees: u32| {
        let turned = format!("transform = {{ rotation = [0, {degrees}, 0] }}");
        let stage = Stage::default().mesh("square", "square.glb", &turned);
        stage.picture_with(Files::default().with("square.glb", glb.clone())).drawn()
    };
    assert!((drawn(0) > 0) != (drawn(180) > 0), "{} pixels in front, {} behind", drawn(0), drawn(180));
    let obj = |degrees: u32| {
        one_square(&format!("transform = {{ rotation = [0, {degrees}, 0] }}"), &square(1.0), "")
    };
    assert_eq!(obj(0).drawn(), obj(180).drawn(), "surfaces of OBJ files have two sides");
}

#[test]
fn puffs_and_meshes_hide_each_other() {
    let stage = Stage::default()
        .balls("puff", &[[0.0, 0.0, 0.0, 3.0]], "style = { tones = [\"#ff0000\"] }")
        .mesh("square", "square.obj", "transform = { position = [2, 0, 0] }");
    let picture = stage.picture_with(Files::default().with("square.obj", square(2.0)));
    let middle = SIDE / 2;
    assert_eq!(picture.rgb(middle + 10, middle), [255, 0, 0], "the puff bulges out of the square");
    assert_eq!(picture.rgb(middle + 150, middle), [255; 3]);
}
