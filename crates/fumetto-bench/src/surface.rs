//! Making a surface anew for a frame.

use std::time::{Duration, Instant};

use anyhow::Context as _;
use fumetto::{Engine, Player};

use crate::{
    cube::{Cube, FILE, SPLIT},
    measure::{Budget, Made, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const SURFACE: Subsystem = Subsystem {
    name: "surface",
    title: "reading a cube full of particles, and the surface around them",
    counted: "particles",
    sizes: &[12, 200, 10_000, 100_000, 1_000_000],
    variants: &["puffs", "22 cells", "64 cells", "128 cells", "256 cells", "two near", "two far"],
    measure,
};

struct Running {
    player: Player,
    frame: u32,
}

fn measure(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let cube = Cube::new(size);
    let mut cases = variants
        .iter()
        .map(|variant| {
            let shape = shape(variant).context("there is no such variant")?;
            let player =
                engine.play(scene::load(variant, &text(variant, &shape))?, Box::new(cube.clone()))?;
            let mut case = Running { player, frame: 0 };
            next_frame(engine, &mut case)?;
            Ok(case)
        })
        .collect::<anyhow::Result<Vec<_>>>()?;
    let mut samples = rounds(&mut cases, budget, |case| next_frame(engine, case))?;
    for (samples, case) in samples.iter_mut().zip(&cases) {
        let made = engine.surfaces(&case.player)?;
        samples.made = made.first().map(|made| Made { triangles: made.triangles, bytes: made.bytes });
    }
    Ok(samples)
}

fn next_frame(engine: &Engine, case: &mut Running) -> anyhow::Result<Duration> {
    case.frame += 1;
    let begin = Instant::now();
    engine.seek(&mut case.player, case.frame)?;
    engine.gpu().wait()?;
    Ok(begin.elapsed())
}

fn shape(variant: &str) -> Option<String> {
    if variant == "puffs" {
        return Some("puffs = {}".to_owned());
    }
    if split(variant).is_some() {
        // Half as many overlap as in the cube.
        return Some("surface = { threshold = 0.25, per_radius = 2 }".to_owned());
    }
    let cells = variant.strip_suffix(" cells")?;
    Some(format!("surface = {{ threshold = 0.5, subdivisions = {cells} }}"))
}

/// The file of one of the variants with two clouds.
fn split(variant: &str) -> Option<&'static str> {
    ["two near", "two far"].iter().position(|name| *name == variant).map(|number| SPLIT[number].0)
}

fn text(variant: &str, shape: &str) -> String {
    let file = split(variant).unwrap_or(FILE);
    format!(
        r##"
format = 1
[camera]
eye = [0.0, 0.0, 6.0]
target = [0.0, 0.0, 0.0]
[[object]]
name = "cube"
kind = "cloud"
shape = {{ {shape} }}
particles = "{file}"
"##
    )
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use fumetto_scene::{Resolution, Shape};

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene() {
        let resolutions = SURFACE.variants.iter().map(|variant| {
            let scene = scene::load(variant, &text(variant, &shape(variant).unwrap())).unwrap();
            scene.objects[0].shape.surface().map(|surface| surface.resolution)
        });
        let cells = |cells| Some(Resolution::Subdivisions(cells));
        let two = Some(Resolution::PerRadius(2.0));
        let expected = [None, cells(22), cells(64), cells(128), cells(256), two, two];
        assert_eq!(resolutions.collect::<Vec<_>>(), expected);
        let puffs = scene::load("puffs", &text("puffs", "puffs = {}")).unwrap();
        assert!(matches!(puffs.objects[0].shape, Shape::Puffs(_)));
    }
}
