//! OpenVDB files out, in version 224 of the format, which OpenVDB 10 writes and later ones read.

mod nodes;
mod pack;
mod transform;

use std::io::Write;
use std::sync::Arc;

use self::nodes::Nodes;
use self::pack::Packer;
use super::archive::{HALF_SUFFIX, MAGIC, NAME_SEPARATOR};
use super::codec::{ACTIVE_MASK, ZIP};
use crate::WriteError;
use crate::excerpt::excerpt;
use crate::volume::grid::{Grid, GridClass, Voxels};

const VERSION: u32 = 224;

/// An OpenVDB that writes this version, major and minor: readers look at it to know old files' faults.
const LIBRARY_VERSION: [u32; 2] = [10, 0];

/// The identifier that stands for none, so that the bytes depend on the grids alone.
const NIL_UUID: &[u8] = b"00000000-0000-0000-0000-000000000000";

/// How volumes are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VdbOptions {
    /// Packs nodes with zlib, OpenVDB's "zip": slower to write, and smaller.
    pub zip: bool,
    /// Stores values as half floats: three digits, and at most 65 504.
    pub half: bool,
}

/// Writes grids as an OpenVDB file; inactive values that are background are left out of it.
///
/// Grids that share their voxels in memory share them in the file. `out` is not flushed.
///
/// # Errors
/// If a grid is not as [`Voxels`](crate::Voxels) and [`Grid::world_from_index`] promise, a number is not
/// finite or is beyond what half floats can hold, or `out` refuses the bytes.
pub fn write_vdb(grids: &[Grid], options: VdbOptions, mut out: impl Write) -> Result<(), WriteError> {
    let mut entry = header(grids.len());
    let mut written = 0;
    for (place, grid) in grids.iter().enumerate() {
        let shown = excerpt(grid.name.as_bytes());
        let refuse = |problem: String| WriteError::Volume { grid: shown.clone(), problem };
        let parent = grids[..place].iter().position(|other| Arc::ptr_eq(&other.voxels, &grid.voxels));
        put_string(&mut entry, &unique_name(grids, place));
        put_string(&mut entry, &tree_type(grid, options));
        put_string(&mut entry, &parent.map(|parent| unique_name(grids, parent)).unwrap_or_default());

        // What is broken is refused here, before anything is computed from it.
        let own =
            if parent.is_none() { tree(&grid.voxels, options).map_err(refuse)? } else { Default::default() };
        let [topology, voxels] = own;
        let head = head(grid, options).map_err(refuse)?;
        let start = written + entry.len() + 3 * size_of::<u64>();
        let blocks = start + head.len() + topology.len();
        for position in [start, blocks, blocks + voxels.len()] {
            entry.extend((position as u64).to_le_bytes());
        }
        for bytes in [&entry, &head, &topology, &voxels] {
            out.write_all(bytes)?;
            written += bytes.len();
        }
        entry.clear();
    }
    out.write_all(&entry)?;
    Ok(())
}

/// What stands before the first grid.
fn header(grid_count: usize) -> Vec<u8> {
    let mut bytes = MAGIC.to_le_bytes().to_vec();
    put_u32(&mut bytes, VERSION);
    LIBRARY_VERSION.into_iter().for_each(|number| put_u32(&mut bytes, number));
    // Grids tell where they start and end.
    bytes.push(1);
    bytes.extend(NIL_UUID);
    // No metadata.
    put_u32(&mut bytes, 0);
    put_u32(&mut bytes, grid_count as u32);
    bytes
}

/// The grid's name, with a number behind it if there is none, or others have the same.
fn unique_name(grids: &[Grid], place: usize) -> Vec<u8> {
    let name = &grids[place].name;
    let is_same = |grid: &&Grid| grid.name == *name;
    let mut unique = name.clone().into_bytes();
    if name.is_empty() || grids.iter().filter(is_same).count() > 1 {
        unique.push(NAME_SEPARATOR);
        unique.extend(grids[..place].iter().filter(is_same).count().to_string().into_bytes());
    }
    unique
}

fn tree_type(grid: &Grid, options: VdbOptions) -> Vec<u8> {
    let values: &[u8] = if grid.voxels.channels == 3 { b"vec3s" } else { b"float" };
    let half: &[u8] = if options.half { HALF_SUFFIX } else { b"" };
    [b"Tree_", values, b"_5_4_3", half].concat()
}

/// What stands before a grid's tree: how it is packed, metadata, transform.
fn head(grid: &Grid, options: VdbOptions) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    put_u32(&mut bytes, if options.zip { ZIP | ACTIVE_MASK } else { ACTIVE_MASK });
    let class: &[u8] = match grid.class {
        GridClass::Unknown => b"unknown",
        GridClass::FogVolume => b"fog volume",
        GridClass::LevelSet => b"level set",
        GridClass::Staggered => b"staggered",
    };
    // Programs take the bounds from here before they read any voxel.
    let [low, high] = grid.voxels.active_bounds().unwrap_or([[i32::MAX; 3], [i32::MIN; 3]]);
    let vector = |index: [i32; 3]| index.map(i32::to_le_bytes).concat();
    let metadata: [(&str, &str, &[u8]); 6] = [
        ("class", "string", class),
        ("file_bbox_max", "vec3i", &vector(high)),
        ("file_bbox_min", "vec3i", &vector(low)),
        ("file_voxel_count", "int64", &grid.voxels.active_count().to_le_bytes()),
        ("is_saved_as_half_float", "bool", &[options.half.into()]),
        ("name", "string", grid.name.as_bytes()),
    ];
    put_u32(&mut bytes, metadata.len() as u32);
    for (name, type_name, value) in metadata {
        put_string(&mut bytes, name.as_bytes());
        put_string(&mut bytes, type_name.as_bytes());
        put_string(&mut bytes, value);
    }
    transform::put(&mut bytes, &grid.world_from_index)?;
    Ok(bytes)
}

/// The topology of a tree, and its voxels.
fn tree(voxels: &Voxels, options: VdbOptions) -> Result<[Vec<u8>; 2], String> {
    let nodes = Nodes::of(voxels)?;
    let packer = Packer::new(voxels, options)?;
    Ok([nodes.topology(&packer), nodes.voxels(&packer)])
}

fn put_u32(bytes: &mut Vec<u8>, number: u32) {
    bytes.extend(number.to_le_bytes());
}

fn put_index(bytes: &mut Vec<u8>, index: [i32; 3]) {
    bytes.extend(index.map(i32::to_le_bytes).as_flattened());
}

/// Bytes behind their count.
fn put_string(bytes: &mut Vec<u8>, string: &[u8]) {
    put_u32(bytes, string.len() as u32);
    bytes.extend(string);
}
