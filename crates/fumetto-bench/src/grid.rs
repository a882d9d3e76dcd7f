//! One step of a plume in a grid of air, and its stages.

use std::{cell::RefCell, io, time::Duration};

use anyhow::Context as _;
use fumetto::{AirTimes, Assets, Engine, Player};

use crate::{
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const GRID: Subsystem = Subsystem {
    name: "grid",
    title: "one step of a plume in a grid of air, and its stages",
    counted: "cells along a side",
    sizes: &[32, 64, 128, 256],
    variants: &["step", "advect", "push", "pressure", "particles"],
    measure,
};

/// Frames until the plume has risen through a good part of the box.
const WARM_UP_FRAME: u32 = 24;

/// No scene here names a file.
struct NoFiles;

impl Assets for NoFiles {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// The first variant of a round makes the step, the others tell what they had of it.
struct Running {
    player: Player,
    times: AirTimes,
}

fn measure(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let mut player = engine.play(scene::load("grid", &text(size))?, Box::new(NoFiles))?;
    engine.seek(&mut player, WARM_UP_FRAME)?;
    engine.gpu().wait()?;
    let running = RefCell::new(Running { player, times: AirTimes::default() });
    let mut cases: Vec<(usize, &str)> = variants.iter().copied().enumerate().collect();
    rounds(&mut cases, budget, |&mut (place, variant)| {
        let mut running = running.borrow_mut();
        if place == 0 {
            running.times = engine.time_air(&mut running.player)?;
        }
        share(&running.times, variant).context("there is no such variant")
    })
}

fn share(times: &AirTimes, variant: &str) -> Option<Duration> {
    Some(match variant {
        "step" => times.advect + times.push + times.pressure + times.particles,
        "advect" => times.advect,
        "push" => times.push,
        "pressure" => times.pressure,
        "particles" => times.particles,
        _ => return None,
    })
}

/// Hot smoke that rises in a cube of a metre.
fn text(cells: u32) -> String {
    format!(
        r##"
format = 1
[camera]
eye = [0.0, 0.5, 3.0]
target = [0.0, 0.5, 0.0]
[time]
fps = 24
substeps = 1
[[object]]
name = "smoke"
kind = "smoke"
solver = "grid"
[object.grid]
box = {{ center = [0.0, 0.5, 0.0], size = [1.0, 1.0, 1.0] }}
cells = {cells}
[object.emitter]
shape = {{ sphere = {{ center = [0.0, 0.12, 0.0], radius = 0.08 }} }}
count = 10000
life = 1
[[object.force]]
kind = "buoyancy"
acceleration = 1.0
"##
    )
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;

    #[test]
    fn every_size_has_its_cells_and_every_variant_its_share() {
        for &size in GRID.sizes {
            let scene = scene::load("grid", &text(size)).unwrap();
            let plan = scene.requirements()[0].grid.unwrap();
            assert_eq!(plan.cells, [size; 3]);
        }
        for variant in GRID.variants {
            assert_eq!(share(&AirTimes::default(), variant), Some(Duration::ZERO));
        }
    }
}
