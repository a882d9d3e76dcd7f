//! The numbers of nodes, as they are stored: their types, and which of them are left out (OpenVDB's
//! `readCompressedValues`).

use half::f16;

use super::Trouble;
use super::archive::Entry;
use super::bytes::Bytes;
use super::codec::Compression;
use crate::excerpt::excerpt;

/// What the numbers of a tree are.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    scalar: Scalar,
    /// Numbers of a value.
    pub(super) channels: usize,
    pub(super) leaf: Leaf,
}

/// A type of numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Scalar {
    Bool,
    I32,
    I64,
    F16,
    F32,
    F64,
}

/// How leaves store their voxels.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Leaf {
    /// As an array.
    Array,
    /// A bit each.
    Bits,
    /// Not at all: active voxels are 1, others 0.
    Mask,
}

impl Kind {
    /// What a tree of the type `Tree_<values>_5_4_3` holds: nodes of 32³, 16³ and 8³.
    pub(super) fn parse(tree_type: &[u8]) -> Result<Self, Trouble> {
        let values = tree_type.strip_prefix(b"Tree_").and_then(|name| name.strip_suffix(b"_5_4_3"));
        let (scalar, channels, leaf) = match values {
            Some(b"float") => (Scalar::F32, 1, Leaf::Array),
            Some(b"half") => (Scalar::F16, 1, Leaf::Array),
            Some(b"double") => (Scalar::F64, 1, Leaf::Array),
            Some(b"int32") => (Scalar::I32, 1, Leaf::Array),
            Some(b"int64") => (Scalar::I64, 1, Leaf::Array),
            Some(b"bool") => (Scalar::Bool, 1, Leaf::Bits),
            Some(b"mask") => (Scalar::Bool, 1, Leaf::Mask),
            Some(b"vec3s") => (Scalar::F32, 3, Leaf::Array),
            Some(b"vec3d") => (Scalar::F64, 3, Leaf::Array),
            Some(b"vec3i") => (Scalar::I32, 3, Leaf::Array),
            _ => {
                return Err(Trouble::Unsupported(format!(
                    "its type is `{}`, which is not read; what is are numbers and vectors of three in trees of the \
                     usual shape, such as `Tree_float_5_4_3`",
                    excerpt(tree_type)
                )));
            }
        };
        Ok(Self { scalar, channels, leaf })
    }

    /// Bytes of a value.
    fn size(self) -> usize {
        self.channels * self.scalar.size()
    }

    /// Whether half floats may stand for its values.
    fn is_real(self) -> bool {
        matches!(self.scalar, Scalar::F16 | Scalar::F32 | Scalar::F64)
    }
}

impl Scalar {
    fn size(self) -> usize {
        match self {
            Self::Bool => 1,
            Self::F16 => 2,
            Self::I32 | Self::F32 => 4,
            Self::I64 | Self::F64 => 8,
        }
    }

    /// Appends the numbers that `raw` holds.
    fn decode(self, raw: &[u8], numbers: &mut Vec<f32>) {
        match self {
            Self::Bool => numbers.extend(raw.iter().map(|&byte| f32::from(u8::from(byte != 0)))),
            Self::F16 => numbers.extend(raw.as_chunks().0.iter().map(|&b| f16::from_le_bytes(b).to_f32())),
            Self::I32 => numbers.extend(raw.as_chunks().0.iter().map(|&b| i32::from_le_bytes(b) as f32)),
            Self::F32 => numbers.extend(raw.as_chunks().0.iter().map(|&b| f32::from_le_bytes(b))),
            Self::I64 => numbers.extend(raw.as_chunks().0.iter().map(|&b| i64::from_le_bytes(b) as f32)),
            Self::F64 => numbers.extend(raw.as_chunks().0.iter().map(|&b| f64::from_le_bytes(b) as f32)),
        }
    }
}

/// A bit for each child or voxel of a node, the least significant of a byte first.
#[derive(Clone, Copy)]
pub(super) struct Mask<'a>(&'a [u8]);

impl<'a> Mask<'a> {
    /// Reads the mask of a node with `size` children or voxels.
    pub(super) fn read(bytes: &mut Bytes<'a>, size: usize) -> Result<Self, Trouble> {
        Ok(Self(bytes.take(size / 8)?))
    }

    pub(super) fn is_on(self, place: usize) -> bool {
        self.0[place / 8] >> (place % 8) & 1 == 1
    }

    pub(super) fn size(self) -> usize {
        8 * self.0.len()
    }

