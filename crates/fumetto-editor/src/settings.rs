//! What the editor remembers of how its user likes it.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::clock::Pacing;
use crate::view::Navigation;

/// Kept from one start to the next. Nothing here belongs to a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Settings {
    pub(crate) navigation: Navigation,
    pub(crate) pacing: Pacing,
    /// Whether playing begins anew at the end.
    pub(crate) looping: bool,
    pub(crate) tree: bool,
    pub(crate) inspector: bool,
    pub(crate) styles: bool,
    pub(crate) text: bool,
    pub(crate) grid: bool,
    pub(crate) times: bool,
    /// Scene files that were opened or saved, the last first.
    pub(crate) recent: Vec<PathBuf>,
}

/// As many files are remembered as a menu shows well.
const MOST_RECENT: usize = 10;

impl Settings {
    /// A scene file was opened or saved.
    pub(crate) fn remember(&mut self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        self.recent.retain(|known| *known != path);
        self.recent.insert(0, path);
        self.recent.truncate(MOST_RECENT);
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            navigation: Navigation::default(),
            pacing: Pacing::default(),
            looping: true,
            tree: true,
            inspector: true,
            styles: false,
            text: false,
            grid: false,
            times: false,
            recent: Vec::new(),
        }
    }
}
