//! `fumetto info`

mod json;
mod text;

use std::process::ExitCode;

use anyhow::Context as _;
use fumetto::Assets as _;
use fumetto_formats::{read_particles, sequence_path};
use fumetto_scene::limits::PARTICLE_BYTES;
use fumetto_scene::{Background, Light, LightKind, Matter, Scene};

use crate::args::InfoArgs;
use crate::console;
use crate::files::SceneFolder;
use crate::scene;

pub(crate) fn run(args: &InfoArgs) -> anyhow::Result<ExitCode> {
    let opened = scene::open(&args.scene)?;
    let name = args.scene.scene.display().to_string();
    let particles = particles(&opened.scene, &opened.folder).with_context(|| name.clone())?;
    let text = if args.json {
        json::of(&name, &opened.scene, &particles).to_string()
    } else {
        text::of(&name, &opened.scene, &particles)
    };
    console::print(&text)?;
    Ok(ExitCode::SUCCESS)
}

/// Most particles of each object at once; of a sequence of files those of the first.
fn particles(scene: &Scene, folder: &SceneFolder) -> anyhow::Result<Vec<u64>> {
    let costs = scene.requirements();
    let counts =
        scene.objects.iter().zip(costs).map(|(object, cost)| match (&object.matter, cost.particles) {
            (Matter::File(path), _) => {
                let path = sequence_path(path, scene.time.frames[0]);
                let bytes = folder.read(&path).with_context(|| format!("cannot read `{path}`"))?;
                Ok(read_particles(&path, &bytes)?.particles.len() as u64)
            }
            (_, known) => Ok(known.unwrap_or_default()),
        });
    counts.collect()
}

fn bytes(particles: u64) -> u64 {
    particles.saturating_mul(PARTICLE_BYTES)
}

fn duration_secs(scene: &Scene) -> f64 {
    let [first, last] = scene.time.frames;
    (f64::from(last - first) + 1.0) / f64::from(scene.time.fps)
}

/// Most particles of all objects together.
fn sum(particles: &[u64]) -> u64 {
    particles.iter().copied().fold(0, u64::saturating_add)
}

fn light_kind(light: &Light) -> &'static str {
    match light.kind {
        LightKind::Sun { .. } => "sun",
        LightKind::Point { .. } => "point",
    }
}

fn background(scene: &Scene) -> String {
    match &scene.background {
        Background::Transparent => "transparent".to_owned(),
        Background::Colour(colour) => hex(colour.to_srgb8()),
        Background::Gradient { top, bottom } => {
            format!("{} to {}", hex(top.to_srgb8()), hex(bottom.to_srgb8()))
        }
        Background::Image(path) => path.clone(),
    }
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
