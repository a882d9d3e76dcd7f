//! Where the files that a scene names come from: memory, and on the desktop the folder of the scene.

use std::collections::BTreeMap;
use std::io;
use std::sync::Arc;

use fumetto::Assets;
#[cfg(not(target_arch = "wasm32"))]
use fumetto_disk::SceneFolder;

/// The files beside a scene. Cheap to clone.
#[derive(Clone, Debug, Default)]
pub(crate) struct Files {
    /// Dropped onto the window, or out of an example.
    memory: BTreeMap<String, Arc<[u8]>>,
    #[cfg(not(target_arch = "wasm32"))]
    folder: Option<SceneFolder>,
}

impl Files {
    /// Those in the folder of the scene file `scene`.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) fn beside(scene: &std::path::Path) -> Self {
        Self { folder: Some(SceneFolder::of(scene)), ..Self::default() }
    }

    /// Adds a file, in place of another of that name.
    pub(crate) fn add(&mut self, name: impl Into<String>, bytes: impl Into<Arc<[u8]>>) {
        self.memory.insert(name.into(), bytes.into());
    }

    /// Those that are on no disk yet.
    pub(crate) fn in_memory(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.memory.iter().map(|(name, bytes)| (name.as_str(), &**bytes))
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
        #[cfg(not(target_arch = "wasm32"))]
        if let Some(folder) = &self.folder {
            return folder.read(path);
        }
        let help = "drop the file onto the window";
        Err(io::Error::new(io::ErrorKind::NotFound, format!("there is no such file; {help}")))
    }
}
