//! What is edited: a scene file's text, what it means, and where it lies.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use anyhow::Context as _;
use fumetto_scene::edit::{Document, Edit, EditError};
use fumetto_scene::{Report, Scene, SceneText, StyleChoice};

use crate::examples::{EXAMPLES, Example};
use crate::files::Files;

/// Where a scene comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// It lies nowhere yet.
    New,
    /// It lies nowhere either; this is the example's name.
    Example(String),
    /// It is saved there without asking.
    File(PathBuf),
}

/// A scene that is open.
pub struct Project {
    /// Tells it from every other that was open before, be it the same file.
    id: u64,
    document: Document,
    /// What it is called in titles and messages.
    name: String,
    origin: Origin,
    /// What the file said when it was last read or written here.
    on_disk: Option<String>,
    pub(crate) files: Files,
    /// What the text means, where it means anything.
    scene: Option<Scene>,
    report: Report,
}

impl Project {
    /// A scene that lies nowhere yet.
    pub(crate) fn new(name: impl Into<String>, text: String, files: Files) -> Result<Self, EditError> {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        let mut project = Self {
            id: NEXT.fetch_add(1, Ordering::Relaxed),
            document: Document::open(text)?,
            name: name.into(),
            origin: Origin::New,
            on_disk: None,
            files,
            scene: None,
            report: Report::default(),
        };
        project.check();
        Ok(project)
    }

    /// An example with its files.
    pub(crate) fn example(example: &Example) -> Result<Self, EditError> {
        let project = Self::new(example.name, example.text.to_owned(), example.files())?;
        Ok(Self { origin: Origin::Example(example.name.to_owned()), ..project })
    }

    /// No other project has it.
    pub(crate) fn id(&self) -> u64 {
        self.id
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
        let files = self.files.clone();
        files.noting(|| {
            self.load();
            self.scene.is_some()
        });
    }

    fn load(&mut self) {
        let text = SceneText { name: &self.name, toml: self.document.text(), ..SceneText::default() };
        let files = &self.files;
        (self.scene, self.report) = match Scene::load(&text, &mut |path| files.text(path)) {
            Ok((scene, report)) => (Some(scene), report),
            Err(report) => (None, report),
        };
    }
}

impl Project {
    /// Opens a scene file.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn open(path: &Path) -> anyhow::Result<Self> {
        let shown = || format!("cannot open {}", path.display());
        // The editor may be elsewhere when it is saved or rendered.
        let path = std::path::absolute(path).with_context(shown)?;
        let text = fumetto_disk::read_text(&path).with_context(shown)?;
        let mut project = Self::new(name_of(&path), text, Files::beside(&path)).with_context(shown)?;
        project.on_disk = Some(project.document.text().to_owned());
        project.origin = Origin::File(path);
        Ok(project)
    }

    /// A scene with changes that were never saved. Where what it comes from can no longer be read, the text stands by
    /// itself: it may be the only copy.
    pub(crate) fn recovered(origin: &Origin, text: String) -> Result<Self, EditError> {
        let found = match origin {
            Origin::New => None,
            Origin::Example(name) => {
                let example = EXAMPLES.iter().find(|example| example.name == name);
                example.and_then(|example| Self::example(example).ok())
            }
            Origin::File(path) => Self::open(path).ok(),
        };
        let mut project = match (found, origin) {
            (Some(project), _) => project,
            (None, Origin::File(path)) => Self::new(name_of(path), String::new(), Files::beside(path))?,
            (None, _) => Self::new("recovered.toml", String::new(), Files::default())?,
        };
        project.edit(&Edit::ReplaceText(text), None)?;
        Ok(project)
    }

    pub(crate) fn origin(&self) -> &Origin {
        &self.origin
    }

    /// Where it is saved to without asking.
    pub(crate) fn path(&self) -> Option<&Path> {
        match &self.origin {
            Origin::File(path) => Some(path),
            Origin::New | Origin::Example(_) => None,
        }
    }

    /// Saves it as `path`, with those of its files that are not there yet. The file that was there stays until the new
    /// one is whole.
    pub(crate) fn save(&mut self, path: &Path) -> anyhow::Result<()> {
        use std::io::Write as _;
        let path = std::path::absolute(path).with_context(|| format!("cannot write {}", path.display()))?;
        self.check_others(&path)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        self.files.luggage(folder, &self.document)?.unpack()?;
        fumetto_disk::write(&path, |draft| draft.write_all(self.document.text().as_bytes()))?;
        self.document.mark_saved();
        self.on_disk = Some(self.document.text().to_owned());
        self.name = name_of(&path);
        self.files = self.files.moved(&path);
        self.origin = Origin::File(path);
        // What it needs has not changed; only what it is called has.
        self.load();
        Ok(())
    }

    /// Refuses once to write over what another program has made of the scene's own file.
    fn check_others(&mut self, path: &Path) -> anyhow::Result<()> {
        let is_own = self.path() == Some(path);
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

fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use std::fs;

    use fumetto::Assets as _;

    use super::*;

    #[test]
    fn what_cannot_be_opened_again_is_recovered_by_itself() {
        let folder = tempfile::tempdir().unwrap();
        let broken = folder.path().join("a.toml");
        fs::write(&broken, b"\xff\xfe").unwrap();
        for origin in [Origin::File(broken), Origin::File("/gone/a.toml".into()), Origin::New] {
            let project = Project::recovered(&origin, "format = 1\n".to_owned()).unwrap();
            assert_eq!((project.document.text(), project.path()), ("format = 1\n", None));
            assert!(project.document.is_changed());
        }
    }

    #[test]
    fn a_recovered_example_has_its_files() {
        let origin = Origin::Example("cumulus.toml".to_owned());
        let project = Project::recovered(&origin, "format = 1\n".to_owned()).unwrap();
        assert!(project.files.read("cumulus.csv").is_ok());
        assert_eq!(*project.origin(), origin);
    }

    #[test]
    fn a_scene_lies_where_it_lies_wherever_the_editor_is() {
        let own = std::env::current_dir().unwrap();
        let folder = tempfile::tempdir_in(&own).unwrap();
        let relative = Path::new(folder.path().file_name().unwrap()).join("a.toml");
        fs::write(&relative, "format = 1\n").unwrap();
        let mut project = Project::open(&relative).unwrap();
        assert_eq!(project.path(), Some(own.join(&relative).as_path()));
        project.save(&relative.with_file_name("b.toml")).unwrap();
        assert!(project.path().unwrap().is_absolute() && folder.path().join("b.toml").exists());
    }

    #[test]
    fn files_are_read_from_where_the_scene_was_saved_last() {
        let folder = tempfile::tempdir().unwrap();
        let place = |name: &str| {
            let place = folder.path().join(name);
            fs::create_dir_all(&place).unwrap();
            place
        };
        let mut project = Project::example(&EXAMPLES[0]).unwrap();
        project.save(&place("one").join("a.toml")).unwrap();
        fs::write(place("one").join("cumulus.csv"), "changed").unwrap();
        assert_eq!(project.files.read("cumulus.csv").unwrap(), b"changed");
        project.save(&place("two").join("a.toml")).unwrap();
        fs::remove_dir_all(place("one")).unwrap();
        assert_eq!(project.files.read("cumulus.csv").unwrap(), b"changed");
        fs::write(place("three").join("cumulus.csv"), "another's").unwrap();
        assert!(project.save(&place("three").join("a.toml")).is_err());
        assert!(!place("three").join("a.toml").exists() && project.path().unwrap().starts_with(place("two")));
    }
}
