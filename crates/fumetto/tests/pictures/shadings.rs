//! Every way to shade, against theory.

use std::collections::BTreeSet;

use fumetto_formats::Image;

use crate::{
    models::{ball, square},
    stage::{BACKGROUND, DISTANCE, Files, Picture, Rgb, SIDE, Stage, style},
};

const DARK: Rgb = [0x30, 0x30, 0x40];
const LIGHT: Rgb = [0xf0, 0xe0, 0xd0];
const MARK: Rgb = [0xff, 0x41, 0x7b];
const RADIUS: f32 = 4.0;

/// A style with `tones = […]` or what takes its place, and `more`.
pub(crate) fn shaded(by: &str, more: &str) -> String {
    style(&[], more).replace("tones = []", by)
}

const TWO_TONES: &str = "tones = [{ colour = \"#303040\", from = 0 }, { colour = \"#f0e0d0\", from = 0.5 }]";

pub(crate) fn stage(style: String, direction: [f32; 3]) -> Stage {
    Stage { light: format!("kind = \"sun\", direction = {direction:?}"), style, ..Stage::default() }
}

/// A ball of 4 m, lit along `direction`.
pub(crate) fn lit_ball(style: String, direction: [f32; 3]) -> Picture {
    let files = Files::default().with("ball.obj", ball(RADIUS, 64)).with("ramp.png", rows());
    stage(style, direction).mesh("ball", "ball.obj", "").picture_with(files)
}

pub(crate) const FROM_CAMERA: [f32; 3] = [0.0, 0.0, -1.0];

/// Where on the ball something is: `angle` from the axis to the eye.
#[derive(Clone, Copy)]
pub(crate) struct Spot {
    pub(crate) angle: f32,
}

impl Spot {
    /// The outermost that is seen.
    fn horizon() -> Self {
        Self { angle: (RADIUS / DISTANCE).acos() }
    }

    /// Cosine and sine between the normal and the direction to the eye.
    pub(crate) fn facing(self) -> [f32; 2] {
        let (sin, cos) = self.angle.sin_cos();
        let eye = [-RADIUS * sin, DISTANCE - RADIUS * cos];
        let length = eye[0].hypot(eye[1]);
        [(eye[0] * sin + eye[1] * cos) / length, (eye[1] * sin - eye[0] * cos) / length]
    }

    /// Cosine between the normal and the middle between the eye and a sun behind the camera.
    fn halfway(self) -> f32 {
        // The light is as far from the normal as the spot from the axis; the eye lies beyond the light.
        let to_eye = self.facing()[0].acos();
        (0.5 * (self.angle + to_eye)).cos()
    }

    /// Share of the ball's picture that lies nearer the middle.
    pub(crate) fn share(self) -> f32 {
        let edge = |spot: Self| {
            let (sin, cos) = spot.angle.sin_cos();
            RADIUS * sin / (DISTANCE - RADIUS * cos)
        };
        (edge(self) / edge(Self::horizon())).powi(2)
    }

    /// Where `falling` comes down to `value`.
    pub(crate) fn where_is(value: f32, falling: impl Fn(Self) -> f32) -> Self {
        let (mut near, mut far) = (0.0, Self::horizon().angle);
        for _ in 0..40 {
            let middle = 0.5 * (near + far);
            if falling(Self { angle: middle }) > value { near = middle } else { far = middle }
        }
        Self { angle: near }
    }
}

#[track_caller]
pub(crate) fn assert_share(picture: &Picture, colour: Rgb, expected: f32) {
    let share = picture.count(colour) as f32 / picture.drawn() as f32;
    assert!((share - expected).abs() < 0.006, "{share} of the ball is {colour:02x?}, should be {expected}");
}

fn png(width: u32, colours: &[Rgb]) -> Vec<u8> {
    let pixels = colours.iter().flat_map(|&[r, g, b]| [r, g, b, 255]).collect();
    let image = Image { width, height: colours.len() as u32 / width, pixels };
    let mut bytes = Vec::new();
    fumetto_formats::write_png(&image, &mut bytes).unwrap();
    bytes
}

/// Four rows: dark on the left, light on the right.
pub(crate) const ROWS: [[Rgb; 2]; 4] = [
    [[0x10, 0x11, 0x12], [0xf0, 0xf1, 0xf2]],
    [[0x20, 0x21, 0x22], [0xe0, 0xe1, 0xe2]],
    [[0x30, 0x31, 0x32], [0xd0, 0xd1, 0xd2]],
    [[0x40, 0x41, 0x42], [0xc0, 0xc1, 0xc2]],
];

