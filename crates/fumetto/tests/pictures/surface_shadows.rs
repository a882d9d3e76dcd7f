//! The shadows of surfaces, against those of balls: around a lone particle, a surface is one.

use std::f32::consts::PI;

use glam::{Vec2, Vec3};

use crate::{
    balls::{self, EYE},
    mesh_shadows::{LIT, RED, SHADOW, SUN, assert_dark, two_tones},
    models::square,
    stage::{Files, PX_PER_METRE, Picture, SIDE, Stage, engine, picture_at},
};

/// Radius of the surface over that of a lone particle of mass 1: equation 2 of Álvarez et al. 2007 solved for
/// the distance at which it is the threshold.
fn skin(threshold: f32) -> f32 {
    (1.0 - threshold.sqrt()).sqrt()
}

/// With cells fine enough that nobody sees them.
const FINE: &str = "threshold = 0.25, subdivisions = 128";

/// A particle whose surface has a radius of `radius`.
fn particle(middle: Vec3, radius: f32) -> [f32; 4] {
    [middle.x, middle.y, middle.z, radius / skin(0.25)]
}

fn stage(light: &str) -> Stage {
    Stage { light: light.into(), style: two_tones(), ..Stage::default() }
}

/// A wall in the plane z = 0 with a red ball before it.
fn before_wall(light: &str, middle: Vec3, radius: f32) -> Picture {
    let stage =
        stage(light).mesh("wall", "wall.obj", "").surface("ball", &[particle(middle, radius)], FINE, RED);
    stage.picture_with(Files::default().with("wall.obj", square(8.0)))
}

/// How far a ray passes a middle, and how far along that is.
fn passes(from: Vec3, along: Vec3, middle: Vec3) -> (f32, f32) {
    let along = along.normalize_or(Vec3::Z);
    let at = (middle - from).dot(along);
    (from.distance(middle - along * at), at)
}

#[test]
fn a_ball_has_the_shadow_of_a_ball() {
    let (middle, radius) = (Vec3::new(-2.5, 0.0, 2.0), 0.8);
    let toward = Vec3::new(-1.0, 0.0, 1.0);
    let picture = before_wall(SUN, middle, radius);
    // As large as the cylinder behind it, cut at 45 degrees.
    let area = PI * radius * radius * 2_f32.sqrt() * PX_PER_METRE * PX_PER_METRE;
    let dark = picture.count(SHADOW) as f32;
    assert!((dark / area - 1.0).abs() < 0.01, "{dark} pixels are dark, should be {area}");
    assert_dark(&picture, 5000, |place| passes(place.extend(0.0), toward, middle).0 < radius);
}

#[test]
fn a_lamp_throws_a_larger_one() {
    for lamp in [Vec3::new(-4.0, 1.0, 5.0), Vec3::new(-6.0, 0.0, 9.0), Vec3::new(-1.0, 3.0, 12.0)] {
        let light = format!("kind = \"point\", position = {:?}", lamp.to_array());
        let (middle, radius) = (Vec3::new(-1.5, 0.5, 2.5), 0.5);
        assert_dark(&before_wall(&light, middle, radius), 1000, |place| {
            let place = place.extend(0.0);
            passes(place, lamp - place, middle).0 < radius
        });
    }
}

#[test]
fn a_camera_inside_a_shadow_sees_the_same_shadow() {
    for [x, y] in [[0.0, 0.0], [0.9, -0.4], [1.1, 0.0]] {
        let middle = Vec3::new(x, y, 14.0);
        let picture = before_wall("kind = \"sun\", direction = [0.02, 0.01, -1]", middle, 1.0);
        assert_dark(&picture, 7000, |place| {
            passes(place.extend(0.0), Vec3::new(-0.02, -0.01, 1.0), middle).0 < 1.0
        });
    }
}

