//! Where shadows fall on a wall, against a wall that is lit by arithmetic.

use glam::Vec3;

use crate::{
    balls::{self, EYE},
    stage::{CORE, Picture, Rgb, Stage, style},
};

const SHADOW: Rgb = [0x40, 0x40, 0x60];
const LIT: Rgb = [0xf0, 0xf0, 0xe0];

/// A ball that nearly fills the picture, and one that leaves nothing of the background.
const WALL: [f32; 4] = [0.0, 0.0, -4.0, 9.0];
const WIDE_WALL: [f32; 4] = [0.0, 0.0, -30.0, 50.0];

/// `wall` behind `caster`, which is drawn in a colour of its own. All of the wall that a sun in
/// `direction` meets is lit.
fn picture(wall: [f32; 4], direction: Vec3, caster: [f32; 4], shadow: &str) -> Picture {
    let stage = Stage {
        light: format!("kind = \"sun\", direction = {:?}", direction.to_array()),
        style: style(&[], "").replace(
            "tones = []",
            "tones = [{ colour = \"#404060\", from = 0 }, { colour = \"#f0f0e0\", from = 0.02 }]",
        ),
        ..Stage::default()
    };
    let caster_style = format!("style = {{ tones = [\"#ff0000\"], shadow = {{ {shadow} }} }}");
    stage.balls("wall", &[wall], "").balls("caster", &[caster], &caster_style).picture()
}

/// Whether the sun is kept from what a pixel shows of the wall; `None` where it shows something else.
fn expected(
    (x, y): (u32, u32),
    wall: [f32; 4],
    direction: Vec3,
    caster: [f32; 4],
    [reach, start, size]: [f32; 3],
) -> Option<bool> {
    let ray = balls::ray(x, y);
    let depth = balls::distance(ray, wall)?;
    if balls::distance(ray, caster).is_some_and(|nearer| nearer > 0.0 && nearer < depth) {
        return None;
    }
    let place = EYE + ray * depth;
    let [cx, cy, cz, radius] = caster;
    let behind = place - Vec3::new(cx, cy, cz);
    let along = behind.dot(direction);
    let ball = CORE * radius * size;
    // The volume is as thick as the ball is high there, and begins so many heights behind the middle.
    let aside = (behind - along * direction).length();
    let height = (ball * ball - aside * aside).max(0.0).sqrt();
    Some(aside < ball && along > start * height && along < reach * radius)
}

/// Compares the shadow with the one expected: its area within a tenth, and nearly every pixel.
#[track_caller]
fn assert_shadow(wall: [f32; 4], direction: Vec3, caster: [f32; 4]) {
    let direction = direction.normalize_or_zero();
    let shadow = "on = true, reach = 20, start = 0.5, size = 0.8";
    let with = picture(wall, direction, caster, shadow);
    let without = picture(wall, direction, caster, "on = false");
    let (mut area, mut area_expected, mut wrong) = (0_u32, 0_u32, 0_u32);
    for (x, y) in with.places() {
        // Only the lit side of the wall can tell.
        if without.rgb(x, y) != LIT {
            continue;
        }
        if let Some(dark) = expected((x, y), wall, direction, caster, [20.0, 0.5, 0.8]) {
            let is_dark = with.rgb(x, y) == SHADOW;
            area += u32::from(is_dark);
            area_expected += u32::from(dark);
            wrong += u32::from(is_dark != dark);
        }
    }
    assert!(area_expected > 500, "there is a shadow to see: {area_expected}");
    let ratio = f64::from(area) / f64::from(area_expected);
    assert!((ratio - 1.0).abs() < 0.1, "{area} pixels are dark, should be {area_expected}");
    assert!(f64::from(wrong) < 0.1 * f64::from(area_expected), "{wrong} of {area_expected} pixels are wrong");
}

#[test]
fn a_ball_throws_its_shadow_where_geometry_says() {
    assert_shadow(WALL, Vec3::new(0.5, -0.4, -1.0), [-1.0, 0.8, 3.5, 1.0]);
    assert_shadow(WALL, Vec3::new(-1.0, 0.2, -0.6), [2.5, 0.0, 2.5, 0.8]);
}

