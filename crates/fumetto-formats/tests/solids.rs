//! Triangles and particles, written and read back by our own readers. What other programs make of them
//! is looked at by `tools/exports.py`.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::io;

use fumetto_formats::{
    Group, Model, ModelOptions, Solid, WriteError, read_model, read_particles, write_glb, write_mtl,
    write_obj, write_particles_csv, write_particles_ply, write_solids_ply,
};
use fumetto_scene::{Colour, Particle};

const SKY: [u8; 3] = [0xc8, 0xd4, 0xe0];
const ROOF: [u8; 3] = [0x90, 0x30, 0x20];

fn group(material: &str, srgb: [u8; 3], triangles: &[[u32; 3]]) -> Group {
    Group { material: material.into(), colour: Colour::from_srgb8(srgb), triangles: triangles.to_vec() }
}

/// A tetrahedron of two materials that starts at `x`; its normals point away from its middle.
fn tetrahedron(name: &str, x: f32) -> Solid {
    let positions = vec![[x, 0.0, 0.0], [x + 1.0, 0.1, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
    let normals = positions
        .iter()
        .map(|&[px, y, z]| {
            let away = [px - x - 0.25, y - 0.275, z - 0.25];
            let length = away.iter().map(|along| along * along).sum::<f32>().sqrt();
            away.map(|along| along / length)
        })
        .collect();
    let groups = vec![
        group("the sky", SKY, &[[0, 2, 1], [0, 1, 3]]),
        group(&format!("{name}.roof"), ROOF, &[[0, 3, 2], [1, 2, 3]]),
    ];
    Solid { name: name.into(), positions, normals, groups }
}

fn solids() -> Vec<Solid> {
    vec![tetrahedron("left one", -3.25), tetrahedron("right", 2.0)]
}

fn written(write: impl FnOnce(&mut Vec<u8>) -> Result<(), WriteError>) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&mut bytes).unwrap();
    bytes
}

/// Corners of all triangles with their normals, as the file has them.
fn corners(model: &Model) -> Vec<([f32; 3], [f32; 3])> {
    let parts = model.placed(0.0).into_iter().map(|placed| &model.parts[placed.part]);
    let of = |part: &fumetto_formats::Part| {
        let corner = |&vertex: &u32| (part.positions[vertex as usize], part.normals[vertex as usize]);
        part.triangles.as_flattened().iter().map(corner).collect::<Vec<_>>()
    };
    parts.flat_map(of).collect()
}

#[track_caller]
fn assert_is_written(model: &Model) {
    let expected: Vec<_> = solids()
        .iter()
        .flat_map(|solid| {
            let triangles = solid.groups.iter().flat_map(|group| group.triangles.as_flattened());
            triangles.map(|&v| (solid.positions[v as usize], solid.normals[v as usize])).collect::<Vec<_>>()
        })
        .collect();
    let found = corners(model);
    assert_eq!(found.len(), expected.len());
    for ((position, normal), (expected, facing)) in found.into_iter().zip(expected) {
        assert_eq!(position, expected);
        assert!(normal.iter().zip(facing).all(|(a, b)| (a - b).abs() < 1e-6), "{normal:?} {facing:?}");
    }
    let colours: Vec<_> = model.parts.iter().map(|part| model.materials[part.material].colour).collect();
    for (found, srgb) in colours.into_iter().zip([SKY, ROOF, SKY, ROOF]) {
        let [r, g, b] = Colour::from_srgb8(srgb).linear;
        assert!(found.iter().zip([r, g, b, 1.0]).all(|(a, b)| (a - b).abs() < 1e-3), "{found:?}");
    }
}

#[test]
fn glb_comes_back() {
    let bytes = written(|out| write_glb(&solids(), out));
    let none = &mut |_: &str| Err(io::ErrorKind::NotFound.into());
    let model = read_model("out.glb", &bytes, ModelOptions::default(), none).unwrap();
    assert_is_written(&model);
    let names: Vec<&str> = model.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["the sky", "left one.roof", "right.roof"]);
    assert_eq!(model.notes, Vec::<String>::new());
}

