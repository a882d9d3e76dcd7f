//! Spreading against closed forms, on whatever adapter there is.

mod downhill;
mod pour;
mod spread;
mod stain;

use std::{
    io,
    sync::{LazyLock, Mutex, MutexGuard, PoisonError},
};

use fumetto_scene::{Scene, SceneText};

use super::scene::Body;
use crate::{Assets, Engine, Gpu, Player, gpu::read_buffer};

/// Building all pipelines takes longer than most tests do: they share one engine.
static ENGINE: LazyLock<Mutex<Engine>> =
    LazyLock::new(|| Mutex::new(Engine::new(pollster::block_on(Gpu::headless()).expect("a Vulkan driver"))));

fn engine() -> MutexGuard<'static, Engine> {
    ENGINE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// One model, whatever it is called.
struct Model(&'static str);

impl Assets for Model {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        if self.0.is_empty() { Err(io::ErrorKind::NotFound.into()) } else { Ok(self.0.into()) }
    }
}

/// Paint with these `keys`, over a model in the format of Wavefront, if there is any.
fn play(engine: &Engine, keys: &str, model: &'static str) -> Player {
    let ground = if model.is_empty() {
        ""
    } else {
        "[[object]]\nname = \"ground\"\nkind = \"mesh\"\nmodel = \"a.obj\"\n"
    };
    let toml = format!(
        "format = 1\ncamera = {{ eye = [0, 0, 5], target = [0, 0, 0] }}\n\
         time = {{ fps = 24, frames = [0, 1000] }}\n{ground}\
         [[object]]\nname = \"paint\"\nkind = \"paint\"\n{keys}"
    );
    let text = SceneText { name: "test", toml: &toml, ..Default::default() };
    let loaded = Scene::load(&text, &mut |_| Err("there are no styles".into()));
    let (scene, _) = loaded.unwrap_or_else(|report| panic!("{}", report.render(false)));
    engine.play(scene, Box::new(Model(model))).expect("the scene fits")
}

/// Radius and speed of every vertex at a frame.
fn vertices_at(engine: &Engine, player: &mut Player, frame: u32) -> Vec<[f32; 2]> {
    engine.seek(player, frame).expect("there are no files to miss");
    read_buffer(engine.gpu(), &player.paints.vertices).expect("the device lives")
}

fn bodies_at(engine: &Engine, player: &mut Player, frame: u32) -> Vec<Body> {
    engine.seek(player, frame).expect("there are no files to miss");
    read_buffer(engine.gpu(), &player.paints.bodies).expect("the device lives")
}
