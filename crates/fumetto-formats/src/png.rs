//! PNG, through the `png` crate.

use std::{
    borrow::Cow,
    io::{Cursor, Write},
};

use png::{BitDepth, ColorType, Compression, Decoder, Encoder, EncodingError, Limits, Transformations};

use crate::{FormatError, Image, WriteError};

/// Most pixels on a side of a picture that is read: what every GPU takes as one texture.
pub const MAX_IMAGE_SIDE: u32 = 8192;

/// What the decoder may allocate beside the picture: a few rows, the palette, the chunk at hand.
const DECODER_BYTES: usize = 16 << 20;

/// Bytes of a chunk of a picture that is written band by band.
const CHUNK_BYTES: usize = 1 << 20;

/// Deflate never makes data smaller than this many times (zlib's "Maximum Compression Factor").
const MAX_DEFLATE_FACTOR: u64 = 1032;

/// Reads a PNG of any colour type and bit depth as 8-bit sRGB with straight alpha.
///
/// Of 16-bit samples the upper byte is kept. Colour profiles and gamma are not applied: the numbers
/// are taken as sRGB, so that a picked colour stays what it is. Of an animation the default picture is
/// read. `name` is for messages.
///
/// # Errors
/// If the bytes are not a whole PNG, or a side is longer than [`MAX_IMAGE_SIDE`].
pub fn read_png(name: &str, bytes: &[u8]) -> Result<Image, FormatError> {
    let malformed =
        |problem: String| FormatError::Malformed { file: name.to_owned(), position: None, problem };
    let broken =
        |error: png::DecodingError| malformed(format!("not a readable PNG ({error}); export it again"));

    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), Limits { bytes: DECODER_BYTES });
    decoder.set_transformations(Transformations::ALPHA | Transformations::EXPAND | Transformations::STRIP_16);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);

    let header = decoder.read_header_info().map_err(broken)?;
    let (width, height) = (header.width, header.height);
    if width.max(height) > MAX_IMAGE_SIDE {
        return Err(FormatError::ImageTooLarge {
            file: name.to_owned(),
            width,
            height,
            allowed: MAX_IMAGE_SIDE,
        });
    }
    let least_raw_bytes = u64::from(width) * u64::from(height) * header.bits_per_pixel() as u64 / 8;
    if least_raw_bytes > MAX_DEFLATE_FACTOR * bytes.len() as u64 {
        return Err(malformed(format!(
            "{} bytes are too few for the {width} × {height} pixels that its header promises; the file is cut off",
            bytes.len()
        )));
    }

    let mut reader = decoder.read_info().map_err(broken)?;
    let size = reader
        .output_buffer_size()
        .ok_or_else(|| malformed("its pixels do not fit into memory; scale the picture down".to_owned()))?;
    let mut pixels = vec![0; size];
    let frame = reader.next_frame(&mut pixels).map_err(broken)?;
    if (frame.width, frame.height) != (width, height) {
        return Err(malformed(format!(
            "its first frame covers {} × {} of {width} × {height} pixels; export it as a plain PNG",
            frame.width, frame.height
        )));
    }
    match frame.color_type {
        ColorType::Rgba => {}
        ColorType::GrayscaleAlpha => pixels = grey_to_rgba(&pixels),
        other => {
            return Err(malformed(format!("its colour type {other:?} is not supported; export it as RGBA")));
        }
    }
    Ok(Image { width, height, pixels })
}

/// Spreads pairs of grey and alpha to four channels.
fn grey_to_rgba(pixels: &[u8]) -> Vec<u8> {
    let pairs = pixels.as_chunks::<2>().0;
    pairs.iter().flat_map(|&[grey, alpha]| [grey, grey, grey, alpha]).collect()
}

/// Writes a picture as PNG, marked as sRGB: RGBA, or RGB if every pixel is opaque.
///
/// The bytes depend on the picture alone. `out` is not flushed.
///
/// # Errors
/// If the picture has no pixels or not as many as its size says, or `out` refuses the bytes.
pub fn write_png(image: &Image, out: impl Write) -> Result<(), WriteError> {
    image.check()?;
    let failed = |error| refused(error, image);
    let opaque = image.rgba().all(|[.., alpha]| alpha == u8::MAX);
    let mut writer = encoder(out, [image.width, image.height], opaque).write_header().map_err(failed)?;
    writer.write_image_data(&stored(image, opaque)).map_err(failed)?;
    writer.finish().map_err(failed)
}

/// Writes a picture of `size` as PNG, marked as sRGB, without ever holding all of it: `next_band` gives the next
/// rows, until there are none. It is RGB if it is said to be `opaque`; then alpha is ignored.
///
/// The bytes depend on the picture and its bands alone. `out` is not flushed.
///
/// # Errors
/// If the bands are not of the picture's width, or too few or too many; if `next_band` fails, or `out` refuses
/// the bytes.
pub fn write_png_bands<E: From<WriteError>>(
    size: [u32; 2],
    opaque: bool,
    out: impl Write,
    mut next_band: impl FnMut() -> Result<Option<Image>, E>,
) -> Result<(), E> {
    let [width, height] = size;
    let whole = Image { width, height, pixels: Vec::new() };
    let failed = |error| refused(error, &whole);
    let mut writer = encoder(out, size, opaque).write_header().map_err(failed)?;
    let mut rows = writer.stream_writer_with_size(CHUNK_BYTES).map_err(failed)?;
    while let Some(band) = next_band()? {
        band.check()?;
        if band.width != width {
            return Err(whole.refuse(format!("a band of it is {} pixels wide", band.width)).into());
        }
        rows.write_all(&stored(&band, opaque)).map_err(WriteError::Io)?;
    }
    rows.finish().map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(())
}

fn encoder<W: Write>(out: W, [width, height]: [u32; 2], opaque: bool) -> Encoder<'static, W> {
    let mut encoder = Encoder::new(out, width, height);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_color(if opaque { ColorType::Rgb } else { ColorType::Rgba });
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_compression(Compression::Balanced);
    encoder
}

/// The pixels as they are stored.
fn stored(image: &Image, opaque: bool) -> Cow<'_, [u8]> {
    if opaque {
        image.rgba().flat_map(|[r, g, b, _]| [r, g, b]).collect()
    } else {
        Cow::Borrowed(&image.pixels)
    }
}

fn refused(error: EncodingError, image: &Image) -> WriteError {
    match error {
        EncodingError::IoError(error) => WriteError::Io(error),
        other => image.refuse(other.to_string()),
    }
}
