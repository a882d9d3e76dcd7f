//! Making a surface anew for a frame of smoke.

use std::{
    io,
    time::{Duration, Instant},
};

use anyhow::Context as _;
use fumetto::{Assets, Engine, Player};

use crate::{
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const SURFACE: Subsystem = Subsystem {
    name: "surface",
    title: "one step of smoke, and the surface around its particles",
    counted: "particles",
    sizes: &[24, 1_000, 10_000, 100_000],
    variants: &["puffs", "22 cells", "64 cells", "128 cells"],
    measure,
};

/// At 24 frames a second, all particles are born by then: the first births are spread over their life, one
/// second.
const WARM_UP_FRAME: u32 = 30;

/// No scene here names a file.
struct NoFiles;

impl Assets for NoFiles {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

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
    let mut cases = variants
        .iter()
        .map(|variant| {
            let shape = shape(variant).context("there is no such variant")?;
            let player = engine.play(scene::load(variant, &text(size, &shape))?, Box::new(NoFiles))?;
            let mut case = Running { player, frame: WARM_UP_FRAME };
            engine.seek(&mut case.player, case.frame)?;
            engine.gpu().wait()?;
            Ok(case)
        })
        .collect::<anyhow::Result<Vec<_>>>()?;
    rounds(&mut cases, budget, |case| next_frame(engine, case))
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
    let cells = variant.strip_suffix(" cells")?;
    Some(format!("surface = {{ threshold = 0.5, subdivisions = {cells} }}"))
}

/// A cube of smoke that stands, of particles that overlap as much whatever their number.
fn text(count: u32, shape: &str) -> String {
    let radius = 1.8 / f64::from(count).cbrt();
    format!(
        r##"
format = 1
[camera]
eye = [0.0, 0.0, 6.0]
target = [0.0, 0.0, 0.0]
[time]
fps = 24
substeps = 1
[[object]]
name = "smoke"
kind = "smoke"
shape = {{ {shape} }}
[object.emitter]
shape = {{ box = {{ center = [0.0, 0.0, 0.0], size = [2.0, 2.0, 2.0] }} }}
count = {count}
life = 1
radius = {radius}
"##
    )
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use fumetto_scene::{Resolution, Shape};

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene_of_every_size() {
        let resolutions = SURFACE.variants.iter().map(|variant| {
            for size in SURFACE.sizes {
                scene::load(variant, &text(*size, &shape(variant).unwrap())).unwrap();
            }
            let scene = scene::load(variant, &text(24, &shape(variant).unwrap())).unwrap();
            scene.objects[0].shape.surface().map(|surface| surface.resolution)
        });
        let cells = |cells| Some(Resolution::Subdivisions(cells));
        assert_eq!(resolutions.collect::<Vec<_>>(), [None, cells(22), cells(64), cells(128)]);
        let puffs = scene::load("puffs", &text(24, "puffs = {}")).unwrap();
        assert!(matches!(puffs.objects[0].shape, Shape::Puffs(_)));
    }
}
