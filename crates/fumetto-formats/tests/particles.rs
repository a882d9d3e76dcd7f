//! Particles from files that other programs wrote (by `tools/fixtures/particles.py`), and the refusals.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::fs;

use fumetto_formats::{MAX_PARTICLES, ParticleTable, read_particles};
use fumetto_scene::Particle;

const CENTERS: [[f32; 3]; 5] =
    [[0.0, 1.0, 0.0], [0.875, 0.875, 0.125], [-0.75, 1.25, -0.5], [100.0, -2.5, 1024.5], [0.0625, 0.0, 3.0]];
const RADII: [f32; 5] = [1.0, 0.75, 0.5, 0.25, 2.0];
const MASSES: [f32; 5] = [8.0, 4.0, 2.0, 1.0, 0.5];

fn fixture(name: &str) -> ParticleTable {
    let path = format!("{}/tests/fixtures/{name}", env!("CARGO_MANIFEST_DIR"));
    read_particles(name, &fs::read(path).unwrap()).unwrap()
}

fn full() -> Vec<Particle> {
    let particle = |i: usize| Particle { center: CENTERS[i], radius: RADII[i], mass: MASSES[i] };
    (0..5).map(particle).collect()
}

fn points_only() -> Vec<Particle> {
    CENTERS.into_iter().map(|center| Particle { center, radius: 0.1, mass: 1.0 }).collect()
}

fn message(name: &str, bytes: &[u8]) -> String {
    read_particles(name, bytes).unwrap_err().to_string()
}

#[test]
fn point_clouds_of_trimesh_and_pyvista_are_read_with_defaults() {
    for name in ["trimesh-ascii.ply", "trimesh-binary.ply", "pyvista-ascii.ply", "pyvista-binary.ply"] {
        let table = fixture(name);
        assert_eq!(table.particles, points_only(), "{name}");
        let notes = [
            format!("{name} has no column `radius`: every particle has a radius of 0.1 m"),
            format!("{name} has no column `mass`: every particle has a mass of 1"),
        ];
        assert_eq!(table.notes, notes);
    }
}

#[test]
fn a_mesh_with_attributes_gives_its_vertices() {
    for name in ["trimesh-mesh-ascii.ply", "trimesh-mesh-binary.ply"] {
        assert_eq!(fixture(name), ParticleTable { particles: full(), notes: vec![] }, "{name}");
    }
}

#[test]
fn a_table_for_excel_is_read_and_its_other_columns_are_noted() {
    let table = fixture("excel.csv");
    assert_eq!(table.particles, full());
    assert_eq!(table.notes, ["excel.csv: ignored the column `Name`"]);
}

#[test]
fn tables_of_numpy_are_read() {
    assert_eq!(fixture("numpy.csv"), ParticleTable { particles: full(), notes: vec![] });
    assert_eq!(fixture("numpy-tabs.csv").particles, points_only());
}

/// A PLY of both byte orders whose vertices stand between other elements and hold lists.
fn binary_ply(big_endian: bool) -> Vec<u8> {
    let order = if big_endian { "big" } else { "little" };
    let mut bytes = format!(
        "ply\r\nformat binary_{order}_endian 1.0\r\ncomment caf\u{e9}\r\nelement face 2\r\n\
         property list uchar short corners\r\nelement fixed 3\r\nproperty double d\r\nelement vertex 2\r\n\
         property list ushort double history\r\nproperty double M\r\nproperty short X\r\nproperty float y\r\n\
         property int8 Z\r\nproperty uint PScale\r\nelement tail 1\r\nproperty int t\r\nend_header\r\n"
    )
    .into_bytes();
    let mut put = |big: &[u8]| {
        let mut value = big.to_vec();
        if !big_endian {
            value.reverse();
        }
        bytes.extend(value);
    };
    put(&[1]);
    put(&7_i16.to_be_bytes());
    put(&[0]);
    for d in [1.0_f64, 2.0, 3.0] {
        put(&d.to_be_bytes());
    }
    for i in 0..2_u8 {
        put(&u16::from(i).to_be_bytes());
        for _ in 0..i {
            put(&9.0_f64.to_be_bytes());
        }
        put(&(f64::from(i) + 0.5).to_be_bytes());
        put(&(-300_i16).to_be_bytes());
        put(&0.25_f32.to_be_bytes());
        put(&(-3_i8).to_be_bytes());
        put(&70_000_u32.to_be_bytes());
    }
    put(&1_i32.to_be_bytes());
    bytes
}

#[test]
fn any_scalar_type_order_and_place_of_the_vertices_is_read() {
    let particle = |mass| Particle { center: [-300.0, 0.25, -3.0], radius: 70_000.0, mass };
    for big_endian in [false, true] {
        let table = read_particles("a.PLY", &binary_ply(big_endian)).unwrap();
        assert_eq!(table.particles, [particle(0.5), particle(1.5)]);
        assert_eq!(table.notes, [""; 0]);
    }
}

#[test]
fn text_rows_may_hold_lists_and_follow_other_elements() {
    let text = "ply\nformat ascii 1.0\nelement nothing 4000000000\nelement face 2\nproperty list uchar int c\n\
                element vertex 2\nproperty list uchar int c\nproperty float x\nproperty float y\n\
                property float z\nproperty float r\nproperty float weight\nend_header\n\
                3 0 1 2\n\n0\n2 8 9 1 2 3 4 .5\n\n0 -1. +2e0 3 4 5";
    let particles = [
        Particle { center: [1.0, 2.0, 3.0], radius: 4.0, mass: 0.5 },
        Particle { center: [-1.0, 2.0, 3.0], radius: 4.0, mass: 5.0 },
    ];
    for line_end in ["\n", "\r\n", "\r"] {
        let table = read_particles("a.ply", text.replace('\n', line_end).as_bytes()).unwrap();
        assert_eq!(table.particles, particles, "{line_end:?}");
    }
}

