//! How much of a ball is lit, and how much of the picture it covers.

use std::f32::consts::PI;

use crate::stage::{BACKGROUND, CORE, PX_PER_METRE, Picture, Rgb, Stage, style};

const RADIUS: f32 = 4.5;
const DARK: Rgb = [0x30, 0x30, 0x40];
const LIGHT: Rgb = [0xf0, 0xe0, 0xd0];

/// `DARK`, and `LIGHT` from `threshold` upward.
fn two_tones(threshold: f32) -> String {
    let light = format!("{{ colour = \"#f0e0d0\", from = {threshold} }}");
    format!("tones = [{{ colour = \"#303040\", from = 0 }}, {light}]")
}

/// One ball in two tones, the light one from `threshold` upward.
fn ball(direction: [f32; 3], threshold: f32, more: &str) -> Picture {
    let style = style(&[], more).replace("tones = []", &two_tones(threshold));
    let stage =
        Stage { light: format!("kind = \"sun\", direction = {direction:?}"), style, ..Stage::default() };
    stage.balls("ball", &[[0.0, 0.0, 0.0, RADIUS]], "").picture()
}

fn lit_share(direction: [f32; 3], threshold: f32, more: &str) -> f32 {
    let picture = ball(direction, threshold, more);
    picture.count(LIGHT) as f32 / (picture.count(LIGHT) + picture.count(DARK)) as f32
}

#[track_caller]
fn assert_share(actual: f32, expected: f32) {
    assert!((actual - expected).abs() < 0.01, "{actual} is lit, should be {expected}");
}

#[test]
fn a_ball_covers_the_area_of_its_disc() {
    let covered = ball([0.0, 0.0, -1.0], 0.5, "").drawn() as f32;
    let area = PI * (CORE * RADIUS * PX_PER_METRE).powi(2);
    assert!((covered / area - 1.0).abs() < 0.01, "{covered} pixels, should be {area}");
}

#[test]
fn light_from_the_camera_lights_a_disc() {
    for threshold in [0.2, 0.5, 0.8, 0.95_f32] {
        // n·l is the height over the disc: above T within a radius of √(1 - T²).
        let expected = 1.0 - threshold * threshold;
        assert_share(lit_share([0.0, 0.0, -1.0], threshold, ""), expected);
    }
}

#[test]
fn light_from_the_side_lights_a_segment() {
    for direction in [[-1.0, 0.0, 0.0], [0.0, -2.0, 0.0]] {
        for threshold in [0.1, 0.4, 0.7_f32] {
            // n·l is the distance from the diameter.
            let expected = (threshold.acos() - threshold * (1.0 - threshold * threshold).sqrt()) / PI;
            assert_share(lit_share(direction, threshold, ""), expected);
        }
    }
}

#[test]
fn light_from_a_corner_lights_a_foreshortened_cap() {
    // The cap within acos T of the light, all of it before the horizon, seen at 36.87 degrees.
    for threshold in [0.7, 0.85, 0.95_f32] {
        let expected = (1.0 - threshold * threshold) * 0.8;
        assert_share(lit_share([0.6, 0.0, -0.8], threshold, ""), expected);
    }
}

#[test]
fn light_from_behind_lights_nothing() {
    assert_share(lit_share([0.0, 0.0, 1.0], 0.05, ""), 0.0);
}

#[test]
fn wrap_moves_the_terminator() {
    // (n·l + w) / (1 + w) > 1/2 where n·l > (1 - w) / 2.
    for (wrap, threshold) in [(1.0, 0.0), (0.5, 0.25_f32)] {
        let expected = (threshold.acos() - threshold * (1.0 - threshold * threshold).sqrt()) / PI;
        assert_share(lit_share([-1.0, 0.0, 0.0], 0.5, &format!("wrap = {wrap}")), expected);
    }
}

#[test]
fn two_lights_add_up() {
    let stage = Stage {
        light: "kind = \"sun\", direction = [0, 0, -1], intensity = 0.25 }, \
                { kind = \"sun\", direction = [0, 0, -1], intensity = 0.5"
            .into(),
        style: style(&[], "").replace("tones = []", &two_tones(0.6)),
        ..Stage::default()
    };
    let picture = stage.balls("ball", &[[0.0, 0.0, 0.0, RADIUS]], "").picture();
    let share = picture.count(LIGHT) as f32 / picture.drawn() as f32;
    // 3/4 n·l > 0.6 where n·l > 0.8.
    assert_share(share, 1.0 - 0.64);
}

#[test]
fn pre_shaded_puffs_look_much_like_those_shaded_by_pixel() {
    let by_pixel = lit_share([-1.0, 0.0, -1.0], 0.5, "");
    let pre_shaded = lit_share([-1.0, 0.0, -1.0], 0.5, "shading = \"pre-shaded\"");
    assert!((by_pixel - pre_shaded).abs() < 0.05, "{pre_shaded} is lit, by pixel {by_pixel}");
}

#[test]
fn light_falls_where_the_sun_comes_from() {
    let picture = ball([-1.0, -1.0, -1.0], 0.5, "");
    let (middle, off) = (256, 80);
    assert_eq!(picture.rgb(middle + off, middle - off), LIGHT, "up and to the right is toward the sun");
    assert_eq!(picture.rgb(middle - off, middle + off), DARK);
    assert_eq!(picture.rgb(2, 2), BACKGROUND);
}
