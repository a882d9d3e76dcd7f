//! Strokes that shade, against theory.

use std::collections::BTreeSet;

use crate::{
    models::{ball, square},
    shadings::{shaded, stage},
    stage::{BACKGROUND, DISTANCE, Files, PX_PER_METRE, Picture, Rgb, SIDE, Stage, style},
};

const PAPER: Rgb = [0xf4, 0xf0, 0xe4];
pub(crate) const INK: Rgb = [0x20, 0x18, 0x30];
const RADIUS: f32 = 4.0;
pub(crate) const FROM_CAMERA: [f32; 3] = [0.0, 0.0, -1.0];

/// Paper, and ink hatched with `keys`.
pub(crate) fn paper(keys: &str) -> String {
    hatched_over("tones = [\"#f4f0e4\"]", keys)
}

fn hatched_over(tones: &str, keys: &str) -> String {
    shaded(tones, &format!("hatching = {{ colour = \"#201830\", {keys} }}"))
}

/// Strokes that begin where light begins to lack, whole and straight.
pub(crate) const PLAIN: &str =
    "width = { px = 4 }, spacing = { px = 8 }, from = 1, gaps = 0, wobble = { px = 0 }";

/// A square that fills the picture, of which every place gets `light`.
pub(crate) fn sheet(style: String, light: f32) -> Stage {
    let stage = stage(style, FROM_CAMERA).mesh("sheet", "sheet.obj", "");
    Stage { light: format!("kind = \"sun\", direction = [0, 0, -1], intensity = {light}"), ..stage }
}

pub(crate) fn files() -> Files {
    Files::default().with("sheet.obj", square(6.0)).with("ball.obj", ball(RADIUS, 96))
}

fn share(picture: &Picture) -> f32 {
    picture.count(INK) as f32 / (SIDE * SIDE) as f32
}

#[test]
fn strokes_cover_as_much_as_light_lacks() {
    let cases = [("swell = 1, layers = 1", 1), ("swell = 1, layers = 2", 2), ("swell = 0, layers = 1", 1)];
    let more = [("swell = 0.4, layers = 3, cross = 45, length = { px = 40 }", 3), ("length = { px = 0 }", 2)];
    for (keys, layers) in cases.into_iter().chain(more) {
        let most = 1.0 - 0.5_f32.powi(layers);
        let mut before = -1.0;
        for light in [1.0, 0.85, 0.7, 0.5, 0.3, 0.15, 0.0] {
            let picture = sheet(paper(&format!("{PLAIN}, {keys}")), light).picture_with(files());
            assert!(picture.colours().is_subset(&BTreeSet::from([PAPER, INK])), "{keys}");
            let (covered, expected) = (share(&picture), most * (1.0 - light));
            assert!((covered - expected).abs() < 0.05, "{keys} at {light}: {covered}, should be {expected}");
            assert!(covered > before, "{keys} at {light}: {covered} after {before}");
            before = covered;
        }
    }
}

#[test]
fn a_ball_gets_darker_as_it_turns_away() {
    let keys = format!("{PLAIN}, layers = 2, smooth = {{ px = 4 }}");
    let picture = stage(paper(&keys), FROM_CAMERA).mesh("ball", "ball.obj", "").picture_with(files());
    // The cosine to the light, where a pixel's ray meets the ball.
    let light_at = |x: u32, y: u32| {
        let aside = |px: u32| (px as f32 + 0.5 - 0.5 * SIDE as f32) / PX_PER_METRE / DISTANCE;
        let tangent = aside(x).hypot(aside(y));
        let (along, square) = (DISTANCE, 1.0 + tangent * tangent);
        let root = (along * along - square * (DISTANCE * DISTANCE - RADIUS * RADIUS)).sqrt();
        (DISTANCE - (along - root) / square) / RADIUS
    };
    let mut before = 0.0;
    for bin in (5..9).rev().map(|tenths| tenths as f32 / 10.0) {
        let places = picture.places().filter(|&(x, y)| (bin..bin + 0.1).contains(&light_at(x, y)));
        let (mut inked, mut all) = (0.0, 0.0);
        for (x, y) in places {
            inked += if picture.rgb(x, y) == INK { 1.0 } else { 0.0 };
            all += 1.0;
        }
        let (covered, expected) = (inked / all, 0.75 * (0.95 - bin));
        assert!((covered - expected).abs() < 0.06, "{covered} at {bin}, should be {expected}");
        assert!(covered > before, "{covered} at {bin} after {before}");
        before = covered;
    }
}

