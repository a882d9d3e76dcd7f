//! Pictures through PNG and back.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use fumetto_formats::{Image, WriteError, read_png, write_png, write_png_bands};
use png::{BitDepth, ColorType};

fn written(image: &Image) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_png(image, &mut bytes).unwrap();
    bytes
}

/// Every 8-bit value with every alpha: the grey one, and one that differs by channel.
fn all_values() -> Image {
    let pixel = |i: u32| {
        let (value, alpha) = (i as u8, (i >> 8) as u8);
        [[value, value, value, alpha], [value, !value, value.rotate_left(3), alpha]]
    };
    let pixels = (0..0x1_0000).flat_map(pixel).collect::<Vec<_>>().into_flattened();
    Image { width: 512, height: 256, pixels }
}

#[test]
fn every_value_with_every_alpha_survives() {
    let image = all_values();
    assert_eq!(read_png("a.png", &written(&image)).unwrap(), image);
}

#[test]
fn an_opaque_picture_is_stored_without_alpha_and_survives() {
    let mut image = all_values();
    for pixel in image.pixels.chunks_mut(4) {
        pixel[3] = 255;
    }
    let bytes = written(&image);
    let reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
    assert_eq!(reader.info().color_type, ColorType::Rgb);
    assert!(reader.info().srgb.is_some());
    assert_eq!(read_png("a.png", &bytes).unwrap(), image);
}

#[test]
fn the_same_picture_gives_the_same_bytes() {
    assert_eq!(written(&all_values()), written(&all_values()));
}

/// Bands of so many rows each.
fn in_bands(image: &Image, opaque: bool, rows: &[u32]) -> Result<Vec<u8>, WriteError> {
    let (mut bytes, mut rows, mut first) = (Vec::new(), rows.iter(), 0);
    write_png_bands([image.width, image.height], opaque, &mut bytes, || {
        Ok::<_, WriteError>(rows.next().map(|&height| {
            let length = 4 * (image.width * height) as usize;
            first += length;
            let pixels = image.pixels.iter().copied().cycle().skip(first - length).take(length).collect();
            Image { width: image.width, height, pixels }
        }))
    })?;
    Ok(bytes)
}

#[test]
fn a_picture_in_bands_is_the_same_picture() {
    let image = all_values();
    let bytes = in_bands(&image, false, &[100, 1, 155]).unwrap();
    assert_eq!(read_png("a.png", &bytes).unwrap(), image);
    let opaque = read_png("a.png", &in_bands(&image, true, &[256]).unwrap()).unwrap();
    assert!(
        opaque.pixels.chunks(4).zip(image.pixels.chunks(4)).all(|(a, b)| a[..3] == b[..3] && a[3] == 255)
    );
}

#[test]
fn bands_that_do_not_make_up_the_picture_are_refused() {
    assert!(in_bands(&all_values(), false, &[100, 100]).is_err(), "too few rows");
    assert!(in_bands(&all_values(), false, &[200, 200]).is_err(), "too many rows");
    let narrow = || Ok(Some(Image { width: 1, height: 512 * 256, pixels: all_values().pixels }));
    let error =
        write_png_bands([512, 256], false, Vec::new(), narrow).map_err(|error: WriteError| error.to_string());
    assert!(error.unwrap_err().contains("1 pixels wide"));
}

/// A PNG of one row, made by the `png` crate itself.
fn row(
    colour: ColorType,
    depth: BitDepth,
    width: u32,
    data: &[u8],
    set: impl FnOnce(&mut png::Encoder<'_, &mut Vec<u8>>),
) -> Vec<[u8; 4]> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, 1);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    set(&mut encoder);
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    let image = read_png("a.png", &bytes).unwrap();
    assert_eq!((image.width, image.height), (width, 1));
    image.pixels.as_chunks().0.to_vec()
}

#[test]
fn grey_of_any_depth_is_spread_to_rgba() {
    let grey = |value: u8| [value, value, value, 255];
    assert_eq!(row(ColorType::Grayscale, BitDepth::One, 3, &[0b1010_0000], |_| {}), [255, 0, 255].map(grey));
    assert_eq!(
        row(ColorType::Grayscale, BitDepth::Two, 4, &[0b0001_1011], |_| {}),
        [0, 85, 170, 255].map(grey)
    );
    assert_eq!(row(ColorType::Grayscale, BitDepth::Four, 2, &[0x3f], |_| {}), [51, 255].map(grey));
    assert_eq!(row(ColorType::Grayscale, BitDepth::Eight, 2, &[7, 200], |_| {}), [7, 200].map(grey));
    assert_eq!(row(ColorType::Grayscale, BitDepth::Sixteen, 2, &[7, 99, 200, 0], |_| {}), [7, 200].map(grey));
    assert_eq!(row(ColorType::GrayscaleAlpha, BitDepth::Eight, 1, &[7, 200], |_| {}), [[7, 7, 7, 200]]);
}

#[test]
fn a_grey_key_becomes_transparency() {
    let pixels =
        row(ColorType::Grayscale, BitDepth::Eight, 2, &[7, 8], |encoder| encoder.set_trns(vec![0, 7]));
    assert_eq!(pixels, [[7, 7, 7, 0], [8, 8, 8, 255]]);
}

#[test]
fn a_palette_with_alpha_is_looked_up() {
    let pixels = row(ColorType::Indexed, BitDepth::Two, 3, &[0b0110_0000], |encoder| {
        encoder.set_palette(vec![1, 2, 3, 4, 5, 6, 7, 8, 9]);
        encoder.set_trns(vec![255, 40]);
    });
    assert_eq!(pixels, [[4, 5, 6, 40], [7, 8, 9, 255], [1, 2, 3, 255]]);
}

#[test]
fn sixteen_bits_keep_the_upper_eight() {
    let data = [1, 0xff, 2, 0, 3, 0x80, 4, 0x7f];
    assert_eq!(row(ColorType::Rgba, BitDepth::Sixteen, 1, &data, |_| {}), [[1, 2, 3, 4]]);
    assert_eq!(row(ColorType::Rgb, BitDepth::Sixteen, 1, &data[..6], |_| {}), [[1, 2, 3, 255]]);
}

#[test]
fn rgb_becomes_opaque() {
    assert_eq!(row(ColorType::Rgb, BitDepth::Eight, 1, &[1, 2, 3], |_| {}), [[1, 2, 3, 255]]);
}

#[test]
fn a_picture_that_does_not_fill_its_size_is_not_written() {
    for (width, height, bytes) in [(2, 2, 15), (0, 2, 0), (2, 0, 0), (u32::MAX, u32::MAX, 4)] {
        let image = Image { width, height, pixels: vec![0; bytes] };
        assert!(matches!(write_png(&image, &mut Vec::new()), Err(WriteError::Image { .. })));
    }
}

/// An output on a full disk.
struct Full;

impl std::io::Write for Full {
    fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
        Err(std::io::ErrorKind::StorageFull.into())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_full_disk_is_an_error_of_the_output() {
    let error = write_png(&all_values(), Full).unwrap_err();
    assert!(matches!(error, WriteError::Io(ref error) if error.kind() == std::io::ErrorKind::StorageFull));
}
