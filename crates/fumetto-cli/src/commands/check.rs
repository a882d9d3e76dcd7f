//! `fumetto check`

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::process::ExitCode;

use anyhow::Context as _;
use fumetto::{Assets as _, imported_size};
use fumetto_formats::{
    FormatError, ModelOptions, is_sequence, read_model, read_particles, read_png, sequence_path,
};
use fumetto_scene::{
    Background, Imported, Ink, Matter, Mesh, Object, Ramp, RampImage, Report, Scene, StrokeTexture, Time,
};

use crate::args::CheckArgs;
use crate::console;
use crate::scene::{self, Opened};
use fumetto_disk::SceneFolder;

/// Broken files that are told of one sequence: whoever misses one frame often misses all.
const PROBLEMS_A_SEQUENCE: usize = 3;

pub(crate) fn run(args: &CheckArgs) -> anyhow::Result<ExitCode> {
    let opened = match scene::load(&args.scene) {
        Ok(opened) => opened,
        Err(error) => {
            let report: Report = error.downcast()?;
            console::print(&report.render(console::stdout_is_coloured()))?;
            return Ok(ExitCode::FAILURE);
        }
    };
    let problems = check_files(&opened);
    if !opened.report.is_empty() {
        console::print(&opened.report.render(console::stdout_is_coloured()))?;
    }
    for problem in &problems {
        console::print(&format!("error: {}: {problem}", args.scene.scene.display()))?;
    }
    if !problems.is_empty() {
        return Ok(ExitCode::FAILURE);
    }
    if opened.report.is_empty() {
        console::print("no problems")?;
    }
    Ok(ExitCode::SUCCESS)
}

/// What is wrong with the files that the scene names.
fn check_files(opened: &Opened) -> Vec<String> {
    let Opened { scene, folder, .. } = opened;
    let mut problems = Vec::new();
    let mut note = |whose: String, result: anyhow::Result<()>| {
        if let Err(error) = result {
            problems.push(format!("{whose}: {error:#}"));
        }
    };
    for object in &scene.objects {
        match &object.matter {
            Matter::File(path) => {
                for result in check_particles(folder, path, &scene.time) {
                    note(format!("the particles of `{}`", object.name), result);
                }
            }
            Matter::Morph(morph) => {
                for path in morph.all().filter_map(fumetto_scene::Given::file) {
                    note(format!("the particles of `{}`", object.name), check_one(folder, path));
                }
            }
            Matter::Mesh(mesh) => {
                note(format!("the model of `{}`", object.name), check_model(folder, mesh));
            }
            Matter::Imported(imported) => {
                for result in check_volume(folder, imported, &scene.time) {
                    note(format!("the volume of `{}`", object.name), result);
                }
            }
            Matter::Still(_) | Matter::Smoke(_) | Matter::Paint(_) => {}
        }
    }
    for (ramp, objects) in ramps(scene) {
        note(format!("the ramp of {objects}"), check_picture(folder, ramp));
    }
    for (path, object) in stroke_textures(scene) {
        note(format!("the strokes of `{object}`"), check_picture(folder, path));
    }
    if let Background::Image(path) = &scene.background {
        note("the background".to_owned(), check_picture(folder, path));
    }
    problems
}

/// Pictures that strokes are drawn with, and the first object that names each.
fn stroke_textures(scene: &Scene) -> BTreeMap<&str, &str> {
    let mut textures = BTreeMap::new();
    for object in &scene.objects {
        for stroke in Object::inks(object).flat_map(Ink::strokes) {
            if let StrokeTexture::File(path) = &stroke.texture {
                textures.entry(path.as_str()).or_insert(object.name.as_str());
            }
        }
    }
    textures
}

/// Reads the particle file `path`, or as many of its sequence as the scene's frames show.
fn check_particles(folder: &SceneFolder, path: &str, time: &Time) -> Vec<anyhow::Result<()>> {
    if !is_sequence(path) {
        return vec![check_one(folder, path)];
    }
    let [first, last] = time.frames;
    // A drawing is held from the last multiple of `hold` on.
    let drawings = (first - first % time.hold..=last).step_by(time.hold as usize);
    let results = drawings.map(|frame| check_one(folder, &sequence_path(path, frame)));
    results.filter(Result::is_err).take(PROBLEMS_A_SEQUENCE).collect()
}

fn check_one(folder: &SceneFolder, path: &str) -> anyhow::Result<()> {
    check(folder, path, |bytes| read_particles(path, bytes).map(drop))
}

/// Reads a volume's file, or as many of its sequence as the scene's frames show.
fn check_volume(folder: &SceneFolder, imported: &Imported, time: &Time) -> Vec<anyhow::Result<()>> {
    let one = |frame: u32| imported_size(folder, imported, frame).map(drop).map_err(anyhow::Error::from);
    let [first, last] = time.frames;
    if !is_sequence(&imported.file) {
        return vec![one(first)];
    }
    let drawings = (first - first % time.hold..=last).step_by(time.hold as usize);
    let mut numbers = BTreeSet::new();
    let others = drawings.filter(|&frame| numbers.insert(imported.number_at(frame)));
    others.map(one).filter(Result::is_err).take(PROBLEMS_A_SEQUENCE).collect()
}

fn check_model(folder: &SceneFolder, mesh: &Mesh) -> anyhow::Result<()> {
    let options = ModelOptions { smooth_degrees: mesh.smooth_deg };
    check(folder, &mesh.model, |bytes| {
        read_model(&mesh.model, bytes, options, &mut |beside| folder.read(beside)).map(drop)
    })
}

fn check_picture(folder: &SceneFolder, path: &str) -> anyhow::Result<()> {
    check(folder, path, |bytes| read_png(path, bytes).map(drop))
}

fn check(
    folder: &SceneFolder,
    path: &str,
    read: impl Fn(&[u8]) -> Result<(), FormatError>,
) -> anyhow::Result<()> {
    let bytes: Result<Vec<u8>, io::Error> = folder.read(path);
    let bytes = bytes.with_context(|| format!("cannot read `{path}`"))?;
    Ok(read(&bytes)?)
}

/// Every ramp picture once, and the objects that are drawn with it.
fn ramps(scene: &Scene) -> Vec<(&str, String)> {
    let mut ramps: Vec<(&str, String)> = Vec::new();
    for (index, object) in scene.objects.iter().enumerate() {
        let paths = scene.styles_of(index).filter_map(|style| match &style.ramp {
            Ramp::Image(RampImage { path, .. }) => Some(path),
            Ramp::Tones(_) | Ramp::Gooch(_) => None,
        });
        let name = format!("`{}`", object.name);
        for path in paths {
            match ramps.iter_mut().find(|(known, _)| known == path) {
                Some((_, objects)) if objects.ends_with(&name) => {}
                Some((_, objects)) => *objects += &format!(", {name}"),
                None => ramps.push((path, name.clone())),
            }
        }
    }
    ramps
}
