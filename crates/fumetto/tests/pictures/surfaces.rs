//! Surfaces round particles: where they are, and what they look like.

use std::f32::consts::PI;

use crate::stage::{BACKGROUND, Files, PX_PER_METRE, Picture, Rgb, SIDE, Stage, engine, style};

const DARK: Rgb = [0x30, 0x30, 0x40];
const LIGHT: Rgb = [0xf0, 0xe0, 0xd0];
pub(crate) const MIDDLE: u32 = SIDE / 2;

/// Radius of a lone particle of mass 1 whose surface has a radius of 1 at a threshold of 0.05: equation 2 of
/// Álvarez et al. 2007 solved for the distance.
pub(crate) const REACH: f32 = 1.134_967_9;

fn assert_close(actual: f32, expected: f32, tolerance: f32) {
    assert!((actual - expected).abs() < tolerance, "{actual}, should be {expected}");
}

fn lone(direction: [f32; 3], threshold: f32) -> Picture {
    let tones = format!(
        "tones = [{{ colour = \"#303040\", from = 0 }}, {{ colour = \"#f0e0d0\", from = {threshold} }}]"
    );
    let light = format!("kind = \"sun\", direction = {direction:?}");
    let stage = Stage { light, style: style(&[], "").replace("tones = []", &tones), ..Stage::default() };
    stage.surface("ball", &[[0.0, 0.0, 0.0, 4.0 * REACH]], "subdivisions = 64", "").picture()
}

fn lit_share(picture: &Picture) -> f32 {
    picture.count(LIGHT) as f32 / (picture.count(LIGHT) + picture.count(DARK)) as f32
}

#[test]
fn a_lone_particle_covers_the_silhouette_of_its_ball() {
    // Seen from 10 m a ball of 4 m shows a cone of half angle asin(0.4).
    let radius_px = PX_PER_METRE * 10.0 * 0.4_f32.asin().tan();
    let covered = lone([0.0, 0.0, -1.0], 0.5).drawn() as f32;
    assert_close(covered / (PI * radius_px * radius_px), 1.0, 0.003);
}

#[test]
fn two_tones_split_it_where_theory_says() {
    // As for a ball among models.
    for threshold in [0.5, 0.7, 0.9_f32] {
        let (distance, radius) = (10.0, 4.0);
        let (along, across) = (radius * threshold, radius * (1.0 - threshold * threshold).sqrt());
        let edge = across / (distance - along);
        let silhouette = (radius / distance).asin().tan();
        let share = lit_share(&lone([0.0, 0.0, -1.0], threshold));
        assert_close(share, (edge / silhouette).powi(2), 0.004);
    }
    assert_close(lit_share(&lone([-1.0, 0.0, 0.0], 0.01)), 0.4936, 0.004);
}

const RED: &str = "style = { tones = [\"#ff0000\"] }";
const BLUE: &str = "style = { tones = [\"#0000ff\"] }";

#[test]
fn surfaces_hide_each_other_where_they_are_nearer() {
    let ball = |x: f32, z: f32| [[x, 0.0, z, 2.0]];
    let beside =
        Stage::default().surface("a", &ball(-1.0, 0.0), "", RED).surface("b", &ball(1.0, 0.0), "", BLUE);
    let picture = beside.picture();
    // They meet in the plane x = 0.
    for (x, y) in picture.places().filter(|&(x, _)| x.abs_diff(MIDDLE) > 1) {
        let other = if x < MIDDLE { [0, 0, 255] } else { [255, 0, 0] };
        assert!(picture.rgb(x, y) != other, "at {x}, {y}");
    }
    assert_close(picture.count([255, 0, 0]) as f32 / picture.count([0, 0, 255]) as f32, 1.0, 0.01);
    let before =
        Stage::default().surface("a", &ball(0.0, 1.5), "", RED).surface("b", &ball(0.0, 0.0), "", BLUE);
    assert_eq!(before.picture().rgb(MIDDLE, MIDDLE), [255, 0, 0]);
}

