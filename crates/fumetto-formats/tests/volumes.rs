//! Volumes that OpenVDB and Blender wrote (by `tools/fixtures/volumes.py`), voxel by voxel, and what is
//! written for them.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::collections::BTreeMap;
use std::fs;
use std::io::{Read, Write};
use std::sync::Arc;

use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use fumetto_formats::{
    BRICK_VOXELS, Grid, GridClass, Tile, VdbOptions, Volume, Voxels, read_volume, write_vdb,
};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/volumes");

fn bytes(name: &str) -> Vec<u8> {
    let packed = fs::read(format!("{FOLDER}/{name}.vdb.gz")).unwrap();
    let mut bytes = Vec::new();
    GzDecoder::new(&packed[..]).read_to_end(&mut bytes).unwrap();
    bytes
}

fn read(name: &str) -> Volume {
    read_volume(&format!("{name}.vdb"), &bytes(name), &[]).unwrap()
}

fn refusal(name: &str, wanted: &[&str]) -> String {
    read_volume(&format!("{name}.vdb"), &bytes(name), wanted).unwrap_err().to_string()
}

fn write(grids: &[Grid], options: VdbOptions) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_vdb(grids, options, &mut bytes).unwrap();
    bytes
}

fn write_and_read(grids: &[Grid], options: VdbOptions) -> Volume {
    read_volume("a.vdb", &write(grids, options), &[]).unwrap()
}

/// What is active or not background: least and greatest index, whether it is active, its value.
type Entry<'a> = ([i32; 3], [i32; 3], bool, &'a [f32]);

fn entries(voxels: &Voxels) -> Vec<Entry<'_>> {
    let background = &voxels.background[..voxels.channels];
    let mut entries = Vec::new();
    for (place, brick) in voxels.bricks.iter().enumerate() {
        for (voxel, value) in voxels.brick_values(place).chunks(voxels.channels).enumerate() {
            let [x, y, z] = [voxel % 8, voxel / 8 % 8, voxel / 64];
            let index = [0, 1, 2].map(|axis| brick.origin[axis] + [x, y, z][axis] as i32);
            entries.push((index, index, brick.active[z] >> (x + 8 * y) & 1 == 1, value));
        }
    }
    for tile in &voxels.tiles {
        let last = tile.origin.map(|i| i + tile.side - 1);
        entries.push((tile.origin, last, tile.active, &tile.value[..voxels.channels]));
    }
    entries.retain(|&(_, _, active, value)| active || value != background);
    entries.sort_by_key(|entry| entry.0);
    entries
}