/// Whether what a pixel shows of a ball is lit, and where that is.
fn seen(picture: &Picture, (x, y): (u32, u32), middle: Vec3, radius: f32) -> Option<(bool, Vec3)> {
    let ray = balls::ray(x, y).normalize_or(Vec3::NEG_Z);
    let (past, at) = passes(EYE, ray, middle);
    let colour = picture.rgb(x, y);
    let is_ball = past < radius && (colour == SHADOW || colour == LIT);
    is_ball.then(|| (colour == LIT, EYE + ray * (at - (radius * radius - past * past).sqrt())))
}

/// Asserts that a ball is dark where another keeps the sun away, and nowhere else save on its dark side.
#[track_caller]
fn assert_shadowed(picture: &Picture, toward: Vec3, [middle, other]: [Vec3; 2], radius: f32) {
    let toward = toward.normalize_or(Vec3::Y);
    let (mut dark, mut wrong) = (0, 0);
    for at in picture.places() {
        let Some((lit, place)) = seen(picture, at, middle, radius) else { continue };
        if (place - middle).normalize_or(Vec3::Y).dot(toward) < 0.1 {
            continue;
        }
        let (past, along) = passes(place, toward, other);
        // Not where the edge runs.
        if (past - radius).abs() > 0.03 {
            let kept = past < radius && along > 0.0;
            dark += usize::from(kept);
            wrong += usize::from(lit == kept);
        }
    }
    assert!(dark > 1000, "{dark} pixels are to be dark");
    assert!(wrong * 200 < dark, "{wrong} pixels are wrong of {dark}");
}

const SLANTED: &str = "kind = \"sun\", direction = [1, -0.3, -0.8]";
const TOWARD: Vec3 = Vec3::new(-1.0, 0.3, 0.8);

#[test]
fn surfaces_shadow_themselves_and_each_other() {
    let middles = [Vec3::new(1.8, -0.3, -1.0), Vec3::new(-1.8, 0.6, 1.2)];
    let [far, near] = middles.map(|middle| particle(middle, 1.5));
    let one = stage(SLANTED).surface("both", &[far, near], FINE, "").picture();
    assert_shadowed(&one, TOWARD, middles, 1.5);
    let two = stage(SLANTED).surface("far", &[far], FINE, "").surface("near", &[near], FINE, RED).picture();
    assert_shadowed(&two, TOWARD, middles, 1.5);
}

#[test]
fn surfaces_throw_shadows_on_puffs() {
    let (puff, middle) = ([0.0, 0.0, -4.0, 9.0], Vec3::new(-2.0, 0.5, 4.0));
    let toward = Vec3::new(-1.0, 0.4, 1.0).normalize_or(Vec3::Y);
    let stage = stage("kind = \"sun\", direction = [1, -0.4, -1]")
        .balls("puff", &[puff], "style = { shadow = { on = false } }")
        .surface("ball", &[particle(middle, 0.7)], FINE, RED);
    let picture = stage.picture();
    let (mut dark, mut wrong) = (0, 0);
    for (x, y) in picture.places() {
        let (ray, colour) = (balls::ray(x, y), picture.rgb(x, y));
        let Some(depth) = balls::distance(ray, puff).filter(|_| colour == SHADOW || colour == LIT) else {
            continue;
        };
        let place = EYE + ray * depth;
        // The puff's own dark side is dark too.
        if (place - Vec3::new(0.0, 0.0, -4.0)).normalize_or(Vec3::Y).dot(toward) < 0.2 {
            continue;
        }
        let kept = passes(place, toward, middle).0 < 0.7;
        dark += usize::from(kept);
        wrong += usize::from(kept != (colour == SHADOW));
    }
    assert!(dark > 1000 && wrong * 50 < dark, "{wrong} pixels are wrong of {dark}");
}

