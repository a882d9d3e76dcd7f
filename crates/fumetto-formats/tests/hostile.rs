//! Any bytes give data or an error: no panic, no hang, no allocation that the file does not justify.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::time::{Duration, Instant};

use fumetto_formats::{Image, read_particles, read_png, write_png};
use proptest::prelude::*;

const CSV: &[u8] = b"# a comment\nx;y;z;radius;\"mass\"\n0;1;2;3;4\n0.5;-1e3;\"2\";3;4\n";

const ASCII_PLY: &[u8] =
    b"ply\nformat ascii 1.0\ncomment c\nelement vertex 2\nproperty float x\nproperty float y\n\
    property float z\nproperty list uchar int l\nelement face 1\nproperty list uchar int i\nend_header\n\
    1 2 3 2 8 9\n4 5 6 0\n3 0 0 0\n";

fn binary_ply(order: &str) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement face 2\nproperty list uchar int i\nelement vertex 2\n\
         property float x\nproperty float y\nproperty float z\nproperty double radius\nend_header\n"
    )
    .into_bytes();
    bytes.extend([1, 0, 0, 0, 0, 0]);
    for _ in 0..2 {
        for value in [1.0_f32, 2.0, 3.0] {
            bytes.extend(if order == "big" { value.to_be_bytes() } else { value.to_le_bytes() });
        }
        bytes.extend(if order == "big" { 0.5_f64.to_be_bytes() } else { 0.5_f64.to_le_bytes() });
    }
    bytes
}

fn png() -> Vec<u8> {
    let image = Image { width: 7, height: 5, pixels: (0..140).collect() };
    let mut bytes = Vec::new();
    write_png(&image, &mut bytes).unwrap();
    bytes
}

/// Small valid files of every kind.
fn samples() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("a.csv", CSV.to_vec()),
        ("a.ply", ASCII_PLY.to_vec()),
        ("a.ply", binary_ply("little")),
        ("a.ply", binary_ply("big")),
        ("a.png", png()),
    ]
}

/// Reads the file; whether it was understood.
fn read(name: &str, bytes: &[u8]) -> bool {
    let start = Instant::now();
    let message = if name == "a.png" {
        read_png(name, bytes).err().map(|error| error.to_string())
    } else {
        read_particles(name, bytes).err().map(|error| error.to_string())
    };
    assert!(start.elapsed() < Duration::from_secs(5), "took {:?}", start.elapsed());
    if let Some(message) = &message {
        assert!(message.starts_with(name) && message.len() < 1000, "{message}");
        assert!(!message.contains(|c: char| c.is_control()), "{message:?}");
    }
    message.is_none()
}

#[test]
fn the_samples_are_valid() {
    for (name, bytes) in samples() {
        assert!(read(name, &bytes), "{name}");
    }
}

#[test]
fn every_prefix_gives_data_or_an_error() {
    for (name, bytes) in samples() {
        for length in 0..bytes.len() {
            read(name, &bytes[..length]);
        }
    }
}

#[test]
fn a_binary_file_that_lacks_a_byte_is_refused() {
    for bytes in [binary_ply("little"), binary_ply("big")] {
        assert!(!read("a.ply", &bytes[..bytes.len() - 1]));
    }
}

#[test]
fn lying_counts_are_refused_before_anything_is_allocated() {
    for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
        for count in
            ["4000000000", "18446744073709551615", "18446744073709551616", "1500000", "-1", "1e3", "x"]
        {
            let header = format!(
                "ply\nformat {format} 1.0\nelement vertex {count}\nproperty float x\nproperty float y\n\
                 property float z\nend_header\n"
            );
            assert!(!read("a.ply", header.as_bytes()), "{header}");
            let before = format!(
                "ply\nformat {format} 1.0\nelement face {count}\nproperty list uint double i\nelement vertex 1\n\
                 property float x\nproperty float y\nproperty float z\nend_header\n0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0"
            );
            assert!(!read("a.ply", before.as_bytes()), "{before}");
        }
    }
}

#[test]
fn four_thousand_million_rows_of_nothing_take_no_time() {
    let header = "ply\nformat binary_little_endian 1.0\nelement nothing 18446744073709551615\nelement vertex 1\n\
                  property uchar x\nproperty uchar y\nproperty uchar z\nend_header\nabc";
    assert!(read("a.ply", header.as_bytes()));
}

