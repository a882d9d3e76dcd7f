//! Strokes of smoke that moves: what they cost beside its surface, and how steady they are.

use std::time::{Duration, Instant};

use anyhow::Context as _;
use fumetto::{Assets, Engine, PICTURE_FORMAT, Player, Shot};

use crate::{
    flicker::{Ink, flicker},
    measure::{Budget, Samples, rounds},
    scene,
    subsystem::Subsystem,
};

pub(crate) const STROKES: Subsystem = Subsystem {
    name: "strokes",
    title: "smoke: its surface alone, and one picture of 1280 x 720 pixels without antialiasing",
    counted: "particles",
    sizes: &[200],
    variants: &["surface", "draw: none", "draw: plain", "draw: steady", "draw: boiling", "draw: naive"],
    measure,
};

/// A frame in which there is smoke, and how many from there on are held against each other.
const FIRST: u32 = 96;
const FRAMES: u32 = 8;

/// Pixels that smoke moves in a frame, at most.
const MOTION_PX: i64 = 7;

/// The smoke has no files.
struct Nothing;

impl Assets for Nothing {
    fn read(&self, _: &str) -> std::io::Result<Vec<u8>> {
        Err(std::io::ErrorKind::NotFound.into())
    }
}

struct Case {
    /// Whether making the surface is timed, and not the picture.
    is_surface: bool,
    player: Player,
    shot: Shot,
    target: wgpu::TextureView,
    frame: u32,
}

fn ink(variant: &str) -> Option<&'static str> {
    Some(match variant {
        "surface" | "draw: none" => "on = false",
        "draw: plain" => "method = \"vector\"",
        "draw: steady" => "stroke = { texture = \"brush\" }",
        "draw: boiling" => "stroke = { texture = \"brush\", boil = 4 }",
        // Each picture as if there were no other.
        "draw: naive" => "stroke = { texture = \"brush\", boil = 1 }",
        _ => return None,
    })
}

fn text(variant: &str, particles: u32) -> Option<String> {
    let ink = ink(variant)?;
    Some(format!(
        r##"
format = 1
seed = 5
[camera]
eye = [0.0, 2.6, 13.0]
target = [0.6, 2.75, 0.0]
fov = 30
[background]
colour = "#ffffff"
[output]
size = [1280, 720]
antialias = 1
[style]
tones = ["#ffffff"]
clean = {{ px = 0 }}
ink = {{ colour = "#000000", width = {{ px = 8 }}, lit_thinning = 0, {ink} }}
shadow = {{ on = false }}
[[object]]
name = "smoke"
kind = "smoke"
solver = "forces"
shape = {{ surface = {{ threshold = 0.35, subdivisions = 72, size = 1.15 }} }}
[object.emitter]
shape = {{ disc = {{ center = [-3.1, -0.9, 0.0], normal = [0, 1, 0], radius = 0.18 }} }}
count = {particles}
velocity = [0.2, 2.6, 0.0]
spread = 12
life = [6.0, 7.0]
radius = [0.16, 0.48]
radius_over_life = [[0.0, 0.8], [0.15, 1.1], [0.6, 2.1], [1.0, 2.7]]
[[object.force]]
kind = "buoyancy"
acceleration = 2.3
[[object.force]]
kind = "drag"
rate = 1.6
[[object.force]]
kind = "wind"
velocity = [1.15, 0.0, 0.0]
"##
    ))
}

fn measure(
    engine: &mut Engine,
    variants: &[&'static str],
    size: u32,
    budget: Budget,
) -> anyhow::Result<Vec<Samples>> {
    let cases = variants.iter().map(|variant| Case::new(engine, variant, size));
    let mut cases = cases.collect::<anyhow::Result<Vec<_>>>()?;
    let mut samples = rounds(&mut cases, budget, |case| case.time(engine))?;
    for ((variant, case), samples) in variants.iter().zip(&mut cases).zip(&mut samples) {
        if variant.starts_with("draw") && *variant != "draw: none" {
            samples.flicker = Some(case.flicker(engine)?);
        }
    }
    Ok(samples)
}

impl Case {
    fn new(engine: &Engine, variant: &str, particles: u32) -> anyhow::Result<Self> {
        let toml = text(variant, particles).context("there is no such variant")?;
        let mut player = engine.play(scene::load(variant, &toml)?, Box::new(Nothing))?;
        engine.seek(&mut player, FIRST)?;
        let shot = Shot::of(player.scene());
        let [width, height] = shot.size;
        let texture = engine.gpu().device.create_texture(&wgpu::TextureDescriptor {
            label: Some("bench.strokes.target"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: PICTURE_FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        let target = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Ok(Self { is_surface: variant == "surface", player, shot, target, frame: FIRST })
    }

    /// One more frame, and its picture; one of them is timed.
    fn time(&mut self, engine: &mut Engine) -> anyhow::Result<Duration> {
        self.frame += 1;
        let begin = Instant::now();
        engine.seek(&mut self.player, self.frame)?;
        engine.gpu().wait()?;
        if self.is_surface {
            return Ok(begin.elapsed());
        }
        // The first picture fetches textures that other variants had no use for.
        engine.draw(&self.player, &self.shot, &self.target)?;
        engine.gpu().wait()?;
        let begin = Instant::now();
        engine.draw(&self.player, &self.shot, &self.target)?;
        engine.gpu().wait()?;
        Ok(begin.elapsed())
    }

    fn ink(&self, engine: &mut Engine) -> anyhow::Result<Ink> {
        Ok(Ink::new(self.shot.size, &engine.picture(&self.player, &self.shot)?.pixels))
    }

    /// The mean over some frames.
    fn flicker(&mut self, engine: &mut Engine) -> anyhow::Result<f64> {
        let mut sum = 0.0;
        engine.seek(&mut self.player, FIRST)?;
        let mut before = self.ink(engine)?;
        for frame in FIRST + 1..=FIRST + FRAMES {
            engine.seek(&mut self.player, frame)?;
            let after = self.ink(engine)?;
            sum += flicker(&before, &after, MOTION_PX);
            before = after;
        }
        Ok(sum / f64::from(FRAMES))
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use fumetto::Gpu;

    use super::*;

    #[test]
    fn every_variant_is_a_good_scene() {
        for variant in STROKES.variants {
            let scene = scene::load(variant, &text(variant, 200).unwrap()).unwrap();
            assert!(scene.objects[0].shape.surface().is_some());
        }
    }

    #[test]
    fn steady_strokes_flicker_least_and_naive_ones_most() {
        let mut engine = Engine::new(pollster::block_on(Gpu::headless()).unwrap());
        let scores = ["draw: steady", "draw: boiling", "draw: naive"].map(|variant| {
            let mut case = Case::new(&engine, variant, 60).unwrap();
            case.shot.size = [640, 360];
            case.flicker(&mut engine).unwrap()
        });
        let [steady, boiling, naive] = scores;
        assert!(steady < 0.97 * boiling && boiling < 0.9 * naive, "{scores:?}");
    }
}