#[test]
fn a_model_and_a_surface_throw_both_their_shadows() {
    let stage = stage(SUN)
        .mesh("wall", "wall.obj", "")
        .surface("ball", &[particle(Vec3::new(-2.5, 2.0, 2.0), 0.7)], FINE, RED)
        .mesh("plate", "plate.obj", &format!("transform = {{ position = [-2.5, -2, 2] }}\n{RED}"));
    let files = Files::default().with("wall.obj", square(8.0)).with("plate.obj", square(0.8));
    assert_dark(&stage.picture_with(files), 8000, |place| {
        let off = place - Vec2::new(-0.5, -2.0);
        let ball = passes(place.extend(0.0), Vec3::new(-1.0, 0.0, 1.0), Vec3::new(-2.5, 2.0, 2.0)).0 < 0.7;
        ball || off.abs().max_element() < 0.8
    });
}

#[test]
fn a_coarse_ball_has_a_smooth_terminator() {
    for cells in [5, 9, 30] {
        for light in [
            "kind = \"sun\", direction = [-1, -0.3, -0.2]",
            "kind = \"sun\", direction = [1, -0.1, 0.6]",
            "kind = \"point\", position = [5, 5, 3]",
        ] {
            let shape = format!("threshold = 0.25, subdivisions = {cells}");
            let picture = |on: bool| {
                let more = format!("style = {{ shadow = {{ on = {on} }} }}");
                stage(light).surface("ball", &[particle(Vec3::ZERO, 3.0)], &shape, &more).picture()
            };
            let (with, without) = (picture(true), picture(false));
            assert!(without.count(SHADOW) > 5000 && without.count(LIT) > 5000, "both sides are seen");
            let apart = with.places().filter(|&(x, y)| with.rgb(x, y) != without.rgb(x, y)).count();
            assert!(apart <= 3, "{apart} pixels differ with {cells} cells under {light}");
        }
    }
}

#[test]
fn the_shadow_of_smoke_goes_where_the_smoke_goes() {
    let smoke = format!(
        "[[object]]\nname = \"ball\"\nkind = \"smoke\"\nsolver = \"forces\"\n\
         shape = {{ surface = {{ threshold = 0.25, cell = 0.05 }} }}\n\
         emitter = {{ shape = {{ point = {{ center = [-2.5, -2, 2] }} }}, bursts = [{{ at = 0, count = 1 }}], \
         velocity = [0, 2, 0], life = [9, 9], radius = [1, 1] }}\n{RED}\n"
    );
    let mut stage = stage(SUN).mesh("wall", "wall.obj", "");
    stage.objects += &smoke;
    let mut engine = engine();
    let mut player = stage.play(&engine, Files::default().with("wall.obj", square(8.0))).unwrap();
    for (frame, y) in [(12, -1.0), (48, 2.0), (24, 0.0)] {
        let picture = picture_at(&mut engine, &mut player, frame).unwrap();
        let dark: Vec<_> = picture
            .places()
            .filter(|&(x, y)| picture.rgb(x, y) == SHADOW)
            .map(|(_, y)| y as f32 + 0.5)
            .collect();
        let middle = dark.iter().sum::<f32>() / dark.len() as f32;
        let expected = 0.5 * SIDE as f32 - y * PX_PER_METRE;
        assert!(dark.len() > 5000 && (middle - expected).abs() < 6.0, "{middle}, should be {expected}");
    }
}

#[test]
fn who_throws_no_shadow_throws_none_and_who_shows_none_shows_none() {
    let dark = |wall: &str, ball: &str| {
        let stage = stage(SUN).mesh("wall", "wall.obj", wall).surface(
            "ball",
            &[particle(Vec3::new(-2.5, 0.0, 2.0), 0.8)],
            FINE,
            ball,
        );
        stage.picture_with(Files::default().with("wall.obj", square(8.0))).count(SHADOW)
    };
    assert!(dark("", RED) > 5000);
    assert_eq!(dark("", "style = { tones = [\"#ff0000\"], shadow = { on = false } }"), 0);
    assert_eq!(dark("", "visible = false"), 0);
    assert_eq!(dark("style = { shadow = { receive = false } }", RED), 0);
}
