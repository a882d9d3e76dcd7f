//! The shadows of meshes: balls over a ground, with and without.

use std::{
    f64::consts::{PI, TAU},
    fmt::Write as _,
    io,
    sync::Arc,
};

use anyhow::Context as _;
use fumetto::{Assets, Engine};

use crate::{
    draw::{Sitter, time},
    measure::{Budget, Samples},
    subsystem::Subsystem,
};

pub(crate) const SHADOWS: Subsystem = Subsystem {
    name: "mesh",
    title: "one picture of 64 balls over a ground, 1280 x 720 pixels, without antialiasing",
    counted: "triangles",
    sizes: &[12_000, 100_000, 400_000],
    variants: &["body", "sun", "sun open", "lamp"],
    measure,
};

/// Balls along each side of the square that they stand in.
const ROW: u32 = 8;

/// A file in memory: the ball and the ground.
#[derive(Clone, Debug)]
struct Models {
    ball: Arc<str>,
}

impl Models {
    /// Balls that have `triangles` together. An open one lacks the faces around its pole.
    fn new(triangles: u32, is_open: bool) -> Self {
        let rings = (f64::from(triangles) / f64::from(ROW * ROW) / 4.0).sqrt().round().max(3.0) as u32;
        let round = 2 * rings;
        let mut obj = String::new();
        for ring in 0..=rings {
            for step in 0..round {
                let latitude = PI * f64::from(ring) / f64::from(rings);
                let longitude = TAU * f64::from(step) / f64::from(round);
                let [x, z] = [longitude.cos(), -longitude.sin()].map(|part| 0.4 * latitude.sin() * part);
                // Writing to a string cannot fail.
                let _ = writeln!(obj, "v {x:.6} {:.6} {z:.6}", 0.4 * latitude.cos());
            }
        }
        let pole = u32::from(is_open);
        for (ring, step) in (pole..rings).flat_map(|ring| (0..round).map(move |step| (ring, step))) {
            let corner = |ring: u32, step: u32| 1 + ring * round + step % round;
            let [a, b] = [corner(ring, step), corner(ring + 1, step)];
            let [c, d] = [corner(ring + 1, step + 1), corner(ring, step + 1)];
            let _ = writeln!(obj, "f {a} {b} {d}\nf {b} {c} {d}");
        }
        Self { ball: obj.into() }
    }
}

impl Assets for Models {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        match path {
            "ball.obj" => Ok(self.ball.as_bytes().to_vec()),
            "ground.obj" => Ok(b"v -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -9\nf 1 2 3 4\n".to_vec()),
            _ => Err(io::ErrorKind::NotFound.into()),
        }
    }
}

fn scene(variant: &str) -> Option<String> {
    let sun = "kind = \"sun\", direction = [0.5, -1.0, -0.6]";
    let (light, shadow) = match variant {
        "body" => (sun, false),
        "sun" | "sun open" => (sun, true),
        "lamp" => ("kind = \"point\", position = [-1.0, 6.0, 2.0]", true),
        _ => return None,
    };
    let row = |at: u32| f64::from(at) - 0.5 * f64::from(ROW - 1);
    let places: Vec<_> = (0..ROW * ROW)
        .map(|at| format!("{{ position = [{}, 0.6, {}] }}", row(at % ROW), row(at / ROW)))
        .collect();
    Some(format!(
        r##"
format = 1
[camera]
eye = [0.0, 5.0, 8.0]
target = [0.0, 0.0, 0.0]
fov = 45
[[light]]
{}
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
name = "balls"
kind = "mesh"
model = "ball.obj"
transform = [{}]
"##,
        light.replace(", d", "\nd").replace(", p", "\np"),
        places.join(", "),
    ))
}

fn measure(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let cases = variants.iter().map(|variant| {
        let toml = scene(variant).context("there is no such variant")?;
        Sitter::new(engine, variant, &toml, Box::new(Models::new(size, variant.contains("open"))))
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
        for variant in SHADOWS.variants {
            let scene = crate::scene::load(variant, &scene(variant).unwrap()).unwrap();
            assert_eq!(scene.objects.len(), 2);
        }
    }

    #[test]
    fn the_balls_have_about_as_many_triangles_as_said() {
        for size in [12_000, 100_000] {
            let faces = Models::new(size, false).ball.lines().filter(|line| line.starts_with('f')).count();
            let all = f64::from(ROW * ROW) * faces as f64;
            assert!((all / f64::from(size) - 1.0).abs() < 0.1, "{all}");
        }
    }
}
