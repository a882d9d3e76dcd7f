//! What survives a crash: the text as it was some seconds before.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::{fs, time::Duration};

use tempfile::NamedTempFile;
use web_time::Instant;

use crate::project::{Origin, Project};

/// So often is the text written while it changes: what a crash may cost.
pub(crate) const EVERY: Duration = Duration::from_secs(5);

/// The first line of what is kept says where the scene lay, as a comment that no scene has.
const MARK: &str = "#fumetto-autosave ";

/// The same where it began as an example.
const EXAMPLE_MARK: &str = "#fumetto-autosave-example ";

/// How the names of locks end.
const LOCK: &str = ".lock";

/// Keeps the unsaved text of one editor in a file of its own.
#[derive(Debug)]
pub(crate) struct Autosave {
    folder: PathBuf,
    /// Locked while the editor runs, whatever becomes of it; the text lies beside it under the same name.
    lock: Option<NamedTempFile>,
    /// Which project and which of its revisions the text is.
    kept: Option<(u64, u64)>,
    /// Whose text was written last, or should have been, and when.
    tried: Option<(u64, Instant)>,
    /// What the project was recovered from, until the project itself is kept.
    before: Option<Left>,
}

/// A text that an editor left behind when it ended unexpectedly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Left {
    lock: PathBuf,
    /// Where the scene came from.
    pub(crate) origin: Origin,
    pub(crate) text: String,
}

impl Autosave {
    /// In `folder`, beside those of other editors that run.
    pub(crate) fn new(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), lock: None, kept: None, tried: None, before: None }
    }

    /// Writes the text, if it has changed and that is due; otherwise tells how long it may still wait.
    pub(crate) fn keep(&mut self, project: &Project) -> anyhow::Result<Option<Duration>> {
        let document = project.document();
        let state = (project.id(), document.revision());
        if self.kept == Some(state) {
            return Ok(None);
        }
        let last = self.tried.filter(|(id, _)| *id == project.id()).map(|(_, when)| when.elapsed());
        if let Some(gone) = last.filter(|gone| *gone < EVERY) {
            return Ok(Some(EVERY.saturating_sub(gone)));
        }
        self.tried = Some((project.id(), Instant::now()));
        let lock = match self.lock.take() {
            Some(lock) => lock,
            None => locked_in(&self.folder)?,
        };
        let mark = marked(project.origin());
        let written =
            fumetto_disk::write(&text_of(lock.path()), |draft| write!(draft, "{mark}\n{}", document.text()));
        self.lock = Some(lock);
        written?;
        self.kept = Some(state);
        self.forget_before();
        Ok(None)
    }

    /// What is kept next takes the place of `left`, which stays until then.
    pub(crate) fn follow(&mut self, left: Left) {
        self.before = Some(left);
    }

    /// The text is safe elsewhere, or not wanted.
    pub(crate) fn forget(&mut self) {
        if let Some(lock) = self.lock.take() {
            // It is no longer needed; where it stays it is offered once more.
            let _ = fs::remove_file(text_of(lock.path()));
        }
        (self.kept, self.tried) = (None, None);
        self.forget_before();
    }

    fn forget_before(&mut self) {
        if let Some(left) = self.before.take() {
            left.forget();
        }
    }
}

fn text_of(lock: &Path) -> PathBuf {
    lock.with_extension("toml")
}

fn marked(origin: &Origin) -> String {
    match origin {
        Origin::New => MARK.to_owned(),
        Origin::Example(name) => format!("{EXAMPLE_MARK}{name}"),
        Origin::File(path) => format!("{MARK}{}", path.display()),
    }
}

fn origin_of(mark: &str) -> Option<Origin> {
    if let Some(name) = mark.strip_prefix(EXAMPLE_MARK) {
        return Some(Origin::Example(name.to_owned()));
    }
    let path = mark.strip_prefix(MARK)?;
    Some(if path.is_empty() { Origin::New } else { Origin::File(path.into()) })
}

/// A locked file in `folder`.
fn locked_in(folder: &Path) -> io::Result<NamedTempFile> {
    fs::create_dir_all(folder)?;
    let lock = tempfile::Builder::new().prefix("scene-").suffix(LOCK).tempfile_in(folder)?;
    lock.as_file().try_lock().map_err(io::Error::from)?;
    Ok(lock)
}

impl Left {
    /// The texts in `folder` that no running editor keeps.
    pub(crate) fn all(folder: &Path) -> Vec<Self> {
        let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
        entries.filter_map(|entry| Self::read(entry.ok()?.path())).collect()
    }