#[test]
fn a_list_longer_than_the_file_is_refused() {
    for (length_type, length) in [("uint", [255; 4]), ("int", [0, 0, 0, 128]), ("int", [255, 255, 255, 127])]
    {
        let mut bytes = format!(
            "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty list {length_type} double l\n\
             property uchar x\nproperty uchar y\nproperty uchar z\nend_header\n"
        )
        .into_bytes();
        bytes.extend(length);
        bytes.extend([1; 64]);
        assert!(!read("a.ply", &bytes), "{length:?}");
    }
    let text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uint int l\nproperty float x\n\
                property float y\nproperty float z\nend_header\n18446744073709551615 1 2 3\n";
    assert!(!read("a.ply", text.as_bytes()));
}

#[test]
fn a_picture_far_larger_than_its_file_is_refused() {
    // IHDR's sides stand at bytes 16 and 20, its checksum at 29.
    let mut bytes = png();
    bytes[16..24].copy_from_slice(&[0, 0, 0x20, 0, 0, 0, 0x20, 0]);
    let checksum = crc32(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&checksum.to_be_bytes());
    let message = read_png("a.png", &bytes).unwrap_err().to_string();
    assert!(message.contains("too few for the 8192 × 8192 pixels"), "{message}");

    bytes[16..20].copy_from_slice(&[0, 0, 0x20, 1]);
    let checksum = crc32(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&checksum.to_be_bytes());
    let message = read_png("a.png", &bytes).unwrap_err().to_string();
    let expected =
        "a.png: 8193 × 8192 pixels are more than the 8192 × 8192 that are allowed; scale the picture down";
    assert_eq!(message, expected);
}

/// The checksum of PNG's chunks, bit by bit.
fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |crc, &byte| {
        (0..8).fold(
            crc ^ u32::from(byte),
            |crc, _| if crc & 1 == 1 { 0xedb8_8320 ^ (crc >> 1) } else { crc >> 1 },
        )
    })
}

/// A change to a file: bytes overwritten, cut out or put in.
#[derive(Clone, Debug)]
enum Mutation {
    Set(prop::sample::Index, u8),
    Cut(prop::sample::Index, usize),
    Insert(prop::sample::Index, Vec<u8>),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    // Digits and separators keep text plausible, so that mutants get beyond the first check.
    let byte = prop_oneof![any::<u8>(), prop::sample::select(b"0123456789 \n-.e,;\"#".to_vec())];
    prop_oneof![
        (any::<prop::sample::Index>(), byte.clone()).prop_map(|(at, byte)| Mutation::Set(at, byte)),
        (any::<prop::sample::Index>(), 1..20_usize).prop_map(|(at, length)| Mutation::Cut(at, length)),
        (any::<prop::sample::Index>(), prop::collection::vec(byte, 1..20))
            .prop_map(|(at, bytes)| Mutation::Insert(at, bytes)),
    ]
}

fn mutate(bytes: &mut Vec<u8>, mutation: &Mutation) {
    if bytes.is_empty() {
        return;
    }
    match mutation {
        Mutation::Set(at, byte) => *at.get_mut(bytes) = *byte,
        Mutation::Cut(at, length) => {
            let start = at.index(bytes.len());
            bytes.drain(start..bytes.len().min(start + length));
        }
        Mutation::Insert(at, inserted) => {
            let start = at.index(bytes.len());
            bytes.splice(start..start, inserted.iter().copied());
        }
    }
}

/// Puts right checksums over a mutated PNG, or mutants would not get beyond them.
fn mend_checksums(bytes: &mut [u8]) {
    let mut start = 8;
    while let Some(length) = bytes.get(start..start + 4) {
        let length = u32::from_be_bytes(length.try_into().unwrap()) as usize;
        let end = start + 8 + length;
        if end + 4 > bytes.len() {
            return;
        }
        let checksum = crc32(&bytes[start + 4..end]);
        bytes[end..end + 4].copy_from_slice(&checksum.to_be_bytes());
        start = end + 4;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutated_files_give_data_or_an_error(
        sample in 0..samples().len(),
        mutations in prop::collection::vec(mutation(), 1..6),
    ) {
        let (name, mut bytes) = samples().swap_remove(sample);
        for mutation in &mutations {
            mutate(&mut bytes, mutation);
        }
        read(name, &bytes);
        if name == "a.png" {
            mend_checksums(&mut bytes);
            read(name, &bytes);
        }
    }

    #[test]
    fn random_bytes_give_data_or_an_error(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        for (name, sample) in samples() {
            read(name, &bytes);
            // Behind a valid header, too.
            let header = sample.windows(11).position(|bytes| bytes == b"end_header\n").map_or(8, |at| at + 11);
            read(name, &[&sample[..header], &bytes].concat());
        }
    }
}
