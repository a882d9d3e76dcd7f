//! What is half transparent or eaten away.

use std::fmt::Write as _;

use crate::stage::{BACKGROUND, Picture, Rgb, Stage, style};

/// sRGB's transfer functions, in double precision.
fn decoded(byte: u8) -> f64 {
    let encoded = f64::from(byte) / 255.0;
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

fn encoded(light: f64) -> f64 {
    255.0 * if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

/// `over` with `opacity` on `under`, mixed in linear light.
fn mixed(over: Rgb, under: Rgb, opacity: f64) -> [f64; 3] {
    [0, 1, 2]
        .map(|channel| encoded(opacity * decoded(over[channel]) + (1.0 - opacity) * decoded(under[channel])))
}

#[track_caller]
fn assert_about(actual: Rgb, expected: [f64; 3]) {
    let apart =
        (0..3).map(|channel| (f64::from(actual[channel]) - expected[channel]).abs()).fold(0.0, f64::max);
    assert!(apart <= 1.5, "{actual:?} should be {expected:?}");
}

const TONE: Rgb = [0xe0, 0x50, 0x20];
const BALLS: [[f32; 4]; 3] = [[-1.0, 0.0, 0.0, 3.0], [1.0, 0.5, 0.5, 3.0], [0.0, -1.0, -1.0, 3.0]];

fn half_transparent(antialias: u32) -> Picture {
    let stage = Stage {
        style: style(&["#e05020"], ""),
        output: format!("size = [512, 512], antialias = {antialias}"),
        ..Stage::default()
    };
    stage.balls("glass", &BALLS, "opacity = 0.5").picture()
}

#[test]
fn a_transparent_cel_mixes_with_the_background_in_linear_light() {
    for antialias in [1, 3] {
        assert_about(half_transparent(antialias).rgb(256, 256), mixed(TONE, BACKGROUND, 0.5));
    }
}

#[test]
fn no_inner_faces_show_in_a_transparent_cel() {
    let colours = half_transparent(1).colours();
    assert_eq!(colours.len(), 2, "the cel and the background: {colours:?}");
}

#[test]
fn a_transparent_cel_shows_the_opaque_ones_behind_it_and_hides_behind_those_before() {
    let stage = Stage { style: style(&["#e05020"], ""), ..Stage::default() };
    let blue = "style = { tones = [\"#2040c0\"] }";
    let picture = stage
        .balls("glass", &[[0.0, 0.0, 0.0, 4.0]], "opacity = 0.5")
        .balls("behind", &[[-1.0, 0.0, -4.0, 1.5]], blue)
        .balls("before", &[[1.0, 0.0, 4.0, 0.7]], blue)
        .picture();
    let blue = [0x20, 0x40, 0xc0];
    // The one behind is 14 m away: -1 m is 36 pixels to the left; the one before 6 m: 1 m is 85.
    assert_about(picture.rgb(256 - 36, 256), mixed(TONE, blue, 0.5));
    assert_eq!(picture.rgb(256 + 85, 256), blue);
}

#[test]
fn the_nearer_of_two_transparent_cels_lies_on_top() {
    let stage = Stage::default();
    let glass = |tone: &str| format!("opacity = 0.5\nstyle = {{ tones = [\"{tone}\"] }}");
    let picture = stage
        .balls("near", &[[0.0, 0.0, 2.0, 2.0]], &glass("#ff0000"))
        .balls("far", &[[0.0, 0.0, -2.0, 4.0]], &glass("#0000ff"))
        .picture();
    let far = mixed([0, 0, 255], BACKGROUND, 0.5).map(|channel| channel.round() as u8);
    assert_about(picture.rgb(256, 256), mixed([255, 0, 0], far, 0.5));
}

/// A single puff of smoke at frame 1, with `more` keys of its emitter.
fn puff(background: &str, shape: &str, more: &str) -> Picture {
    puff_on(Stage { background: background.into(), ..Stage::default() }, shape, more)
}

fn puff_on(mut stage: Stage, shape: &str, more: &str) -> Picture {
    write!(
        stage.objects,
        "[[object]]\nname = \"puff\"\nkind = \"smoke\"\nshape = {{ puffs = {{ {shape} }} }}\n[object.emitter]\n\
         shape = {{ point = {{ center = [0, 0, 0] }} }}\nbursts = [{{ at = 0, count = 1 }}]\nlife = 10\n\
         radius = 3\n{more}\n"
    )
    .unwrap();
    let mut engine = crate::stage::engine();
    let mut player = stage.play(&engine, crate::stage::Files::default()).unwrap();
    crate::stage::picture_at(&mut engine, &mut player, 1).unwrap()
}

#[test]
fn erosion_eats_a_puff_away_to_nothing() {
    for shape in ["spheres = 1, variants = 1", "spheres = 24, variants = 1"] {
        let covered = [0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.0].map(|erosion| {
            puff(&Stage::default().background, shape, &format!("erosion_over_life = {erosion}")).drawn()
        });
        assert!(covered[0] > 20_000, "{covered:?}");
        assert!(covered.is_sorted_by(|more, fewer| more > fewer || *more == 0), "{covered:?} with {shape}");
        assert_eq!(covered[7], 0);
    }
}

#[test]
fn opacity_over_life_becomes_alpha() {
    for (opacity, alpha) in [(1.0, 255), (0.6, 153), (0.2, 51), (0.0, 0)] {
        let picture = puff("", "spheres = 1, variants = 1", &format!("opacity_over_life = {opacity}"));
        let middle = picture.rgba(256, 256);
        assert!(middle[3].abs_diff(alpha) <= 1, "{middle:?} should have alpha {alpha}");
        assert_eq!(picture.rgba(2, 2)[3], 0);
    }
}

#[test]
fn ink_fades_with_the_puff_that_it_runs_round() {
    let ink = "ink = { colour = \"#000000\", width = { px = 8 }, lit_thinning = 0, shortest = 0 }";
    let stage = Stage { background: String::new(), style: style(&["#ffffff"], ink), ..Stage::default() };
    let picture = puff_on(stage, "spheres = 1, variants = 1", "opacity_over_life = 0.6");
    let alphas: Vec<u8> = picture
        .places()
        .map(|(x, y)| picture.rgba(x, y))
        .filter(|&[r, _, _, alpha]| r == 0 && alpha > 0)
        .map(|[_, _, _, alpha]| alpha)
        .collect();
    assert!(alphas.len() > 1_000, "there is a line: {} pixels", alphas.len());
    assert!(alphas.iter().all(|alpha| alpha.abs_diff(153) <= 1), "{:?}", alphas.iter().max());
}