    fn read(lock: PathBuf) -> Option<Self> {
        let is_lock = lock.to_str().is_some_and(|name| name.ends_with(LOCK));
        // A running editor has it locked.
        if !is_lock || fs::File::open(&lock).ok()?.try_lock().is_err() {
            return None;
        }
        let kept = fumetto_disk::read_text(&text_of(&lock)).ok()?;
        let (mark, text) = kept.split_once('\n')?;
        Some(Self { lock, origin: origin_of(mark)?, text: text.to_owned() })
    }

    /// It was opened again, or is not wanted.
    pub(crate) fn forget(&self) {
        for file in [&text_of(&self.lock), &self.lock] {
            // Where it stays it is offered once more.
            let _ = fs::remove_file(file);
        }
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use fumetto_scene::edit::Edit;

    use super::*;
    use crate::files::Files;

    /// A scene that says this; each has the same revision.
    fn changed(text: &str) -> Project {
        let mut project = Project::new("a.toml", String::new(), Files::default()).unwrap();
        project.edit(&Edit::ReplaceText(text.to_owned()), None).unwrap();
        project
    }

    fn texts(folder: &Path) -> Vec<String> {
        let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let texts = files.filter(|file| file.extension().is_some_and(|ending| ending == "toml"));
        texts.map(|file| fs::read_to_string(file).unwrap()).collect()
    }

    #[test]
    fn what_a_crash_leaves_is_found_once() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("scene-1.lock"), "").unwrap();
        fs::write(folder.path().join("scene-1.toml"), format!("{MARK}/scenes/a.toml\nformat = 1\n")).unwrap();
        fs::write(folder.path().join("other.txt"), "no text of ours").unwrap();
        let left = Left::all(folder.path());
        assert_eq!(left.len(), 1);
        assert_eq!(left[0].origin, Origin::File("/scenes/a.toml".into()));
        assert_eq!(left[0].text, "format = 1\n");
        left[0].forget();
        assert_eq!(Left::all(folder.path()), []);
    }

    #[test]
    fn a_running_editor_keeps_its_own() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().join("new");
        let mut autosave = Autosave::new(&folder);
        let mut project = changed("format = 1\n");
        assert_eq!(autosave.keep(&project).unwrap(), None);
        assert_eq!(texts(&folder), [format!("{MARK}\nformat = 1\n")]);
        assert_eq!(Left::all(&folder), []);
        project.edit(&Edit::ReplaceText("format = 2\n".to_owned()), None).unwrap();
        assert!(autosave.keep(&project).unwrap().is_some(), "it says when it is due");
        autosave.forget();
        assert_eq!(texts(&folder), [""; 0]);
    }

    #[test]
    fn another_scene_of_the_same_revision_is_kept_too() {
        let folder = tempfile::tempdir().unwrap();
        let mut autosave = Autosave::new(folder.path());
        autosave.keep(&changed("one = 1\n")).unwrap();
        autosave.keep(&changed("two = 2\n")).unwrap();
        assert_eq!(texts(folder.path()), [format!("{MARK}\ntwo = 2\n")]);
    }

    #[test]
    fn what_was_recovered_goes_when_it_is_kept_anew() {
        let folder = tempfile::tempdir().unwrap();
        let lock = folder.path().join("scene-1.lock");
        fs::write(&lock, "").unwrap();
        fs::write(text_of(&lock), format!("{EXAMPLE_MARK}cumulus.toml\nold = 1\n")).unwrap();
        let left = Left::all(folder.path()).remove(0);
        assert_eq!(left.origin, Origin::Example("cumulus.toml".to_owned()));
        let nowhere = folder.path().join("nowhere");
        fs::write(&nowhere, "a file where a folder should be").unwrap();
        let mut autosave = Autosave::new(&nowhere);
        autosave.follow(left);
        let project = Project::recovered(&Origin::Example("cumulus.toml".to_owned()), "old = 1\n".to_owned());
        let project = project.unwrap();
        autosave.keep(&project).unwrap_err();
        assert!(text_of(&lock).exists(), "it is the only copy");
        assert!(autosave.keep(&project).unwrap().is_some(), "it is tried again, but not at once");
        fs::remove_file(&nowhere).unwrap();
        autosave.tried = None;
        assert_eq!(autosave.keep(&project).unwrap(), None);
        assert!(!text_of(&lock).exists());
        assert_eq!(texts(&nowhere), [format!("{EXAMPLE_MARK}cumulus.toml\nold = 1\n")]);
    }
}