pub(crate) fn rows() -> Vec<u8> {
    png(2, &ROWS.concat())
}

#[test]
fn one_tone_is_solid() {
    assert_eq!(
        lit_ball(style(&["#c8d4e0"], ""), FROM_CAMERA).colours(),
        BTreeSet::from([BACKGROUND, [0xc8, 0xd4, 0xe0]])
    );
}

#[test]
fn steps_share_the_light_and_mix_in_linear_light() {
    let picture =
        lit_ball(shaded("tones = { dark = \"#000000\", light = \"#f0e0d0\", steps = 8 }", ""), FROM_CAMERA);
    // Black is of n·l < 1/8, which lies beyond the horizon.
    let lit: BTreeSet<_> = picture.colours().into_iter().filter(|&colour| colour != BACKGROUND).collect();
    assert!((4..=7).contains(&lit.len()), "{lit:?}");
    let cosine = |spot: Spot| spot.angle.cos();
    assert_share(&picture, LIGHT, Spot::where_is(7.0 / 8.0, cosine).share());
    let linear = |byte: u8| fumetto_scene::Colour::from_srgb8([byte; 3]).linear[0];
    let mixed = fumetto_scene::Colour { linear: LIGHT.map(|byte| linear(byte) * 5.0 / 7.0) }.to_srgb8();
    let expected = Spot::where_is(5.0 / 8.0, cosine).share() - Spot::where_is(6.0 / 8.0, cosine).share();
    assert_share(&picture, mixed, expected);
}

#[test]
fn a_highlight_covers_what_blinn_and_phong_say() {
    for (from, gloss) in [(0.9, 40.0), (0.5, 40.0), (0.5, 8.0_f32)] {
        let more = format!("highlight = {{ colour = \"#ff417b\", from = {from}, gloss = {gloss} }}");
        let picture = lit_ball(shaded(TWO_TONES, &more), FROM_CAMERA);
        let spot = Spot::where_is(from, |spot| spot.halfway().powf(gloss));
        assert_share(&picture, MARK, spot.share());
        assert_eq!(picture.colours(), BTreeSet::from([BACKGROUND, DARK, LIGHT, MARK]));
    }
}

#[test]
fn there_is_no_highlight_in_shadow_or_from_behind() {
    let marked = |shadow: bool, direction| {
        let more = format!(
            "highlight = {{ colour = \"#ff417b\", from = 0.5 }}, shadow = {{ on = {shadow}, reach = 9, start = 1, size = 1 }}"
        );
        let files = Files::default().with("ball.obj", ball(2.0, 48));
        let stage = stage(shaded(TWO_TONES, &more), direction).mesh("ball", "ball.obj", "");
        // Above the picture, but over the whole ball.
        stage.balls("cover", &[[0.0, 12.0, 0.0, 5.0]], "").picture_with(files).count(MARK)
    };
    assert!(marked(false, [0.0, -1.0, 0.0]) > 100);
    assert_eq!(marked(true, [0.0, -1.0, 0.0]), 0, "the cover keeps the light away");
    assert_eq!(marked(false, [0.0, 0.0, 1.0]), 0, "the light comes from behind");
}

#[test]
fn a_rim_covers_what_turns_away() {
    for width in [0.3, 0.6_f32] {
        let rim = format!("rim = {{ colour = \"#ff417b\", width = {width}, from = 0 }}");
        let picture = lit_ball(shaded(TWO_TONES, &rim), FROM_CAMERA);
        let inside = Spot::where_is(width, |spot| spot.facing()[0]).share();
        assert_share(&picture, MARK, 1.0 - inside);
        assert!(picture.colours().is_subset(&BTreeSet::from([BACKGROUND, DARK, LIGHT, MARK])));
    }
}

#[test]
fn a_rim_lies_on_the_lit_side_unless_it_may_lie_anywhere() {
    let marked = |from: f32| {
        let rim = format!("rim = {{ colour = \"#ff417b\", width = 0.5, from = {from} }}");
        let picture = lit_ball(shaded(TWO_TONES, &rim), [-1.0, 0.0, 0.0]);
        let left = picture.places().filter(|&(x, y)| x < SIDE / 2 && picture.rgb(x, y) == MARK).count();
        (left, picture.count(MARK) - left)
    };
    let (left, right) = marked(0.2);
    assert!(left == 0 && right > 1000, "{left} on the dark side, {right} on the lit one");
    let (left, right) = marked(0.0);
    assert!(left.abs_diff(right) < 20, "{left} and {right}");
}

