//! What comes out of a GIF when another program's decoder opens it.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::collections::HashSet;

use fumetto_formats::{GifWriter, Image, WriteError};
use gif::{ColorOutput, DecodeOptions, DisposalMethod, Repeat};

const INK: [u8; 3] = [0x10, 0x14, 0x18];
const DARK: [u8; 3] = [0x8f, 0xa3, 0xb8];
const LIGHT: [u8; 3] = [0xe8, 0xee, 0xf4];
const KEEP: [[u8; 3]; 3] = [INK, DARK, LIGHT];

fn picture(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [u8; 4]) -> Image {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| pixel(x, y));
    Image { width, height, pixels: pixels.collect::<Vec<_>>().into_flattened() }
}

fn opaque([r, g, b]: [u8; 3]) -> [u8; 4] {
    [r, g, b, 255]
}

/// A drawing: stripes of the kept colours on a ground of thousands of others.
fn drawing(width: u32, height: u32) -> Image {
    picture(width, height, |x, y| match x / 8 % 4 {
        stripe @ 0..3 => opaque(KEEP[stripe as usize]),
        _ => [x as u8, y as u8, (x * 7 + y * 3) as u8, 255],
    })
}

fn encode(frames: &[Image], fps: f32, transparent: bool) -> Vec<u8> {
    let (width, height) = (frames[0].width, frames[0].height);
    let mut writer = GifWriter::new(Vec::new(), width, height, fps, transparent, &KEEP).unwrap();
    for frame in frames {
        writer.push(frame).unwrap();
    }
    writer.finish().unwrap()
}

struct Decoded {
    repeat: Repeat,
    delays: Vec<u16>,
    disposals: Vec<DisposalMethod>,
    frames: Vec<Vec<[u8; 4]>>,
}

fn decode(bytes: &[u8]) -> Decoded {
    let mut options = DecodeOptions::new();
    options.set_color_output(ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes).unwrap();
    let mut decoded =
        Decoded { repeat: Repeat::default(), delays: vec![], disposals: vec![], frames: vec![] };
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        decoded.delays.push(frame.delay);
        decoded.disposals.push(frame.dispose);
        decoded.frames.push(frame.buffer.as_chunks().0.to_vec());
    }
    decoded.repeat = decoder.repeat();
    decoded
}

#[test]
fn kept_colours_are_exact_among_thousands() {
    for transparent in [false, true] {
        let image = drawing(320, 180);
        let pixels = image.pixels.as_chunks::<4>().0;
        assert!(pixels.iter().collect::<HashSet<_>>().len() > 5000);
        let decoded = decode(&encode(std::slice::from_ref(&image), 24.0, transparent));
        for (drawn, shown) in pixels.iter().zip(&decoded.frames[0]) {
            let kept = |pixel: &[u8; 4]| KEEP.map(opaque).contains(pixel);
            if kept(drawn) {
                assert_eq!(shown, drawn);
            }
        }
    }
}

#[test]
fn other_colours_stay_near() {
    let image = picture(256, 128, |x, y| [x as u8, (2 * y) as u8, 128, 255]);
    let decoded = decode(&encode(std::slice::from_ref(&image), 24.0, false));
    let error = |(a, b): (&[u8; 4], &[u8; 4])| {
        a.iter().zip(b).map(|(&a, &b)| (f64::from(a) - f64::from(b)).powi(2)).sum::<f64>()
    };
    let pixels = image.pixels.as_chunks().0;
    let mean = pixels.iter().zip(&decoded.frames[0]).map(error).sum::<f64>() / pixels.len() as f64;
    // 256 entries in a square of 256 x 256 are squares of 16 x 16: a mean of 2 * 16^2 / 12 at best.
    assert!(mean < 90.0, "{mean}");
}

#[test]
fn a_palette_that_holds_all_colours_is_exact() {
    for (transparent, colours) in [(false, 256), (true, 255)] {
        let image = picture(64, 64, |x, y| {
            let i = (x + 64 * y) % colours;
            [i as u8, (i * 3) as u8, 255 - i as u8, 255]
        });
        let decoded = decode(&encode(std::slice::from_ref(&image), 24.0, transparent));
        assert_eq!(decoded.frames[0], image.pixels.as_chunks().0);
    }
}

