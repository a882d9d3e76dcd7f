//! Exaggerated shading: what is bumpy gains contrast, what is flat has none to gain.

use std::fmt::Write as _;

use crate::{
    shadings::{shaded, stage},
    stage::{BACKGROUND, Files, Picture, Stage},
};

/// A square of 6 m with a normal at every 0.1 m, which waves by `slope` along x.
fn waves(slope: f32) -> String {
    let mut obj = String::new();
    for row in 0..=60 {
        for column in 0..=60 {
            let (x, y) = (column as f32 * 0.1 - 3.0, row as f32 * 0.1 - 3.0);
            let tilt = slope * (x * std::f32::consts::TAU / 1.2).sin();
            writeln!(obj, "v {x} {y} 0\nvn {tilt} 0 1").unwrap();
        }
    }
    for row in 0..60 {
        for column in 1..=60 {
            let [a, d] = [row * 61 + column, (row + 1) * 61 + column];
            writeln!(obj, "f {a}//{a} {b}//{b} {c}//{c} {d}//{d}", b = a + 1, c = d + 1).unwrap();
        }
    }
    obj
}

/// Standard deviation of what is drawn, in bytes.
pub(crate) fn contrast(picture: &Picture) -> f32 {
    let values: Vec<_> = picture
        .places()
        .map(|(x, y)| picture.rgb(x, y))
        .filter(|&colour| colour != BACKGROUND)
        .map(|[red, _, _]| f32::from(red))
        .collect();
    let mean = values.iter().sum::<f32>() / values.len() as f32;
    (values.iter().map(|value| (value - mean).powi(2)).sum::<f32>() / values.len() as f32).sqrt()
}

pub(crate) const GREYS: &str = "tones = { dark = \"#000000\", light = \"#ffffff\", steps = 32 }";

#[test]
fn exaggeration_brings_out_relief_and_leaves_flat_what_is_flat() {
    let lights = ["kind = \"sun\", direction = [-0.1, -0.05, -1]", "kind = \"point\", position = [2, 1, 30]"];
    for light in lights {
        let picture = |slope: f32, more: &str| {
            let stage = Stage { light: light.into(), style: shaded(GREYS, more), ..Stage::default() };
            stage
                .mesh("waves", "waves.obj", "")
                .picture_with(Files::default().with("waves.obj", waves(slope)))
        };
        let (plain, strong) = (
            contrast(&picture(0.1, "")),
            contrast(&picture(0.1, "exaggerate = { scales = 8, contrast = 30 }")),
        );
        assert!(strong > 3.0 * plain, "{plain} becomes {strong}");
        let half = contrast(&picture(0.1, "exaggerate = { amount = 0.5, scales = 8, contrast = 30 }"));
        assert!((plain..strong).contains(&half), "{plain}, {half}, {strong}");
        let flat = contrast(&picture(0.0, "exaggerate = {}"));
        assert!(flat < 2.0, "a flat surface has a contrast of {flat}");
    }
}

#[test]
fn exaggeration_brings_out_puffs_on_the_side_that_is_lit_evenly() {
    let picture = |more: &str| {
        let stage = stage(shaded(GREYS, &format!("wrap = 1, {more}")), [-0.1, -0.1, -1.0]);
        stage.cloud("cloud", &[[0.0, 0.0, 0.0, 4.0]], "spheres = 60, variants = 1, tile = 256", "").picture()
    };
    let (plain, strong) = (contrast(&picture("")), contrast(&picture("exaggerate = { amount = 1 }")));
    assert!(strong > 1.2 * plain, "{plain} becomes {strong}");
}
