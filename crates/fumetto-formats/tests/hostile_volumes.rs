//! Any bytes give a volume that keeps its promises, or an error that names the file and what is wrong.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::fs;
use std::io::Read;
use std::sync::Arc;
use std::time::{Duration, Instant};

use flate2::read::GzDecoder;
use fumetto_formats::{
    BRICK_VOXELS, FormatError, Grid, GridClass, Tile, VdbOptions, Volume, Voxels, read_volume, write_vdb,
};
use proptest::prelude::*;
use proptest::sample::Index;

fn fixture(name: &str) -> Vec<u8> {
    let path = format!("{}/tests/fixtures/volumes/{name}.vdb.gz", env!("CARGO_MANIFEST_DIR"));
    let mut bytes = Vec::new();
    GzDecoder::new(&fs::read(path).unwrap()[..]).read_to_end(&mut bytes).unwrap();
    bytes
}

/// Reads a volume; whatever comes, it comes soon, and keeps its promises.
fn read(bytes: &[u8]) -> Result<Volume, FormatError> {
    let start = Instant::now();
    let read = read_volume("a.vdb", bytes, &[]);
    assert!(start.elapsed() < Duration::from_secs(5), "took {:?}", start.elapsed());
    match &read {
        Ok(volume) => {
            assert!(!volume.grids.is_empty());
            volume.grids.iter().for_each(|grid| check(grid, bytes.len()));
            volume.notes.iter().for_each(|note| check_message(note));
        }
        Err(error) => check_message(&error.to_string()),
    }
    read
}

fn check(grid: &Grid, file_bytes: usize) {
    let Voxels { channels, background, bricks, values, tiles } = &*grid.voxels;
    assert!([1, 3].contains(channels));
    assert_eq!(values.len(), bricks.len() * BRICK_VOXELS * channels);
    let all = values.iter().chain(background).chain(tiles.iter().flat_map(|tile| &tile.value));
    assert!(all.chain(&[0.0]).all(|number| number.is_finite()));
    assert!(bricks.is_sorted_by(|one, next| one.origin < next.origin));
    assert!(tiles.is_sorted_by(|one, next| one.origin < next.origin));
    for (origin, side) in
        bricks.iter().map(|brick| (brick.origin, 8)).chain(tiles.iter().map(|t| (t.origin, t.side)))
    {
        assert!([8, 128, 4096].contains(&side) && origin.iter().all(|i| i % side == 0));
    }
    assert!(tiles.iter().all(|tile| tile.active || tile.value != *background));
    // What is stored takes up bytes of the file.
    assert!(64 * bricks.len() <= file_bytes && tiles.len() <= 4 * file_bytes);
    assert!(grid.world_from_index.as_flattened().iter().all(|number| number.is_finite()));
    let _ = (grid.voxels.active_count(), grid.voxels.active_bounds(), grid.voxels.at([0; 3]));
}

fn check_message(message: &str) {
    assert!(message.starts_with("a.vdb: ") && message.len() < 1000, "{message}");
    assert!(!message.contains(|c: char| c.is_control()), "{message:?}");
}

fn refusal(bytes: &[u8]) -> String {
    read(bytes).map(|volume| volume.notes).unwrap_err().to_string()
}

/// A brick, a tile, and nothing else; the numbers of the brick are packed only if `zip`.
fn small(zip: bool) -> Vec<u8> {
    let mut voxels = Voxels::from_dense([0; 3], [8, 8, 1], 1, &[1.5; 64], [0.0; 3]).unwrap();
    voxels.tiles.push(Tile { origin: [4096, 0, 0], side: 4096, value: [2.0, 0.0, 0.0], active: true });
    let world_from_index =
        [[0.5, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0], [0.0, 0.0, 0.5, 0.0], [0.0, 0.0, 0.0, 1.0]];
    let grid = |name: &str, voxels| Grid {
        name: name.to_owned(),
        class: GridClass::FogVolume,
        world_from_index,
        voxels,
    };
    let voxels = Arc::new(voxels);
    let grids = [grid("density", Arc::clone(&voxels)), grid("heat", voxels)];
    let mut bytes = Vec::new();
    write_vdb(&grids, VdbOptions { zip, half: false }, &mut bytes).unwrap();
    bytes
}

