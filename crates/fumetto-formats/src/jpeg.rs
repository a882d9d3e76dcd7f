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

#[cfg(test)]
mod tests {
    use super::*;

    const FOUR_QUARTERS: &[u8] = include_bytes!("../tests/fixtures/models/my textures/four quarters.jpg");

    /// The picture with another height and width in its frame header (ITU-T T.81, section B.2.2).
    fn resized(height: u16, width: u16) -> Vec<u8> {
        let mut bytes = FOUR_QUARTERS.to_vec();
        let is_header = |marker: &[u8]| marker == [0xff, 0xc0] || marker == [0xff, 0xc2];
        let header = bytes.windows(2).position(is_header).expect("a frame");
        bytes[header + 5..header + 7].copy_from_slice(&height.to_be_bytes());
        bytes[header + 7..header + 9].copy_from_slice(&width.to_be_bytes());
        bytes
    }

    fn message(bytes: &[u8]) -> String {
        read_jpeg("a.jpg", bytes).expect_err("not a whole picture").to_string()
    }

    #[test]
    fn every_pixel_has_four_channels() {
        let image = read_jpeg("a.jpg", FOUR_QUARTERS).expect("a whole picture");
        assert_eq!((image.width, image.height, image.pixels.len()), (32, 32, 4 * 32 * 32));
        assert!(image.rgba().all(|[.., alpha]| alpha == u8::MAX));
    }

    #[test]
    fn sizes_are_held_against_the_limit_and_the_bytes() {
        let expected =
            "a.jpg: 8193 × 32 pixels are more than the 8192 × 8192 that are allowed; scale the picture down";
        assert_eq!(message(&resized(32, 8193)), expected);
        let few = message(&resized(8192, 8192));
        assert!(few.contains("bytes are too few for the 8192 × 8192 pixels"), "{few}");
        assert!(message(b"\xff\xd8").starts_with("a.jpg: not a readable JPEG"));
    }
}
