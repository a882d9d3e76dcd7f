//! What survives a crash: the text as it was some seconds before.

use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{fs, io};

use web_time::Instant;

/// So often is the text written while it changes: what a crash may cost.
const EVERY: Duration = Duration::from_secs(5);

/// The first line of what is kept says where the scene lay, as a comment that no scene has.
const MARK: &str = "#fumetto-autosave ";

/// Keeps the unsaved text of one editor in a file of its own.
#[derive(Debug)]
pub(crate) struct Autosave {
    file: PathBuf,
    written: Option<(u64, Instant)>,
}

/// A text that an editor left behind when it ended unexpectedly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Left {
    file: PathBuf,
    /// Where the scene was saved last, if it was.
    pub(crate) path: Option<PathBuf>,
    pub(crate) text: String,
}

impl Autosave {
    /// In `folder`, beside those of other editors that run.
    pub(crate) fn new(folder: &Path) -> Self {
        Self { file: folder.join(format!("{}.toml", std::process::id())), written: None }
    }

    /// Writes the text, if it has changed and that is due.
    pub(crate) fn keep(&mut self, revision: u64, path: Option<&Path>, text: &str) -> io::Result<()> {
        let is_due =
            self.written.is_none_or(|(written, when)| written != revision && when.elapsed() >= EVERY);
        if !is_due {
            return Ok(());
        }
        self.written = Some((revision, Instant::now()));
        if let Some(folder) = self.file.parent() {
            fs::create_dir_all(folder)?;
        }
        let path = path.map_or_else(String::new, |path| path.display().to_string());
        fs::write(&self.file, format!("{MARK}{path}\n{text}"))
    }

    /// The text is safe elsewhere, or not wanted.
    pub(crate) fn forget(&mut self) {
        if self.written.take().is_some() {
            // It is no longer needed; where it stays it is offered once more.
            let _ = fs::remove_file(&self.file);
        }
    }
}

impl Left {
    /// The texts in `folder` that no running editor keeps.
    pub(crate) fn all(folder: &Path) -> Vec<Self> {
        let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
        entries.filter_map(|entry| Self::read(entry.ok()?.path())).collect()
    }

    fn read(file: PathBuf) -> Option<Self> {
        let process: u32 = file.file_stem()?.to_str()?.parse().ok()?;
        if is_running(process) {
            return None;
        }
        let kept = fumetto_disk::read_text(&file).ok()?;
        let (mark, text) = kept.split_once('\n')?;
        let path = mark.strip_prefix(MARK)?;
        let path = (!path.is_empty()).then(|| PathBuf::from(path));
        Some(Self { file, path, text: text.to_owned() })
    }

    /// It was opened again, or is not wanted.
    pub(crate) fn forget(&self) {
        let _ = fs::remove_file(&self.file);
    }
}

/// Whether a process runs, as far as the system tells.
fn is_running(process: u32) -> bool {
    process == std::process::id() || Path::new("/proc").join(process.to_string()).exists()
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;

    #[test]
    fn what_a_crash_leaves_is_found_once() {
        let folder = tempfile::tempdir().unwrap();
        // No process has the largest number.
        let file = folder.path().join(format!("{}.toml", u32::MAX));
        fs::write(&file, format!("{MARK}/scenes/a.toml\nformat = 1\n")).unwrap();
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
        autosave.keep(1, None, "format = 1\n").unwrap();
        assert!(autosave.file.exists());
        assert_eq!(Left::all(&folder.path().join("new")), []);
        autosave.forget();
        assert!(!autosave.file.exists());
    }
}