/// Where `text` first stands.
fn find(bytes: &[u8], text: &[u8]) -> usize {
    bytes.windows(text.len()).position(|window| window == text).unwrap()
}

/// Where the place of the first grid stands, behind the length of an empty string.
fn offsets(bytes: &[u8]) -> usize {
    find(bytes, b"Tree_float_5_4_3") + 16 + 4
}

/// Where the first grid's tree starts.
fn tree(bytes: &[u8]) -> usize {
    find(bytes, b"UniformScaleTranslateMap") + 24 + 18 * 8
}

/// What is said of the small file if `change` stands at `at` instead.
fn refusal_with(zip: bool, at: impl Fn(&[u8]) -> usize, change: &[u8]) -> String {
    let mut bytes = small(zip);
    let at = at(&bytes);
    bytes[at..at + change.len()].copy_from_slice(change);
    refusal(&bytes)
}

#[test]
fn the_small_files_are_in_order() {
    for zip in [false, true] {
        assert_eq!(read(&small(zip)).unwrap().grids.len(), 2);
    }
}

#[test]
fn what_is_no_openvdb_file_is_told_so() {
    let message = "a.vdb: not an OpenVDB file: it does not start as those do";
    assert_eq!(refusal(b""), message);
    assert_eq!(refusal(b"ply\nformat ascii 1.0"), message);
    let name = read_volume("clouds.bin", &small(false), &[]).unwrap_err().to_string();
    assert_eq!(
        name,
        "clouds.bin: volumes are read from `.vdb`, `.nrrd` and `.npy` files; convert this one to OpenVDB"
    );
}

#[test]
fn versions_that_are_not_read_are_named() {
    for version in [0, 221, 226, u32::MAX] {
        let message = refusal_with(false, |_| 8, &version.to_le_bytes());
        let expected = format!(
            "a.vdb: it has version {version} of OpenVDB's format, and versions 222 to 225 are read; open it with OpenVDB's \
             tools and save it again"
        );
        assert_eq!(message, expected);
    }
}

#[test]
fn places_that_cannot_be_are_refused() {
    let end = |bytes: &[u8]| offsets(bytes) + 16;
    let message = refusal_with(false, offsets, &(-1_i64).to_le_bytes());
    assert_eq!(message, "a.vdb: grid `density`: its place in the file is negative; export the file again");
    let message = refusal_with(false, offsets, &20_i64.to_le_bytes());
    assert!(message.contains("bytes 20 to") && message.contains("cannot start before byte 124"), "{message}");
    let message = refusal_with(false, end, &200_i64.to_le_bytes());
    assert!(message.contains("bytes are asked for where only"), "{message}");
    for far in [1 << 20, i64::MAX] {
        let message = refusal_with(false, end, &far.to_le_bytes());
        assert!(message.contains("grid `density`: ") && message.contains("the file is cut off"), "{message}");
    }
}

#[test]
fn a_parent_that_is_not_there_is_missed() {
    let mut bytes = small(false);
    // The second grid's parent is the first one's name, for the last time.
    let at = bytes.windows(7).rposition(|window| window == b"density").unwrap();
    bytes[at] = b'D';
    let expected = "a.vdb: grid `heat`: the grid whose voxels it shares is not there; export the file again";
    assert_eq!(refusal(&bytes), expected);
}

#[test]
fn what_is_not_known_cannot_be_left_aside_in_a_file_without_places() {
    let mut bytes = fixture("stream");
    let at = find(&bytes, b"Tree_float_5_4_3");
    bytes[at + 15] = b'2';
    assert!(
        refusal(&bytes)
            .starts_with("a.vdb: grid `density`: its type is `Tree_float_5_4_2`, which is not read")
    );
}

