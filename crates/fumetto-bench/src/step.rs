//! One step of the simulation.

use std::{
    io,
    time::{Duration, Instant},
};

use fumetto::{Assets, Engine, Player};

use crate::{
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const STEP: Subsystem = Subsystem {
    name: "step",
    title: "one step of the simulation, and turning its particles into puffs",
    counted: "particles",
    sizes: &[1_000, 5_000, 20_000, 100_000, 1_000_000],
    variants: &["step"],
    measure,
};

/// At 24 frames a second, all particles are born and some reborn by then: the first births are spread over
/// the longest life, one second.
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
        .map(|name| {
            let player = engine.play(scene::load(name, &text(size))?, Box::new(NoFiles))?;
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

/// A plume with every kind of force that is common in smoke, kept at `count` particles.
fn text(count: u32) -> String {
    format!(
        r##"
format = 1
[camera]
eye = [0.0, 1.6, 6.0]
target = [0.3, 1.6, 0.0]
[time]
fps = 24
substeps = 1
[[object]]
name = "smoke"
kind = "smoke"
solver = "forces"
[object.emitter]
shape = {{ disc = {{ center = [0.0, 0.0, 0.0], radius = 0.25 }} }}
count = {count}
velocity = [0.0, 1.2, 0.0]
spread = 12
speed_jitter = 0.2
life = [0.8, 1.0]
radius = [0.22, 0.34]
radius_over_life = [[0.0, 0.5], [0.3, 1.0], [1.0, 1.9]]
erosion_over_life = [[0.0, 0.0], [0.6, 0.0], [1.0, 1.0]]
[[object.force]]
kind = "buoyancy"
acceleration = 1.0
cooling = 0.8
[[object.force]]
kind = "drag"
rate = 1.5
[[object.force]]
kind = "wind"
velocity = [0.5, 0.2, 0.0]
gust = 0.3
[[object.force]]
kind = "turbulence"
speed = 0.5
scale = 1.2
octaves = 2
[[object.force]]
kind = "vortex"
center = [0.0, 1.0, 0.0]
radius = 0.5
speed = 0.8
"##
    )
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use fumetto_scene::Matter;

    use super::*;

    #[test]
    fn every_size_is_a_good_scene() {
        for size in STEP.sizes {
            let scene = scene::load("step", &text(*size)).unwrap();
            assert_eq!(scene.time.substeps, 1, "a frame is one step");
            let Matter::Smoke(smoke) = &scene.objects[0].matter else { panic!("smoke") };
            assert_eq!((smoke.emitters[0].count, smoke.forces.len()), (Some(*size), 5));
            let warm_up_secs = f64::from(WARM_UP_FRAME) * scene.time.step_secs();
            assert!(warm_up_secs > f64::from(smoke.emitters[0].life[1]), "all are born");
        }
    }
}
