//! Files that are read: the scene, and what it names.

use std::fs::File;
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use fumetto::Assets;

/// The longest scene or style file: a million listed particles have room in it.
const MAX_TEXT_BYTES: u64 = 64 << 20;

/// The longest picture or particle file: an uncompressed PNG of the largest size, with room to spare.
const MAX_ASSET_BYTES: u64 = 1 << 30;

/// The text of a scene or style file.
pub(crate) fn read_text(path: &Path) -> io::Result<String> {
    let bytes = read_at_most(path, MAX_TEXT_BYTES)?;
    String::from_utf8(bytes).map_err(|error| {
        let text = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        // As many pieces as lines have begun.
        let line = text.split(|&byte| byte == b'\n').count();
        let problem = format!("line {line} is not UTF-8 text; save the file as UTF-8");
        io::Error::new(io::ErrorKind::InvalidData, problem)
    })
}

/// Does not trust the length that the file system tells: devices and pipes have none.
fn read_at_most(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    if file.metadata()?.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
    }
    let mut bytes = Vec::new();
    file.take(limit + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit {
        let problem = format!("it is longer than {} MiB", limit >> 20);
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, problem));
    }
    Ok(bytes)
}

/// The files beside a scene file.
#[derive(Clone, Debug)]
pub(crate) struct SceneFolder {
    folder: PathBuf,
}

impl SceneFolder {
    /// The folder that `scene` lies in.
    pub(crate) fn of(scene: &Path) -> Self {
        Self { folder: scene.parent().unwrap_or(Path::new("")).to_owned() }
    }

    /// Where `path`, as the scene writes it, is.
    pub(crate) fn path(&self, path: &str) -> PathBuf {
        self.folder.join(path)
    }
}

impl Assets for SceneFolder {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        let place = self.path(path);
        read_at_most(&place, MAX_ASSET_BYTES).map_err(|error| {
            // The engine's message has the name as the scene writes it; say where that led.
            io::Error::new(error.kind(), format!("{}: {error}", place.display()))
        })
    }
}
