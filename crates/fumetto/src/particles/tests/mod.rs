//! Simulation against closed forms, on whatever adapter there is.

mod air;
mod births;
mod motion;
mod repeat;
mod snapshots;

use std::{
    io,
    sync::{LazyLock, Mutex, MutexGuard, PoisonError},
};

use fumetto_scene::{Scene, SceneText};
use glam::Vec3;

pub(super) use super::state::Particle;
use crate::{Assets, Engine, Gpu, Player, gpu::read_buffer};

/// Making pipelines takes longer than most tests do: they share one engine.
static ENGINE: LazyLock<Mutex<Engine>> =
    LazyLock::new(|| Mutex::new(Engine::new(pollster::block_on(Gpu::headless()).expect("a Vulkan driver"))));

pub(super) fn engine() -> MutexGuard<'static, Engine> {
    ENGINE.lock().unwrap_or_else(PoisonError::into_inner)
}

struct NoFiles;

impl Assets for NoFiles {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// One emitter at `fps` steps a second; `emitter` holds its keys, `forces` are tables.
fn play(engine: &Engine, fps: f32, emitter: &str, forces: &[&str]) -> Player {
    play_seeded(engine, 1, fps, emitter, forces)
}

fn play_seeded(engine: &Engine, seed: u32, fps: f32, emitter: &str, forces: &[&str]) -> Player {
    play_smoke(
        engine,
        seed,
        fps,
        &format!("solver = \"forces\"\nforce = [{}]\n[object.emitter]\n{emitter}\n", forces.join(", ")),
    )
}

/// Smoke with these `keys`, at `fps` steps a second.
pub(super) fn play_smoke(engine: &Engine, seed: u32, fps: f32, keys: &str) -> Player {
    play_timed(engine, seed, &format!("fps = {fps}"), keys)
}

/// Smoke with these `keys`, by a clock with those of `time`.
fn play_timed(engine: &Engine, seed: u32, time: &str, keys: &str) -> Player {
    let toml = format!(
        "format = 1\nseed = {seed}\ncamera = {{ eye = [0, 0, 5], target = [0, 0, 0] }}\n\
         time = {{ {time}, frames = [0, 100] }}\n\
         [[object]]\nname = \"smoke\"\nkind = \"smoke\"\n{keys}"
    );
    let text = SceneText { name: "test", toml: &toml, ..Default::default() };
    let loaded = Scene::load(&text, &mut |_| Err("there are no styles".into()));
    let (scene, _) = loaded.unwrap_or_else(|report| panic!("{}", report.render(false)));
    engine.play(scene, Box::new(NoFiles)).expect("the scene fits")
}

/// All slots of the one emitter after `steps` steps.
pub(super) fn slots_after(engine: &Engine, player: &mut Player, steps: u32) -> Vec<Particle> {
    engine.seek(player, steps).expect("there are no files to miss");
    let plume = player.plumes().next().expect("there is smoke");
    let emission = plume.emissions.first().expect("there is one emitter");
    read_buffer(engine.gpu(), emission.particles()).expect("the device lives")
}

/// The living after `steps` steps.
fn alive_after(engine: &Engine, player: &mut Player, steps: u32) -> Vec<Particle> {
    let mut particles = slots_after(engine, player, steps);
    particles.retain(|particle| !particle.is_dead());
    particles
}

/// Asserts that two vectors are within `tolerance` of each other.
#[track_caller]
fn assert_close(actual: Vec3, expected: Vec3, tolerance: f32) {
    assert!(actual.distance(expected) <= tolerance, "{actual} should be {expected}, within {tolerance}");
}
