//! The tree that bricks and tiles are hung into.

use std::collections::BTreeMap;

use super::pack::{Bits, Packer};
use super::{put_index, put_u32};
use crate::volume::grid::{BRICK_SIDE, BRICK_VOXELS, Brick, Tile, Voxels};
use crate::volume::vdb::tree::{LEVELS, Level, ROOT_CHILD_SIDE};

/// The root's children and tiles.
pub(super) struct Nodes<'a>(Slots<'a>);

/// What stands in a node, by its origin: that is the order in which OpenVDB keeps it.
type Slots<'a> = BTreeMap<[i32; 3], Slot<'a>>;

enum Slot<'a> {
    Tile(&'a Tile),
    /// A brick, and its place among all.
    Brick(&'a Brick, usize),
    Node(Slots<'a>),
}

impl<'a> Nodes<'a> {
    /// Hangs up all bricks and tiles; refuses those that are askew or in one another's way.
    pub(super) fn of(voxels: &'a Voxels) -> Result<Self, String> {
        let mut slots = Slots::new();
        for (place, brick) in voxels.bricks.iter().enumerate() {
            insert(&mut slots, brick.origin, BRICK_SIDE, Slot::Brick(brick, place))?;
        }
        for tile in &voxels.tiles {
            insert(&mut slots, tile.origin, tile.side, Slot::Tile(tile))?;
        }
        Ok(Self(slots))
    }

    pub(super) fn topology(&self, packer: &Packer<'_>) -> Vec<u8> {
        let mut topology = Vec::new();
        let bytes = &mut topology;
        // Each leaf has one buffer.
        put_u32(bytes, 1);
        packer.put_background(bytes);
        let tiles = || self.0.values().filter(|slot| matches!(slot, Slot::Tile(_)));
        let tile_count = tiles().count();
        put_u32(bytes, tile_count as u32);
        put_u32(bytes, (self.0.len() - tile_count) as u32);
        for slot in tiles() {
            if let Slot::Tile(tile) = slot {
                put_index(bytes, tile.origin);
                packer.put_single(bytes, tile.value);
                bytes.push(tile.active.into());
            }
        }
        for (&origin, slot) in &self.0 {
            if let Slot::Node(slots) = slot {
                put_index(bytes, origin);
                put_node(slots, &LEVELS, packer, bytes);
            }
        }
        topology
    }

    pub(super) fn voxels(&self, packer: &Packer<'_>) -> Vec<u8> {
        let mut bytes = Vec::new();
        put_voxels(&self.0, packer, &mut bytes);
        bytes
    }
}

fn insert<'a>(slots: &mut Slots<'a>, origin: [i32; 3], side: i32, slot: Slot<'a>) -> Result<(), String> {
    let sides = [ROOT_CHILD_SIDE, 1 << LEVELS[0].child_bits, 1 << LEVELS[1].child_bits];
    let Some(depth) = sides.iter().position(|&possible| possible == side) else {
        return Err(format!("a tile has {side} voxels a side, where only {sides:?} are possible"));
    };
    if origin.iter().any(|i| i % side != 0) {
        return Err(format!(
            "a cube of {side} voxels a side starts at {origin:?}, which are no multiples of {side}"
        ));
    }
    let overlap = || Err(format!("two of its bricks and tiles cover the voxel {origin:?}"));
    let mut slots = slots;
    for side in &sides[..depth] {
        let corner = origin.map(|i| i & !(side - 1));
        let Slot::Node(below) = slots.entry(corner).or_insert_with(|| Slot::Node(Slots::new())) else {
            return overlap();
        };
        slots = below;
    }
    if slots.insert(origin, slot).is_some() { overlap() } else { Ok(()) }
}

fn put_node(slots: &Slots<'_>, levels: &[Level], packer: &Packer<'_>, bytes: &mut Vec<u8>) {
    let Some((level, below)) = levels.split_first() else { return };
    let mut children = Bits::new(level.places());
    let mut active = Bits::new(level.places());
    let mut numbers = packer.background().repeat(level.places());
    let channels = packer.channels();
    for (&origin, slot) in slots {
        let place = level.place(origin);
        if let Slot::Tile(tile) = slot {
            active.set(place, tile.active);
            numbers[channels * place..][..channels].copy_from_slice(&tile.value[..channels]);
        } else {
            children.set(place, true);
        }
    }
    bytes.extend(children.bytes());
    bytes.extend(active.bytes());
    packer.put_node(bytes, &active, &children, &numbers);
    for slot in slots.values() {
        match slot {
            Slot::Node(slots) => put_node(slots, below, packer, bytes),
            Slot::Brick(brick, _) => bytes.extend(stored_mask(brick).bytes()),
            Slot::Tile(_) => {}
        }
    }
}

fn put_voxels(slots: &Slots<'_>, packer: &Packer<'_>, bytes: &mut Vec<u8>) {
    for slot in slots.values() {
        match slot {
            Slot::Node(slots) => put_voxels(slots, packer, bytes),
            Slot::Brick(brick, place) => {
                let active = stored_mask(brick);
                bytes.extend(active.bytes());
                let channels = packer.channels();
                let values = packer.brick_values(*place);
                let along_z = (0..BRICK_VOXELS).flat_map(|stored| {
                    let [x, y, z] = stored_place(stored);
                    &values[channels * (x + 8 * (y + 8 * z))..][..channels]
                });
                let numbers: Vec<f32> = along_z.copied().collect();
                packer.put_node(bytes, &active, &Bits::new(BRICK_VOXELS), &numbers);
            }
            Slot::Tile(_) => {}
        }
    }
}

/// Which voxels are active, in OpenVDB's order.
fn stored_mask(brick: &Brick) -> Bits {
    let mut bits = Bits::new(BRICK_VOXELS);
    for stored in 0..BRICK_VOXELS {
        let [x, y, z] = stored_place(stored);
        bits.set(stored, brick.active[z] >> (x + 8 * y) & 1 == 1);
    }
    bits
}

/// The place in a leaf of the voxel that OpenVDB stores there: it counts along z, then y, then x.
fn stored_place(stored: usize) -> [usize; 3] {
    [stored >> 6, stored >> 3 & 7, stored & 7]
}
