//! Files that are written: whole or not at all.
//!
//! A file grows under a hidden temporary name in its final folder and gets its own name when it is
//! complete, so a name is either absent, or the old file, or the new one.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context as _, bail};
use tempfile::{Builder, NamedTempFile};

/// A file that does not have its name yet. Dropping it leaves nothing behind.
#[derive(Debug)]
pub struct Draft {
    file: BufWriter<NamedTempFile>,
    path: PathBuf,
}

impl Draft {
    /// Starts the file that will be `path`.
    ///
    /// # Errors
    /// When its folder is missing or refuses new files.
    pub fn new(path: &Path) -> anyhow::Result<Self> {
        if path.is_dir() {
            bail!("cannot write {}: it is a folder; choose another name", path.display());
        }
        let folder = folder_of(path);
        let file = temporary(folder).map_err(|error| refusal(path, folder, &error))?;
        Ok(Self { file: BufWriter::new(file), path: path.to_owned() })
    }

    /// Gives the file its name, in place of any file that had it.
    ///
    /// # Errors
    /// When the disk is full or fails; the file that had the name stays.
    pub fn publish(self) -> anyhow::Result<()> {
        let path = self.path.clone();
        let failed = || format!("cannot write {}", path.display());
        let file = self.settle().with_context(failed)?;
        file.persist(&path).map_err(|error| error.error).with_context(failed)?;
        Ok(())
    }

    /// Gives the file its name, unless another file has it.
    ///
    /// # Errors
    /// When another file has it, or the disk is full or fails.
    pub fn publish_new(self) -> anyhow::Result<()> {
        let path = self.path.clone();
        let file = self.settle().with_context(|| format!("cannot write {}", path.display()))?;
        file.persist_noclobber(&path).map(drop).map_err(|error| match error.error.kind() {
            io::ErrorKind::AlreadyExists => {
                anyhow::anyhow!("{} exists already and was left alone; choose another name", path.display())
            }
            _ => anyhow::Error::new(error.error).context(format!("cannot write {}", path.display())),
        })
    }

    /// All bytes on the disk: network and full disks report errors only now.
    fn settle(self) -> io::Result<NamedTempFile> {
        let file = self.file.into_inner().map_err(io::IntoInnerError::into_error)?;
        file.as_file().sync_all()?;
        Ok(file)
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Writes a whole file.
///
/// # Errors
/// What `fill` says, or when the file cannot be written; the file that had the name stays.
pub fn write<E>(path: &Path, fill: impl FnOnce(&mut Draft) -> Result<(), E>) -> anyhow::Result<()>
where
    E: std::error::Error + Send + Sync + 'static,
{
    let mut draft = Draft::new(path)?;
    fill(&mut draft).with_context(|| format!("cannot write {}", path.display()))?;
    draft.publish()
}

/// Finds out early whether `path` can be written, before hours are spent on what goes there.
///
/// # Errors
/// When it cannot.
pub fn check(path: &Path) -> anyhow::Result<()> {
    Draft::new(path).map(drop)
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

fn temporary(folder: &Path) -> io::Result<NamedTempFile<File>> {
    let mut builder = Builder::new();
    builder.prefix(".fumetto-").suffix(".tmp");
    // Temporary files are private; a picture is as readable as the user's other files (the umask still
    // takes its bits away).
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

fn refusal(path: &Path, folder: &Path, error: &io::Error) -> anyhow::Error {
    let (path, shown) = (path.display(), folder.display());
    if folder.is_dir() {
        let reason = error.kind();
        anyhow::anyhow!(
            "cannot write {path}: the folder {shown} refuses new files ({reason}); choose another"
        )
    } else if folder.exists() {
        anyhow::anyhow!("cannot write {path}: {shown} is not a folder; choose another")
    } else {
        anyhow::anyhow!("cannot write {path}: there is no folder {shown}; create it first (mkdir -p {shown})")
    }
}
