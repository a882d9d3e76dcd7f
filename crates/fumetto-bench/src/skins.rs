//! The shadows of surfaces: a rugged cloud over a ground, with and without.

use std::{fmt::Write as _, io};

use anyhow::Context as _;
use fumetto::{Assets, Engine};

use crate::{
    draw::{Sitter, time},
    measure::{Budget, Samples},
    subsystem::Subsystem,
};

pub(crate) const SKINS: Subsystem = Subsystem {
    name: "skin",
    title: "one picture of a surface over a ground, 1280 x 720 pixels, without antialiasing",
    counted: "cells",
    sizes: &[48, 96, 192],
    variants: &["body", "sun", "lamp"],
    measure,
};

/// The ground, in memory.
struct Ground;

impl Assets for Ground {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        match path {
            "ground.obj" => Ok(b"v -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -9\nf 1 2 3 4\n".to_vec()),
            _ => Err(io::ErrorKind::NotFound.into()),
        }
    }
}

/// A long cloud of two rows of balls.
fn particles() -> String {
    let mut list = String::new();
    for at in 0..12_u32 {
        let x = 0.6 * f64::from(at) - 3.3;
        let (low, high) = (0.9 + 0.2 * f64::from(at % 3), 1.5 - 0.15 * f64::from(at % 4));
        // Writing to a string cannot fail.
        let _ = write!(list, "{{ center = [{x}, {low}, 0.4], radius = 1.0 }}, ");
        let _ = write!(list, "{{ center = [{x}, {high}, -0.4], radius = 0.9 }}, ");
    }
    list
}

fn scene(variant: &str, cells: u32) -> Option<String> {
    let sun = "kind = \"sun\"\ndirection = [0.5, -1.0, -0.6]";
    let (light, shadow) = match variant {
        "body" => (sun, false),
        "sun" => (sun, true),
        "lamp" => ("kind = \"point\"\nposition = [-1.0, 6.0, 2.0]", true),
        _ => return None,
    };
    let particles = particles();
    Some(format!(
        r##"
format = 1
[camera]
eye = [0.0, 5.0, 8.0]
target = [0.0, 0.6, 0.0]
fov = 45
[[light]]
{light}
[output]
size = [1280, 720]
antialias = 1
[style]
ink = {{ on = false }}
shadow = {{ on = {shadow} }}
[[object]]
name = "ground"
kind = "mesh"
model = "ground.obj"
[[object]]
name = "cloud"
kind = "cloud"
particles = [{particles}]
[object.shape.surface]
threshold = 0.35
subdivisions = {cells}
noise = {{ amplitude = 0.35, size = 1.2, octaves = 2 }}
"##
    ))
}

fn measure(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let cases = variants.iter().map(|variant| {
        let toml = scene(variant, size).context("there is no such variant")?;
        Sitter::new(engine, variant, &toml, Box::new(Ground))
    });
    let cases = cases.collect::<anyhow::Result<Vec<_>>>()?;
    time(engine, cases, budget)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene() {
        for variant in SKINS.variants {
            let scene = crate::scene::load(variant, &scene(variant, 48).unwrap()).unwrap();
            assert!(scene.objects[1].shape.surface().is_some());
        }
    }
}
