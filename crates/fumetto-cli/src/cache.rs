//! A folder of simulated frames: one file each, and one from which the simulation can go on.

use std::io;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, bail};
use fumetto::Snapshot;
use fumetto_disk as disk;
use fumetto_formats::{
    CACHE_HEADER_BYTES, CachedFrame, read_cache_fingerprint, read_cached_frame, write_cached_frame,
};

/// The name of what the simulation can go on from.
const CHECKPOINT: &str = "checkpoint.frame";

/// Frames of one scene.
pub(crate) struct Cache {
    folder: PathBuf,
    /// Of the scene.
    fingerprint: u128,
}

/// What there is of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Found {
    Ours,
    /// It is another scene's.
    Other,
    Nothing,
}

impl Cache {
    /// That in a folder that there is.
    pub(crate) fn open(folder: &Path, fingerprint: u128) -> anyhow::Result<Self> {
        if !folder.is_dir() {
            bail!("there is no folder {}; `fumetto bake` makes and fills one", folder.display());
        }
        Ok(Self { folder: folder.to_owned(), fingerprint })
    }

    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// The file of a frame.
    pub(crate) fn file(&self, frame: u32) -> PathBuf {
        self.folder.join(format!("{frame:04}.frame"))
    }

    /// What there is of a frame.
    pub(crate) fn find(&self, frame: u32) -> anyhow::Result<Found> {
        self.find_at(&self.file(frame))
    }

    /// A frame that was found.
    pub(crate) fn read(&self, frame: u32) -> anyhow::Result<Snapshot> {
        let file = self.file(frame);
        let snapshot = read(&file)?;
        if snapshot.frame != frame {
            bail!("{} is of frame {}; it was given another name", file.display(), snapshot.frame);
        }
        Ok(snapshot)
    }

    /// Adds a frame.
    pub(crate) fn write(&self, snapshot: Snapshot) -> anyhow::Result<()> {
        self.write_at(&self.file(snapshot.frame), snapshot)
    }

    /// What the simulation can go on from, if it is this scene's.
    pub(crate) fn checkpoint(&self) -> anyhow::Result<Option<Snapshot>> {
        let file = self.folder.join(CHECKPOINT);
        Ok(if self.find_at(&file)? == Found::Ours { Some(read(&file)?) } else { None })
    }

    /// Keeps what the simulation can go on from, in place of what was kept before.
    pub(crate) fn keep(&self, snapshot: Snapshot) -> anyhow::Result<()> {
        self.write_at(&self.folder.join(CHECKPOINT), snapshot)
    }

    fn find_at(&self, file: &Path) -> anyhow::Result<Found> {
        let named = || file.display().to_string();
        match disk::read_beginning(file, CACHE_HEADER_BYTES) {
            Ok(beginning) => {
                let is_ours = read_cache_fingerprint(&beginning).with_context(named)? == self.fingerprint;
                Ok(if is_ours { Found::Ours } else { Found::Other })
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Found::Nothing),
            Err(error) => Err(error).with_context(named),
        }
    }

    fn write_at(&self, file: &Path, Snapshot { frame, parts }: Snapshot) -> anyhow::Result<()> {
        let cached = CachedFrame { fingerprint: self.fingerprint, frame, parts };
        disk::write(file, |draft| write_cached_frame(&cached, draft))
    }
}

fn read(file: &Path) -> anyhow::Result<Snapshot> {
    let named = || file.display().to_string();
    let bytes = disk::read_bytes(file).with_context(named)?;
    let CachedFrame { frame, parts, .. } = read_cached_frame(&bytes).with_context(named)?;
    Ok(Snapshot { frame, parts })
}