#[test]
fn darker_tones_hold_the_strokes_of_lighter_ones() {
    for keys in [
        "swell = 1",
        "swell = 0, gaps = 0.2, wobble = { px = 2 }",
        "swell = 0.5, layers = 4, tooth = 1",
        "swell = 0, levels = 4, length = { px = 30 }",
    ] {
        let mut lighter: Option<Picture> = None;
        for light in [0.8, 0.6, 0.45, 0.2, 0.0] {
            let picture = sheet(paper(keys), light).picture_with(files());
            if let Some(lighter) = lighter {
                let lost = |&(x, y): &(u32, u32)| lighter.rgb(x, y) == INK && picture.rgb(x, y) != INK;
                assert_eq!(picture.places().filter(lost).count(), 0, "{keys} at {light}");
            }
            lighter = Some(picture);
        }
    }
}

/// Lengths from stroke to stroke on a column through a sheet that is seen from `distance`.
fn spacings(distance: f32, keys: &str) -> Vec<f32> {
    let flat = "angle = 0, tilt = 0, layers = 1, gaps = 0, wobble = { px = 0 }";
    let stage = sheet(paper(&format!("{flat}, {keys}")), 0.1);
    let camera = format!("eye = [0, 0, {distance}], target = [0, 0, 0], fov = 53.130102");
    let files = Files::default().with("sheet.obj", square(100.0));
    let picture = Stage { camera, ..stage }.picture_with(files);
    let inked = |y: u32| picture.rgb(SIDE / 2, y) == INK;
    let begins: Vec<u32> = (1..SIDE).filter(|&y| inked(y) && !inked(y - 1)).collect();
    begins.windows(2).map(|pair| (pair[1] - pair[0]) as f32).collect()
}

#[test]
fn strokes_keep_their_spacing_as_the_camera_moves_away() {
    for step in 0..=16 {
        let distance = 4.0 * 2.0_f32.powf(0.25 * step as f32);
        let keys = "width = { px = 3 }, spacing = { px = 8 }, swell = 1, length = { px = 2000 }";
        let spacings = spacings(distance, keys);
        let mean = spacings.iter().sum::<f32>() / spacings.len() as f32;
        assert!((6.5..10.0).contains(&mean), "{mean} px at {distance} m");
        assert!(spacings.iter().all(|px| (4.0..=17.0).contains(px)), "{spacings:?} at {distance} m");
    }
}

#[test]
fn strokes_spaced_in_metres_draw_together_with_distance() {
    let keys = "width = { world = 0.1 }, spacing = { world = 0.25 }, swell = 1";
    for distance in [4.0, 8.0, 16.0] {
        let expected = 0.25 * SIDE as f32 / distance;
        let spacings = spacings(distance, keys);
        assert!(
            !spacings.is_empty() && spacings.iter().all(|px| (px - expected).abs() <= 1.0),
            "{spacings:?}"
        );
    }
}

