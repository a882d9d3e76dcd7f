//! Little-endian numbers and strings, one after another.

use super::Trouble;

/// What is left to read of a file, or of one grid in it.
#[derive(Clone)]
pub(super) struct Bytes<'a> {
    all: &'a [u8],
    at: usize,
}

impl<'a> Bytes<'a> {
    pub(super) fn new(all: &'a [u8]) -> Self {
        Self { all, at: 0 }
    }

    /// How many bytes were read.
    pub(super) fn position(&self) -> usize {
        self.at
    }

    /// How many bytes follow.
    pub(super) fn remaining(&self) -> usize {
        self.all.len() - self.at
    }

    /// What follows, as bytes of their own that end before byte `end`, and goes on behind them.
    pub(super) fn section(&mut self, end: usize) -> Result<Self, Trouble> {
        let length = end.checked_sub(self.at).ok_or_else(|| self.cut_off(0))?;
        Ok(Self::new(self.take(length)?))
    }

    pub(super) fn take(&mut self, count: usize) -> Result<&'a [u8], Trouble> {
        let taken = self.all[self.at..].get(..count).ok_or_else(|| self.cut_off(count))?;
        self.at += count;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], Trouble> {
        let (array, _) = self.all[self.at..].split_first_chunk().ok_or_else(|| self.cut_off(N))?;
        self.at += N;
        Ok(*array)
    }

    pub(super) fn u8(&mut self) -> Result<u8, Trouble> {
        Ok(u8::from_le_bytes(self.array()?))
    }

    pub(super) fn u32(&mut self) -> Result<u32, Trouble> {
        Ok(u32::from_le_bytes(self.array()?))
    }

    pub(super) fn i64(&mut self) -> Result<i64, Trouble> {
        Ok(i64::from_le_bytes(self.array()?))
    }

    pub(super) fn f64(&mut self) -> Result<f64, Trouble> {
        Ok(f64::from_le_bytes(self.array()?))
    }

    /// Three coordinates of a voxel.
    pub(super) fn index(&mut self) -> Result<[i32; 3], Trouble> {
        Ok([self.u32()?, self.u32()?, self.u32()?].map(u32::cast_signed))
    }

    /// The bytes of a string, behind their count.
    pub(super) fn string(&mut self) -> Result<&'a [u8], Trouble> {
        let length = self.u32()?;
        self.take(length as usize)
    }

    fn cut_off(&self, count: usize) -> Trouble {
        Trouble::Damaged(format!(
            "{count} bytes are asked for where only {} are left; the file is cut off or damaged, so export or copy it \
             again",
            self.remaining()
        ))
    }
}
