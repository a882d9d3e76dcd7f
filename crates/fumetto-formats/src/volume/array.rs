//! Arrays with a number for every voxel of a box: what NRRD and npy files hold.

use std::sync::Arc;

use fumetto_scene::RawNumber;
use glam::DMat4;
use half::f16;

use super::MAX_VOLUME_NUMBERS;
use super::dense::{Strided, Strides};
use super::grid::{BRICK_SIDE, BRICK_VOXELS, Grid, GridClass, Volume, Voxels, has_inverse};
use crate::FormatError;

/// A type of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    U64,
    I64,
    F16,
    F32,
    F64,
}

impl From<RawNumber> for Number {
    fn from(number: RawNumber) -> Self {
        match number {
            RawNumber::U8 => Self::U8,
            RawNumber::I8 => Self::I8,
            RawNumber::U16 => Self::U16,
            RawNumber::I16 => Self::I16,
            RawNumber::U32 => Self::U32,
            RawNumber::I32 => Self::I32,
            RawNumber::F16 => Self::F16,
            RawNumber::F32 => Self::F32,
            RawNumber::F64 => Self::F64,
        }
    }
}

impl Number {
    /// Bytes of a number.
    pub(super) fn size(self) -> usize {
        match self {
            Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 | Self::F16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::U64 | Self::I64 | Self::F64 => 8,
        }
    }

    /// The numbers that `bytes` hold, in the nearest single precision.
    pub(super) fn decode(self, bytes: &[u8], big_endian: bool) -> Vec<f32> {
        fn each<const N: usize>(bytes: &[u8], big_endian: bool, decode: impl Fn([u8; N]) -> f32) -> Vec<f32> {
            let in_order = |&(mut number): &[u8; N]| {
                if big_endian {
                    number.reverse();
                }
                decode(number)
            };
            bytes.as_chunks().0.iter().map(in_order).collect()
        }
        match self {
            Self::U8 => each(bytes, big_endian, |b| u8::from_le_bytes(b).into()),
            Self::I8 => each(bytes, big_endian, |b| i8::from_le_bytes(b).into()),
            Self::U16 => each(bytes, big_endian, |b| u16::from_le_bytes(b).into()),
            Self::I16 => each(bytes, big_endian, |b| i16::from_le_bytes(b).into()),
            Self::U32 => each(bytes, big_endian, |b| u32::from_le_bytes(b) as f32),
            Self::I32 => each(bytes, big_endian, |b| i32::from_le_bytes(b) as f32),
            Self::U64 => each(bytes, big_endian, |b| u64::from_le_bytes(b) as f32),
            Self::I64 => each(bytes, big_endian, |b| i64::from_le_bytes(b) as f32),
            Self::F16 => each(bytes, big_endian, |b| f16::from_le_bytes(b).to_f32()),
            Self::F32 => each(bytes, big_endian, f32::from_le_bytes),
            Self::F64 => each(bytes, big_endian, |b| f64::from_le_bytes(b) as f32),
        }
    }
}

/// What a file says of its array.
pub(super) struct Array<'a> {
    pub(super) file: &'a str,
    pub(super) size: [u32; 3],
    /// Numbers of a voxel: 1 or 3.
    pub(super) channels: usize,
    /// `None` if voxels have no size.
    pub(super) world_from_index: Option<DMat4>,
}

impl Array<'_> {
    /// How many numbers it has; refuses none, and more than are allowed once they are in bricks.
    pub(super) fn count(&self) -> Result<usize, FormatError> {
        if self.size.contains(&0) {
            return Err(malformed(
                self.file,
                "there is no voxel in it; export it again with at least one".to_owned(),
            ));
        }
        let bricks = self.size.map(|side| u64::from(side.div_ceil(BRICK_SIDE.unsigned_abs())));
        let numbers = [self.channels as u64, BRICK_VOXELS as u64].into_iter().chain(bricks);
        let numbers = numbers.reduce(u64::saturating_mul).unwrap_or(0);
        if numbers > MAX_VOLUME_NUMBERS {
            return Err(FormatError::VolumeTooLarge {
                file: self.file.to_owned(),
                allowed: MAX_VOLUME_NUMBERS,
            });
        }
        Ok(self.size.iter().map(|&side| side as usize).product::<usize>() * self.channels)
    }

    /// The volume of its numbers: one grid, called as the file, whose zeros are background.
    pub(super) fn volume(&self, mut values: Vec<f32>, strides: Strides) -> Result<Volume, FormatError> {
        let malformed = |problem: String| malformed(self.file, problem);
        let mut notes = Vec::new();
        let broken = values.iter_mut().filter(|number| !number.is_finite());
        let broken = broken.map(|number| *number = 0.0).count();
        if broken > 0 {
            notes.push(format!(
                "{}: {broken} of its values are infinite or no numbers; they became zero",
                self.file
            ));
        }
        if self.world_from_index.is_none() {
            notes.push(format!("{}: it does not tell the size of its voxels; they are 1 m wide", self.file));
        }
        let world_from_index = self.world_from_index.unwrap_or(DMat4::IDENTITY);
        if !has_inverse(&world_from_index) {
            return Err(malformed("its voxels have no size; correct its spacings or directions".to_owned()));
        }
        let dense = Strided { values: &values, strides };
        let voxels = Voxels::from_strided([0; 3], self.size, self.channels, &dense, [0.0; 3]);
        let voxels =
            voxels.ok_or_else(|| malformed("its sides are too long; cut it to pieces".to_owned()))?;
        let grid = Grid {
            name: stem(self.file).to_owned(),
            class: GridClass::Unknown,
            world_from_index: world_from_index.to_cols_array_2d(),
            voxels: Arc::new(voxels),
        };
        Ok(Volume { grids: vec![grid], notes })
    }
}

/// The file's name without folders and extension.
fn stem(file: &str) -> &str {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

/// The error that `file` as a whole is not in order.
pub(super) fn malformed(file: &str, problem: String) -> FormatError {
    FormatError::Malformed { file: file.to_owned(), position: None, problem }
}