#[test]
fn obj_and_its_materials_come_back() {
    let obj = written(|out| write_obj(&solids(), "my out.mtl", out));
    let mtl = written(|out| write_mtl(&solids(), out));
    let read = &mut |name: &str| {
        assert_eq!(name, "my out.mtl");
        Ok(mtl.clone())
    };
    let model = read_model("my out.obj", &obj, ModelOptions::default(), read).unwrap();
    assert_is_written(&model);
    assert!(model.materials.iter().any(|material| material.name == "left_one.roof"));
}

#[test]
fn ply_holds_vertices_faces_and_materials() {
    let bytes = written(|out| write_solids_ply(&solids(), out));
    let end = b"end_header\n";
    let start = bytes.windows(end.len()).position(|window| window == end).unwrap() + end.len();
    let header = str::from_utf8(&bytes[..start]).unwrap();
    for line in
        ["element vertex 8", "element face 8", "comment material 0 the sky", "comment material 2 right.roof"]
    {
        assert!(header.lines().any(|found| found == line), "{line}:\n{header}");
    }
    assert_eq!(bytes.len() - start, 8 * 24 + 8 * 20);
    let last = &bytes[bytes.len() - 20..];
    let numbers: Vec<u32> =
        last[1..17].as_chunks::<4>().0.iter().map(|word| u32::from_le_bytes(*word)).collect();
    assert_eq!((last[0], &numbers[..], &last[17..]), (3, &[5, 6, 7, 2][..], &ROOF[..]));
    let vertices = read_particles("out.ply", &bytes).unwrap().particles;
    assert_eq!(vertices[5].center, [3.0, 0.1, 0.0]);
}

#[test]
fn nothing_is_a_file_as_well() {
    let empty = Solid { name: "smoke".into(), positions: vec![], normals: vec![], groups: vec![] };
    let glb = written(|out| write_glb(std::slice::from_ref(&empty), out));
    assert_eq!(u32::from_le_bytes([glb[8], glb[9], glb[10], glb[11]]) as usize, glb.len());
    assert!(!glb.windows(4).any(|window| window == b"mesh"), "a mesh without triangles is no glTF");
    assert!(written(|out| write_obj(std::slice::from_ref(&empty), "a.mtl", out)).ends_with(b"o smoke\n"));
    assert!(written(|out| write_solids_ply(&[empty], out)).ends_with(b"end_header\n"));
}

#[test]
fn what_no_reader_understands_is_refused() {
    let mut lost = tetrahedron("lost", 0.0);
    lost.positions[1][2] = f32::NAN;
    let mut torn = tetrahedron("torn", 0.0);
    torn.groups[0].triangles[0][0] = 4;
    for (solid, says) in [(lost, "lies nowhere"), (torn, "no vertex")] {
        let solid = [solid];
        let errors = [
            write_glb(&solid, io::sink()).unwrap_err(),
            write_obj(&solid, "a.mtl", io::sink()).unwrap_err(),
            write_solids_ply(&solid, io::sink()).unwrap_err(),
        ];
        for error in errors {
            assert!(error.to_string().contains(says), "{error}");
        }
    }
}

#[test]
fn particles_come_back() {
    let particles: Vec<Particle> = [[0.1, -2.5, 1024.5], [1e-7, 3.0, 0.3]]
        .into_iter()
        .map(|center| Particle { center, radius: 0.7, mass: 1.0 / 3.0 })
        .collect();
    let ply = written(|out| write_particles_ply(&particles, out));
    let csv = written(|out| write_particles_csv(&particles, out));
    for (name, bytes) in [("a.ply", ply), ("a.csv", csv)] {
        let table = read_particles(name, &bytes).unwrap();
        assert_eq!(table.particles, particles, "{name}");
        assert_eq!(table.notes, Vec::<String>::new());
    }
}