#[test]
fn transforms_without_an_inverse_are_refused() {
    let scale = |bytes: &[u8]| tree(bytes) - 15 * 8;
    for number in [0.0, f64::NAN, f64::INFINITY] {
        let message = refusal_with(false, scale, &number.to_le_bytes());
        let expected = "a.vdb: grid `density`: its transform has no inverse, so its voxels have no size; export it again";
        assert_eq!(message, expected);
    }
    let message = refusal_with(false, |bytes| tree(bytes) - 18 * 8 - 1, b"?");
    assert!(message.contains("its transform is a `UniformScaleTranslateMa?`"), "{message}");
}

#[test]
fn trees_that_cannot_be_are_refused() {
    // Behind each other: buffers, background, numbers of tiles and children; a tile; a child's origin, masks, and what is left out.
    let background = |bytes: &[u8]| tree(bytes) + 4;
    let tile = |bytes: &[u8]| background(bytes) + 12;
    let child = |bytes: &[u8]| tile(bytes) + 17;
    let left_out = |bytes: &[u8]| child(bytes) + 12 + 2 * 4096;
    type Case<'a> = (&'a dyn Fn(&[u8]) -> usize, &'a [u8], &'a str);
    let cases: [Case<'_>; 6] = [
        (&tree, &[2], "its leaves have 2 buffers each, and one is read"),
        (&|bytes| background(bytes) + 4, &[255; 4], "one of its nodes starts at"),
        (&|bytes| background(bytes) + 8, &[255; 4], "one of its nodes starts at"),
        (&tile, &[1], "one of its nodes starts at [4097, 0, 0], where none can; export it again"),
        (&tile, &[0, 0, 0, 0], "two of its nodes start at [0, 0, 0]; export it again"),
        (&left_out, &[7], "a node leaves out values in a way `7` that is not known; export it again"),
    ];
    for (at, change, problem) in cases {
        let message = refusal_with(false, at, change);
        assert!(message.starts_with("a.vdb: grid `density`: ") && message.contains(problem), "{message}");
    }
    // The first grid's compression stands behind its place in the file.
    let message = refusal_with(false, |bytes| offsets(bytes) + 24, &[0x12]);
    assert!(message.contains("its compression 0x12 is not known"), "{message}");
}

#[test]
fn more_leaves_than_bytes_are_refused_before_anything_is_allocated() {
    let mut bytes = small(false);
    let upper = tree(&bytes) + 16 + 17 + 12;
    // All 16³ places of the lower node hold leaves, each with a mask of its own, and then the file ends.
    let lower = upper + 2 * 4096 + 1;
    bytes.truncate(lower);
    bytes.extend([255; 512]);
    bytes.extend([0; 512 + 1 + 4096 * 64]);
    let end = bytes.len() as i64;
    let at = offsets(&bytes) + 16;
    bytes[at..at + 8].copy_from_slice(&end.to_le_bytes());
    bytes[61..65].copy_from_slice(&1_u32.to_le_bytes());
    let expected = "a.vdb: grid `density`: its 4096 leaves take 266240 bytes at least, but only 0 follow; the file is cut \
                    off, so export or copy it again";
    assert_eq!(refusal(&bytes), expected);
}

#[test]
fn packed_nodes_that_lie_about_their_length_are_refused() {
    // The first packed array, of no values, is the upper node's.
    let length = |bytes: &[u8]| tree(bytes) + 16 + 17 + 12 + 2 * 4096 + 1;
    for lie in [-4_i64, 1, 4_000_000_000, i64::MAX, i64::MIN] {
        let message = refusal_with(true, length, &lie.to_le_bytes());
        assert!(message.starts_with("a.vdb: grid `density`: "), "{message}");
    }
    // The upper node's 32³ values of four bytes, in a Blosc buffer.
    let mut bytes = fixture("blosc");
    let size = find(&bytes, &[4, 0, 0, 2, 0]) + 1;
    bytes[size] = 1;
    let expected = "a.vdb: grid `density`: a node cannot be decompressed (it has 131073 bytes instead of 131072); export \
                    the file again";
    assert_eq!(refusal(&bytes), expected);
}

