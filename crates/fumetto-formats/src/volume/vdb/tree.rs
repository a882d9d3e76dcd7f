//! A tree: a root, nodes of 32³ and 16³ children, and leaves of 8³ voxels (OpenVDB's `tree/*.h`).
//!
//! First comes the topology, which says where nodes are and what tiles stand between them, then the
//! voxels of all leaves in the same order.

use super::Trouble;
use super::archive::Entry;
use super::bytes::Bytes;
use super::codec::Compression;
use super::values::{Leaf, Mask, Values};
use crate::volume::grid::{BRICK_VOXELS, Brick, Tile, Voxels};

/// The least bytes that a leaf's voxels take: which are active, and what is left out.
const LEAST_LEAF_BYTES: usize = BRICK_VOXELS / 8 + 1;

/// A level of nodes that have children.
#[derive(Clone, Copy)]
pub(super) struct Level {
    /// Bits of a place along each axis.
    bits: u32,
    /// Bits of a voxel's index within a child.
    pub(super) child_bits: u32,
}

/// From the root's children down to the parents of leaves.
pub(super) const LEVELS: [Level; 2] = [Level { bits: 5, child_bits: 7 }, Level { bits: 4, child_bits: 3 }];

/// Voxels along a side of a child of the root.
pub(super) const ROOT_CHILD_SIDE: i32 = 4096;

/// What a tile counts for among the numbers that a volume may have: its bytes, in numbers.
const TILE_NUMBERS: u64 = (size_of::<Tile>() / size_of::<f32>()) as u64;

/// A tree, and how many of its numbers were none.
pub(super) struct Tree {
    pub(super) voxels: Voxels,
    pub(super) not_finite: u64,
}

/// Reads a tree that takes up at most as many numbers as `allowed` are, and takes them away from there.
pub(super) fn read(
    bytes: &mut Bytes<'_>,
    entry: &Entry<'_>,
    compression: Compression,
    allowed: &mut u64,
) -> Result<Tree, Trouble> {
    let buffers = bytes.u32()?;
    if buffers != 1 {
        return Err(Trouble::Unsupported(format!("its leaves have {buffers} buffers each, and one is read")));
    }
    let mut values = Values::new(entry, compression)?;
    values.background = values.single(bytes)?;
    let mut topology =
        Topology { values, leaves: Vec::new(), tiles: Vec::new(), allowed, scratch: Vec::new() };
    topology.read_root(bytes)?;
    let Topology { mut values, leaves, mut tiles, allowed, .. } = topology;
    tiles.sort_unstable_by_key(|tile| tile.origin);
    let voxels = read_leaves(bytes, &mut values, &leaves, allowed)?;
    Ok(Tree { voxels: Voxels { tiles, ..voxels }, not_finite: values.not_finite })
}

/// What is known of a tree before its leaves are read.
struct Topology<'a> {
    values: Values,
    /// The origins of leaves, in the order in which their voxels follow.
    leaves: Vec<[i32; 3]>,
    tiles: Vec<Tile>,
    allowed: &'a mut u64,
    scratch: Vec<f32>,
}