#[test]
fn surfaces_and_puffs_hide_each_other() {
    let front = [[-1.0, 0.0, 2.0, 1.5]];
    let back = [[1.0, 0.0, -2.0, 3.0]];
    let surface_first = Stage::default().surface("a", &front, "", RED).balls("b", &back, BLUE).picture();
    let puff_first = Stage::default().balls("a", &front, RED).surface("b", &back, "", BLUE).picture();
    for picture in [surface_first, puff_first] {
        let px = |x: f32, z: f32| (MIDDLE as f32 + x * 10.0 / (10.0 - z) * PX_PER_METRE) as u32;
        assert_eq!(picture.rgb(px(-1.0, 2.0), MIDDLE), [255, 0, 0]);
        assert_eq!(picture.rgb(px(1.0, -2.0), MIDDLE), [0, 0, 255]);
        assert!(picture.count([0, 0, 255]) > 0);
    }
}

#[test]
fn a_transparent_surface_is_even() {
    // Two pieces, one behind the other, and a third that melts into the first.
    let particles = [[0.0, 0.0, 2.0, 1.0], [0.3, 0.0, -2.0, 2.0], [0.8, 0.5, 2.0, 1.0]];
    let picture = Stage::default().surface("a", &particles, "", "opacity = 0.5").picture();
    let colours = picture.colours();
    assert_eq!(colours.len(), 2, "{colours:?}");
    assert!(picture.drawn() > 10_000 && !colours.contains(&[255; 3]));
}

/// Lobes that hide each other, with noise on them.
const LOBES: [[f32; 4]; 5] = [
    [0.0, 0.0, 2.0, 2.0],
    [1.4, 0.6, 0.0, 2.2],
    [-1.6, 0.4, -1.0, 2.0],
    [0.2, -1.2, 0.5, 1.6],
    [0.3, 1.6, -2.0, 2.4],
];

const NOISY: &str = "subdivisions = 64, noise = { amplitude = 1.5, size = 0.7 }";

#[test]
fn a_transparent_surface_covers_its_mask_times_its_opacity() {
    for ink in ["ink = { on = false }", "ink = { on = true, width = { px = 5 } }"] {
        let coverage = |opacity: f32| {
            let stage = Stage {
                background: String::new(),
                output: format!("size = [{SIDE}, {SIDE}], antialias = 2"),
                style: style(&["#405060", "#ffffff"], ink),
                ..Stage::default()
            };
            let picture = stage.surface("cloud", &LOBES, NOISY, &format!("opacity = {opacity}")).picture();
            picture.places().map(|(x, y)| f32::from(picture.rgba(x, y)[3]) / 255.0).sum::<f32>()
        };
        let mask = coverage(1.0);
        assert!(mask > 20_000.0, "{mask} pixels");
        for opacity in [0.2, 0.6] {
            assert_close(coverage(opacity) / mask, opacity, 0.003);
        }
    }
}

/// Encoded bytes as linear light.
fn linear(rgb: Rgb) -> [f32; 3] {
    rgb.map(|byte| {
        let share = f32::from(byte) / 255.0;
        if share <= 0.040_45 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
    })
}

