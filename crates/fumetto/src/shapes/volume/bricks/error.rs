use fumetto_scene::limits::MAX_VOLUME_BYTES;
use thiserror::Error;

use super::map::{MAX_ACROSS, MAX_TABLE_BYTES};

/// Why a volume that was read cannot be drawn.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ImportError {
    /// No grid has the name that the scene says, or none is of single numbers.
    #[error(
        "there is no grid of single numbers called {wanted} in it, but {found}; name one of these in the scene"
    )]
    NoGrid {
        /// The name that is looked for, quoted.
        wanted: String,
        /// The names that are there, quoted, as a list.
        found: String,
    },
    /// What a file leaves out would be dense.
    #[error(
        "its voxels are {background} wherever nothing is stored, which `range` makes matter without end; choose a \
         `range` that begins there"
    )]
    DenseOutside {
        /// The grid's background.
        background: f32,
    },
    /// Too much of it is dense.
    #[error(
        "its matter fills {bricks} bricks of 8 x 8 x 8 voxels, which take {bytes} bytes, and {MAX_VOLUME_BYTES} are \
         allowed: let `range` begin higher, or export it with larger voxels"
    )]
    TooLarge {
        /// That were counted until there were too many.
        bricks: u64,
        /// That they need at least.
        bytes: u64,
    },
    /// Its matter is too far apart.
    #[error(
        "its matter lies in a box of {} x {} x {} voxels, where a table of {bytes} bytes would tell where matter is; \
         {MAX_ACROSS} voxels a side and {MAX_TABLE_BYTES} bytes are allowed: split it into several files",
        sides[0], sides[1], sides[2]
    )]
    TooWide {
        /// Of the box, in voxels.
        sides: [u64; 3],
        /// Of the table.
        bytes: u64,
    },
}
