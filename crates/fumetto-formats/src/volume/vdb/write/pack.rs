//! The values of nodes, as they are stored (OpenVDB's `writeCompressedValues`).

use std::io::Write;

use flate2::write::ZlibEncoder;
use half::f16;

use super::VdbOptions;
use crate::volume::grid::{BRICK_VOXELS, Voxels};

/// A bit for each place of a node, the least significant of a byte first.
pub(super) struct Bits(Vec<u8>);

impl Bits {
    pub(super) fn new(size: usize) -> Self {
        Self(vec![0; size.div_ceil(8)])
    }

    pub(super) fn set(&mut self, place: usize, on: bool) {
        self.0[place / 8] |= u8::from(on) << (place % 8);
    }

    fn is_on(&self, place: usize) -> bool {
        self.0[place / 8] >> (place % 8) & 1 == 1
    }

    pub(super) fn bytes(&self) -> &[u8] {
        &self.0
    }
}

/// Writes the values of one grid.
pub(super) struct Packer<'a> {
    voxels: &'a Voxels,
    options: VdbOptions,
}

impl<'a> Packer<'a> {
    /// Refuses numbers that cannot be stored.
    pub(super) fn new(voxels: &'a Voxels, options: VdbOptions) -> Result<Self, String> {
        let channels = voxels.channels;
        if ![1, 3].contains(&channels) {
            return Err(format!("its values have {channels} channels, where 1 or 3 are possible"));
        }
        let (count, expected) = (voxels.values.len(), voxels.bricks.len() * channels * BRICK_VOXELS);
        if count != expected {
            return Err(format!("it has {count} numbers, where its bricks need {expected}"));
        }
        let tiles = voxels.tiles.iter().flat_map(|tile| &tile.value);
        let greatest = if options.half { f16::MAX.to_f32() } else { f32::MAX };
        let is_wrong = |number: &&f32| number.is_nan() || number.abs() > greatest;
        if let Some(number) = voxels.values.iter().chain(&voxels.background).chain(tiles).find(is_wrong) {
            return Err(format!("its number {number} cannot be stored; the greatest that can is {greatest}"));
        }
        Ok(Self { voxels, options })
    }

    pub(super) fn channels(&self) -> usize {
        self.voxels.channels
    }

    pub(super) fn background(&self) -> &'a [f32] {
        &self.voxels.background[..self.voxels.channels]
    }

    pub(super) fn brick_values(&self, place: usize) -> &'a [f32] {
        self.voxels.brick_values(place)
    }

    pub(super) fn put_background(&self, bytes: &mut Vec<u8>) {
        self.put_single(bytes, self.voxels.background);
    }

    /// Appends a value that stands alone: such are never stored as half floats, but are as coarse.
    pub(super) fn put_single(&self, bytes: &mut Vec<u8>, value: [f32; 3]) {
        value[..self.channels()].iter().for_each(|&number| bytes.extend(self.rounded(number).to_le_bytes()));
    }

    fn rounded(&self, number: f32) -> f32 {
        if self.options.half { f16::from_f32(number).to_f32() } else { number }
    }

    /// Appends the values of a node: those that are active, and what the others are in as few words as
    /// possible. What stands at children's places does not matter.
    pub(super) fn put_node(&self, bytes: &mut Vec<u8>, active: &Bits, children: &Bits, numbers: &[f32]) {
        let channels = self.channels();
        let values = || numbers.chunks_exact(channels).enumerate();
        let inactive = || values().filter(|&(place, _)| !active.is_on(place) && !children.is_on(place));
        let mut first = None;
        let mut second = None;
        let mut more = false;
        for (_, value) in inactive() {
            if *first.get_or_insert(value) != value && *second.get_or_insert(value) != value {
                more = true;
            }
        }
        let single = |value: &[f32]| {
            let mut single = [0.0; 3];
            single[..channels].copy_from_slice(value);
            single
        };
        match (first, second) {
            _ if more => bytes.push(6),
            (Some(first), Some(second)) => {
                bytes.push(5);
                self.put_single(bytes, single(first));
                self.put_single(bytes, single(second));
                let mut is_second = Bits::new(numbers.len() / channels);
                inactive().for_each(|(place, value)| is_second.set(place, value == second));
                bytes.extend(is_second.bytes());
            }
            (Some(first), None) if first != self.background() => {
                bytes.push(2);
                self.put_single(bytes, single(first));
            }
            _ => bytes.push(0),
        }
        let stored = values().filter(|&(place, _)| more || active.is_on(place)).flat_map(|(_, value)| value);
        self.put_array(bytes, stored.copied());
    }

    fn put_array(&self, bytes: &mut Vec<u8>, numbers: impl Iterator<Item = f32>) {
        let raw: Vec<u8> = if self.options.half {
            numbers.flat_map(|number| f16::from_f32(number).to_le_bytes()).collect()
        } else {
            numbers.flat_map(f32::to_le_bytes).collect()
        };
        // Empty arrays of half floats are not stored at all, others with their length.
        if !self.options.zip || raw.is_empty() && self.options.half {
            bytes.extend(raw);
            return;
        }
        // A vector takes all bytes.
        let mut encoder = ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        let packed = encoder.write_all(&raw).and_then(|()| encoder.finish());
        match packed {
            Ok(packed) if packed.len() < raw.len() => {
                bytes.extend((packed.len() as i64).to_le_bytes());
                bytes.extend(packed);
            }
            // A negative length says that the bytes are as they were.
            _ => {
                bytes.extend((-(raw.len() as i64)).to_le_bytes());
                bytes.extend(raw);
            }
        }
    }
}