/// FNV-1a over all entries, as `volumes.cc` computes it.
fn hash(entries: &[Entry<'_>]) -> u64 {
    let mut bytes = Vec::new();
    for (least, greatest, active, value) in entries {
        [*least, *greatest].as_flattened().iter().for_each(|i| bytes.extend(i.to_le_bytes()));
        bytes.push(u8::from(*active));
        value.iter().for_each(|number| bytes.extend(number.to_le_bytes()));
    }
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[test]
fn every_grid_is_what_openvdb_finds_in_the_file() {
    let table = fs::read_to_string(format!("{FOLDER}/counts.csv")).unwrap();
    let mut rows = BTreeMap::<&str, Vec<Vec<&str>>>::new();
    for line in table.lines().skip(1) {
        let cells: Vec<_> = line.split(',').collect();
        rows.entry(cells[0]).or_default().push(cells);
    }
    assert!(rows.len() > 20);
    for (name, mut rows) in rows {
        // Volumes are not read through a frustum.
        rows.retain(|row| row[..2] != ["frustum", "seen"]);
        let mut found: Vec<_> = read(name).grids.iter().map(|grid| row(name, grid)).collect();
        let mut expected: Vec<_> = rows.iter().map(|row| (told(row), corners(row))).collect();
        // OpenVDB tells them by name.
        found.sort_by(|one, other| one.0.cmp(&other.0));
        expected.sort_by(|one, other| one.0.cmp(&other.0));
        assert_eq!(found.len(), expected.len(), "{name}");
        for ((found, found_at), (expected, expected_at)) in found.into_iter().zip(expected) {
            assert_eq!(found, expected);
            for (one, other) in found_at.iter().zip(&expected_at) {
                assert!((one - other).abs() < 1e-12, "{name}: {found_at:?} instead of {expected_at:?}");
            }
        }
    }
}

/// What a row of the table tells, but for the type and where voxels are.
fn told(row: &[&str]) -> Vec<String> {
    [0, 1, 3, 4, 5, 6, 7].map(|cell| row[cell].to_owned()).to_vec()
}

/// Where the voxels (0, 0, 0), (1, 0, 0), (0, 1, 0) and (0, 0, 1) are.
fn corners(row: &[&str]) -> Vec<f64> {
    row[8..].iter().map(|cell| cell.parse().unwrap()).collect()
}

/// The same of a grid.
fn row(name: &str, grid: &Grid) -> (Vec<String>, Vec<f64>) {
    let entries = entries(&grid.voxels);
    let class = match grid.class {
        GridClass::Unknown => "unknown",
        GridClass::FogVolume => "fog volume",
        GridClass::LevelSet => "level set",
        GridClass::Staggered => "staggered",
    };
    let told = vec![
        name.to_owned(),
        grid.name.clone(),
        class.to_owned(),
        entries.len().to_string(),
        grid.voxels.active_count().to_string(),
        format!("{:016x}", hash(&entries)),
        grid.voxels.background[0].to_string(),
    ];
    let [x, y, z, origin] = grid.world_from_index;
    let corners = [[0.0; 4], x, y, z].map(|axis| [0, 1, 2].map(|i| origin[i] + axis[i]));
    (told, corners.concat())
}

/// The values of `volumes.cc`.
fn formula([x, y, z]: [i32; 3]) -> f32 {
    ((7 * x + 13 * y + 29 * z).rem_euclid(64) + 1) as f32 / 16.0
}

/// A ball as OpenVDB was told to make it.
fn check_ball(grid: &Grid, center: [i32; 3], expected: impl Fn([i32; 3]) -> [f32; 3]) {
    let mut active = 0;
    for (x, y, z) in (-20..60).flat_map(|x| (-20..40).flat_map(move |y| (-20..40).map(move |z| (x, y, z)))) {
        let index = [x, y, z];
        let inside = (0..3).map(|i| (index[i] - center[i]).pow(2)).sum::<i32>() <= 25;
        let value = if inside { expected(index) } else { [0.0; 3] };
        assert_eq!(grid.voxels.at(index), (value, inside), "{} at {index:?}", grid.name);
        active += u64::from(inside);
    }
    assert_eq!(grid.voxels.active_count(), active);
    let bounds = [center.map(|i| i - 5), center.map(|i| i + 5)];
    assert_eq!(grid.voxels.active_bounds(), Some(bounds));
}

#[test]
fn every_codec_gives_the_numbers_that_were_written() {
    let names = "none mask zip zip-mask blosc blosc-mask half-none half-zip half-blosc half-blosc-all half-grid stream";
    for name in names.split(' ') {
        check_ball(&read(name).grids[0], [12, 9, 10], |index| [formula(index), 0.0, 0.0]);
    }
    check_ball(&read("corners").grids[0], [-1, 2, 0], |index| [formula(index), 0.0, 0.0]);
}

#[test]
fn every_type_gives_the_numbers_that_were_written() {
    for name in ["types", "types-zip", "half-types"] {
        for grid in read(name).grids {
            check_ball(&grid, [12, 9, 10], |index| {
                let v = formula(index);
                match grid.name.as_str() {
                    "double" => [v, 0.0, 0.0],
                    "int32" | "int64" => [16.0 * v, 0.0, 0.0],
                    "bool" => [f32::from(v > 2.0), 0.0, 0.0],
                    "mask" => [1.0, 0.0, 0.0],
                    "vec3i" => [16.0 * v, -16.0 * v, 16.0 * v + 1.0],
                    _ => [v, -v, v + 1.0],
                }
            });
        }
    }
}

#[test]
fn three_voxels_far_apart_take_three_bricks() {
    let volume = read("far");
    let voxels = &volume.grids[0].voxels;
    assert_eq!((voxels.bricks.len(), voxels.tiles.len(), voxels.values.len()), (3, 0, 3 * BRICK_VOXELS));
    assert_eq!(voxels.active_bounds(), Some([[-5000; 3], [5000; 3]]));
}

#[test]
fn tiles_of_every_size_are_kept_unless_they_are_background() {
    let volume = read("tiles");
    let voxels = &volume.grids[0].voxels;
    let sides: Vec<_> =
        voxels.tiles.iter().map(|tile| (tile.origin, tile.side, tile.value[0], tile.active)).collect();
    let expected = [
        ([-4096, 0, 4096], 4096, 3.5, true),
        ([8, 16, 24], 8, 1.5, true),
        ([80, 0, 0], 8, 0.5, false),
        ([128, 256, 0], 128, 2.5, true),
        ([4096, 0, 0], 4096, 4.5, false),
    ];
    assert_eq!(sides, expected);
    for (index, value, active) in [
        ([-1, 4095, 8191], 3.5, true),
        ([-1, 4096, 8191], 0.25, false),
        ([15, 23, 31], 1.5, true),
        ([16, 23, 31], 0.25, false),
        ([255, 383, 127], 2.5, true),
        ([8191, 4095, 4095], 4.5, false),
        ([1000, 2000, 3000], 1.0, true),
        ([1000, 2000, 3001], 0.25, false),
    ] {
        assert_eq!(voxels.at(index), ([value, 0.0, 0.0], active), "{index:?}");
    }
}

#[test]
fn grids_that_share_voxels_share_memory() {
    let volume = read("instances");
    let [density, heat, other] = &volume.grids[..] else { panic!("three grids") };
    assert!(Arc::ptr_eq(&density.voxels, &heat.voxels) && !Arc::ptr_eq(&density.voxels, &other.voxels));
    assert_eq!([&density.name, &heat.name, &other.name], ["density", "heat", "density"]);
    assert_eq!(heat.world_from_index[0][0], 2.0);

    // One can be had without the other, and they share them in a written file, too.
    let alone = read_volume("a.vdb", &bytes("instances"), &["heat"]).unwrap();
    assert_eq!(alone.grids, std::slice::from_ref(heat));
    let written = write_and_read(&volume.grids, VdbOptions::default());
    assert_eq!(written.grids, volume.grids);
    assert!(Arc::ptr_eq(&written.grids[0].voxels, &written.grids[1].voxels));
    assert_eq!(write_and_read(&volume.grids[1..], VdbOptions::default()).grids, volume.grids[1..]);
}

#[test]
fn only_the_grids_that_are_wanted_are_read() {
    let names = |name: &str, wanted: &[&str]| -> Vec<String> {
        let volume = read_volume(name, &bytes(name.trim_end_matches(".vdb")), wanted).unwrap();
        volume.grids.into_iter().map(|grid| grid.name).collect()
    };
    assert_eq!(names("blender.vdb", &["temperature", "density", "heat"]), ["density", "temperature"]);
    assert_eq!(names("stream.vdb", &["vel"]), ["vel"]);
    assert_eq!(
        refusal("stream", &["smoke", "fire"]),
        "stream.vdb: there is no grid called `smoke`, `fire` in it, but `density`, `vel`; export it again with one of \
         these names"
    );
}

#[test]
fn grids_of_unknown_kinds_are_left_aside_unless_there_is_nothing_else() {
    let volume = read("unsupported");
    assert_eq!(volume.grids.len(), 1);
    let kind = "its type is `Tree_float_5_4_2`, which is not read; what is are numbers and vectors of three in trees of \
                the usual shape, such as `Tree_float_5_4_3`";
    assert_eq!(volume.notes, [format!("unsupported.vdb: grid `small`: it is left aside: {kind}")]);
    assert_eq!(refusal("unsupported-only", &[]), format!("unsupported-only.vdb: grid `small`: {kind}"));
    let frustum = "its transform is a `NonlinearFrustumMap`, and only affine ones are read";
    assert_eq!(read("frustum").notes, [format!("frustum.vdb: grid `seen`: it is left aside: {frustum}")]);
    assert_eq!(refusal("frustum", &["seen"]), format!("frustum.vdb: grid `seen`: {frustum}"));
}

#[test]
fn numbers_that_are_none_become_background() {
    let volume = read("nan");
    let note =
        "nan.vdb: grid `density`: 2 of its values are infinite or no numbers; they became its background";
    assert_eq!(volume.notes, [note]);
    let voxels = &volume.grids[0].voxels;
    assert_eq!(voxels.at([12, 9, 10]), ([0.0; 3], true));
    assert_eq!(voxels.at([13, 9, 10]), ([0.0; 3], true));
    assert_eq!(voxels.active_count(), 515);
}

#[test]
fn what_is_written_is_read_again() {
    for name in
        ["blender", "half-types", "corners", "tiles", "far", "inactive", "level-set", "blosc", "zip", "empty"]
    {
        let grids = read(name).grids;
        for (zip, half) in [(false, false), (true, false), (false, true), (true, true)] {
            let read = write_and_read(&grids, VdbOptions { zip, half });
            assert_eq!(read.notes, [""; 0]);
            // The level set's distances alone are too fine for half floats.
            if !half || name != "level-set" {
                assert_eq!(read.grids, grids, "{name}, zip {zip}, half {half}");
            }
        }
    }
}

/// A ball as `volumes.cc` makes it, among other things: tiles, vectors, inactive values that differ.
fn own_grids() -> Vec<Grid> {
    let origin = [-6, -3, -5];
    let box_of = |channels: usize, value: &dyn Fn([i32; 3], bool) -> [f32; 3], background: [f32; 3]| {
        let mut values = Vec::new();
        for (z, y, x) in (0..11).flat_map(|z| (0..11).flat_map(move |y| (0..11).map(move |x| (z, y, x)))) {
            let inside = [x, y, z].iter().map(|i| (i - 5_i32).pow(2)).sum::<i32>() <= 25;
            let index = [origin[0] + x, origin[1] + y, origin[2] + z];
            values.extend(&value(index, inside)[..channels]);
        }
        Voxels::from_dense(origin, [11; 3], channels, &values, background).unwrap()
    };
    let ball = |index, inside| if inside { [formula(index), 0.0, 0.0] } else { [0.0; 3] };
    let density = box_of(1, &ball, [0.0; 3]);
    let mut temperature = box_of(
        1,
        &|index, inside| if inside { [formula(index), 0.0, 0.0] } else { [2.5, 0.0, 0.0] },
        [2.5, 0.0, 0.0],
    );
    let tile = |origin, side, value, active| Tile { origin, side, value: [value, 0.0, 0.0], active };
    temperature.tiles = vec![
        tile([-4096, 0, 4096], 4096, 3.5, true),
        tile([16, 24, 32], 8, 1.5, true),
        tile([128, 256, 0], 128, 2.0, false),
    ];
    // The first brick's inactive voxels have two values, the second's many.
    for (voxel, number) in temperature.values[..2 * BRICK_VOXELS].iter_mut().enumerate() {
        let brick = &temperature.bricks[voxel / BRICK_VOXELS];
        if brick.active[voxel / 64 % 8] >> (voxel % 64) & 1 == 0 {
            *number = if voxel < BRICK_VOXELS { [0.5, 0.25][voxel % 2] } else { (voxel % 7) as f32 };
        }
    }
    let wind = |index, inside| if inside { [formula(index), -formula(index), 1.0] } else { [0.0; 3] };
    let velocity = box_of(3, &wind, [0.0; 3]);
    let uniform = [[0.5, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0], [0.0, 0.0, 0.5, 0.0], [1.0, 2.0, 3.0, 1.0]];
    let stretched =
        [[0.5, 0.0, 0.0, 0.0], [0.0, 0.25, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0], [0.0, 0.0, -1.0, 1.0]];
    let turned = [[0.0, 0.5, 0.0, 0.0], [-0.5, 0.0, 0.0, 0.0], [0.0, 0.125, 0.5, 0.0], [1.0, 0.0, 0.0, 1.0]];
    let grid = |name: &str, class, world_from_index, voxels: &Arc<Voxels>| Grid {
        name: name.to_owned(),
        class,
        world_from_index,
        voxels: Arc::clone(voxels),
    };
    let density = Arc::new(density);
    vec![
        grid("density", GridClass::FogVolume, uniform, &density),
        grid("temperature", GridClass::Unknown, stretched, &Arc::new(temperature)),
        grid("vel", GridClass::Staggered, turned, &Arc::new(velocity)),
        grid("density", GridClass::FogVolume, stretched, &density),
    ]
}

/// OpenVDB has read these files: `counts.csv` tells what it found. `UPDATE_VOLUMES=1` writes them anew, for
/// `tools/fixtures/volumes.py` and `tools/check_vdb.py` to read.
#[test]
fn what_is_written_is_what_openvdb_was_shown() {
    let grids = own_grids();
    for (name, zip, half) in
        [("plain", false, false), ("zip", true, false), ("half", false, true), ("half-zip", true, true)]
    {
        let name = format!("written-{name}");
        let written = write(&grids, VdbOptions { zip, half });
        if std::env::var_os("UPDATE_VOLUMES").is_some() {
            let mut packer = GzEncoder::new(Vec::new(), Compression::best());
            packer.write_all(&written).unwrap();
            fs::write(format!("{FOLDER}/{name}.vdb.gz"), packer.finish().unwrap()).unwrap();
        }
        assert_eq!(read(&name).grids, grids, "{name}");
        // Other versions of zlib pack otherwise.
        assert!(zip || bytes(&name) == written, "{name} is not what is written now");
    }
}

#[test]
fn grids_that_break_their_promises_are_not_written() {
    let refusal = |change: &dyn Fn(&mut Voxels), options: VdbOptions| {
        let mut grid = own_grids().swap_remove(1);
        change(Arc::make_mut(&mut grid.voxels));
        write_vdb(&[grid], options, Vec::new()).unwrap_err().to_string()
    };
    let plain = VdbOptions::default();
    let half = VdbOptions { half: true, ..plain };
    type Case<'a> = (&'a dyn Fn(&mut Voxels), VdbOptions, &'a str);
    let cases: [Case<'_>; 9] = [
        (
            &|v| v.bricks[0].origin = [i32::MAX; 3],
            plain,
            "a cube of 8 voxels a side starts at [2147483647, 2147483647, 2147483647], which are no multiples of 8",
        ),
        (&|v| v.channels = 2, plain, "its values have 2 channels, where 1 or 3 are possible"),
        (&|v| v.values.truncate(9), plain, "it has 9 numbers, where its bricks need 4096"),
        (
            &|v| v.values[5] = f32::NAN,
            plain,
            "its number NaN cannot be stored; the greatest that can is 340282350000000000000000000000000000000",
        ),
        (
            &|v| v.values[5] = 65_505.0,
            half,
            "its number 65505 cannot be stored; the greatest that can is 65504",
        ),
        (
            &|v| v.tiles[1].side = 16,
            plain,
            "a tile has 16 voxels a side, where only [4096, 128, 8] are possible",
        ),
        (
            &|v| v.bricks[0].origin[1] = -9,
            plain,
            "a cube of 8 voxels a side starts at [-8, -9, -8], which are no multiples of 8",
        ),
        (
            &|v| v.bricks[1].origin = [-8; 3],
            plain,
            "two of its bricks and tiles cover the voxel [-8, -8, -8]",
        ),
        (&|v| v.tiles[2].origin = [0; 3], plain, "two of its bricks and tiles cover the voxel [0, 0, 0]"),
    ];
    for (change, options, problem) in cases {
        assert_eq!(refusal(change, options), format!("the grid `temperature` cannot be written: {problem}"));
    }
    let mut flat = own_grids().swap_remove(0);
    flat.world_from_index[2] = [0.0; 4];
    let message = write_vdb(&[flat], plain, Vec::new()).unwrap_err().to_string();
    assert_eq!(
        message,
        "the grid `density` cannot be written: its transform has to be affine and to have an inverse"
    );
}
