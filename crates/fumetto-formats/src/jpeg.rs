//! JPEG, through the `zune-jpeg` crate.

use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

use crate::{FormatError, Image, MAX_IMAGE_SIDE};

/// Every block of 8 × 8 samples takes one bit at least.
const MAX_PIXELS_PER_BYTE: u64 = 8 * 8 * 8;

/// Scans of a progressive picture: more than any encoder writes, and few enough to be read in no time.
const MAX_SCANS: usize = 64;

/// Reads a JPEG as 8-bit sRGB. `name` is for messages.
///
/// Colour profiles are not applied, as with PNG.
///
/// # Errors
/// If the bytes are not a JPEG, or a side is longer than [`MAX_IMAGE_SIDE`].
pub(crate) fn read_jpeg(name: &str, bytes: &[u8]) -> Result<Image, FormatError> {
    let malformed =
        |problem: String| FormatError::Malformed { file: name.to_owned(), position: None, problem };
    let broken = |error: &dyn std::fmt::Debug| {
        let error = crate::excerpt::excerpt(format!("{error:?}").as_bytes());
        malformed(format!("not a readable JPEG ({error}); export it again"))
    };

    let options = DecoderOptions::default()
        .set_max_width(usize::from(u16::MAX))
        .set_max_height(usize::from(u16::MAX))
        .jpeg_set_max_scans(MAX_SCANS)
        .jpeg_set_out_colorspace(ColorSpace::RGBA);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder.decode_headers().map_err(|error| broken(&error))?;
    let header = decoder.info().ok_or_else(|| broken(&"no header"))?;
    let (width, height) = (u32::from(header.width), u32::from(header.height));
    if width.max(height) > MAX_IMAGE_SIDE {
        return Err(FormatError::ImageTooLarge {
            file: name.to_owned(),
            width,
            height,
            allowed: MAX_IMAGE_SIDE,
        });
    }
    let area = u64::from(width) * u64::from(height);
    if area > MAX_PIXELS_PER_BYTE * bytes.len() as u64 {
        return Err(malformed(format!(
            "{} bytes are too few for the {width} × {height} pixels that its header promises; the file is cut off",
            bytes.len()
        )));
    }
    let pixels = decoder.decode().map_err(|error| broken(&error))?;
    if pixels.len() as u64 != 4 * area {
        return Err(malformed("its kind of colour is not supported; export it as PNG".to_owned()));
    }
    Ok(Image { width, height, pixels })
}