#[test]
fn every_prefix_is_refused() {
    for bytes in [small(false), small(true)] {
        for length in (0..bytes.len() - 150).step_by(7).chain(bytes.len() - 150..bytes.len()) {
            refusal(&bytes[..length]);
        }
    }
    for name in ["blender", "stream", "types", "half-zip", "blosc"] {
        let bytes = fixture(name);
        for length in (0..bytes.len()).step_by(bytes.len() / 150) {
            refusal(&bytes[..length]);
        }
    }
}

/// A change to a file: bytes overwritten, cut out or put in; numbers are mostly telling ones.
#[derive(Clone, Debug)]
enum Mutation {
    Set(Index, Vec<u8>),
    Cut(Index, usize),
    Insert(Index, Vec<u8>),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let number = prop_oneof![
        any::<u8>().prop_map(|byte| vec![byte]),
        prop::sample::select(vec![0, 1, 2, -1, 8, 4096, i32::MAX, i32::MIN])
            .prop_map(|number| number.to_le_bytes().to_vec()),
        prop::sample::select(vec![0, -1, 1, -2048, i64::MAX, i64::MIN])
            .prop_map(|number| number.to_le_bytes().to_vec()),
        prop::sample::select(vec![f32::NAN, f32::INFINITY, -0.0])
            .prop_map(|number| number.to_le_bytes().to_vec()),
    ];
    prop_oneof![
        4 => (any::<Index>(), number.clone()).prop_map(|(at, bytes)| Mutation::Set(at, bytes)),
        1 => (any::<Index>(), 1..20_usize).prop_map(|(at, length)| Mutation::Cut(at, length)),
        1 => (any::<Index>(), number).prop_map(|(at, bytes)| Mutation::Insert(at, bytes)),
    ]
}

fn mutate(bytes: &mut Vec<u8>, mutation: &Mutation, within: usize) {
    let place = |at: &Index| at.index(within.min(bytes.len()));
    match mutation {
        Mutation::Set(at, with) => {
            let start = place(at);
            let end = bytes.len().min(start + with.len());
            bytes[start..end].copy_from_slice(&with[..end - start]);
        }
        Mutation::Cut(at, length) => {
            let start = place(at);
            bytes.drain(start..bytes.len().min(start + length));
        }
        Mutation::Insert(at, with) => {
            let start = place(at);
            bytes.splice(start..start, with.iter().copied());
        }
    }
}

const SAMPLES: [&str; 11] = [
    "mask",
    "zip",
    "zip-mask",
    "blosc",
    "blosc-mask",
    "half-zip",
    "half-blosc-all",
    "tiles",
    "instances",
    "stream",
    "unsupported",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutated_files_give_data_or_an_error(
        sample in prop::sample::select(&SAMPLES[..]),
        // Most of a file is masks and values: headers are worth more damage.
        within in prop::sample::select(vec![400, 1000, usize::MAX]),
        mutations in prop::collection::vec(mutation(), 1..5),
    ) {
        let mut bytes = fixture(sample);
        for mutation in &mutations {
            mutate(&mut bytes, mutation, within);
        }
        let _ = read(&bytes);
    }

    #[test]
    fn random_bytes_behind_a_header_give_data_or_an_error(tail in prop::collection::vec(any::<u8>(), 0..600)) {
        let mut bytes = small(true);
        for end in [65, tree(&bytes) + 16, tree(&bytes) + 16 + 17 + 12] {
            bytes.truncate(end);
            let _ = read(&[&bytes[..], &tail].concat());
            bytes = small(true);
        }
    }
}