#[test]
fn the_full_name_of_a_column_goes_before_its_short_one() {
    let table = read_particles("a.csv", b"r,m,x,y,z,radius,mass\n8,9,1,2,3,4,5\n").unwrap();
    assert_eq!(table.particles, [Particle { center: [1.0, 2.0, 3.0], radius: 4.0, mass: 5.0 }]);
    assert_eq!(table.notes, ["a.csv: ignored the columns `r`, `m`"]);
}

#[test]
fn an_unknown_extension_lists_the_known_ones() {
    let expected =
        "clouds/a.xyz: particles are read from `.ply` and `.csv` files; convert this one to either";
    assert_eq!(message("clouds/a.xyz", b""), expected);
}

#[test]
fn a_bad_number_is_named_with_file_line_column_and_text() {
    let expected = "a.csv, line 5, column `Radius`: `0,5` is not a number; write one like 0.25, with a point";
    let tables = [
        "# c\nx;y;z;Radius\n0;0;0;1\n\n0;0;0;0,5\n",
        "\u{feff}#,,,,\r\nx;y;z;Radius\r\n0;0;0;\"1\"\r\n# c\r\n0;0;0;0,5",
        "x;y;z;Radius\r0;0;0;1\r\r0;0;0;1\r0;0;0;0,5\r",
    ];
    for table in tables {
        assert_eq!(message("a.csv", table.as_bytes()), expected, "{table:?}");
    }
    let header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n\
                  property float z\nproperty float mass\nend_header\n";
    let expected = "a.ply, line 11, column `mass`: `-1` is not above zero, as it has to be";
    assert_eq!(message("a.ply", format!("{header}0 0 0 1\n\n0 0 0 -1\n").as_bytes()), expected);
}

#[test]
fn values_that_no_particle_can_have_are_refused() {
    for value in ["nan", "inf", "-infinity", "1e300", "", "1e", "0x1"] {
        for row in [format!("{value},0,0,1,1"), format!("0,0,0,{value},1"), format!("0,0,0,1,{value}")] {
            let text = message("a.csv", format!("x,y,z,radius,mass\n{row}\n").as_bytes());
            assert!(text.contains("line 2, column") && text.contains(&format!("`{value}`")), "{text}");
        }
    }
    for value in ["0", "-0.0", "-2", "1e-300"] {
        for row in [format!("0,0,0,{value},1"), format!("0,0,0,1,{value}")] {
            let text = message("a.csv", format!("x,y,z,radius,mass\n{row}\n").as_bytes());
            assert!(text.contains("is not above zero"), "{text}");
        }
    }
}

#[test]
fn a_bad_binary_value_is_named_with_its_vertex() {
    let mut bytes = b"ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n\
                      property float y\nproperty double z\nend_header\n"
        .to_vec();
    bytes.extend([0; 16]);
    bytes.extend([0; 8]);
    bytes.extend(f64::NAN.to_le_bytes());
    let expected = "a.ply, vertex 1, column `z`: `NaN` is not a finite number that single precision can hold";
    assert_eq!(message("a.ply", &bytes), expected);
}

#[test]
fn missing_and_doubled_columns_are_named() {
    let text = message("a.csv", b"px,y,pz\n1,2,3\n");
    assert!(text.starts_with("a.csv: no column is called `x`, `z`; the file has `px`, `y`, `pz`."), "{text}");
    let text = message("a.csv", b"x,y,z,X\n1,2,3,4\n");
    assert_eq!(text, "a.csv: two columns are called `x`; rename the one that is not meant");
    let list = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
                property list uchar int z\nend_header\n1 2 1 3\n";
    assert!(message("a.ply", list.as_bytes()).contains("no column is called `z`"));
}

#[test]
fn an_uneven_row_is_named() {
    let expected = "a.csv, line 3: 2 values stand under 3 column names; give every row one value for each";
    assert_eq!(message("a.csv", b"x,y,z\n1,2,3\n1,2\n"), expected);
    let ply = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
               end_header\n1     2\n";
    let expected = "a.ply, line 8: the row ends after 2 of 3 properties; export the file again";
    assert_eq!(message("a.ply", ply.as_bytes()), expected);
}

#[test]
fn a_file_without_particles_is_refused() {
    for (name, bytes) in [
        ("a.csv", ""),
        ("a.csv", "# x,y,z\n"),
        ("a.csv", "x,y,z\n\n"),
        (
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n",
        ),
    ] {
        let text = message(name, bytes.as_bytes());
        assert_eq!(text, format!("{name}: there is no particle in it; export it again with at least one"));
    }
}

#[test]
fn too_many_particles_are_counted_and_refused() {
    let mut table = "x,y,z\n".to_owned();
    table.push_str(&"0,0,0\n".repeat(MAX_PARTICLES));
    assert_eq!(read_particles("a.csv", table.as_bytes()).unwrap().particles.len(), MAX_PARTICLES);
    table.push_str("1,1,1\n1,1,1\n");
    let expected =
        "a.csv: 1500002 particles are more than the 1500000 that are allowed; keep every n-th of them";
    assert_eq!(message("a.csv", table.as_bytes()), expected);
}