#[test]
fn among_others_a_transparent_surface_is_one_even_veil() {
    let picture = |visible: bool, opacity: f32| {
        let stage = Stage { style: style(&["#405060", "#ffffff"], ""), ..Stage::default() };
        stage
            .mesh("ball", "ball.obj", RED)
            .balls("puff", &[[-1.5, -0.5, 4.0, 1.2]], BLUE)
            .surface("solid", &[[2.5, 1.0, 0.5, 1.8]], "", "")
            .surface("glass", &LOBES, NOISY, &format!("visible = {visible}\nopacity = {opacity}"))
            .picture_with(Files::default().with("ball.obj", crate::models::ball(2.2, 32)))
    };
    let (without, solid, veil) = (picture(false, 1.0), picture(true, 1.0), picture(true, 0.4));
    let mut veiled = 0;
    for (x, y) in solid.places() {
        veiled += usize::from(veil.rgb(x, y) != without.rgb(x, y));
        let (below, above, seen) =
            (linear(without.rgb(x, y)), linear(solid.rgb(x, y)), linear(veil.rgb(x, y)));
        for channel in 0..3 {
            let expected = below[channel] + 0.4 * (above[channel] - below[channel]);
            assert!(
                (seen[channel] - expected).abs() < 0.01,
                "at {x}, {y}: {seen:?} of {below:?} under {above:?}"
            );
        }
    }
    assert!(veiled > 10_000, "{veiled} pixels");
}

#[test]
fn a_transparent_surface_lies_between_others() {
    let ball = |z: f32, radius: f32| [[0.0, 0.0, z, radius]];
    let picture = Stage::default()
        .surface("back", &ball(-3.0, 3.5), "", RED)
        .surface("glass", &ball(0.0, 2.5), "", "opacity = 0.5")
        .balls("puff", &ball(3.0, 0.7), BLUE)
        .picture();
    let across: Vec<Rgb> = (MIDDLE..SIDE).map(|x| picture.rgb(x, MIDDLE)).collect();
    let mut seen = across.clone();
    seen.dedup();
    let through = |behind: Rgb| {
        let mixed = seen.iter().any(|colour| {
            (0..3).all(|i| colour[i] > behind[i] || behind[i] == 255)
                && *colour != [255; 3]
                && *colour != behind
        });
        assert!(mixed, "{behind:?} through the glass: {seen:?}");
    };
    assert_eq!(seen[0], [0, 0, 255], "the puff before it is not dimmed");
    through([255, 0, 0]);
    assert_eq!(*seen.last().unwrap(), BACKGROUND);
    assert!(seen.len() <= 4, "{seen:?}");
}

#[test]
fn particles_of_a_surface_are_not_drawn_singly() {
    let ball = [[0.0, 0.0, -2.0, 3.0]];
    let inked = style(&["#202020", "#ffffff"], "ink = { width = { px = 4 } }, shadow = { on = true }");
    let stage = Stage { style: inked, ..Stage::default() };
    let alone = stage.clone().balls("ball", &ball, "").picture();
    // Nowhere is their density as much as the threshold.
    let thin = stage.balls("ball", &ball, "").surface("thin", &[[0.5, 0.5, 2.0, 1.0]], "threshold = 2", "");
    assert!(thin.picture() == alone);
}

#[test]
fn finer_cells_and_larger_sizes_do_what_they_say() {
    let drawn = |shape: &str| {
        Stage::default().surface("ball", &[[0.0, 0.0, 0.0, 2.0]], shape, "").picture().drawn() as f32
    };
    let fine = drawn("subdivisions = 96");
    let coarse = drawn("subdivisions = 5");
    assert!(coarse < 0.99 * fine, "a polyhedron within the ball: {coarse} of {fine}");
    assert_close(drawn("per_radius = 48") / fine, 1.0, 0.002);
    assert_close(drawn("cell = 0.05") / fine, 1.0, 0.002);
    let small = drawn("size = 0.5");
    assert!((0.2..0.25).contains(&(small / fine)), "{small} of {fine}");
}

#[test]
fn a_threshold_that_leaves_nothing_is_told_with_the_most_that_there_is() {
    let engine = engine();
    let ball = [[0.0, 0.0, 0.0, 1.0]];
    let notes = |keys: &str| {
        let player =
            Stage::default().surface("thin", &ball, keys, "").play(&engine, Files::default()).unwrap();
        player.notes().to_vec()
    };
    let told = notes("threshold = 2");
    assert!(told.len() == 1 && told[0].contains("`thin`") && told[0].contains("about 1 dense"), "{told:?}");
    assert!(notes("threshold = 0.5").is_empty());
}
