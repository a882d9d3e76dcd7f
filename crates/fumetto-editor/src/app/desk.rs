//! Files: saving, what dialogs answer, what is dropped onto the window, and what a crash left.

use std::path::Path;

use egui::Context;
use fumetto_scene::edit::{Document, Edit, Item};

use super::{App, leaving::Goal};
use crate::autosave::Left;
use crate::dialogs::Purpose;
use crate::jobs::{Job, Work};
use crate::panels::output::{Asked, Usual};
use crate::project::Project;

impl App {
    /// Saves the scene where it lies, or asks where.
    pub(super) fn save_scene(&mut self, ctx: &Context) {
        match self.project.path().map(Path::to_owned) {
            Some(path) => self.save_as(&path),
            None => self.dialogs.ask(ctx, Purpose::Save, self.project.name()),
        }
    }

    fn save_as(&mut self, path: &Path) {
        match self.project.save(path) {
            Ok(()) => {
                self.refusal = None;
                self.settings.remember(path);
                self.autosave.forget();
            }
            Err(error) => self.refusal = Some(format!("{error:#}")),
        }
    }

    /// Does what the system's dialogs answered.
    pub(super) fn hear_dialogs(&mut self, ctx: &Context) {
        for (purpose, path) in self.dialogs.answers() {
            let Some(path) = path else {
                // Who gives the scene no name does not leave it either.
                self.leaving = None;
                continue;
            };
            match purpose {
                Purpose::Open => self.leave_for(Goal::File(path), ctx),
                Purpose::Save => self.save_as(&path),
                Purpose::Output => self.output.name(path),
                Purpose::Style => self.save_style(&path),
            }
        }
    }

    /// Takes what was dropped onto the window: a scene is opened, other files become part of the scene.
    pub(super) fn take_dropped(&mut self, ctx: &Context) {
        for file in ctx.input(|input| input.raw.dropped_files.clone()) {
            let path = file.path().to_owned();
            if has_extension(&path, "toml") {
                self.leave_for(Goal::File(path), ctx);
                continue;
            }
            let edit =
                self.named_from_scene(&path).and_then(|name| addition(self.project.document(), &path, &name));
            match edit {
                Ok(edit) => {
                    self.refusal = self.project.edit(&edit, None).err().map(|error| error.to_string());
                }
                Err(message) => self.refusal = Some(message),
            }
        }
    }

    /// What the scene calls a file: as it is found from the scene's folder.
    fn named_from_scene(&self, path: &Path) -> Result<String, String> {
        let folder = self.project.path().and_then(Path::parent);
        let name = folder.and_then(|folder| path.strip_prefix(folder).ok()).unwrap_or(path);
        let name = name.to_str().ok_or_else(|| format!("{} cannot be written in a scene", path.display()))?;
        Ok(name.replace('\\', "/"))
    }

    /// Writes the scene's style as a file that other scenes can name.
    fn save_style(&mut self, path: &Path) {
        use std::io::Write as _;
        let style = self.project.document().get(&fumetto_scene::edit::Path::root().key("style"));
        let text = style.map_or_else(String::new, |style| style.to_string());
        let written = fumetto_disk::write(path, |draft| draft.write_all(text.as_bytes()));
        self.refusal = written.err().map(|error| format!("{error:#}"));
    }

    /// Keeps what is not saved, for the case of a crash.
    pub(super) fn keep_safe(&mut self, ctx: &Context) {
        let document = self.project.document();
        if !document.is_changed() {
            self.autosave.forget();
            return;
        }
        match self.autosave.keep(document.revision(), self.project.path(), document.text()) {
            // Nobody may touch anything until then.
            Ok(Some(wait)) => ctx.request_repaint_after(wait),
            Ok(None) => {}
            Err(error) => {
                self.refusal =
                    Some(format!("what is not saved cannot be kept for the case of a crash: {error:#}"));
            }
        }
    }