#[test]
fn kept_colours_beyond_the_palette_give_way_to_larger_ones() {
    let keep: Vec<[u8; 3]> = (0..300).map(|i| [i as u8, (i / 256) as u8, 9]).collect();
    // Every colour fills one row; the first 200 fill two.
    let rows: Vec<[u8; 3]> = keep.iter().chain(&keep[..200]).copied().collect();
    let image = picture(2, 500, |_, y| opaque(rows[y as usize]));
    let mut writer = GifWriter::new(Vec::new(), 2, 500, 24.0, false, &keep).unwrap();
    writer.push(&image).unwrap();
    let decoded = decode(&writer.finish().unwrap());
    for (drawn, shown) in rows.into_iter().zip(decoded.frames[0].chunks(2)).take(256) {
        assert_eq!(shown, [opaque(drawn); 2]);
    }
}

#[test]
fn pixels_below_half_alpha_are_clear_and_the_frame_before_does_not_show_through() {
    let frame = |shift: u32| {
        picture(16, 4, |x, _| match (x + shift) % 4 {
            0 => [0x10, 0x14, 0x18, 127],
            1 => [0, 0, 0, 0],
            2 => [0x8f, 0xa3, 0xb8, 128],
            _ => [0, 0, 0, 255],
        })
    };
    let decoded = decode(&encode(&[frame(0), frame(1)], 24.0, true));
    for (shift, pixels) in decoded.frames.iter().enumerate() {
        for (x, pixel) in pixels[..16].iter().enumerate() {
            match (x + shift) % 4 {
                0 | 1 => assert_eq!(pixel[3], 0),
                2 => assert_eq!(*pixel, opaque(DARK)),
                _ => assert_eq!(*pixel, [0, 0, 0, 255]),
            }
        }
    }
    assert_eq!(decoded.disposals, [DisposalMethod::Background; 2]);
}

#[test]
fn it_loops_for_ever_and_a_second_takes_a_second() {
    let frames: Vec<Image> = (0..24).map(|frame| picture(8, 8, |_, _| opaque([frame, 0, 0]))).collect();
    let decoded = decode(&encode(&frames, 24.0, false));
    assert_eq!(decoded.repeat, Repeat::Infinite);
    assert_eq!(decoded.delays.len(), 24);
    assert_eq!(decoded.delays.iter().sum::<u16>(), 100);
}

#[test]
fn a_held_drawing_is_written_once_and_shown_as_long() {
    let frames: Vec<Image> = (0..24).map(|frame| picture(8, 8, |_, _| opaque([frame / 2, 0, 0]))).collect();
    let decoded = decode(&encode(&frames, 24.0, false));
    assert_eq!(decoded.delays.len(), 12, "on twos");
    assert_eq!(decoded.delays.iter().sum::<u16>(), 100);
}

#[test]
fn the_same_frames_give_the_same_bytes() {
    let frames = [drawing(100, 60), drawing(100, 60)];
    assert_eq!(encode(&frames, 12.0, true), encode(&frames, 12.0, true));
}

#[test]
fn all_but_the_held_drawing_is_a_whole_file_after_a_drop() {
    let mut bytes = Vec::new();
    let mut writer = GifWriter::new(&mut bytes, 8, 8, 24.0, false, &[]).unwrap();
    writer.push(&drawing(8, 8)).unwrap();
    writer.push(&picture(8, 8, |_, _| opaque([1, 2, 3]))).unwrap();
    drop(writer);
    assert_eq!(decode(&bytes).frames.len(), 1);
}

#[test]
fn impossible_sizes_and_rates_are_refused() {
    let new = |width, height, fps| GifWriter::new(Vec::new(), width, height, fps, false, &[]).err();
    assert!(matches!(new(0, 1, 24.0), Some(WriteError::Image { .. })));
    assert!(matches!(new(1, 65_536, 24.0), Some(WriteError::Image { .. })));
    let expected = "GIF cannot show 60 frames a second: viewers keep time between 0.01 and 50; choose a rate in that \
                    range";
    assert_eq!(new(1, 1, 60.0).unwrap().to_string(), expected);

    let mut writer = GifWriter::new(Vec::new(), 8, 8, 24.0, false, &[]).unwrap();
    assert!(matches!(writer.push(&drawing(8, 9)), Err(WriteError::Image { .. })));
}
