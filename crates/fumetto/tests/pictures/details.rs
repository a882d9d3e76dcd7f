//! Layers of detail: lines of surfaces inside others.

use std::f32::consts::PI;

use crate::{
    ink_methods::{inked, silhouette},
    models::ball,
    stage::{Files, PX_PER_METRE, Picture, Rgb, SIDE, Stage, engine},
    surfaces::REACH,
};

const MIDDLE: u32 = SIDE / 2;
const RED: Rgb = [0xc0, 0x20, 0x20];
const BLUE: Rgb = [0x20, 0x20, 0xc0];
const LINE_PX: f32 = 4.0;

/// A layer of detail with lines of a colour, for the shape of an object.
fn detail(keys: &str, colour: Rgb, method: &str) -> String {
    let [r, g, b] = colour;
    format!(
        "{{ {keys}, ink = {{ method = \"{method}\", colour = \"#{r:02x}{g:02x}{b:02x}\", width = {{ px = {LINE_PX} }} }} }}"
    )
}

/// Balls in places, of so many metres, with these layers of detail.
fn clouds(stage: Stage, name: &str, balls: &[[f32; 4]], details: &[String]) -> Stage {
    let particles: Vec<_> = balls.iter().map(|&[x, y, z, radius]| [x, y, z, radius * REACH]).collect();
    stage.surface(name, &particles, &format!("cell = 0.12, detail = [{}]", details.join(", ")), "")
}

fn stage() -> Stage {
    inked("image", "width = { px = 2 }")
}

/// Length of the lines of a colour in pixels.
fn length(picture: &Picture, colour: Rgb) -> f32 {
    picture.count(colour) as f32 / LINE_PX
}

fn assert_near(actual: f32, expected: f32, share: f32, what: &str) {
    assert!((actual / expected - 1.0).abs() < share, "{what}: {actual}, should be {expected}");
}

#[test]
fn every_method_draws_the_inner_contour_over_the_body() {
    for method in ["vector", "image", "hybrid", "shell", "angle"] {
        let layer = detail("size = 0.5", RED, method);
        let picture = clouds(stage(), "cloud", &[[0.0, 0.0, 0.0, 4.0]], &[layer]).picture();
        if method == "angle" {
            assert!(picture.count(RED) > 1000);
            continue;
        }
        // A shell's line lies outside.
        let middle = silhouette(2.0) + if method == "shell" { 0.5 * LINE_PX } else { 0.0 };
        assert_near(length(&picture, RED), 2.0 * PI * middle, 0.12, method);
        let plain = clouds(stage(), "cloud", &[[0.0, 0.0, 0.0, 4.0]], &[]).picture();
        for (x, y) in picture.places().filter(|&(x, y)| picture.rgb(x, y) != RED) {
            assert_eq!(picture.rgb(x, y), plain.rgb(x, y), "{method}: the body is as it was, at {x}, {y}");
        }
    }
}

#[test]
fn mass_and_threshold_move_it() {
    let radius = |keys: &str| {
        let layer = detail(keys, RED, "vector");
        let picture = clouds(stage(), "cloud", &[[0.0, 0.0, 0.0, 4.0]], &[layer]).picture();
        let row = (MIDDLE..SIDE).filter(|&x| picture.rgb(x, MIDDLE) == RED);
        let reds: Vec<_> = row.collect();
        assert!(!reds.is_empty(), "{keys}: no line");
        reds.iter().sum::<u32>() as f32 / reds.len() as f32 + 0.5 - MIDDLE as f32
    };
    // Equation 2 of Álvarez et al. 2007, solved for the distance.
    for (keys, mass, threshold) in
        [("size = 1, mass = 0.2", 0.2, 0.05), ("size = 1, threshold = 0.4", 1.0, 0.4_f32)]
    {
        let expected = 4.0 * REACH * (1.0 - (threshold / mass as f32).sqrt()).sqrt();
        let found = radius(keys);
        assert!(
            (found - silhouette(expected)).abs() < 1.0,
            "{keys}: {found}, should be {}",
            silhouette(expected)
        );
    }
}