impl Topology<'_> {
    fn read_root(&mut self, bytes: &mut Bytes<'_>) -> Result<(), Trouble> {
        let tile_count = bytes.u32()?;
        let child_count = bytes.u32()?;
        let mut taken = Vec::new();
        for _ in 0..tile_count {
            let origin = root_origin(bytes)?;
            let value = self.values.single(bytes)?;
            let active = bytes.u8()? != 0;
            taken.push(origin);
            self.push_tile(Tile { origin, side: ROOT_CHILD_SIDE, value, active })?;
        }
        let mut children = Vec::new();
        for _ in 0..child_count {
            let origin = root_origin(bytes)?;
            let first = self.leaves.len();
            self.read_node(bytes, &LEVELS, origin)?;
            taken.push(origin);
            children.push((origin, first..self.leaves.len()));
        }
        taken.sort_unstable();
        if let Some([origin, _]) = taken.array_windows().find(|[one, next]| one == next) {
            return Err(Trouble::Damaged(format!("two of its nodes start at {origin:?}; export it again")));
        }
        // The voxels of leaves follow by their place, whatever the order of the topology.
        children.sort_unstable_by_key(|(origin, _)| *origin);
        self.leaves = children.into_iter().flat_map(|(_, leaves)| &self.leaves[leaves]).copied().collect();
        Ok(())
    }

    /// Reads the node at `origin`, and below it what `levels` say.
    fn read_node(
        &mut self,
        bytes: &mut Bytes<'_>,
        levels: &[Level],
        origin: [i32; 3],
    ) -> Result<(), Trouble> {
        let Some((&level, below)) = levels.split_first() else {
            self.leaves.push(origin);
            Mask::read(bytes, BRICK_VOXELS)?;
            return Ok(());
        };
        let places = level.places();
        let children = Mask::read(bytes, places)?;
        let active = Mask::read(bytes, places)?;
        let mut numbers = std::mem::take(&mut self.scratch);
        self.values.node(bytes, active, &mut numbers)?;
        for (place, number) in numbers.chunks_exact(self.values.kind.channels).enumerate() {
            if !children.is_on(place) {
                let mut value = [0.0; 3];
                value[..number.len()].copy_from_slice(number);
                let (origin, side) = (level.child(origin, place), 1 << level.child_bits);
                self.push_tile(Tile { origin, side, value, active: active.is_on(place) })?;
            }
        }
        self.scratch = numbers;
        for place in (0..places).filter(|&place| children.is_on(place)) {
            self.read_node(bytes, below, level.child(origin, place))?;
        }
        Ok(())
    }

    /// Keeps a tile if it differs from what is where nothing is stored.
    fn push_tile(&mut self, tile: Tile) -> Result<(), Trouble> {
        if tile.active || tile.value != self.values.background {
            spend(self.allowed, TILE_NUMBERS)?;
            self.tiles.push(tile);
        }
        Ok(())
    }
}

impl Level {
    /// How many children a node has.
    pub(super) fn places(self) -> usize {
        1 << (3 * self.bits)
    }

    /// The place of the child at `origin` within its node.
    pub(super) fn place(self, origin: [i32; 3]) -> usize {
        let last = (1 << self.bits) - 1;
        origin.iter().fold(0, |place, i| place << self.bits | (i >> self.child_bits & last) as usize)
    }

    /// The origin of the child at `place` of a node: places count along z, then y, then x.
    fn child(self, origin: [i32; 3], place: usize) -> [i32; 3] {
        let last = (1 << self.bits) - 1;
        [0, 1, 2].map(|axis| {
            let along = place >> (self.bits * (2 - axis as u32)) & last;
            origin[axis] + ((along as i32) << self.child_bits)
        })
    }
}

/// The origin of a child of the root.
fn root_origin(bytes: &mut Bytes<'_>) -> Result<[i32; 3], Trouble> {
    let origin = bytes.index()?;
    if origin.iter().any(|i| i % ROOT_CHILD_SIDE != 0) {
        let problem = format!("one of its nodes starts at {origin:?}, where none can; export it again");
        return Err(Trouble::Damaged(problem));
    }
    Ok(origin)
}

