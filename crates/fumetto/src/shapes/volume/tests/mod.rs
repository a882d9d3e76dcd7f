//! Fields, light and rays against closed forms, on whatever adapter there is.

mod bricks;
mod light;
mod noise;
mod rays;

use std::{
    io,
    sync::{LazyLock, Mutex, PoisonError},
};

use fumetto_scene::{Scene, SceneText};
use glam::{UVec3, Vec3};
use half::f16;

use super::{March, field::Field};
use crate::{
    Assets, Engine, Gpu, Player,
    gpu::{Frame, Region, TexturePool, View, read_buffer, read_texture},
    layers::Layers,
    light::LightsUniform,
    shapes::puffs::Subject,
};

/// Making pipelines takes longer than most tests do: they share them.
static BENCH: LazyLock<Mutex<Bench>> = LazyLock::new(|| {
    let engine = Engine::new(pollster::block_on(Gpu::headless()).expect("a Vulkan driver"));
    let march = March::new(engine.gpu());
    Mutex::new(Bench { engine, march, pool: TexturePool::default() })
});

struct Bench {
    engine: Engine,
    march: March,
    pool: TexturePool,
}

/// No scene here names a file.
struct NoFiles;

impl Assets for NoFiles {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// Sides of the picture.
const SIDE: u32 = 64;

/// Distance of the camera from the origin, in metres; half of what it sees there is as wide.
const AWAY: f32 = 4.0;

/// What a camera sees of a volume: linear colour times opacity, and opacity.
type Soft = Vec<[f32; 4]>;

/// Seen along -z, by its own light of 1 beside that of `lights`.
fn play(bench: &Bench, lights: &str, particles: &str, volume: &str) -> Player {
    let toml = format!(
        "format = 1\ncamera = {{ eye = [0, 0, {AWAY}], target = [0, 0, 0], fov = 53.130102, near = 0.01 }}\n\
         light = [{lights}]\nobject = [{{ name = \"puff\", kind = \"cloud\", particles = [{particles}],\n\
         shape = {{ volume = {{ soft = 1, {volume} }} }} }}]"
    );
    let text = SceneText { name: "test", toml: &toml, ..Default::default() };
    let (scene, _) = Scene::load(&text, &mut |_| Err("there are no styles".into()))
        .unwrap_or_else(|report| panic!("{}", report.render(false)));
    let mut player = bench.engine.play(scene, Box::new(NoFiles)).expect("the scene can be played");
    bench.engine.seek(&mut player, 0).expect("there is a frame 0");
    player
}

fn marched(bench: &Bench, player: &Player) -> Soft {
    marched_in(bench, player, Region::whole([SIDE; 2]))
}

/// A part of the picture.
fn marched_in(bench: &Bench, player: &Player, region: Region) -> Soft {
    let gpu = bench.engine.gpu();
    let mut frame = Frame::new(gpu, &bench.pool, "test");
    let view = View::new(&player.scene().cameras[0], region);
    let view = frame.uniform("test.view", &view.uniform);
    let lights = frame.uniform("test.lights", &LightsUniform::of(player.scene()));
    let subject =
        Subject { scene: &player.puffs, meshes: &player.meshes, view: &view, lights: &lights, pens: &view };
    let mut layers = Layers::new(&frame, region.size);
    layers.begin(&mut frame, None);
    bench.march.record(&mut frame, subject, (&player.volumes, &[0]), &mut layers);
    frame.submit();
    halves(gpu, layers.soft.texture())
}

/// What is seen of `particles` in a part of the picture.
fn seen_in(region: Region, particles: &str, volume: &str) -> Soft {
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    marched_in(&bench, &play(&bench, "", particles, volume), region)
}

/// What is seen of `particles`.
fn seen(particles: &str, volume: &str) -> Soft {
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    marched(&bench, &play(&bench, "", particles, volume))
}

fn halves(gpu: &Gpu, texture: &wgpu::Texture) -> Vec<[f32; 4]> {
    let bytes = read_texture(gpu, texture).expect("the device lives");
    let half = |texel: &[u8], at: usize| f16::from_le_bytes([texel[2 * at], texel[2 * at + 1]]).to_f32();
    bytes.chunks_exact(8).map(|texel| [0, 1, 2, 3].map(|at| half(texel, at))).collect()
}

/// A texture of a field, read back.
struct Grid {
    origin: Vec3,
    cell_m: f32,
    cells: UVec3,
    texels: Vec<[f32; 4]>,
}

/// The density, and the light.
fn grids(gpu: &Gpu, field: &Field) -> [Grid; 2] {
    let Field::Cells(field) = field else { panic!("they are of puffs") };
    let words: Vec<u32> = read_buffer(gpu, &field.grid).expect("the device lives");
    let float = |at: usize| f32::from_bits(words[at]);
    let cells = |at: usize| UVec3::new(words[at], words[at + 1], words[at + 2]);
    let origin = Vec3::new(float(0), float(1), float(2));
    [
        Grid { origin, cell_m: float(3), cells: cells(4), texels: halves(gpu, &field.density) },
        Grid { origin, cell_m: float(7), cells: cells(8), texels: halves(gpu, &field.transmitted) },
    ]
}

impl Grid {
    fn texel(&self, at: UVec3) -> [f32; 4] {
        self.texels[((at.z * self.cells.y + at.y) * self.cells.x + at.x) as usize]
    }

    /// Between the middles of cells.
    fn density(&self, place: Vec3) -> f32 {
        let at = (place - self.origin) / self.cell_m - 0.5;
        let part = at - at.floor();
        let corner = |index: u32| {
            let step = UVec3::new(index & 1, (index >> 1) & 1, index >> 2);
            let cell = (at.floor() + step.as_vec3()).clamp(Vec3::ZERO, self.cells.as_vec3() - 1.0);
            let weight = Vec3::select(step.cmpeq(UVec3::ONE), part, 1.0 - part);
            weight.element_product() * self.texel(cell.as_uvec3())[3]
        };
        (0..8).map(corner).sum()
    }

    fn middle(&self, cell: UVec3) -> Vec3 {
        self.origin + (cell.as_vec3() + 0.5) * self.cell_m
    }
}
