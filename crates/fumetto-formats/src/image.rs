//! A picture in memory.

use crate::WriteError;

/// A picture of 8-bit sRGB with straight alpha, the kind that PNG stores.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
    /// Red, green, blue, alpha; row after row from the top, `4 * width * height` bytes.
    pub pixels: Vec<u8>,
}

impl Image {
    /// Refuses to write a picture whose pixels do not fill its size, or that has none.
    pub(crate) fn check(&self) -> Result<(), WriteError> {
        let bytes = 4 * u128::from(self.width) * u128::from(self.height);
        if self.pixels.len() as u128 != bytes {
            return Err(self.refuse(format!("its size asks for {bytes} bytes")));
        }
        if bytes == 0 {
            return Err(self.refuse("it needs at least one pixel".to_owned()));
        }
        Ok(())
    }

    /// Its pixels, one by one.
    pub(crate) fn rgba(&self) -> impl Iterator<Item = [u8; 4]> {
        self.pixels.as_chunks::<4>().0.iter().copied()
    }

    /// The error that this picture cannot be written because of `problem`.
    pub(crate) fn refuse(&self, problem: String) -> WriteError {
        WriteError::Image { width: self.width, height: self.height, bytes: self.pixels.len(), problem }
    }
}
