//! Files that are read: the scene, and what it names.

use std::fs::{self, File};
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use fumetto::Assets;

/// The longest scene or style file: a million listed particles have room in it.
const MAX_TEXT_BYTES: u64 = 64 << 20;

/// The longest picture or particle file: an uncompressed PNG of the largest size, with room to spare.
const MAX_ASSET_BYTES: u64 = 1 << 30;

/// The text of a scene or style file that the user names; it may be a pipe.
///
/// # Errors
/// When there is none, it cannot be read, is too long or no UTF-8.
pub fn read_text(path: &Path) -> io::Result<String> {
    if fs::metadata(path)?.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
    }
    text(read_at_most(path, MAX_TEXT_BYTES)?)
}

/// The bytes of a file that the user names.
///
/// # Errors
/// When there is none, it cannot be read or is too long.
pub fn read_bytes(path: &Path) -> io::Result<Vec<u8>> {
    read_at_most(path, MAX_ASSET_BYTES)
}

/// The first bytes of a file that the user names; fewer where it is shorter.
///
/// # Errors
/// When there is none, or it cannot be read.
pub fn read_beginning(path: &Path, bytes: usize) -> io::Result<Vec<u8>> {
    let mut beginning = Vec::new();
    File::open(path)?.take(bytes as u64).read_to_end(&mut beginning)?;
    Ok(beginning)
}

/// The text of a scene that comes in by a pipe.
///
/// # Errors
/// When standard input cannot be read, is too long or no UTF-8.
pub fn read_standard_input() -> io::Result<String> {
    text(at_most(io::stdin().lock(), MAX_TEXT_BYTES)?)
}

fn text(bytes: Vec<u8>) -> io::Result<String> {
    String::from_utf8(bytes).map_err(|error| {
        let text = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        // As many pieces as lines have begun.
        let line = text.split(|&byte| byte == b'\n').count();
        let problem = format!("line {line} is not UTF-8 text; save the file as UTF-8");
        io::Error::new(io::ErrorKind::InvalidData, problem)
    })
}

/// Does not rely on the length that the file system tells: pipes have none.
fn read_at_most(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    at_most(File::open(path)?, limit)
}

fn at_most(file: impl io::Read, limit: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(limit + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit { Err(too_long(limit)) } else { Ok(bytes) }
}

fn too_long(limit: u64) -> io::Error {
    io::Error::new(io::ErrorKind::FileTooLarge, format!("it is longer than {} MiB", limit >> 20))
}

/// The files beside a scene file.
#[derive(Clone, Debug)]
pub struct SceneFolder {
    folder: PathBuf,
}

impl SceneFolder {
    /// The folder that `scene` lies in.
    #[must_use]
    pub fn of(scene: &Path) -> Self {
        Self { folder: scene.parent().unwrap_or(Path::new("")).to_owned() }
    }

    /// The text of the style file that the scene calls `path`.
    ///
    /// # Errors
    /// When there is no such regular file, it cannot be read, is too long or no UTF-8.
    pub fn read_text(&self, path: &str) -> io::Result<String> {
        text(self.read_file(path, MAX_TEXT_BYTES)?)
    }

    /// Opens regular files only: a scene out of strange hands may name a pipe that never ends.
    fn read_file(&self, path: &str, limit: u64) -> io::Result<Vec<u8>> {
        let place = self.folder.join(path);
        let read = || {
            let metadata = fs::metadata(&place)?;
            if !metadata.is_file() {
                return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is not a regular file"));
            }
            if metadata.len() > limit {
                return Err(too_long(limit));
            }
            read_at_most(&place, limit)
        };
        // The message that this becomes part of has the name as the scene writes it; say where it led.
        read().map_err(|error| {
            let is_said = place == Path::new(path);
            if is_said {
                error
            } else {
                io::Error::new(error.kind(), format!("{}: {error}", place.display()))
            }
        })
    }
}

impl Assets for SceneFolder {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        self.read_file(path, MAX_ASSET_BYTES)
    }
}