#[test]
fn all_shapes_are_hatched_on_their_dark_side() {
    let style = || paper("from = 0.5, smooth = { px = 6 }");
    let lit = || stage(style(), [-1.0, 0.0, 0.0]);
    let at = [[0.0, 0.0, 0.0, 5.0]];
    let smooth = "extinction = 8, cells = 64, relief = 1, noise = { amplitude = 0 }";
    let pictures = [
        ("puffs", lit().balls("a", &at, "")),
        ("surface", lit().surface("a", &at, "threshold = 0.4, subdivisions = 48", "")),
        ("volume", lit().volume("a", &at, smooth, "")),
        ("mesh", lit().mesh("a", "ball.obj", "")),
    ];
    for (name, stage) in pictures {
        let picture = stage.picture_with(files());
        assert_eq!(picture.colours(), BTreeSet::from([BACKGROUND, PAPER, INK]), "{name}");
        let share = |dark: bool| {
            // Light comes from the right.
            let places = || {
                picture.places().filter(|&(x, y)| (x < SIDE / 2) == dark && picture.rgb(x, y) != BACKGROUND)
            };
            let inked = places().filter(|&(x, y)| picture.rgb(x, y) == INK).count();
            inked as f32 / places().count() as f32
        };
        assert!(share(true) > 0.3, "{name}: {} of the dark side is inked", share(true));
        assert!(share(false) < 0.5 * share(true) + 0.1, "{name}: {} of the lit one", share(false));
    }
}

#[test]
fn strokes_lie_over_all_tones() {
    let tones = "tones = [{ colour = \"#303040\", from = 0 }, { colour = \"#f0e0d0\", from = 0.5 }]";
    let picture = stage(hatched_over(tones, "from = 0.9"), [-1.0, 0.0, -1.0]).mesh("ball", "ball.obj", "");
    let expected = BTreeSet::from([BACKGROUND, INK, [0x30, 0x30, 0x40], [0xf0, 0xe0, 0xd0]]);
    assert_eq!(picture.picture_with(files()).colours(), expected);
}

#[test]
fn samples_hold_more_of_the_same_strokes() {
    let covered = |antialias: u32| {
        let mut stage = sheet(
            paper("width = { px = 2 }, spacing = { px = 8 }, swell = 0, gaps = 0, wobble = { px = 0 }"),
            0.4,
        );
        stage.output = format!("size = [{SIDE}, {SIDE}], antialias = {antialias}");
        let picture = stage.picture_with(files());
        let lights: f32 = picture.places().map(|(x, y)| linear(picture.rgb(x, y)[0])).sum();
        (linear(PAPER[0]) - lights / (SIDE * SIDE) as f32) / (linear(PAPER[0]) - linear(INK[0]))
    };
    let all = [1, 2, 3, 4].map(covered);
    assert!(all.iter().all(|share| (share - all[3]).abs() < 0.02), "{all:?}");
}

fn linear(byte: u8) -> f32 {
    fumetto_scene::Colour::from_srgb8([byte; 3]).linear[0]
}

#[test]
fn strokes_of_a_see_through_cel_are_as_clear_as_it_is() {
    let stage = stage(paper(PLAIN), FROM_CAMERA);
    let stage = Stage { light: "kind = \"sun\", direction = [0, 0, -1], intensity = 0.5".into(), ..stage };
    let picture = stage.mesh("sheet", "sheet.obj", "opacity = 0.5").picture_with(files());
    let half = |colour: Rgb| {
        let mixed = |channel: usize| 0.5 * (linear(colour[channel]) + linear(BACKGROUND[channel]));
        fumetto_scene::Colour { linear: [mixed(0), mixed(1), mixed(2)] }.to_srgb8()
    };
    let near = |a: Rgb, b: Rgb| a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 2);
    let colours = picture.colours();
    assert_eq!(colours.len(), 2, "{colours:?}");
    assert!(
        colours.iter().all(|&colour| near(colour, half(INK)) || near(colour, half(PAPER))),
        "{colours:?}"
    );
}

#[test]
fn sprites_are_not_copied_where_puffs_are_hatched() {
    let picture = |shading: &str| {
        let style =
            style(&["#f4f0e4"], &format!("shading = \"{shading}\", hatching = {{ colour = \"#201830\" }}"));
        stage(style, [1.0, 0.0, 0.0]).balls("ball", &[[0.0, 0.0, 0.0, 5.0]], "").picture()
    };
    assert!(picture("auto") == picture("per-pixel") && picture("auto").count(INK) > 1000);
}
