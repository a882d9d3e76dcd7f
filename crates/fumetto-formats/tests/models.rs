//! Models from files that other programs wrote (by `tools/fixtures/models.py`), and from ones by hand.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod common;

use std::fs;
use std::io;

use common::{ROOF, buffer, check, floats, read_gltf, roof_with};
use fumetto_formats::{Model, ModelOptions, Part, Wrap, read_model};
use glam::{Mat4, Vec2, Vec3};

fn path(name: &str) -> String {
    format!("{}/tests/fixtures/models/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Reads a fixture as if it lay in the folder `models`.
fn fixture_with(name: &str, smooth_degrees: Option<f32>) -> Model {
    let bytes = fs::read(path(name)).unwrap();
    let mut read = |asked: &str| fs::read(path(asked.strip_prefix("models/").unwrap()));
    let options = ModelOptions { smooth_degrees };
    let model = read_model(&format!("models/{name}"), &bytes, options, &mut read).unwrap();
    check(&model);
    model
}

fn fixture(name: &str) -> Model {
    fixture_with(name, None)
}

fn table(name: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path(name)).unwrap();
    text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// The corners of all triangles, where they are at the start.
fn corners(model: &Model) -> Vec<[Vec3; 3]> {
    let placed = model.placed(0.0);
    let of = |placed: &fumetto_formats::Placed| {
        let part = &model.parts[placed.part];
        let world_from_part = Mat4::from_cols_array_2d(&placed.world_from_part);
        let place = |vertex: u32| world_from_part.transform_point3(part.positions[vertex as usize].into());
        part.triangles.iter().map(|triangle| triangle.map(place)).collect::<Vec<_>>()
    };
    placed.iter().flat_map(of).collect()
}

fn area(model: &Model) -> f32 {
    corners(model).iter().map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum()
}

fn bounds(model: &Model) -> [Vec3; 2] {
    let corners = corners(model);
    let all = || corners.iter().flatten();
    [all().copied().fold(Vec3::MAX, Vec3::min), all().copied().fold(Vec3::MIN, Vec3::max)]
}

#[test]
fn every_model_has_as_many_triangles_as_its_program_says() {
    for row in table("counts.csv") {
        let [name, triangles, placed] = row.as_slice() else { panic!("{row:?}") };
        let model = fixture(name);
        assert_eq!(model.triangle_count(), triangles.parse::<u64>().unwrap(), "{name}");
        assert_eq!(model.placed(0.0).len(), placed.parse::<usize>().unwrap(), "{name}");
        assert_eq!(model.notes, [""; 0], "{name}");
    }
}

#[test]
fn a_moving_node_is_where_blender_has_it() {
    let (sampled, keys) = (fixture("blender-windmill.glb"), fixture("blender-windmill-keys.glb"));
    assert!(sampled.is_animated() && keys.is_animated());
    assert_eq!((sampled.duration_secs(), keys.duration_secs()), (2.0, 2.0));
    for row in table("motion.csv") {
        let numbers: Vec<f32> = row.iter().map(|text| text.parse().unwrap()).collect();
        let [secs, rows @ ..] = numbers.as_slice() else { panic!("{row:?}") };
        // The whole animation later, and earlier, it is there again.
        for time in [*secs, secs + 2.0, secs - 4.0] {
            let matrix = sampled.placed(time)[0].world_from_part;
            let keyed = keys.placed(time)[0].world_from_part;
            for (i, expected) in rows.iter().enumerate() {
                let (row, column) = (i / 4, i % 4);
                assert!((matrix[column][row] - expected).abs() < 1e-3, "at {time}, {i}: {matrix:?}");
                // Between keys, Blender turns at an uneven pace, glTF at an even one: height and size
                // are compared everywhere, all the rest where there are keys.
                if row == 1 || secs.fract() == 0.0 {
                    assert!((keyed[column][row] - expected).abs() < 1e-3, "at {time}, {i}: {keyed:?}");
                }
            }
        }
    }
}

#[test]
fn shared_and_mirrored_meshes_stand_where_they_should() {
    let (glb, obj) = (fixture("blender-village.glb"), fixture("blender-village.obj"));
    // The house with its two materials, which stands twice, and the garden.
    assert_eq!((glb.parts.len(), obj.parts.len()), (3, 5));
    assert_eq!(bounds(&glb), bounds(&obj));
    // Six sides of 4, the same twice as high, and a garden of 3.
    assert!((area(&glb) - (24.0 + 40.0 + 3.0)).abs() < 1e-4, "{}", area(&glb));
    assert!((area(&obj) - area(&glb)).abs() < 1e-4);
    let mirrored = |placed: &&fumetto_formats::Placed| {
        Mat4::from_cols_array_2d(&placed.world_from_part).determinant() < 0.0
    };
    assert_eq!(glb.placed(0.0).iter().filter(mirrored).count(), 2);
    assert!(!glb.is_animated());

    let material = |model: &Model, name: &str| {
        model.materials.iter().find(|material| material.name == name).unwrap().colour
    };
    assert_eq!(material(&glb, "roof"), [0.0, 0.5, 1.0, 1.0]);
    // OBJ's are taken as sRGB.
    let [r, g, b, a] = material(&obj, "roof");
    assert!((r, b, a) == (0.0, 1.0, 1.0) && (g - 0.214).abs() < 1e-3, "{g}");
}

#[test]
fn textures_stand_upright() {
    for name in ["trimesh-square.glb", "trimesh-square.obj", "blender-picture.gltf"] {
        let model = fixture(name);
        let part = &model.parts[0];
        let material = &model.materials[part.material];
        assert_eq!(material.name, "quarters", "{name}");
        assert_eq!(material.colour, [1.0; 4], "{name}");
        let image = &model.textures[material.texture.unwrap().image];
        for (position, uv) in part.positions.iter().zip(&part.uvs) {
            // A little towards the middle, to be within the picture.
            let [x, y] = [uv[0], uv[1]].map(|at| 0.5 + 0.9 * (at - 0.5));
            let [x, y] = [x * image.width as f32, y * image.height as f32].map(|at| at as usize);
            let colour = image.pixels.as_chunks::<4>().0[y * image.width as usize + x];
            let expected: [u8; 4] = match (position[0] > 0.5, position[1] > 0.5) {
                (false, true) => [255, 0, 0, 255],
                (true, true) => [0, 255, 0, 255],
                (false, false) => [0, 0, 255, 255],
                (true, false) => [255, 255, 0, 255],
            };
            let close = colour.iter().zip(expected).all(|(found, wanted)| found.abs_diff(wanted) < 10);
            assert!(close, "{name}, {position:?}: {colour:?}");
        }
    }
}

#[test]
fn a_box_without_normals_gets_sharp_edges() {
    let part = &fixture("trimesh-box.glb").parts[0];
    assert_eq!(part.positions.len(), 24);
    for triangle in &part.triangles {
        let [a, b, c] = triangle.map(|vertex| Vec3::from(part.positions[vertex as usize]));
        let face = (b - a).cross(c - a).normalize_or_zero();
        for vertex in triangle {
            assert!(face.distance(part.normals[*vertex as usize].into()) < 1e-6);
        }
    }
    assert_eq!(part.colours, vec![[1.0, 128.0 / 255.0, 0.0, 1.0]; 24]);
}

#[test]
fn a_box_that_shall_be_smooth_looks_out_of_its_corners() {
    let part = &fixture_with("trimesh-box.glb", Some(91.0)).parts[0];
    assert_eq!(part.positions.len(), 8);
    for (position, normal) in part.positions.iter().zip(&part.normals) {
        // However the sides are cut into triangles, each counts with its right angle.
        let corner = Vec3::from(*position).signum() / 3.0_f32.sqrt();
        assert!(corner.distance(Vec3::from(*normal)) < 1e-6, "{normal:?}");
    }
}

#[test]
fn a_ball_without_normals_is_smooth_unless_asked_otherwise() {
    let ball = &fixture("trimesh-balls.gltf").parts[0];
    assert_eq!(ball.positions.len(), 162);
    for (position, normal) in ball.positions.iter().zip(&ball.normals) {
        let angle = Vec3::from(*position).angle_between(Vec3::from(*normal)).to_degrees();
        assert!(angle < 1.0, "{angle}");
    }
    // Its triangles meet at 13 to 20 degrees or so.
    assert_eq!(fixture_with("trimesh-balls.gltf", Some(5.0)).parts[0].positions.len(), 3 * 320);
    assert_eq!(fixture_with("trimesh-balls.gltf", Some(45.0)).parts[0].normals, ball.normals);
}

#[test]
fn normals_of_a_file_are_kept_and_mended() {
    let normals = |smooth| fixture_with("blender-village.glb", smooth).parts[2].normals.clone();
    assert_eq!(normals(None), normals(Some(60.0)));
    let json = roof_with(&[
        (r#""POSITION":0"#, r#""POSITION":0,"NORMAL":2"#),
        (
            r#"{"bufferView":1,"#,
            r#"{"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"#,
        ),
        (r#""indices":1"#, r#""indices":2"#),
        (r#""NORMAL":2"#, r#""NORMAL":1"#),
        (
            r#"{"buffer":0,"byteOffset":36,"#,
            r#"{"buffer":0,"byteOffset":36,"byteLength":6},{"buffer":0,"byteOffset":44,"#,
        ),
        (r#""byteOffset":44,"byteLength":6"#, r#""byteOffset":44,"byteLength":36"#),
    ]);
    let slanted = [0.6, 0.0, 0.8];
    // The second is too long, the third has no direction.
    let bytes = [buffer(), floats(&[0.6, 0.0, 0.8, 6e20, 0.0, 8e20, 0.0, 0.0, 0.0])].concat();
    let model = read_gltf(json.as_bytes(), &bytes).unwrap();
    check(&model);
    let read = &model.parts[0].normals;
    assert!(Vec3::from(read[1]).distance(slanted.into()) < 1e-6, "{read:?}");
    assert_eq!([read[0], read[2]], [slanted, [0.0, 0.0, 1.0]]);
    assert_eq!(
        model.notes,
        ["m/a.gltf: mesh 0 \"roof\", primitive 0: computed 1 normals that have no direction"]
    );
}

/// A flat strip of four corners (0, 0), (1, 0), (0, 1), (1, 1) without indices.
fn flat(mode: u32, order: [usize; 4]) -> Part {
    let json = roof_with(&[
        (r#","indices":1"#, &format!(r#","mode":{mode}"#)),
        (r#""byteLength":36"#, r#""byteLength":48"#),
        (r#""count":3,"type":"VEC3""#, r#""count":4,"type":"VEC3""#),
        (r#""byteLength":44"#, r#""byteLength":48"#),
    ]);
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let model =
        read_gltf(json.as_bytes(), &floats(order.map(|corner| square[corner]).as_flattened())).unwrap();
    check(&model);
    assert!((area(&model) - 1.0).abs() < 1e-6);
    model.parts[0].clone()
}

#[test]
fn strips_and_fans_turn_the_same_way_throughout() {
    for part in [flat(5, [0, 1, 2, 3]), flat(6, [0, 1, 3, 2])] {
        assert_eq!(part.triangles.len(), 2);
        assert_eq!(part.normals, [[0.0, 0.0, 1.0]; 4]);
    }
}

#[test]
fn indices_of_all_widths_are_read() {
    for (kind, width) in [(5121, 1), (5123, 2), (5125, 4)] {
        let json = roof_with(&[
            ("5123", &kind.to_string()),
            (r#""byteOffset":36,"byteLength":6"#, &format!(r#""byteOffset":36,"byteLength":{}"#, 3 * width)),
        ]);
        let mut bytes = buffer();
        bytes.truncate(36);
        for index in [2_u8, 0, 1] {
            bytes.extend([&[index][..], &vec![0; width - 1]].concat());
        }
        let model = read_gltf(json.as_bytes(), &bytes).unwrap();
        assert_eq!(corners(&model), [[Vec3::Y, Vec3::ZERO, Vec3::X]], "{kind}");
    }
}

#[test]
fn a_sparse_accessor_replaces_some_corners() {
    let sparse = r#""count":3,"type":"VEC3","sparse":{"count":1,
        "indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}}"#;
    let json = roof_with(&[
        (r#""count":3,"type":"VEC3""#, sparse),
        (
            r#""byteLength":6}"#,
            r#""byteLength":6},{"buffer":0,"byteOffset":44,"byteLength":1},{"buffer":0,"byteOffset":48,"byteLength":12}"#,
        ),
    ]);
    let bytes = [buffer(), vec![1, 0, 0, 0], floats(&[3.0, 0.0, 0.0])].concat();
    let model = read_gltf(json.as_bytes(), &bytes).unwrap();
    assert_eq!(model.parts[0].positions, [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
}

#[test]
fn instances_are_copies_in_their_node() {
    let json = roof_with(&[
        (
            r#""mesh":0"#,
            r#""mesh":0,"scale":[2,2,2],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}}"#,
        ),
        (r#""asset""#, r#""extensionsRequired":["EXT_mesh_gpu_instancing"],"asset""#),
    ]);
    let model = read_gltf(json.as_bytes(), &buffer()).unwrap();
    check(&model);
    let places: Vec<_> = model.placed(0.0).iter().map(|placed| placed.world_from_part[3]).collect();
    assert_eq!(places, [[0.0, 0.0, 0.0, 1.0], [2.0, 0.0, 0.0, 1.0], [0.0, 2.0, 0.0, 1.0]]);
    assert_eq!(model.triangle_count(), 3);
}

#[test]
fn texture_transforms_end_up_in_the_coordinates() {
    let picture = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNiAAAABgADNjd8qAAAAABJRU5ErkJggg==";
    let json = roof_with(&[
        (r#""indices":1"#, r#""indices":1,"material":0"#),
        (r#""POSITION":0"#, r#""POSITION":0,"TEXCOORD_1":2"#),
        (
            r#""type":"SCALAR"}"#,
            r#""type":"SCALAR"},{"bufferView":2,"componentType":5123,"normalized":true,"count":3,"type":"VEC2"}"#,
        ),
        (r#""byteLength":6}"#, r#""byteLength":6},{"buffer":0,"byteOffset":44,"byteLength":12}"#),
        (
            r#""asset""#,
            &format!(
                r#""materials":[{{"name":"slates","alphaMode":"MASK","pbrMetallicRoughness":{{"baseColorTexture":{{
                "index":0,"extensions":{{"KHR_texture_transform":{{"texCoord":1,"rotation":1.5707964,"scale":[2,1],
                "offset":[0.5,0]}}}}}}}}}}],"textures":[{{"source":0,"sampler":0}}],
                "samplers":[{{"wrapS":33071,"wrapT":33648}}],"images":[{{"uri":"{picture}"}}],"asset""#
            ),
        ),
    ]);
    let mut bytes = buffer();
    bytes.extend([0, 0, 0, 0, 255, 255, 0, 0, 0, 0, 255, 255]);
    let model = read_gltf(json.as_bytes(), &bytes).unwrap();
    check(&model);
    assert_eq!(model.notes, [""; 0]);
    // A quarter turn counter-clockwise as seen: to the right becomes up, and down becomes to the right.
    let expected = [Vec2::new(0.5, 0.0), Vec2::new(0.5, -2.0), Vec2::new(1.5, 0.0)];
    for (uv, expected) in model.parts[0].uvs.iter().zip(expected) {
        assert!(Vec2::from(*uv).distance(expected) < 1e-5, "{uv:?}, not {expected}");
    }
    let material = &model.materials[model.parts[0].material];
    assert_eq!(material.texture.unwrap().wrap, [Wrap::Clamp, Wrap::Mirror]);
    assert_eq!(material.alpha_cutoff, Some(0.5));
}

fn obj(text: &str) -> Model {
    let mut read = |path: &str| match path {
        "m/my lib.mtl" => {
            Ok(b"newmtl glass\nKd 1 1 0\nd 0.5\nnewmtl lost\nmap_Kd C:\\work\\no.png\n".to_vec())
        }
        _ => Err(io::ErrorKind::NotFound.into()),
    };
    let model = read_model("m/a.obj", text.as_bytes(), ModelOptions::default(), &mut read).unwrap();
    check(&model);
    model
}

#[test]
fn obj_faces_may_be_concave_and_count_backwards() {
    let model = obj("v 0 2 0\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nf -1 -6 -5 -4 -3 -2\n");
    assert_eq!((model.triangle_count(), area(&model)), (4, 3.0));
    assert_eq!(model.parts[0].normals, [[0.0, 0.0, 1.0]; 6]);
    // What is convex is cut like a fan.
    assert_eq!(obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").triangle_count(), 2);
}

#[test]
fn obj_corners_may_have_some_values_and_others_not() {
    let model = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.25\nvn 0 0 1\nf 1/1/1 2 3//1\n");
    let part = &model.parts[0];
    assert_eq!(part.uvs, [[0.25, 0.75], [0.0, 0.0], [0.0, 0.0]]);
    assert_eq!(part.normals, [[0.0, 0.0, 1.0]; 3]);
    assert_eq!(model.notes, ["m/a.obj: group \"\": computed 1 normals that have no direction"]);
}

#[test]
fn obj_groups_and_materials_make_parts() {
    let model = obj(
        "mtllib my lib.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\ng a\nusemtl glass\nf 1 2 3\nusemtl lost\n\
         f 1 2 3\nusemtl glass\nf 3 2 1\no b\nf 1 2 3\nusemtl nowhere\nf 1 2 3\nl 1 2\n",
    );
    let parts: Vec<_> = model
        .parts
        .iter()
        .map(|part| (&*part.name, &*model.materials[part.material].name, part.triangles.len()))
        .collect();
    assert_eq!(parts, [("a", "glass", 2), ("a", "lost", 1), ("b", "glass", 1), ("b", "nowhere", 1)]);
    let glass = &model.materials[0];
    assert_eq!((glass.colour, glass.alpha_cutoff), ([1.0, 1.0, 0.0, 0.5], Some(0.25)));
    assert_eq!(model.parts[1].colours[2], [0.0, 0.0, 1.0, 1.0]);
    let notes = [
        "m/a.obj: left out 1 points, lines and faces of less than three corners",
        "m/a.obj: material \"glass\": light goes through it in the file; here, it is solid where it is at least half so",
        "m/a.obj: material \"lost\": goes without its picture, for `m/no.png` cannot be read (entity not found)",
        "m/a.obj: material \"nowhere\": no material library defines it, so it is white",
    ];
    assert_eq!(model.notes, notes);
}

#[test]
fn a_companion_is_asked_for_beside_the_model() {
    let mut asked = Vec::new();
    let mut read = |path: &str| {
        asked.push(path.to_owned());
        Ok(buffer())
    };
    let json = ROOF.replace("b.bin", "../parts%20list/./b.bin");
    read_model("scenes/models/a.gltf", json.as_bytes(), ModelOptions::default(), &mut read).unwrap();
    assert_eq!(asked, ["scenes/parts list/b.bin"]);
}
