//! One step of smoke among vortices.

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

pub(crate) const VORTEX: Subsystem = Subsystem {
    name: "vortex",
    title: "one step of smoke that vortices carry, and of the vortices",
    counted: "particles",
    sizes: &[1_000, 10_000, 100_000],
    variants: &["no vortices", "240 vortices", "2400 vortices", "10080 vortices"],
    measure,
};

/// At 24 frames a second, all particles and rings are born by then: both live one second.
const WARM_UP_FRAME: u32 = 30;
/// Vortices in a ring.
const SEGMENTS: u32 = 24;

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
            let rings = rings(variant).context("there is no such variant")?;
            let player = engine.play(scene::load(variant, &text(size, rings))?, Box::new(NoFiles))?;
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

/// Rings alive at once.
fn rings(variant: &str) -> Option<u32> {
    let count = variant.strip_suffix(" vortices")?;
    if count == "no" { Some(0) } else { Some(count.parse::<u32>().ok()? / SEGMENTS) }
}

/// A cube full of smoke and of rings that turn it over slowly: as many as come a second live at once.
fn text(count: u32, rings: u32) -> String {
    let solver = if rings == 0 { "forces" } else { "vortex" };
    // The more there are, the smaller they are, as when motion gets finer and not wilder.
    let radius = 0.8 / f64::from(rings.max(1)).cbrt();
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
solver = "{solver}"
[object.vortex]
segments = {SEGMENTS}
[object.emitter]
shape = {{ box = {{ center = [0.0, 0.0, 0.0], size = [2.0, 2.0, 2.0] }} }}
count = {count}
life = 1
rings = {{ rate = {rings}, circulation = {}, radius = {radius} }}
"##,
        0.5 * radius
    )
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn every_variant_has_its_vortices() {
        for variant in VORTEX.variants {
            let rings = rings(variant).unwrap();
            let scene = scene::load(variant, &text(1_000, rings)).unwrap();
            let cost = &scene.requirements()[0];
            assert_eq!(cost.particles, Some(1_000));
            // Room for those of a step more than they live, and one for rounding.
            let room = (f64::from(rings) * (1.0 + 1.0 / 24.0)).ceil() as u64 + u64::from(rings > 0);
            assert_eq!(cost.vortices, u64::from(SEGMENTS) * room);
        }
    }
}
