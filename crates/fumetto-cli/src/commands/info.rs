//! `fumetto info`

use std::process::ExitCode;

use anyhow::Context as _;
use fumetto::Assets as _;
use fumetto_formats::{is_sequence, read_particles, sequence_path};
use fumetto_scene::limits::PARTICLE_BYTES;
use fumetto_scene::{Background, Light, LightKind, Matter, Object, Ramp, Scene, Shading, Style, Width};
use indicatif::{BinaryBytes, HumanCount};
use serde_json::{Value, json};

use crate::args::InfoArgs;
use crate::console;
use crate::files::SceneFolder;
use crate::scene;

pub(crate) fn run(args: &InfoArgs) -> anyhow::Result<ExitCode> {
    let opened = scene::open(&args.scene)?;
    let name = args.scene.scene.display().to_string();
    let particles = particles(&opened.scene, &opened.folder).with_context(|| name.clone())?;
    let text = if args.json {
        as_json(&name, &opened.scene, &particles).to_string()
    } else {
        as_text(&name, &opened.scene, &particles)
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

fn as_text(name: &str, scene: &Scene, particles: &[u64]) -> String {
    let ([width, height], samples) = (scene.output.size, scene.output.antialias);
    let ([first, last], time) = (scene.time.frames, &scene.time);
    let cameras: Vec<&str> = scene.cameras.iter().map(|camera| camera.name.as_str()).collect();
    let lights: Vec<String> = scene.lights.iter().map(light_words).collect();
    let lights = if lights.is_empty() { "none".to_owned() } else { lights.join(", ") };
    let mut lines = vec![
        name.to_owned(),
        format!("  picture     {width} x {height} pixels, {samples} x {samples} samples each"),
        format!("  frames      {first} to {last}, {} a second: {:.1} s", time.fps, duration_secs(scene)),
        format!("  drawn       every {}, simulated in {}", counted(time.hold, "frame"), steps(time.substeps)),
        format!("  cameras     {}", cameras.join(", ")),
        format!("  lights      {lights}"),
        format!("  background  {}", background(scene)),
    ];
    for (object, &particles) in scene.objects.iter().zip(particles) {
        lines.push(format!(
            "  `{}`: {}{}",
            object.name,
            matter(object),
            if object.visible { "" } else { ", hidden" }
        ));
        lines.push(format!("    particles {}", cost(particles)));
        lines.push(format!("    style     {}", style_words(&object.style)));
    }
    lines.push(format!("  in all      {}", cost(sum(particles))));
    lines.join("\n")
}

fn sum(particles: &[u64]) -> u64 {
    particles.iter().copied().fold(0, u64::saturating_add)
}

fn cost(particles: u64) -> String {
    format!("at most {} at once, {} on the GPU", HumanCount(particles), BinaryBytes(bytes(particles)))
}

fn counted(number: u32, what: &str) -> String {
    if number == 1 { what.to_owned() } else { format!("{number} {what}s") }
}

fn steps(substeps: u32) -> String {
    if substeps == 1 { "1 step a frame".to_owned() } else { format!("{substeps} steps a frame") }
}

fn light_words(light: &Light) -> String {
    let shadows = if light.shadow { "" } else { " without shadows" };
    format!("{}{shadows}", light_kind(light))
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

fn matter(object: &Object) -> String {
    match &object.matter {
        Matter::Still(_) => "particles in the scene file".to_owned(),
        Matter::File(path) if is_sequence(path) => format!("particles in {path}, by frame"),
        Matter::File(path) => format!("particles in {path}"),
        Matter::Smoke(smoke) => {
            let counted =
                |number: usize, what: &str| format!("{number} {what}{}", if number == 1 { "" } else { "s" });
            let (emitters, forces) =
                (counted(smoke.emitters.len(), "emitter"), counted(smoke.forces.len(), "force"));
            format!("smoke of {emitters}, moved by {forces}")
        }
    }
}

fn style_words(style: &Style) -> String {
    let tones = match &style.ramp {
        Ramp::Tones(tones) => {
            let colours: Vec<String> = tones.iter().map(|tone| hex(tone.colour.to_srgb8())).collect();
            format!("tones {}", colours.join(" "))
        }
        Ramp::Image(path) => format!("ramp {path}"),
    };
    let ink = match (style.ink.on, style.ink.width) {
        (false, _) => "no ink".to_owned(),
        (true, Width::Px(px)) => format!("ink {} {px} px wide", hex(style.ink.colour.to_srgb8())),
        (true, Width::World(metres)) => format!("ink {} {metres} m wide", hex(style.ink.colour.to_srgb8())),
    };
    format!("{tones}; {ink}; {}", if style.shadow.on { "shadows" } else { "no shadows" })
}

fn as_json(name: &str, scene: &Scene, particles: &[u64]) -> Value {
    let objects: Vec<Value> = scene
        .objects
        .iter()
        .zip(particles)
        .map(|(object, &particles)| object_json(object, particles))
        .collect();
    let lights: Vec<Value> = scene
        .lights
        .iter()
        .map(|light| json!({ "kind": light_kind(light), "intensity": light.intensity, "shadow": light.shadow }))
        .collect();
    json!({
        "scene": name,
        "size": scene.output.size,
        "antialias": scene.output.antialias,
        "frames": scene.time.frames,
        "fps": scene.time.fps,
        "seconds": duration_secs(scene),
        "hold": scene.time.hold,
        "substeps": scene.time.substeps,
        "cameras": scene.cameras.iter().map(|camera| camera.name.as_str()).collect::<Vec<_>>(),
        "lights": lights,
        "background": background(scene),
        "objects": objects,
        "particles": sum(particles),
        "bytes": bytes(sum(particles)),
    })
}

fn object_json(object: &Object, particles: u64) -> Value {
    let (kind, emitters, forces, file) = match &object.matter {
        Matter::Still(_) => ("cloud", 0, 0, None),
        Matter::File(path) => ("cloud", 0, 0, Some(path)),
        Matter::Smoke(smoke) => ("smoke", smoke.emitters.len(), smoke.forces.len(), None),
    };
    json!({
        "name": object.name,
        "kind": kind,
        "visible": object.visible,
        "emitters": emitters,
        "forces": forces,
        "file": file,
        "particles": particles,
        "bytes": bytes(particles),
        "style": style_json(&object.style),
    })
}

fn style_json(style: &Style) -> Value {
    let (tones, ramp) = match &style.ramp {
        Ramp::Tones(tones) => (tones.iter().map(|tone| hex(tone.colour.to_srgb8())).collect(), None),
        Ramp::Image(path) => (Vec::new(), Some(path)),
    };
    let shading = match style.shading {
        Shading::Auto => "auto",
        Shading::PerPixel => "per-pixel",
        Shading::PreShaded => "pre-shaded",
    };
    json!({
        "tones": tones,
        "ramp": ramp,
        "form": style.form,
        "shading": shading,
        "ink": style.ink.on.then(|| hex(style.ink.colour.to_srgb8())),
        "shadow": style.shadow.on,
    })
}
