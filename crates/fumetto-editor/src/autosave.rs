//! What survives a crash: the text as it was some seconds before.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::{fs, time::Duration};

use tempfile::NamedTempFile;
use web_time::Instant;

/// So often is the text written while it changes: what a crash may cost.
const EVERY: Duration = Duration::from_secs(5);

/// The first line of what is kept says where the scene lay, as a comment that no scene has.
const MARK: &str = "#fumetto-autosave ";

/// How the names of locks end.
const LOCK: &str = ".lock";

/// Keeps the unsaved text of one editor in a file of its own.
#[derive(Debug)]
pub(crate) struct Autosave {
    folder: PathBuf,
    kept: Option<Kept>,
}

/// A text that is kept.
#[derive(Debug)]
struct Kept {
    /// Locked while the editor runs, whatever becomes of it; the text lies beside it under the same name.
    lock: NamedTempFile,
    revision: u64,
    when: Instant,
}

impl Kept {
    fn text(&self) -> PathBuf {
        text_of(self.lock.path())
    }
}

fn text_of(lock: &Path) -> PathBuf {
    lock.with_extension("toml")
}

/// A text that an editor left behind when it ended unexpectedly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Left {
    lock: PathBuf,
    /// Where the scene was saved last, if it was.
    pub(crate) path: Option<PathBuf>,
    pub(crate) text: String,
}

impl Autosave {
    /// In `folder`, beside those of other editors that run.
    pub(crate) fn new(folder: &Path) -> Self {
        Self { folder: folder.to_owned(), kept: None }
    }

    /// Writes the text, if it has changed and that is due; otherwise tells how long it may still wait.
    pub(crate) fn keep(
        &mut self,
        revision: u64,
        path: Option<&Path>,
        text: &str,
    ) -> anyhow::Result<Option<Duration>> {
        let lock = match self.kept.take() {
            Some(kept) if kept.revision == revision => {
                self.kept = Some(kept);
                return Ok(None);
            }
            Some(kept) if kept.when.elapsed() < EVERY => {
                let wait = EVERY.saturating_sub(kept.when.elapsed());
                self.kept = Some(kept);
                return Ok(Some(wait));
            }
            Some(kept) => kept.lock,
            None => locked_in(&self.folder)?,
        };
        let path = path.map_or_else(String::new, |path| path.display().to_string());
        let kept = Kept { lock, revision, when: Instant::now() };
        let written = fumetto_disk::write(&kept.text(), |draft| write!(draft, "{MARK}{path}\n{text}"));
        self.kept = Some(kept);
        written.map(|()| None)
    }

    /// The text is safe elsewhere, or not wanted.
    pub(crate) fn forget(&mut self) {
        if let Some(kept) = self.kept.take() {
            // It is no longer needed; where it stays it is offered once more.
            let _ = fs::remove_file(kept.text());
        }
    }
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
        let path = mark.strip_prefix(MARK)?;
        let path = (!path.is_empty()).then(|| PathBuf::from(path));
        Some(Self { lock, path, text: text.to_owned() })
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
    use super::*;

    #[test]
    fn what_a_crash_leaves_is_found_once() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("scene-1.lock"), "").unwrap();
        fs::write(folder.path().join("scene-1.toml"), format!("{MARK}/scenes/a.toml\nformat = 1\n")).unwrap();
        fs::write(folder.path().join("other.txt"), "no text of ours").unwrap();
        let left = Left::all(folder.path());
        assert_eq!(left.len(), 1);
        assert_eq!(left[0].path.as_deref(), Some(Path::new("/scenes/a.toml")));
        assert_eq!(left[0].text, "format = 1\n");
        left[0].forget();
        assert_eq!(Left::all(folder.path()), []);
    }

    #[test]
    fn a_running_editor_keeps_its_own() {
        let folder = tempfile::tempdir().unwrap();
        let mut autosave = Autosave::new(&folder.path().join("new"));
        assert_eq!(autosave.keep(1, None, "format = 1\n").unwrap(), None);
        let text = autosave.kept.as_ref().unwrap().text();
        assert!(text.exists());
        assert_eq!(Left::all(&folder.path().join("new")), []);
        assert!(autosave.keep(2, None, "format = 2\n").unwrap().is_some(), "it says when it is due");
        autosave.forget();
        assert!(!text.exists());
    }
}
