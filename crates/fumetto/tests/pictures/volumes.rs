//! Volumes among other things, and in a style.

use std::collections::BTreeSet;

use crate::stage::{BACKGROUND, DISTANCE, Files, Picture, Rgb, Stage, style};

/// Sides of the picture.
const SIDE: u32 = 128;

const MIDDLE: u32 = SIDE / 2;

const PX_PER_METRE: f32 = SIDE as f32 / DISTANCE;

/// A white wall that faces the camera at z = 0, larger than the picture.
const WALL: &str = "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n";

fn stage() -> Stage {
    Stage { output: format!("size = [{SIDE}, {SIDE}], antialias = 1"), ..Stage::default() }
}

/// Dark matter of extinction 0.5 in a ball, soft.
fn dark(particles: &[[f32; 4]]) -> Stage {
    stage().volume("dark", particles, "soft = 1, extinction = 0.5, colours = [[0, 0, 0]], cells = 96", "")
}

fn files() -> Files {
    Files::default().with("wall.obj", WALL)
}

/// Share of white that is left at the middle.
fn left(picture: &Picture) -> f32 {
    let srgb = f32::from(picture.rgb(MIDDLE, MIDDLE)[0]) / 255.0;
    if srgb <= 0.04045 { srgb / 12.92 } else { ((srgb + 0.055) / 1.055).powf(2.4) }
}

fn assert_close(actual: f32, expected: f32) {
    assert!((actual - expected).abs() < 0.02, "{actual}, should be {expected}");
}

#[test]
fn rays_end_at_what_is_solid() {
    let wall = |z: f32| {
        let place = format!("transform = {{ position = [0, 0, {z}] }}");
        dark(&[[0.0, 0.0, 0.0, 2.0]]).mesh("wall", "wall.obj", &place).picture_with(files())
    };
    assert_close(left(&wall(3.0)), 1.0);
    assert_close(left(&wall(1.0)), (-0.5_f32).exp());
    assert_close(left(&wall(0.0)), (-1.0_f32).exp());
    assert_close(left(&wall(-3.0)), (-2.0_f32).exp());
}

#[test]
fn squares_of_pixels_end_where_what_is_solid_does() {
    let post = "v -1 -9 0\nv 1 -9 0\nv 1 9 0\nv -1 9 0\nf 1 2 3 4\n";
    let seen = |pixels: u32| {
        let shape = format!("soft = 1, extinction = 2, colours = [[0, 0, 0]], cells = 96, pixels = {pixels}");
        let stage = stage().volume("dark", &[[0.0, 0.0, -3.0, 2.0]], &shape, "");
        stage.mesh("post", "post.obj", "").picture_with(Files::default().with("post.obj", post))
    };
    let [each, squares] = [1, 4].map(seen);
    let edge = MIDDLE + PX_PER_METRE as u32;
    for x in edge - 4..edge + 4 {
        let [one, other] = [&each, &squares].map(|picture| picture.rgb(x, MIDDLE)[0]);
        assert!(one.abs_diff(other) < 16, "{one} and {other} at {x}, where the post ends at {edge}");
    }
}

#[test]
fn puffs_hide_what_lies_behind_them() {
    let picture = dark(&[[0.0, 0.0, -4.0, 2.0]]).balls("ball", &[[0.0, 0.0, 0.0, 2.0]], "").picture();
    assert_eq!(picture.rgb(MIDDLE, MIDDLE), [0xff; 3]);
}

#[test]
fn the_camera_may_stand_inside() {
    let stage = dark(&[[0.0, 0.0, DISTANCE, 2.0]]).mesh("wall", "wall.obj", "");
    assert_close(left(&stage.picture_with(files())), (-1.0_f32).exp());
}

#[test]
fn nothing_but_matter_is_left_where_nothing_lies_behind() {
    let mut stage = dark(&[[0.0, 0.0, 0.0, 2.0]]);
    stage.background = String::new();
    let alpha = f32::from(stage.picture().rgba(MIDDLE, MIDDLE)[3]) / 255.0;
    assert_close(alpha, 1.0 - (-2.0_f32).exp());
    assert_eq!(stage.picture().rgba(0, 0), [0; 4]);
}

const TONES: [Rgb; 3] = [[0x30, 0x30, 0x40], [0x90, 0x90, 0xa0], [0xf0, 0xe0, 0xd0]];
const INK: Rgb = [0x10, 0x20, 0x30];

/// Lumps in three tones, lit from above.
fn drawn(volume: &str, more: &str) -> Picture {
    let light = "kind = \"sun\", direction = [0.3, -1, -0.4]".into();
    let style = style(&["#303040", "#9090a0", "#f0e0d0"], more);
    let noise = "noise = { amplitude = 0.4, frequency = 2 }";
    let puffs = [[-1.0, 0.0, 0.0, 1.2], [1.0, 0.2, 0.0, 1.4]];
    let shape = format!("extinction = 3, cells = 64, {noise}, {volume}");
    Stage { light, style, ..stage() }.volume("cloud", &puffs, &shape, "").picture()
}

