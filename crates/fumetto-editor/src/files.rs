//! Where the files that a scene names come from: memory, and the folder of the scene.

mod luggage;
mod shelf;

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

use fumetto::Assets;
use fumetto_disk::SceneFolder;

use self::shelf::Shelf;

/// The files beside a scene. Cheap to clone.
#[derive(Clone, Debug, Default)]
pub(crate) struct Files {
    /// Out of an example.
    memory: BTreeMap<String, Arc<[u8]>>,
    /// The scene file beside which the others lie.
    scene: Option<PathBuf>,
    /// All clones have the same.
    shelf: Rc<Shelf>,
}

impl Files {
    /// Those in the folder of the scene file `scene`.
    pub(crate) fn beside(scene: &Path) -> Self {
        Self { scene: Some(scene.to_owned()), ..Self::default() }
    }

    /// Adds a file, in place of another of that name.
    pub(crate) fn add(&mut self, name: impl Into<String>, bytes: impl Into<Arc<[u8]>>) {
        self.memory.insert(name.into(), bytes.into());
    }

    /// Those that are on no disk yet.
    pub(crate) fn in_memory(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.memory.iter().map(|(name, bytes)| (name.as_str(), &**bytes))
    }

    /// The folder in which the others lie.
    pub(crate) fn folder(&self) -> Option<&Path> {
        self.scene.as_deref().and_then(Path::parent)
    }

    /// The text of a style file.
    pub(crate) fn text(&self, path: &str) -> Result<String, String> {
        let bytes = self.read(path).map_err(|error| error.to_string())?;
        String::from_utf8(bytes).map_err(|_| "it is not UTF-8 text; save the file as UTF-8".to_owned())
    }
}

impl Assets for Files {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        if let Some(bytes) = self.memory.get(path) {
            return Ok(bytes.to_vec());
        }
        // What is named from the root is found without a folder, too.
        if self.scene.is_none() && !Path::new(path).is_absolute() {
            let help = "drop the file onto the window, or save the scene beside it";
            return Err(io::Error::new(io::ErrorKind::NotFound, format!("there is no such file; {help}")));
        }
        let folder = SceneFolder::of(self.scene.as_deref().unwrap_or(Path::new("")));
        let place = self.folder().unwrap_or(Path::new("")).join(path);
        let bytes = self.shelf.read(&place, || folder.read(path))?;
        self.shelf.note(path);
        Ok(bytes)
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;

    #[test]
    fn a_scene_that_lies_nowhere_finds_what_is_named_from_the_root() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("a.csv");
        std::fs::write(&place, "x,y,z\n").unwrap();
        let files = Files::default();
        assert_eq!(files.read(place.to_str().unwrap()).unwrap(), b"x,y,z\n");
        assert_eq!(files.read("a.csv").unwrap_err().kind(), io::ErrorKind::NotFound);
    }
}
