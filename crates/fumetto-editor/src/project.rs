//! What is edited: a scene file's text, what it means, and where it lies.

use fumetto_scene::edit::{Document, Edit, EditError};
use fumetto_scene::{Report, Scene, SceneText, StyleChoice};

use crate::files::Files;

/// A scene file that is open.
pub(crate) struct Project {
    document: Document,
    /// What it is called in titles and messages.
    name: String,
    /// Where it is saved to without asking.
    #[cfg(not(target_arch = "wasm32"))]
    path: Option<std::path::PathBuf>,
    /// What the file said when it was last read or written here.
    #[cfg(not(target_arch = "wasm32"))]
    on_disk: Option<String>,
    pub(crate) files: Files,
    /// What the text means, where it means anything.
    scene: Option<Scene>,
    report: Report,
}

impl Project {
    /// A scene that lies nowhere yet.
    pub(crate) fn new(name: impl Into<String>, text: String, files: Files) -> Result<Self, EditError> {
        let mut project = Self {
            document: Document::open(text)?,
            name: name.into(),
            #[cfg(not(target_arch = "wasm32"))]
            path: None,
            #[cfg(not(target_arch = "wasm32"))]
            on_disk: None,
            files,
            scene: None,
            report: Report::default(),
        };
        project.check();
        Ok(project)
    }

    pub(crate) fn document(&self) -> &Document {
        &self.document
    }

    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// The scene, unless something is wrong with it.
    pub(crate) fn scene(&self) -> Option<&Scene> {
        self.scene.as_ref()
    }

    /// All that is wrong with the scene.
    pub(crate) fn report(&self) -> &Report {
        &self.report
    }

    /// Does an edit; one of a `gesture` joins those before it.
    pub(crate) fn edit(&mut self, edit: &Edit, gesture: Option<&str>) -> Result<(), EditError> {
        let before = self.document.revision();
        let done = match gesture {
            Some(gesture) => self.document.apply_during(gesture, edit),
            None => self.document.apply(edit),
        };
        if self.document.revision() != before {
            self.check();
        }
        done
    }

    pub(crate) fn end_gesture(&mut self) {
        self.document.end_gesture();
    }

    pub(crate) fn undo(&mut self) {
        if self.document.undo() {
            self.check();
        }
    }

    pub(crate) fn redo(&mut self) {
        if self.document.redo() {
            self.check();
        }
    }

    /// The scene, drawn in a ready-made style.
    pub(crate) fn in_style(&self, preset: &str) -> Option<Scene> {
        let style = Some(StyleChoice::Preset(preset));
        let text = SceneText { name: &self.name, toml: self.document.text(), style, ..SceneText::default() };
        Some(Scene::load(&text, &mut |path| self.files.text(path)).ok()?.0)
    }

    /// Reads the text anew, and whatever files it names.
    pub(crate) fn check(&mut self) {
        let text = SceneText { name: &self.name, toml: self.document.text(), ..SceneText::default() };
        let files = &self.files;
        match Scene::load(&text, &mut |path| files.text(path)) {
            Ok((scene, report)) => (self.scene, self.report) = (Some(scene), report),
            Err(report) => (self.scene, self.report) = (None, report),
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl Project {
    /// Opens a scene file.
    pub(crate) fn open(path: &std::path::Path) -> anyhow::Result<Self> {
        use anyhow::Context as _;
        let shown = || format!("cannot open {}", path.display());
        let text = fumetto_disk::read_text(path).with_context(shown)?;
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        let mut project = Self::new(name, text, Files::beside(path)).with_context(shown)?;
        project.path = Some(path.to_owned());
        project.on_disk = Some(project.document.text().to_owned());
        Ok(project)
    }

    /// A scene with changes that were never saved; `path` is where it lies without them.
    pub(crate) fn recovered(path: Option<&std::path::Path>, text: String) -> anyhow::Result<Self> {
        let mut project = match path {
            Some(path) if path.exists() => Self::open(path)?,
            _ => Self::new("recovered.toml", String::new(), Files::default())?,
        };
        project.edit(&Edit::ReplaceText(text), None)?;
        Ok(project)
    }

    /// Where it is saved to without asking.
    pub(crate) fn path(&self) -> Option<&std::path::Path> {
        self.path.as_deref()
    }

    /// Saves it as `path`, with those of its files that are on no disk yet. The file that was there stays until the new
    /// one is whole.
    pub(crate) fn save(&mut self, path: &std::path::Path) -> anyhow::Result<()> {
        use std::io::Write as _;
        self.check_others(path)?;
        let folder = path.parent().unwrap_or(std::path::Path::new(""));
        for (name, bytes) in self.files.in_memory() {
            let place = folder.join(name);
            if self.document.text().contains(name) && !place.exists() {
                fumetto_disk::write(&place, |draft| draft.write_all(bytes))?;
            }
        }
        fumetto_disk::write(path, |draft| draft.write_all(self.document.text().as_bytes()))?;
        self.document.mark_saved();
        self.on_disk = Some(self.document.text().to_owned());
        self.path = Some(path.to_owned());
        self.name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        self.check();
        Ok(())
    }

    /// Refuses once to write over what another program has made of the scene's own file.
    fn check_others(&mut self, path: &std::path::Path) -> anyhow::Result<()> {
        let is_own = self.path.as_deref() == Some(path);
        let Ok(now) = fumetto_disk::read_text(path) else { return Ok(()) };
        if is_own && self.on_disk.as_ref().is_some_and(|known| *known != now) {
            // Whoever saves once more has been told.
            self.on_disk = Some(now);
            anyhow::bail!(
                "{} was changed by another program meanwhile; save under another name, or save once more to write over it",
                path.display()
            );
        }
        Ok(())
    }
}
