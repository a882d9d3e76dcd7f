//! What the editor remembers of how its user likes it.

use serde::{Deserialize, Serialize};

use crate::clock::Pacing;
use crate::view::Navigation;

/// Kept from one start to the next. Nothing here belongs to a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Settings {
    pub(crate) navigation: Navigation,
    pub(crate) pacing: Pacing,
    pub(crate) tree: bool,
    pub(crate) inspector: bool,
    pub(crate) styles: bool,
    pub(crate) text: bool,
    pub(crate) grid: bool,
    pub(crate) times: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            navigation: Navigation::default(),
            pacing: Pacing::default(),
            tree: true,
            inspector: true,
            styles: false,
            text: false,
            grid: false,
            times: false,
        }
    }
}
