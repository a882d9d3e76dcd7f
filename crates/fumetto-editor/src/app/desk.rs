//! Files: saving, what dialogs answer, and what is dropped onto the window.

use std::path::Path;

use egui::Context;
use fumetto_scene::edit::{Document, Edit, Item, Table, Value};
use fumetto_scene::presets;

use super::{App, leaving::Goal};
use crate::dialogs::{Answer, Purpose};

impl App {
    /// Saves the scene where it lies, or asks where.
    pub(super) fn save_scene(&mut self, ctx: &Context) {
        match self.project.path().map(Path::to_owned) {
            Some(path) => self.save_as(&path),
            None => self.ask(Purpose::Save, self.project.name(), ctx),
        }
    }

    fn save_as(&mut self, path: &Path) {
        let before = self.project.files.folder().map(Path::to_owned);
        match self.project.save(path) {
            Ok(()) => {
                self.refusal = None;
                if let Some(path) = self.project.path() {
                    self.settings.remember(path);
                }
                self.autosave.forget();
                if self.project.files.folder() != before.as_deref() {
                    // What is still to be read comes from the new folder.
                    self.played = None;
                }
            }
            Err(error) => self.refusal = Some(format!("{error:#}")),
        }
    }

    /// Asks for a file in a window of the system's.
    pub(super) fn ask(&self, purpose: Purpose, name: &str, ctx: &Context) {
        self.dialogs.ask(ctx, purpose, self.project.id(), name);
    }

    /// Does what the system's dialogs answered.
    pub(super) fn hear_dialogs(&mut self, ctx: &Context) {
        for answer in self.dialogs.answers() {
            self.hear(answer, ctx);
        }
    }

    fn hear(&mut self, Answer { purpose, project, path }: Answer, ctx: &Context) {
        match (purpose, path) {
            (Purpose::Open, Some(path)) => self.leave_for(Goal::File(path), ctx),
            // The scene that it was asked for is no longer open.
            _ if project != self.project.id() => {}
            (Purpose::Save, Some(path)) => self.save_as(&path),
            // Who gives the scene no name does not leave it either.
            (Purpose::Save, None) => self.leaving = None,
            (Purpose::Output, Some(path)) => self.output.name(path),
            (Purpose::Style, Some(path)) => self.save_style(&path),
            (Purpose::Open | Purpose::Output | Purpose::Style, None) => {}
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
        let written = style_file(self.project.document()).and_then(|text| {
            fumetto_disk::write(path, |draft| draft.write_all(text.as_bytes()))
                .map_err(|error| format!("{error:#}"))
        });
        self.refusal = written.err();
    }
}

/// The scene's style as a file of its own.
fn style_file(document: &Document) -> Result<String, String> {
    let style = document.get(&fumetto_scene::edit::Path::root().key("style"));
    let mut table = match style {
        Some(Value::Table(table)) => table,
        _ => Table::new(),
    };
    if let Some(file) = table.get("file").and_then(Value::as_str) {
        return Err(format!(
            "the scene's style starts from {file}, and a style file cannot start from another; change that file, or start from a preset"
        ));
    }
    if table.is_empty() {
        table.insert("preset".into(), presets::names()[0].into());
    }
    Ok(table.to_string())
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
    Value::from(text).to_string()
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use std::fs;
    use std::path::PathBuf;
    use std::sync::Arc;

    use fumetto::Assets as _;
    use fumetto_scene::{Scene, SceneText};

    use super::*;
    use crate::examples::EXAMPLES;
    use crate::project::Project;
    use crate::settings::Settings;

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

    #[test]
    fn a_style_of_its_own_is_a_file_that_scenes_can_name() {
        let written = |scene: &str| style_file(&Document::open(scene).unwrap());
        let style = "style = { preset = \"comic\", tones = [\"#102030\", \"#ffffff\"], ink = { width = { px = 3.0 } } }\n";
        let objects = "[[object]]\nname = \"a\"\nkind = \"cloud\"\nparticles = [{ center = [0, 0, 0], radius = 1 }]\n[[light]]\nkind = \"sun\"\ndirection = [0, -1, -1]\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n";
        let load = |style: &str, file: &str| {
            let toml = format!("format = 1\n{style}{objects}");
            let text = SceneText { name: "a.toml", toml: &toml, ..SceneText::default() };
            let (scene, report) = Scene::load(&text, &mut |_| Ok(file.to_owned())).unwrap();
            assert!(report.is_empty(), "{report}");
            scene.objects[0].style.clone()
        };
        let named = "style = { file = \"my.style.toml\" }\n";
        assert_eq!(load(named, &written(style).unwrap()), load(style, ""));
        assert_eq!(
            load(named, &written("format = 1\n").unwrap()),
            load("", ""),
            "the usual style is one, too"
        );
        assert!(written(named).unwrap_err().contains("my.style.toml"));
    }

    /// An editor without a device, with a scene that was changed.
    fn editor(folder: &Path) -> App {
        let mut app = App::with(Settings::default(), None, folder);
        app.project.edit(&Edit::ReplaceText("format = 1\n".to_owned()), None).unwrap();
        app
    }

    #[test]
    fn an_answer_for_a_scene_that_has_gone_does_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let mut app = editor(folder.path());
        let place = folder.path().join("a.toml");
        let answer = |project| Answer { purpose: Purpose::Save, project, path: Some(place.clone()) };
        let old = app.project.id();
        app.show(Project::example(&EXAMPLES[1]).unwrap());
        app.hear(answer(old), &Context::default());
        assert!(!place.exists());
        app.hear(answer(app.project.id()), &Context::default());
        assert!(place.exists());
    }

    #[test]
    fn what_its_user_likes_outlasts_a_scene() {
        let folder = tempfile::tempdir().unwrap();
        let settings = Settings { looping: false, ..Settings::default() };
        let mut app = App::with(settings, None, folder.path());
        let place = folder.path().join("a.toml");
        fs::write(&place, "format = 1\n").unwrap();
        app.show(Project::open(&place).unwrap());
        assert_eq!(app.settings.recent, [place]);
        assert!(!app.settings.looping);
    }

    #[test]
    fn only_who_gives_the_scene_no_name_stays() {
        let folder = tempfile::tempdir().unwrap();
        let mut app = editor(folder.path());
        let ctx = Context::default();
        app.leave_for(Goal::New, &ctx);
        let project = app.project.id();
        app.hear(Answer { purpose: Purpose::Output, project, path: None }, &ctx);
        assert!(app.leaving.is_some());
        app.hear(Answer { purpose: Purpose::Save, project, path: None }, &ctx);
        assert!(app.leaving.is_none());
    }

    #[derive(Debug)]
    struct Dropped(PathBuf);

    impl egui::DroppedFile for Dropped {
        fn path(&self) -> &Path {
            &self.0
        }

        fn bytes(&self) -> Result<Vec<u8>, String> {
            fs::read(&self.0).map_err(|error| error.to_string())
        }
    }

    #[test]
    fn what_is_dropped_onto_a_scene_that_lies_nowhere_is_found() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("a.csv");
        fs::write(&place, "x,y,z,radius\n0,0,0,1\n").unwrap();
        let mut app = editor(folder.path());
        let ctx = Context::default();
        let mut input = egui::RawInput::default();
        input.dropped_files.push(Arc::new(Dropped(place.clone())));
        let mut shown = ctx.run_ui(input, |ui| app.take_dropped(ui.ctx()));
        shown.textures_delta.clear();
        assert!(app.project.document().text().contains("a.csv"), "{:?}", app.refusal);
        assert!(app.project.files.read(place.to_str().unwrap()).is_ok());
    }
}
