//! Animated GIF, through the `gif` crate.

mod clock;
mod histogram;
mod palette;

use std::io::Write;

use ::gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use self::clock::Clock;
pub use self::clock::{MAX_GIF_FPS, MIN_GIF_FPS};
use crate::{Image, WriteError};

/// Writes an animation frame by frame; it plays for ever.
///
/// Every frame has a palette of its own. If its colours fit (256, or 255 beside transparency) they are
/// all exact. If not, the colours that the caller keeps are exact, the rest of the palette is chosen to
/// fit the rest of the picture, and every other colour becomes the nearest in the palette. Nothing is
/// dithered, so a flat tone stays flat. The bytes depend on the frames alone.
///
/// A drawing that is held over several frames is written once and shown for as long. It is written when
/// the next one comes, or by [`finish`](Self::finish).
pub struct GifWriter<W: Write> {
    encoder: Encoder<W>,
    width: u16,
    height: u16,
    clock: Clock,
    transparent: bool,
    keep: Vec<[u8; 3]>,
    /// The drawing that may still be held.
    held: Option<Frame<'static>>,
}

impl<W: Write> GifWriter<W> {
    /// Starts an animation of `width` × `height` pixels and `fps` frames a second.
    ///
    /// `keep` holds the sRGB colours that have to stay exact: tones, ink, flat background. Should more
    /// of them appear in one frame than a palette holds, those that fill most pixels win.
    ///
    /// If `transparent`, a pixel whose alpha is below 128 is not drawn and any other is opaque; if not,
    /// alpha is ignored.
    ///
    /// # Errors
    /// If a side is 0 or above 65 535, `fps` is outside of [`MIN_GIF_FPS`] to [`MAX_GIF_FPS`], or `out`
    /// refuses the header.
    pub fn new(
        out: W,
        width: u32,
        height: u32,
        fps: f32,
        transparent: bool,
        keep: &[[u8; 3]],
    ) -> Result<Self, WriteError> {
        let clock = Clock::new(fps).ok_or(WriteError::GifRate { fps })?;
        let side = |pixels: u32| u16::try_from(pixels).ok().filter(|pixels| *pixels > 0);
        let (Some(width), Some(height)) = (side(width), side(height)) else {
            let problem = "a side of a GIF has 1 to 65535 pixels; choose another size".to_owned();
            return Err(WriteError::Image { width, height, bytes: 0, problem });
        };
        let mut encoder = Encoder::new(out, width, height, &[]).map_err(failed)?;
        encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
        Ok(Self { encoder, width, height, clock, transparent, keep: keep.to_vec(), held: None })
    }

    /// Adds a frame.
    ///
    /// # Errors
    /// If the picture is not of the animation's size, or the output refuses the bytes.
    pub fn push(&mut self, image: &Image) -> Result<(), WriteError> {
        image.check()?;
        let (width, height) = (self.width, self.height);
        if (image.width, image.height) != (width.into(), height.into()) {
            return Err(image.refuse(format!("every frame of this GIF has {width} × {height} pixels")));
        }
        let indexed = palette::index(image, self.transparent, &self.keep);
        let frame = Frame {
            width,
            height,
            buffer: indexed.indices.into(),
            palette: Some(indexed.palette.into_flattened()),
            transparent: indexed.transparent,
            delay: self.clock.tick(),
            // What shows through a transparent pixel must not be the frame before.
            dispose: if self.transparent { DisposalMethod::Background } else { DisposalMethod::Keep },
            ..Frame::default()
        };
        match &mut self.held {
            Some(held) if is_same_drawing(held, &frame) && held.delay.checked_add(frame.delay).is_some() => {
                held.delay += frame.delay;
                Ok(())
            }
            held => {
                held.replace(frame).map_or(Ok(()), |done| self.encoder.write_frame(&done).map_err(failed))
            }
        }
    }

    /// Ends the file and gives the output back, not flushed.
    ///
    /// # Errors
    /// If the output refuses the last byte.
    pub fn finish(mut self) -> Result<W, WriteError> {
        if let Some(last) = self.held.take() {
            self.encoder.write_frame(&last).map_err(failed)?;
        }
        self.encoder.into_inner().map_err(failed)
    }
}

fn is_same_drawing(one: &Frame<'_>, other: &Frame<'_>) -> bool {
    one.buffer == other.buffer && one.palette == other.palette && one.transparent == other.transparent
}

fn failed(error: EncodingError) -> WriteError {
    match error {
        EncodingError::Io(error) => WriteError::Io(error),
        // Sizes and palettes were checked, so what is left is a lack of memory.
        other => WriteError::Io(std::io::Error::other(other)),
    }
}