#[test]
fn shadows_on_a_wall_that_hides_everything_are_found() {
    for z in [8.0, 5.0, 3.0] {
        assert_shadow(WIDE_WALL, Vec3::new(0.3, -0.2, -1.0), [-1.0, 0.5, z, 0.8]);
    }
    assert_shadow(WIDE_WALL, Vec3::new(0.6, 0.2, -0.8), [-2.0, -0.5, 4.0, 0.8]);
}

#[test]
fn a_shadow_ends_where_it_reaches_no_farther() {
    let direction = Vec3::new(0.5, -0.4, -1.0).normalize_or_zero();
    let caster = [-1.0, 0.8, 3.5, 1.0];
    let with = picture(WALL, direction, caster, "on = true, reach = 1");
    let without = picture(WALL, direction, caster, "on = false");
    assert_eq!(with.count(SHADOW), without.count(SHADOW));
}

#[test]
fn without_shadows_all_that_faces_the_sun_is_lit() {
    let picture = picture(WALL, Vec3::new(0.0, 0.0, -1.0), [0.0, 0.0, 3.5, 1.0], "on = false");
    let covered = picture.count(LIT) as f64 / picture.drawn() as f64;
    assert!(covered > 0.8, "{covered} of the wall and the caster");
    // The wall's own rim faces the sun by less than the light tone asks for.
    assert!(picture.count(SHADOW) * 100 < picture.drawn());
}

#[test]
fn a_camera_inside_a_shadow_sees_the_same_shadow() {
    // The caster is behind the camera, and its shadow runs past the camera to the wall.
    assert_shadow(WALL, Vec3::new(0.0, 0.0, -1.0), [0.0, 0.0, 14.0, 3.0]);
    assert_shadow(WALL, Vec3::new(0.0, 0.0, -1.0), [0.6, 0.3, 14.0, 3.0]);
    assert_shadow(WALL, Vec3::new(-0.1, 0.05, -1.0), [0.9, -0.2, 13.0, 3.5]);
}

#[test]
fn a_camera_at_the_edge_of_a_shadow_sees_the_same_shadow() {
    let edge = CORE * 3.0 * 0.8;
    for aside in [0.9, 0.99, 1.01, 1.1] {
        assert_shadow(WALL, Vec3::new(0.0, 0.0, -1.0), [aside * edge, 0.0, 14.0, 3.0]);
    }
}

#[test]
fn a_light_that_throws_no_shadow_throws_none() {
    let scene = |shadow: &str| {
        let stage = Stage {
            light: format!("kind = \"sun\", direction = [0.5, -0.4, -1], shadow = {shadow}"),
            style: style(&["#404060", "#f0f0e0"], "shadow = { on = true, reach = 20 }"),
            ..Stage::default()
        };
        stage.balls("wall", &[WALL, [-1.0, 0.8, 3.5, 1.0]], "").picture()
    };
    let (with, without) = (scene("true"), scene("false"));
    assert!(with.count(SHADOW) > without.count(SHADOW) + 500);
}

#[test]
fn overlapping_shadows_stay_dark() {
    let direction = Vec3::new(0.5, -0.4, -1.0);
    let one = [-1.0, 0.8, 3.5, 1.0];
    let stage = |casters: &[[f32; 4]]| {
        let stage = Stage {
            light: format!("kind = \"sun\", direction = {:?}", direction.to_array()),
            style: style(&["#404060", "#f0f0e0"], ""),
            ..Stage::default()
        };
        let style = "style = { tones = [\"#ff0000\"], shadow = { on = true, reach = 20 } }";
        stage.balls("wall", &[WALL], "").balls("casters", casters, style).picture()
    };
    // A count of eight bits that wrapped would be back at zero.
    let (single, many) = (stage(&[one]), stage(&[one; 256]));
    let apart = single.places().filter(|&(x, y)| single.rgb(x, y) != many.rgb(x, y)).count();
    assert!(apart * 50 < single.count(SHADOW), "{apart} pixels differ");
}
