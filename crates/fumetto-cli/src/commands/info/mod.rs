//! `fumetto info`

mod json;
mod text;

use std::process::ExitCode;

use anyhow::Context as _;
use fumetto::Assets as _;
use fumetto_formats::{ModelOptions, read_model, read_particles, sequence_path};
use fumetto_scene::limits::PARTICLE_BYTES;
use fumetto_scene::{Background, Light, LightKind, Matter, Scene};

use crate::args::InfoArgs;
use crate::console;
use crate::files::SceneFolder;
use crate::scene;

pub(crate) fn run(args: &InfoArgs) -> anyhow::Result<ExitCode> {
    let opened = scene::open(&args.scene)?;
    let name = args.scene.scene.display().to_string();
    let loads = loads(&opened.scene, &opened.folder).with_context(|| name.clone())?;
    let text = if args.json {
        json::of(&name, &opened.scene, &loads).to_string()
    } else {
        text::of(&name, &opened.scene, &loads)
    };
    console::print(&text)?;
    Ok(ExitCode::SUCCESS)
}

/// How much one object holds.
#[derive(Clone, Copy, Default)]
struct Load {
    /// Most of them at once; of a sequence of files those of the first.
    particles: u64,
    /// Copies counted singly.
    triangles: u64,
}

/// What each object holds.
fn loads(scene: &Scene, folder: &SceneFolder) -> anyhow::Result<Vec<Load>> {
    let read = |path: &str| folder.read(path).with_context(|| format!("cannot read `{path}`"));
    let loads = scene.objects.iter().zip(scene.requirements()).map(|(object, cost)| match &object.matter {
        Matter::File(path) => {
            let path = sequence_path(path, scene.time.frames[0]);
            let particles = read_particles(&path, &read(&path)?)?.particles.len() as u64;
            Ok(Load { particles, triangles: 0 })
        }
        Matter::Mesh(mesh) => {
            let options = ModelOptions { smooth_degrees: mesh.smooth_deg };
            let bytes = read(&mesh.model)?;
            let model = read_model(&mesh.model, &bytes, options, &mut |beside| folder.read(beside))?;
            Ok(Load { particles: 0, triangles: model.triangle_count() * mesh.copies.len() as u64 })
        }
        Matter::Still(_) | Matter::Smoke(_) => {
            Ok(Load { particles: cost.particles.unwrap_or_default(), triangles: 0 })
        }
    });
    loads.collect()
}

fn bytes(particles: u64) -> u64 {
    particles.saturating_mul(PARTICLE_BYTES)
}

fn duration_secs(scene: &Scene) -> f64 {
    let [first, last] = scene.time.frames;
    (f64::from(last - first) + 1.0) / f64::from(scene.time.fps)
}

/// All objects together.
fn sum(loads: &[Load]) -> Load {
    loads.iter().fold(Load::default(), |sum, load| Load {
        particles: sum.particles.saturating_add(load.particles),
        triangles: sum.triangles.saturating_add(load.triangles),
    })
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