    fn count(self) -> usize {
        self.0.iter().map(|byte| byte.count_ones() as usize).sum()
    }
}

/// Reads the numbers of one tree.
pub(super) struct Values {
    pub(super) kind: Kind,
    /// The type that arrays are stored as.
    stored: Kind,
    compression: Compression,
    /// Zero until it is known.
    pub(super) background: [f32; 3],
    /// How many numbers were none or infinite, and were replaced by the background.
    pub(super) not_finite: u64,
    /// An array's bytes, and the numbers that they are.
    raw: Vec<u8>,
    numbers: Vec<f32>,
}

impl Values {
    pub(super) fn new(entry: &Entry<'_>, compression: Compression) -> Result<Self, Trouble> {
        let kind = Kind::parse(entry.tree_type)?;
        let stored = if entry.half && kind.is_real() { Kind { scalar: Scalar::F16, ..kind } } else { kind };
        Ok(Self {
            kind,
            stored,
            compression,
            background: [0.0; 3],
            not_finite: 0,
            raw: Vec::new(),
            numbers: Vec::new(),
        })
    }

    /// Reads a value that stands alone: such are never stored as half floats.
    pub(super) fn single(&mut self, bytes: &mut Bytes<'_>) -> Result<[f32; 3], Trouble> {
        let raw = bytes.take(self.kind.size())?;
        self.numbers.clear();
        self.kind.scalar.decode(raw, &mut self.numbers);
        self.mend();
        let mut value = [0.0; 3];
        value[..self.kind.channels].copy_from_slice(&self.numbers);
        Ok(value)
    }

    /// Reads the values of a node of which `active` are active: for each of its places, all channels.
    pub(super) fn node(
        &mut self,
        bytes: &mut Bytes<'_>,
        active: Mask<'_>,
        out: &mut Vec<f32>,
    ) -> Result<(), Trouble> {
        let places = active.size();
        // The inactive values that are left out, and where which one belongs, are told by a number.
        let left_out = bytes.u8()?;
        let mut inactive = match left_out {
            0 | 6 => [self.background; 2],
            1..=5 => [self.negative(self.background), self.background],
            _ => {
                let problem = format!(
                    "a node leaves out values in a way `{left_out}` that is not known; export it again"
                );
                return Err(Trouble::Damaged(problem));
            }
        };
        if matches!(left_out, 2 | 4 | 5) {
            inactive[0] = self.single(bytes)?;
        }
        if left_out == 5 {
            inactive[1] = self.single(bytes)?;
        }
        let second = if matches!(left_out, 3..=5) { Some(Mask::read(bytes, places)?) } else { None };

        let dense = !self.compression.active_mask || left_out == 6;
        let count = if dense { places } else { active.count() };
        self.array(bytes, count)?;
        out.clear();
        if count == places {
            out.extend_from_slice(&self.numbers);
            return Ok(());
        }
        let channels = self.kind.channels;
        let mut stored = self.numbers.chunks_exact(channels);
        for place in 0..places {
            let is_second = second.is_some_and(|mask| mask.is_on(place));
            let left_out = &inactive[usize::from(is_second)][..channels];
            out.extend_from_slice(if active.is_on(place) {
                stored.next().unwrap_or(left_out)
            } else {
                left_out
            });
        }
        Ok(())
    }

    /// Fills `numbers` with an array of `count` values.
    fn array(&mut self, bytes: &mut Bytes<'_>, count: usize) -> Result<(), Trouble> {
        self.numbers.clear();
        // Empty arrays of half floats are not stored at all, others with their length.
        if count == 0 && self.stored.scalar != self.kind.scalar {
            return Ok(());
        }
        self.raw.resize(count * self.stored.size(), 0);
        self.compression.codec.read(bytes, &mut self.raw)?;
        self.stored.scalar.decode(&self.raw, &mut self.numbers);
        self.mend();
        Ok(())
    }

    /// Puts the background where numbers are none or infinite.
    fn mend(&mut self) {
        for value in self.numbers.chunks_exact_mut(self.kind.channels) {
            for (number, instead) in value.iter_mut().zip(self.background) {
                if !number.is_finite() {
                    *number = instead;
                    self.not_finite += 1;
                }
            }
        }
    }

    /// The value that stands for "minus background".
    fn negative(&self, value: [f32; 3]) -> [f32; 3] {
        match self.kind.scalar {
            Scalar::Bool => value.map(|number| 1.0 - number),
            _ => value.map(|number| -number),
        }
    }
}
