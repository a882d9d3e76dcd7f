//! Lines of surfaces by each of the methods, and relief on them.

use crate::{
    ink_methods::{INK, assert_closed, assert_ring, inked, silhouette},
    relief::{GREYS, contrast},
    shadings::{shaded, stage},
    stage::{Picture, SIDE, Stage},
    surfaces::REACH,
};

/// A ball of `radius` metres, sampled with so many cells.
fn ball(method: &str, ink: &str, radius: f32, cells: u32) -> Picture {
    let particles = [[0.0, 0.0, 0.0, radius * REACH]];
    inked(method, ink).surface("ball", &particles, &format!("subdivisions = {cells}"), "").picture()
}

#[test]
fn vector_and_image_lines_run_along_the_silhouette() {
    let radius = silhouette(3.0);
    for method in ["vector", "image", "hybrid"] {
        for width in [2.0, 6.0] {
            let picture = ball(method, &format!("width = {{ px = {width} }}"), 3.0, 48);
            assert_ring(&picture, [radius - 0.5 * width, radius + 0.5 * width], 0.08 * width + 0.2);
        }
    }
}

#[test]
fn shells_lie_outside_it() {
    let radius = silhouette(3.0);
    for width in [3.0, 10.0] {
        let picture = ball("shell", &format!("width = {{ px = {width} }}"), 3.0, 64);
        assert_ring(&picture, [radius, radius + width], 0.12 * width + 0.2);
    }
}

#[test]
fn a_coarse_surface_has_a_closed_contour_all_the_same() {
    for method in ["vector", "shell"] {
        assert_closed(&ball(method, "width = { px = 5 }", 3.0, 8));
    }
}

#[test]
fn a_lobe_before_another_has_a_line_of_its_own() {
    // The small one hides the middle of the large one.
    let particles = [[0.0, 0.0, -2.0, 4.0], [0.0, 0.0, 4.0, 1.0]];
    let ink = |particles: &[[f32; 4]], method: &str| {
        let stage = inked(method, "width = { px = 3 }");
        stage.surface("lobes", particles, "cell = 0.1", "").picture().count(INK) as f32
    };
    for method in ["vector", "image"] {
        let (both, alone) = (ink(&particles, method), ink(&particles[..1], method));
        let small = ink(&particles[1..], method);
        assert!(((both - alone) / small - 1.0).abs() < 0.06, "{method}: {both}, {alone} and {small} pixels");
    }
}

#[test]
fn a_line_that_the_light_takes_wholly_ends() {
    for method in ["vector", "image"] {
        let ink = |thinning: f32| {
            let stage = inked(method, "width = { px = 8 }");
            let style = stage.style.replace("lit_thinning = 0", &format!("lit_thinning = {thinning}"));
            let light = "kind = \"sun\", direction = [1, 0, 0]".to_owned();
            let stage = Stage { style, light, ..stage };
            stage.surface("ball", &[[0.0, 0.0, 0.0, 3.0 * REACH]], "subdivisions = 48", "").picture()
        };
        // The light comes from the left.
        let reach = silhouette(3.0) as u32 + 8;
        let inked = |picture: &Picture, columns: std::ops::Range<u32>| {
            columns.filter(|&x| picture.rgb(x, SIDE / 2) == INK).count()
        };
        let (left, right) = (SIDE / 2 - reach..SIDE / 2, SIDE / 2..SIDE / 2 + reach);
        let (whole, half, gone) = (ink(0.0), ink(0.5), ink(1.0));
        assert!(inked(&whole, left.clone()).abs_diff(8) <= 1, "{method}");
        assert!(inked(&half, left.clone()).abs_diff(4) <= 1, "{method}");
        assert_eq!(inked(&gone, left), 0, "{method}");
        assert!(inked(&gone, right).abs_diff(8) <= 1, "{method}");
    }
}

#[test]
fn exaggeration_brings_out_the_lobes_of_a_surface_that_is_lit_evenly() {
    let ring = (0..12).map(|i| {
        let angle = std::f32::consts::TAU * i as f32 / 12.0;
        [2.0 * angle.cos(), 2.0 * angle.sin(), 0.0, 1.0]
    });
    let lobes: Vec<_> = ring.chain([[0.0, 0.0, 0.0, 2.2]]).collect();
    let picture = |more: &str| {
        let stage = stage(shaded(GREYS, &format!("wrap = 1, {more}")), [-0.1, -0.1, -1.0]);
        stage.surface("cloud", &lobes, "subdivisions = 64", "").picture()
    };
    let (plain, strong) = (picture(""), picture("exaggerate = { contrast = 4 }"));
    assert!(plain.drawn() > (SIDE * SIDE / 20) as usize);
    let (plain, strong) = (contrast(&plain), contrast(&strong));
    assert!(strong > 1.3 * plain, "{plain} becomes {strong}");
}