#[test]
fn its_lines_hide_each_other_but_other_levels_do_not() {
    // The inner ball of the farther one lies behind that of the nearer one.
    let balls = [[0.0, 0.0, 2.0, 3.0], [0.0, 0.0, -2.0, 3.0]];
    let one = clouds(stage(), "cloud", &balls, &[detail("size = 0.5", RED, "vector")]).picture();
    let near = 2.0 * PI * silhouette_at(1.5, 8.0);
    assert_near(length(&one, RED), near, 0.06, "only the nearer one is seen");

    let layers = [detail("size = 0.75", RED, "image"), detail("size = 0.5", BLUE, "vector")];
    let two = clouds(stage(), "cloud", &[[0.0, 0.0, 0.0, 4.0]], &layers).picture();
    assert_near(length(&two, RED), 2.0 * PI * silhouette(3.0), 0.12, "first layer");
    assert_near(length(&two, BLUE), 2.0 * PI * silhouette(2.0), 0.06, "second layer, inside the first");
}

/// Radius in the picture of a ball at a distance.
fn silhouette_at(radius: f32, distance: f32) -> f32 {
    PX_PER_METRE * 10.0 * (radius / distance).asin().tan()
}

#[test]
fn nearer_things_hide_them_and_farther_ones_do_not() {
    for opacity in ["", "opacity = 0.5"] {
        for method in ["vector", "image"] {
            let layer = [detail("size = 0.6", RED, method)];
            let body = |stage: Stage| {
                let mut stage = clouds(stage, "cloud", &[[0.0, 0.0, 0.0, 3.0]], &layer);
                stage.objects += opacity;
                stage.objects.push('\n');
                stage
            };
            let red = |stage: Stage| {
                let files = Files::default().with("ball.obj", ball(1.0, 24));
                let picture = stage.picture_with(files);
                let is_red = |&(x, y): &(u32, u32)| {
                    let [r, g, b] = picture.rgb(x, y).map(u32::from);
                    // Half of it, too, over white or green.
                    r > g.max(b) + 25
                };
                picture.places().filter(is_red).count()
            };
            let alone = red(body(stage()));
            assert!(alone > 2000, "{alone}");
            let scaled = |z: f32, scale: f32| {
                format!("transform = {{ position = [0, 0, {z}], scale = {scale} }}, style = {{ tones = [\"#fefefe\"] }}")
                    .replace(", style", "\nstyle")
            };
            let before = body(stage()).mesh("ball", "ball.obj", &scaled(5.0, 2.0));
            assert_eq!(red(before), 0, "{method} {opacity}: before it");
            let behind = body(stage()).mesh("ball", "ball.obj", &scaled(-6.0, 2.0));
            let kept = red(behind);
            assert!(kept.abs_diff(alone) < alone / 50, "{method} {opacity}: {kept} of {alone} behind it");
            let puff = body(stage()).balls("puff", &[[0.0, 0.0, 5.0, 3.0]], "");
            assert_eq!(red(puff), 0, "{method} {opacity}: a puff before it");
        }
    }
}

#[test]
fn the_surface_of_another_hides_them_too() {
    let layer = [detail("size = 0.6", RED, "vector")];
    let one = clouds(stage(), "far", &[[0.0, 0.0, -2.0, 2.0]], &layer);
    let alone = one.picture().count(RED);
    let both =
        clouds(one, "near", &[[0.0, 0.0, 3.0, 2.0]], &[detail("size = 0.6", BLUE, "vector")]).picture();
    assert!(alone > 500 && both.count(RED) == 0 && both.count(BLUE) > 500);
}

#[test]
fn they_are_told_and_refused_as_surfaces_are() {
    let engine = engine();
    let fine = "{ size = 0.5, subdivisions = 512 }".to_owned();
    let stage = clouds(stage(), "huge", &[[0.0, 0.0, 0.0, 2.0]], &[fine]);
    assert_eq!(stage.scene().requirements()[0].details.len(), 1);
    let message = stage.play(&engine, Files::default()).err().unwrap().to_string();
    assert!(message.contains("`huge`") && message.contains("vertices"), "{message}");
}