#[test]
fn a_drawn_volume_has_no_colours_but_those_of_its_style() {
    let picture = drawn("soft = 0", "shadow = { on = true }");
    let expected: BTreeSet<Rgb> = TONES.into_iter().chain([BACKGROUND]).collect();
    assert_eq!(picture.colours(), expected, "all three tones and what lies behind");
    let inked = drawn("soft = 0", "shadow = { on = true }, ink = { on = true, colour = \"#102030\" }");
    assert_eq!(inked.colours(), expected.into_iter().chain([INK]).collect());
    assert!(inked.count(INK) > 100, "there is a contour all round");
}

#[test]
fn soft_volumes_have_shades_in_between() {
    let count = |volume: &str| drawn(volume, "shadow = { on = true }").colours().len();
    assert!(count("soft = 1") > 50);
    assert!(count("soft = 0.5") > 50);
}

#[test]
fn light_dies_on_its_way_through() {
    let picture = drawn("soft = 1", "shadow = { on = true }");
    let [above, below] = [-1.0, 1.0].map(|metres: f32| {
        let y = MIDDLE as f32 + metres * PX_PER_METRE;
        u32::from(picture.rgb((MIDDLE as f32 - PX_PER_METRE) as u32, y as u32)[0])
    });
    assert!(above > below + 50, "{above} toward the light, {below} away from it");
}

#[test]
fn the_drawn_surface_lies_where_the_opacity_says() {
    // A ray down the middle of a ball is opaque to a half after ln 2 / extinction metres.
    let shape = |surface: f32| format!("extinction = 0.5, cells = 96, surface = {surface}");
    let hidden = |surface: f32, z: f32| {
        let stage = Stage { style: style(&["#f0e0d0"], ""), ..stage() };
        let stage = stage.volume("fog", &[[0.0, 0.0, 0.0, 2.0]], &shape(surface), "");
        let wall = format!("transform = {{ position = [0, 0, {z}] }}\nstyle = {{ tones = [\"#000000\"] }}");
        stage.mesh("wall", "wall.obj", &wall).picture_with(files()).rgb(MIDDLE, MIDDLE) != [0; 3]
    };
    let deep = |opacity: f32| 2.0 + (1.0 - opacity).ln() / 0.5;
    for surface in [0.3, 0.5, 0.8_f32] {
        assert!(hidden(surface, deep(surface) - 0.06), "{surface}");
        assert!(!hidden(surface, deep(surface) + 0.06), "{surface}");
    }
}

/// A ball of 1 m that a slanting sun throws onto the middle of a wall.
fn ball_before_a_wall(volume: &str, ball: &str, wall: &str) -> Picture {
    let light = "kind = \"sun\", direction = [1, 0, -1]".into();
    let style = style(&["#000000", "#ffffff"], "shadow = { on = true }");
    let shape = format!("soft = 1, extinction = 1, cells = 96, light_cells = 96, {volume}");
    let stage = Stage { light, style, ..stage() }.volume("ball", &[[-3.0, 0.0, 3.0, 1.0]], &shape, ball);
    stage.mesh("wall", "wall.obj", wall).picture_with(files())
}

#[test]
fn a_volume_throws_a_shadow_where_it_is_opaque_enough() {
    let lit = |picture: &Picture, metres: f32| {
        picture.rgb(MIDDLE, (MIDDLE as f32 + metres * PX_PER_METRE) as u32) == [0xff; 3]
    };
    for opacity in [0.3, 0.6_f32] {
        // A ray that passes the middle at r goes through 2 sqrt(1 - r²) of matter.
        let edge = (1.0 - (0.5 * (1.0 - opacity).ln()).powi(2)).sqrt();
        let picture = ball_before_a_wall(&format!("shadow = {opacity}"), "", "");
        for side in [-1.0, 1.0] {
            assert!(!lit(&picture, side * (edge - 0.15)), "within {edge} m at {opacity}");
            assert!(lit(&picture, side * (edge + 0.15)), "beyond {edge} m at {opacity}");
        }
    }
    for (volume, ball, wall) in [
        ("shadow = 0", "", ""),
        ("shadow = 0.95", "", ""),
        ("shadow = 0.5", "style.shadow.on = false", ""),
        ("shadow = 0.5", "", "style.shadow.receive = false"),
    ] {
        assert!(lit(&ball_before_a_wall(volume, ball, wall), 0.0), "{volume} {ball} {wall}");
    }
}
