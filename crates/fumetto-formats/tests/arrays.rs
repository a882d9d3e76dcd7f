//! Volumes in NRRD and npy files (written by `tools/fixtures/arrays.py`), and files that are damaged.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::fs;
use std::time::{Duration, Instant};

use fumetto_formats::{FormatError, Grid, Volume, read_volume};
use proptest::prelude::*;
use proptest::sample::Index;

fn bytes(name: &str) -> Vec<u8> {
    fs::read(format!("{}/tests/fixtures/volumes/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn fixture(name: &str) -> Volume {
    read_volume(name, &bytes(name), &["density"]).unwrap()
}

/// Reads a volume; whatever comes, it comes soon.
fn read(name: &str, bytes: &[u8]) -> Result<Volume, FormatError> {
    let start = Instant::now();
    let read = read_volume(name, bytes, &[]);
    assert!(start.elapsed() < Duration::from_secs(5), "took {:?}", start.elapsed());
    let messages = match &read {
        Ok(volume) => {
            let grid = &volume.grids[0];
            assert!(grid.voxels.values.iter().all(|number| number.is_finite()));
            assert!(grid.world_from_index.as_flattened().iter().all(|number| number.is_finite()));
            volume.notes.clone()
        }
        Err(error) => vec![error.to_string()],
    };
    for message in messages {
        assert!(message.starts_with(name) && message.len() < 1000, "{message}");
        assert!(!message.contains(|c: char| c.is_control()), "{message:?}");
    }
    read
}

fn refusal(name: &str, bytes: &[u8]) -> String {
    read(name, bytes).map(|volume| volume.notes).unwrap_err().to_string()
}

/// Compares with the numbers of `arrays.py`, `scale` times as large.
fn check_ball(name: &str, grid: &Grid, scale: f32) {
    let mut count = 0;
    for (x, y, z) in (-1..10).flat_map(|x| (-1..11).flat_map(move |y| (-1..12).map(move |z| (x, y, z)))) {
        let inside = [x - 4, y - 5, z - 5].iter().map(|i: &i32| i.pow(2)).sum::<i32>() <= 16;
        let value = ((7 * x + 13 * y + 29 * z).rem_euclid(64) + 1) as f32 / 16.0 * scale;
        let expected = match (inside, grid.voxels.channels) {
            (false, _) => [0.0; 3],
            (true, 1) => [value, 0.0, 0.0],
            (true, _) => [value, -value, 2.0 * value],
        };
        assert_eq!(grid.voxels.at([x, y, z]), (expected, inside), "{name} at {x} {y} {z}");
        count += u64::from(inside);
    }
    assert_eq!(grid.voxels.active_count(), count);
}

#[test]
fn every_file_gives_the_numbers_that_were_written() {
    for (name, channels, scale) in [
        ("numpy-float.npy", 1, 1.0),
        ("numpy-fortran.npy", 1, 1.0),
        ("numpy-bytes.npy", 1, 16.0),
        ("numpy-vectors.npy", 3, 1.0),
        ("numpy-fortran-vectors.npy", 3, 1.0),
        ("pynrrd-raw.nrrd", 1, 1.0),
        ("pynrrd-gzip.nrrd", 1, 16.0),
        ("pynrrd-text.nrrd", 1, 16.0),
        ("pynrrd-vectors.nrrd", 3, 1.0),
    ] {
        let volume = fixture(name);
        let [grid] = &volume.grids[..] else { panic!("{name} holds one grid") };
        assert_eq!((grid.name.as_str(), grid.voxels.channels), (name.split_once('.').unwrap().0, channels));
        check_ball(name, grid, scale);
    }
}

#[test]
fn voxels_are_where_the_header_says() {
    let columns = |name: &str| fixture(name).grids[0].world_from_index;
    let turned = [[0.5, 0.0, 0.0, 0.0], [0.0, 0.0, 0.25, 0.0], [0.0, -2.0, 0.0, 0.0], [1.0, 2.0, 3.0, 1.0]];
    assert_eq!(columns("pynrrd-raw.nrrd"), turned);
    let spaced = [[0.5, 0.0, 0.0, 0.0], [0.0, 0.25, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    assert_eq!(columns("pynrrd-gzip.nrrd"), spaced);
    assert_eq!(columns("pynrrd-vectors.nrrd"), spaced);
    let note = "numpy-float.npy: it does not tell the size of its voxels; they are 1 m wide";
    assert_eq!(fixture("numpy-float.npy").notes, [note]);
    assert_eq!(fixture("pynrrd-raw.nrrd").notes, [""; 0]);
}

fn nrrd(lines: &str, body: &[u8]) -> Vec<u8> {
    [b"NRRD0004\n", lines.as_bytes(), b"\n\n", body].concat()
}

/// A header and two voxels of two bytes.
const PAIR: &str = "type: short\ndimension: 3\nsizes: 2 1 1\nencoding: raw\nspacings: 1 1 1";

#[test]
fn byte_order_and_skipped_bytes_are_heeded() {
    let values = |lines: &str, body: &[u8]| {
        let volume = read("a.nrrd", &nrrd(lines, body)).unwrap();
        [0, 1].map(|x| volume.grids[0].voxels.at([x, 0, 0]).0[0])
    };
    assert_eq!(values(PAIR, &[1, 0, 0xff, 0xff]), [1.0, -1.0]);
    assert_eq!(values(&format!("{PAIR}\nendian: big"), &[1, 0, 0xff, 0xfe]), [256.0, -2.0]);
    assert_eq!(
        values(&format!("# note\r\nkey:=1\r\n{PAIR}\r\nbyte skip: 3\r"), &[9, 9, 9, 1, 0, 2, 0]),
        [1.0, 2.0]
    );
    assert_eq!(values(&format!("{PAIR}\nbyte skip: -1"), &[9, 9, 9, 9, 9, 1, 0, 2, 0]), [1.0, 2.0]);
}

#[test]
fn numbers_that_are_none_become_zero() {
    let lines = "type: float\nsizes: 2 1 1\nencoding: text\nspacings: 1 1 1";
    let volume = read("a.nrrd", &nrrd(lines, b"nan, 2.5")).unwrap();
    assert_eq!(volume.notes, ["a.nrrd: 1 of its values are infinite or no numbers; they became zero"]);
    assert_eq!(volume.grids[0].voxels.at([1, 0, 0]).0[0], 2.5);
}

#[test]
fn headers_that_are_not_understood_are_quoted() {
    let line = |line: &str| refusal("a.nrrd", &nrrd(&format!("{PAIR}\n{line}"), &[0; 4]));
    for (wrong, problem) in [
        ("type: block", "this type is not read; export numbers"),
        ("sizes: 2 -1 1", "sizes are counts of voxels; export the file again"),
        ("encoding: bzip2", "this encoding is not read; export raw or gzip"),
        (
            "data file: a.raw",
            "the numbers are in another file; export them into one, with the extension `.nrrd`",
        ),
        ("line skip: 2", "lines are not skipped; export raw or gzip"),
        ("byte skip: -2", "as many bytes cannot be skipped; export the file again"),
        ("what", "a line is `field: value`; export the file again"),
    ] {
        assert_eq!(line(wrong), format!("a.nrrd, line 7: `{wrong}`: {problem}"));
    }
    let whole = |lines: &str| refusal("a.nrrd", &nrrd(lines, &[0; 4]));
    assert_eq!(
        refusal("a.nrrd", b"RIFF"),
        "a.nrrd: not an NRRD file: its first line does not start with `NRRD000`"
    );
    assert_eq!(whole("type: float"), "a.nrrd: its header has no line `sizes`; export the file again");
    assert_eq!(
        whole(&PAIR.replace("2 1 1", "2 1")),
        "a.nrrd: its axes have the sizes `2 1`, and volumes have three, behind one of length 3 if they hold vectors"
    );
    assert_eq!(
        whole(&PAIR.replace("1 1 1", "0 1 1")),
        "a.nrrd: its voxels have no size; correct its spacings or directions"
    );
    assert_eq!(
        whole(&PAIR.replace("2 1 1", "2 1 2")),
        "a.nrrd: its numbers take 8 bytes, but only 4 follow; the file is cut off"
    );
    assert_eq!(
        whole(&PAIR.replace("raw", "gzip\nbyte skip: 1")),
        "a.nrrd: its header skips bytes, which is understood before raw numbers only; export it as raw"
    );
    assert!(whole(&PAIR.replace("raw", "gzip")).contains("its numbers cannot be unpacked"));
    assert!(whole(&PAIR.replace("raw", "text")).contains("promises 2 numbers, which do not follow"));
}

fn npy(header: &str, body: &[u8]) -> Vec<u8> {
    let length = (header.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), body].concat()
}

#[test]
fn arrays_that_are_no_volumes_are_refused() {
    let good = "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 1, 2), }";
    assert_eq!(read("a.npy", &npy(good, &[0; 8])).unwrap().grids.len(), 1);
    let refusal = |from: &str, to: &str| refusal("a.npy", &npy(&good.replace(from, to), &[0; 8]));
    for (from, to, problem) in [
        ("<f4", "<c8", "its numbers are of type `c8`, which is not read; write it as `f4`"),
        ("(1, 1, 2)", "(4,)", "its shape is [4], and volumes have (x, y, z) or (x, y, z, 3)"),
        (
            "(1, 1, 2)",
            "(1, 1, 1, 2)",
            "its shape is [1, 1, 1, 2], and volumes have (x, y, z) or (x, y, z, 3)",
        ),
        ("(1, 1, 2)", "(1, 1, 3)", "its array takes 12 bytes, but only 8 follow; the file is cut off"),
        ("(1, 1, 2)", "(1, 1, x)", "its header does not tell its `shape`; write it again with `numpy.save`"),
        ("descr", "d", "its header does not tell its `descr`; write it again with `numpy.save`"),
        ("False", "0", "its header does not tell its `fortran_order`; write it again with `numpy.save`"),
    ] {
        assert_eq!(refusal(from, to), format!("a.npy: {problem}"));
    }
    let version = "a.npy: not a whole npy file of version 1, 2 or 3; write it again with `numpy.save`";
    assert_eq!(self::refusal("a.npy", b"\x93NUMPY\x04\x00"), version);
}

#[test]
fn sizes_beyond_memory_are_refused_before_anything_is_allocated() {
    let sides = ["4294967295 4294967295 4294967295", "1 268435456 1", "65536 65536 1", "4294967295 1 1"];
    for sizes in sides {
        let lines = PAIR.replace("2 1 1", sizes);
        let message = refusal("a.nrrd", &nrrd(&lines, &[0; 4]));
        assert!(message.contains("more than the 268435456 numbers that are allowed"), "{sizes}: {message}");
    }
    // What would fit, but cannot be in so few bytes.
    for encoding in ["raw", "gzip", "text"] {
        let lines = PAIR.replace("2 1 1", "512 512 1000").replace("raw", encoding);
        let message = refusal("a.nrrd", &nrrd(&lines, &[0; 4]));
        assert!(message.contains("follow"), "{encoding}: {message}");
    }
    assert!(
        refusal("a.nrrd", &nrrd(&PAIR.replace("2 1 1", "2 1 4294967296"), &[0; 4]))
            .contains("sizes are counts")
    );
    let empty = PAIR.replace("2 1 1", "0 4294967295 4294967295");
    let message = refusal("a.nrrd", &nrrd(&empty, &[0; 4]));
    assert_eq!(message, "a.nrrd: there is no voxel in it; export it again with at least one");
}

const SAMPLES: [&str; 5] = [
    "numpy-bytes.npy",
    "numpy-fortran-vectors.npy",
    "pynrrd-raw.nrrd",
    "pynrrd-gzip.nrrd",
    "pynrrd-text.nrrd",
];

#[test]
fn every_prefix_is_refused() {
    for name in SAMPLES {
        // A text's last byte may be the end of its line.
        let bytes = bytes(name);
        (0..bytes.len() - 2).for_each(|length| {
            refusal(name, &bytes[..length]);
        });
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutated_files_give_data_or_an_error(
        sample in prop::sample::select(&SAMPLES[..]),
        // Numbers may be anything: headers are worth more damage.
        within in prop::sample::select(vec![150, 500, usize::MAX]),
        changes in prop::collection::vec((any::<Index>(), prop_oneof![
            any::<u8>(), prop::sample::select(b"0123456789 \n-.e,:()'#".to_vec())
        ], any::<bool>()), 1..6),
    ) {
        let mut bytes = bytes(sample);
        for (at, byte, insert) in changes {
            let at = at.index(within.min(bytes.len()));
            if insert { bytes.insert(at, byte) } else { bytes[at] = byte }
        }
        let _ = read(sample, &bytes);
    }
}