#[test]
fn gooch_runs_from_cool_to_warm() {
    let gooch =
        |shares: &str| shaded(&format!("gooch = {{ cool = \"#203a80\", warm = \"#e0c060\", {shares} }}"), "");
    let middle = |style: String, direction| lit_ball(style, direction).rgb(SIDE / 2, SIDE / 2);
    assert_eq!(middle(gooch("alpha = 0, beta = 0"), FROM_CAMERA), [0xe0, 0xc0, 0x60], "faces the light");
    assert_eq!(middle(gooch("alpha = 0, beta = 0"), [0.0, 0.0, 1.0]), [0x20, 0x3a, 0x80], "faces away");
    assert_eq!(middle(gooch("alpha = 0, beta = 0"), [0.0, -1.0, 0.0]), [0x80, 0x7d, 0x70], "half way");
    let painted = gooch("alpha = 0.25, beta = 0.5, colour = \"#804000\"");
    assert_eq!(middle(painted.clone(), [0.0, 0.0, 1.0]), [0x40, 0x4a, 0x80], "a quarter of the paint");
    assert_eq!(middle(painted, FROM_CAMERA), [0xff, 0xe0, 0x60], "half of it, but no more than there is");
}

#[test]
fn gooch_paints_with_a_meshs_own_colour() {
    let obj = format!("mtllib paint.mtl\nusemtl red\n{}", square(1.0));
    let files = Files::default().with("square.obj", obj).with("paint.mtl", "newmtl red\nKd 1 0 0\n");
    let style = shaded("gooch = { cool = \"#000000\", warm = \"#000000\", beta = 0.6 }", "");
    let picture = stage(style, FROM_CAMERA).mesh("square", "square.obj", "").picture_with(files);
    assert_eq!(picture.rgb(SIDE / 2, SIDE / 2), [0x99, 0, 0]);
}

#[test]
fn material_steps_bring_colours_together() {
    let painted = |kd: &str, steps: u32| {
        let obj = format!("mtllib paint.mtl\nusemtl paint\n{}", square(1.0));
        let files =
            Files::default().with("square.obj", obj).with("paint.mtl", format!("newmtl paint\nKd {kd}\n"));
        let style = style(&["#ffffff"], &format!("material_steps = {steps}"));
        stage(style, FROM_CAMERA).mesh("square", "square.obj", "").picture_with(files).rgb(SIDE / 2, SIDE / 2)
    };
    assert_ne!(painted("0.30 0.1 0.05", 0), painted("0.34 0.11 0.05", 0));
    let [red, green, blue] = painted("0.30 0.1 0.05", 4);
    assert_eq!(painted("0.34 0.11 0.05", 4), [red, green, blue]);
    assert!(red > green && green > blue, "the hue stays: {:?}", [red, green, blue]);
    assert_eq!(painted("1 1 1", 3), [255; 3]);
    assert_eq!(painted("0.6 0.6 0.6", 2), [128; 3]);
}

#[test]
fn puffs_take_highlights_and_rims() {
    let more = "highlight = { colour = \"#ff417b\", gloss = 20 }, rim = { colour = \"#4080ff\", from = 0 }";
    let picture =
        stage(shaded(TWO_TONES, more), [0.5, -0.5, -1.0]).balls("ball", &[[0.0, 0.0, 0.0, 5.0]], "");
    let picture = picture.picture();
    assert_eq!(picture.colours(), BTreeSet::from([BACKGROUND, DARK, LIGHT, MARK, [0x40, 0x80, 0xff]]));
    assert!(picture.count(MARK) > 100 && picture.count([0x40, 0x80, 0xff]) > 1000);
}

#[test]
fn what_sprites_cannot_show_is_shaded_by_pixel() {
    let picture = |shading: &str| {
        let more = format!("highlight = {{ colour = \"#ff417b\" }}, shading = \"{shading}\"");
        stage(shaded(TWO_TONES, &more), FROM_CAMERA).balls("ball", &[[0.0, 0.0, 0.0, 5.0]], "").picture()
    };
    let by_pixel = picture("per-pixel");
    assert!(by_pixel.count(MARK) > 100);
    assert!(picture("auto") == by_pixel && picture("pre-shaded") == by_pixel);
}

#[test]
fn a_mesh_is_never_taken_for_sprites() {
    let files = || Files::default().with("ball.obj", ball(RADIUS, 64));
    let picture = |shading: &str| {
        let style = shaded(TWO_TONES, &format!("shading = \"{shading}\""));
        stage(style, FROM_CAMERA).mesh("ball", "ball.obj", "").picture_with(files())
    };
    assert!(picture("pre-shaded") == picture("per-pixel"));
}