/// Reads the voxels of the leaves at `origins`.
fn read_leaves(
    bytes: &mut Bytes<'_>,
    values: &mut Values,
    origins: &[[i32; 3]],
    allowed: &mut u64,
) -> Result<Voxels, Trouble> {
    let (least, available) = (origins.len().saturating_mul(LEAST_LEAF_BYTES), bytes.remaining());
    if least > available {
        return Err(Trouble::Damaged(format!(
            "its {} leaves take {least} bytes at least, but only {available} follow; the file is cut off, so export or \
             copy it again",
            origins.len()
        )));
    }
    let channels = values.kind.channels;
    let length = channels * BRICK_VOXELS;
    spend(allowed, origins.len() as u64 * length as u64)?;

    let mut order: Vec<_> = (0..origins.len()).collect();
    order.sort_unstable_by_key(|&leaf| origins[leaf]);
    let mut bricks: Vec<_> =
        order.iter().map(|&leaf| Brick { origin: origins[leaf], active: [0; 8] }).collect();
    let mut place_of = vec![0; origins.len()];
    for (place, leaf) in order.into_iter().enumerate() {
        place_of[leaf] = place;
    }
    let mut numbers = vec![0.0; origins.len() * length];
    let mut leaf_numbers = Vec::with_capacity(length);
    for place in place_of {
        let active = Mask::read(bytes, BRICK_VOXELS)?;
        read_leaf(bytes, values, active, &mut leaf_numbers)?;
        let out = &mut numbers[place * length..][..length];
        for (stored, value) in leaf_numbers.chunks_exact(channels).enumerate() {
            // Stored along z, then y, then x.
            let [x, y, z] = [stored >> 6, stored >> 3 & 7, stored & 7];
            out[channels * (x + 8 * (y + 8 * z))..][..channels].copy_from_slice(value);
            bricks[place].active[z] |= u64::from(active.is_on(stored)) << (x + 8 * y);
        }
    }
    Ok(Voxels { channels, background: values.background, bricks, values: numbers, tiles: Vec::new() })
}

/// Reads the numbers of a leaf, behind the mask of its active voxels.
fn read_leaf(
    bytes: &mut Bytes<'_>,
    values: &mut Values,
    active: Mask<'_>,
    out: &mut Vec<f32>,
) -> Result<(), Trouble> {
    if values.kind.leaf == Leaf::Array {
        return values.node(bytes, active, out);
    }
    let _origin = bytes.index()?;
    let bits = if values.kind.leaf == Leaf::Bits { Mask::read(bytes, BRICK_VOXELS)? } else { active };
    out.clear();
    out.extend((0..BRICK_VOXELS).map(|voxel| f32::from(u8::from(bits.is_on(voxel)))));
    Ok(())
}

/// Takes `numbers` away from those that are allowed.
fn spend(allowed: &mut u64, numbers: u64) -> Result<(), Trouble> {
    *allowed = allowed.checked_sub(numbers).ok_or(Trouble::TooLarge)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::volume::grid::Grid;
    use crate::volume::vdb::archive::{Head, entries};
    use crate::volume::vdb::write::{VdbOptions, write_vdb};

    /// Reads two bricks and a tile, if so many numbers are allowed.
    fn read_with(mut allowed: u64) -> Result<Tree, Trouble> {
        let mut voxels =
            Voxels::from_dense([4, 0, 0], [8, 1, 1], 1, &[1.0; 8], [0.0; 3]).expect("a whole box");
        voxels.tiles.push(Tile { origin: [128, 0, 0], side: 128, value: [2.0, 0.0, 0.0], active: true });
        let world_from_index = glam::DMat4::IDENTITY.to_cols_array_2d();
        let voxels = Arc::new(voxels);
        let grid = Grid { name: String::new(), class: Default::default(), world_from_index, voxels };
        let mut bytes = Vec::new();
        write_vdb(&[grid], VdbOptions::default(), &mut bytes).expect("a grid in order");
        let mut entries = entries(&bytes).map_err(|(_, trouble)| trouble)?;
        let entry = entries.remove(0);
        let mut body = entry.body.clone();
        let head = Head::read(&mut body)?;
        read(&mut body, &entry, head.compression, &mut allowed)
    }

    #[test]
    fn more_numbers_than_are_allowed_are_refused() {
        let numbers = 2 * 512 + 8;
        assert!(read_with(numbers).is_ok_and(|tree| tree.voxels.active_count() == 8 + 128 * 128 * 128));
        let Err(refusal) = read_with(numbers - 1) else { panic!("it was read") };
        let message = refusal.of("a.vdb", None).to_string();
        let expected = "a.vdb: its grids have more than the 268435456 numbers that are allowed; export it with larger \
                        voxels, or with fewer grids";
        assert_eq!(message, expected);
    }
}