    /// Offers what an editor left that ended unexpectedly.
    pub(super) fn recovery_ui(&mut self, ctx: &Context) {
        let Some(left) = self.left.first().cloned() else { return };
        let name = left
            .path
            .as_ref()
            .map_or_else(|| "A scene that was never saved".into(), |path| path.display().to_string());
        let mut wanted = None;
        egui::Modal::new(egui::Id::unique("recovery")).show(ctx, |ui| {
            ui.heading("Go on with unsaved work?");
            ui.label(format!("{name} had changes when the editor ended unexpectedly."));
            ui.add_space(8.0);
            ui.horizontal(|ui| {
                for (name, what) in [("Recover", true), ("Throw away", false)] {
                    if ui.button(name).clicked() {
                        wanted = Some(what);
                    }
                }
            });
        });
        let Some(wanted) = wanted else { return };
        if wanted {
            self.recover(&left);
        }
        left.forget();
        self.left.remove(0);
    }

    fn recover(&mut self, left: &Left) {
        match Project::recovered(left.path.as_deref(), left.text.clone()) {
            Ok(project) => self.show(project),
            Err(error) => self.refusal = Some(format!("{error:#}")),
        }
    }

    /// Opens the window for renderings (`work`) and exports.
    pub(super) fn order(&mut self, work: Work) {
        let Some(scene) = self.project.scene() else { return };
        let path = self.project.path().map_or_else(|| self.project.name().into(), Path::to_owned);
        let (frame, frames, output) = (self.clock.frame(), scene.time.frames, scene.output);
        self.output.open(work, &Usual { scene: &path, frame, frames, output });
    }

    /// The window for renderings and exports, and what is under way.
    pub(super) fn output_ui(&mut self, ctx: &Context) {
        self.jobs.iter_mut().for_each(Job::hear);
        match self.output.ui(ctx, &mut self.jobs) {
            Some(Asked::Name(name)) => self.dialogs.ask(ctx, Purpose::Output, &name),
            Some(Asked::Start(order)) => match Job::start(order, &self.project, ctx) {
                Ok(job) => self.jobs.push(job),
                Err(error) => self.refusal = Some(format!("{error:#}")),
            },
            None => {}
        }
    }
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(extension))
}

/// The edit that takes a file into a scene, as what it is.
fn addition(document: &Document, path: &Path, name: &str) -> Result<Edit, String> {
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    let quoted = toml_string(name);
    let (kind, key) = match extension.as_str() {
        "glb" | "gltf" | "obj" => ("mesh", "model"),
        "vdb" | "nrrd" | "npy" => ("volume", "volume"),
        "csv" | "ply" => ("cloud", "particles"),
        "png" => {
            let path = fumetto_scene::edit::Path::root().key("background").key("image");
            return Ok(Edit::Set { path, value: name.into() });
        }
        _ => return Err(format!("{}: no scene can have such a file", path.display())),
    };
    let called = toml_string(&path.file_stem().unwrap_or_default().to_string_lossy());
    let text = format!("[[object]]\nname = {called}\nkind = \"{kind}\"\n{key} = {quoted}\n");
    let list = fumetto_scene::edit::Path::root().key("object");
    let index = document.count(&list);
    Ok(Edit::Insert { list, index, item: Item::Snippet(text) })
}

fn toml_string(text: &str) -> String {
    fumetto_scene::edit::Value::from(text).to_string()
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;

    fn added(path: &str) -> Result<String, String> {
        let mut document = Document::open("format = 1\n").unwrap();
        let edit = addition(&document, Path::new(path), path)?;
        document.apply(&edit).map_err(|error| error.to_string())?;
        Ok(document.text().to_owned())
    }

    #[test]
    fn dropped_files_become_what_they_are() {
        assert!(added("a \"b\".GLB").unwrap().contains("kind = \"mesh\"\nmodel = 'a \"b\".GLB'"));
        assert!(added("storm.csv").unwrap().contains("particles = \"storm.csv\""));
        assert!(added("burst.vdb").unwrap().contains("kind = \"volume\"\nvolume = \"burst.vdb\""));
        assert!(added("sky.png").unwrap().contains("image = \"sky.png\""));
        assert!(added("letter.docx").unwrap_err().contains("letter.docx"));
    }
}
