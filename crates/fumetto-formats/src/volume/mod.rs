//! Volumes out of files that simulations and other programs write, and back.

mod array;
mod dense;
mod grid;
mod npy;
mod nrrd;
mod raw;
mod vdb;

pub use self::grid::{BRICK_SIDE, BRICK_VOXELS, Brick, Grid, GridClass, Tile, Volume, Voxels};
pub use self::raw::read_raw_volume;
pub use self::vdb::{VdbOptions, write_vdb};
use crate::FormatError;

/// Most numbers that the grids of a file may have, all together: 1 GiB of memory.
///
/// A voxel of a brick counts, active or not, once for each channel; a tile counts for 8.
pub const MAX_VOLUME_NUMBERS: u64 = 1 << 28;

/// Reads the grids called `wanted` from `bytes`, or all grids if none is named; the extension of `name` (any
/// case) says which format they have.
///
/// `.vdb`: OpenVDB's format in versions 222 to 225, with all its codecs. Grids of
/// `float`, `half`, `double`, `int32`, `int64`, `bool`, `mask`, `vec3s`, `vec3d` and `vec3i` values become
/// numbers of single precision. Grids that share their voxels in the file share them in memory.
///
/// `.nrrd`: three axes, or vectors of three on three axes, behind the header as raw bytes, gzip or text.
/// `.npy`: an array of shape (x, y, z) or (x, y, z, 3). Both hold one grid, whose name is the file's, and
/// which is read whatever is wanted; zeros are its background.
///
/// Memory goes by what is stored, not by how far it is apart. Numbers that are infinite or none become the
/// grid's background; grids of kinds that cannot be read are left aside if there are others. Notes tell of
/// both.
///
/// # Errors
/// If the file is not of its format, it holds none of the grids, none of them is of a kind that is read, or
/// they take up more than [`MAX_VOLUME_NUMBERS`].
pub fn read_volume(name: &str, bytes: &[u8], wanted: &[&str]) -> Result<Volume, FormatError> {
    let extension = name.rsplit_once('.').map(|(_, extension)| extension.to_ascii_lowercase());
    match extension.as_deref() {
        Some("vdb") => vdb::read(name, bytes, wanted),
        Some("nrrd") => nrrd::read(name, bytes),
        Some("npy") => npy::read(name, bytes),
        _ => Err(FormatError::UnknownVolume { file: name.to_owned() }),
    }
}
