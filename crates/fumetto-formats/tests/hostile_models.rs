//! Any bytes give a model that keeps its promises, or an error that names the file and what is wrong.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod common;

use std::fs;
use std::io;
use std::time::{Duration, Instant};

use common::{ROOF, buffer, check, floats, read_gltf, roof_with};
use fumetto_formats::{FormatError, Model, ModelOptions, read_model};
use proptest::prelude::*;
use proptest::sample::Index;

/// Reads a model; whatever comes, it comes soon, and keeps its promises.
fn read(name: &str, bytes: &[u8], companion: &[u8]) -> Result<Model, FormatError> {
    let start = Instant::now();
    let mut read = |_: &str| Ok(companion.to_vec());
    let read = read_model(name, bytes, ModelOptions::default(), &mut read);
    assert!(start.elapsed() < Duration::from_secs(5), "took {:?}", start.elapsed());
    match &read {
        Ok(model) => {
            check(model);
            model.notes.iter().for_each(|note| check_message(name, note));
        }
        Err(error) => check_message(name, &error.to_string()),
    }
    read
}

fn check_message(name: &str, message: &str) {
    assert!(message.starts_with(name) && message.len() < 1000, "{message}");
    assert!(!message.contains(|c: char| c.is_control()), "{message:?}");
}

/// What is said about the roof with these changes.
fn refusal(changes: &[(&str, &str)]) -> String {
    read_gltf(roof_with(changes).as_bytes(), &buffer()).unwrap_err().to_string()
}

fn notes(changes: &[(&str, &str)], buffer: &[u8]) -> Vec<String> {
    read_gltf(roof_with(changes).as_bytes(), buffer).unwrap().notes
}

fn obj_refusal(text: &str) -> String {
    read("a.obj", text.as_bytes(), b"").unwrap_err().to_string()
}

#[test]
fn the_roof_is_in_order() {
    check(&read_gltf(ROOF.as_bytes(), &buffer()).unwrap());
}

#[test]
fn an_index_that_is_past_the_last_vertex_is_named() {
    let mut bytes = buffer();
    bytes[38] = 200;
    let message = read_gltf(ROOF.as_bytes(), &bytes).unwrap_err().to_string();
    let expected = "m/a.gltf: mesh 0 \"roof\", primitive 0: index 200 is past the last of 3 vertices; export the model again";
    assert_eq!(message, expected);
}

#[test]
fn nodes_in_a_circle_or_with_two_parents_are_refused() {
    let circle = refusal(&[(r#""mesh":0}"#, r#""mesh":0,"children":[1]},{"name":"arm","children":[0]}"#)]);
    let expected = "m/a.gltf: node 0 \"house\": both the scene and node 1 \"arm\" have it as their child; nodes form \
                    trees, so export the model again";
    assert_eq!(circle, expected);
    let shared =
        refusal(&[(r#""mesh":0}"#, r#""children":[1,2]},{"children":[3]},{"children":[3]},{"mesh":0}"#)]);
    assert!(shared.contains("node 3: both node 1 and node 2 have it as their child"), "{shared}");
    let absent = refusal(&[(r#""mesh":0}"#, r#""mesh":0,"children":[7]}"#)]);
    assert_eq!(
        absent,
        "m/a.gltf: node 0 \"house\": it needs node 7, which is not there; export the model again"
    );
}

#[test]
fn a_chain_of_a_hundred_thousand_nodes_is_no_deeper_than_others() {
    let last = 100_000;
    let chain: Vec<_> = (1..=last).map(|child| format!(r#"{{"children":[{child}]}}"#)).collect();
    let nodes = format!(r#"{},{{"mesh":0}}"#, chain.join(","));
    let json = roof_with(&[(r#"{"name":"house","mesh":0}"#, &nodes)]);
    assert_eq!(read_gltf(json.as_bytes(), &buffer()).unwrap().triangle_count(), 1);
}

#[test]
fn more_objects_than_fit_into_memory_are_refused_before_they_are_read() {
    let many =
        refusal(&[(r#""nodes":[{"name""#, &format!(r#""nodes":[{}{{"name""#, "{},".repeat(1_000_000)))]);
    assert!(
        many.starts_with("m/a.gltf: it has 1000012 objects, more than the 1000000 that are allowed"),
        "{many}"
    );
}

#[test]
fn counts_are_held_against_the_bytes_before_anything_is_allocated() {
    let cases = [
        (
            r#""count":3,"type":"VEC3""#,
            r#""count":4294967295,"type":"VEC3""#,
            "promises 4294967295 items, but buffer view 0 holds only 3",
        ),
        (
            r#""count":3,"type":"VEC3""#,
            r#""count":18446744073709551615,"type":"VEC3""#,
            "promises 18446744073709551615 items",
        ),
        (
            r#""count":3,"type":"SCALAR""#,
            r#""count":4000000000,"type":"SCALAR""#,
            "buffer view 1 holds only 3",
        ),
        (
            r#""byteLength":36"#,
            r#""byteLength":4294967295"#,
            "takes 4294967295 bytes from byte 0 of buffer 0, which has only 44",
        ),
        (
            r#""byteOffset":36"#,
            r#""byteOffset":18446744073709551615"#,
            "from byte 18446744073709551615 of buffer 0",
        ),
        (
            r#""bufferView":0,"componentType":5126,"count":3"#,
            r#""componentType":5126,"count":4000000000"#,
            "promises 4000000000 items without bytes",
        ),
        (
            r#""buffer":0,"byteLength":36"#,
            r#""buffer":0,"byteLength":36,"byteStride":18446744073709551615"#,
            "holds only 1",
        ),
        (
            r#""buffer":0,"byteLength":36"#,
            r#""buffer":0,"byteLength":36,"byteStride":0"#,
            "has a stride of 0",
        ),
    ];
    for (from, to, expected) in cases {
        let message = refusal(&[(from, to)]);
        assert!(message.contains(expected), "{to}: {message}");
        check_message("m/a.gltf", &message);
    }
}

#[test]
fn many_triangles_from_few_bytes_are_refused() {
    // The same three bytes are an endless fan.
    let wide = [
        (
            r#"{"bufferView":1,"componentType":5123,"count":3"#,
            r#"{"bufferView":0,"componentType":5121,"count":36"#,
        ),
        (r#""indices":1"#, r#""indices":1,"mode":6"#),
        (
            r#""nodes":[{"name":"house","mesh":0}]"#,
            &format!(r#""nodes":[{}]"#, [r#"{"mesh":0}"#; 500_000].join(",")),
        ),
        (r#""scene":0,"scenes":[{"nodes":[0]}],"#, ""),
    ];
    assert_eq!(
        refusal(&wide),
        "m/a.gltf: 17000000 triangles are more than the 16000000 that are allowed; simplify the model or split it"
    );
    let primitives = [r#"{"attributes":{"POSITION":0},"indices":1}"#; 2000].join(",");
    let crowd = refusal(&[
        (r#"{"attributes":{"POSITION":0},"indices":1}"#, &primitives),
        (r#"{"name":"house","mesh":0}"#, &[r#"{"mesh":0}"#; 2000].join(",")),
        (r#""scene":0,"scenes":[{"nodes":[0]}],"#, ""),
    ]);
    assert!(crowd.contains("it places 4000000 parts, more than the 1000000 that are allowed"), "{crowd}");
}

#[test]
fn what_cannot_be_had_is_named() {
    let missing = refusal(&[("b.bin", "walls%201.bin")]);
    let expected = "m/a.gltf: buffer 0: `m/walls 1.bin` cannot be read (entity not found); put it where the model \
                    looks for it";
    assert_eq!(missing, expected);
    let far = refusal(&[("b.bin", "https://example.org/b.bin")]);
    assert!(
        far.starts_with("m/a.gltf: buffer 0: `https://example.org/b.bin` is not a file beside the model"),
        "{far}"
    );
    let none = refusal(&[(r#""uri":"b.bin","#, "")]);
    assert!(none.contains("buffer 0: it has neither a `uri` nor bytes in the file"), "{none}");
    let base64 = refusal(&[("b.bin", "data:application/gltf-buffer;base64,AAA*")]);
    assert!(base64.contains("base64 is damaged"), "{base64}");
}

#[test]
fn extensions_are_refused_when_they_are_required_and_noted_when_not() {
    let draco = r#""extensionsRequired":["KHR_texture_transform","KHR_draco_mesh_compression"],"asset""#;
    let expected = "m/a.gltf: it cannot be read without `KHR_draco_mesh_compression`, which Fumetto does not know; \
                    export it again without compression and without extensions";
    assert_eq!(refusal(&[(r#""asset""#, draco)]), expected);
    let used = r#""extensionsUsed":["KHR_materials_unlit","EXT_lights_ies"],"asset""#;
    assert_eq!(
        notes(&[(r#""asset""#, used)], &buffer()),
        ["m/a.gltf: ignored the extensions `EXT_lights_ies`"]
    );
}

#[test]
fn triangles_that_cannot_be_drawn_are_left_out_with_a_note() {
    let indices = (r#""count":3,"type":"SCALAR""#, r#""count":9,"type":"SCALAR""#);
    let length = (r#""byteOffset":36,"byteLength":6"#, r#""byteOffset":48,"byteLength":18"#);
    let vertices = (r#""count":3,"type":"VEC3""#, r#""count":4,"type":"VEC3""#);
    let view = (r#""byteLength":36"#, r#""byteLength":48"#);
    let mut bytes = floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, f32::NAN, 0.0]);
    bytes.extend([0, 0, 1, 0, 2, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 3, 0]);
    let expected = [
        "m/a.gltf: mesh 0 \"roof\", primitive 0: left out 1 triangle with a corner that is not a finite place",
        "m/a.gltf: mesh 0 \"roof\", primitive 0: left out 1 triangle without area",
    ];
    assert_eq!(notes(&[indices, length, vertices, view], &bytes), expected);
    let model = read_gltf(roof_with(&[indices, length, vertices, view]).as_bytes(), &bytes).unwrap();
    check(&model);
    assert_eq!(model.parts[0].positions.len(), 3);
}

#[test]
fn a_model_without_triangles_is_refused() {
    let empty = "m/a.gltf: there is no triangle in it; export it again with at least one mesh in its scene";
    assert_eq!(refusal(&[(r#","mesh":0"#, "")]), empty);
    assert_eq!(refusal(&[(r#""indices":1"#, r#""indices":1,"mode":1"#)]), empty);
    assert_eq!(
        refusal(&[(r#""primitives":[{"attributes":{"POSITION":0},"indices":1}]"#, r#""primitives":[]"#)]),
        empty
    );
    assert_eq!(read_gltf(ROOF.as_bytes(), &[0; 44]).unwrap_err().to_string(), empty);
    assert!(obj_refusal("v 1 2 3\n").starts_with("a.obj: there is no triangle in it"));
    assert!(obj_refusal("").starts_with("a.obj: there is no triangle in it"));
}

#[test]
fn numbers_beyond_single_precision_are_refused() {
    let message = refusal(&[(r#""mesh":0"#, r#""mesh":0,"scale":[1e39,1,1]"#)]);
    assert!(message.starts_with("m/a.gltf: node 0 \"house\": its transform has numbers"), "{message}");
    // Those that only grow beyond it, from node to node, are flattened.
    let chain = r#""scale":[1e30,1e30,1e30],"children":[1]},{"scale":[1e30,1e30,1e30],"mesh":0}"#;
    let model = read_gltf(roof_with(&[(r#""mesh":0}"#, chain)]).as_bytes(), &buffer()).unwrap();
    check(&model);
}

/// The roof, moved by an animation with these key frames.
fn moved(times: &[f32], values: &[f32], kind: &str) -> Result<Model, FormatError> {
    let (count, items) = (times.len(), values.len() / 3);
    let json = roof_with(&[
        (
            r#""asset""#,
            &format!(
                r#""animations":[{{"name":"rise","channels":[{{"sampler":0,"target":{{"node":0,"path":"translation"}}}}],
                "samplers":[{{"input":2,"output":3,"interpolation":"{kind}"}}]}}],"asset""#
            ),
        ),
        (
            r#""type":"SCALAR"}"#,
            &format!(
                r#""type":"SCALAR"}},{{"bufferView":2,"componentType":5126,"count":{count},"type":"SCALAR"}},
                {{"bufferView":2,"byteOffset":{},"componentType":5126,"count":{items},"type":"VEC3"}}"#,
                4 * count
            ),
        ),
        (
            r#""byteLength":6}"#,
            &format!(
                r#""byteLength":6}},{{"buffer":0,"byteOffset":44,"byteLength":{}}}"#,
                4 * (count + values.len())
            ),
        ),
    ]);
    read_gltf(json.as_bytes(), &[buffer(), floats(times), floats(values)].concat())
}

#[test]
fn key_frames_out_of_order_are_refused() {
    let rise = [0.0, 0.0, 0.0, 0.0, 2.0, 0.0];
    let model = moved(&[0.0, 4.0], &rise, "LINEAR").unwrap();
    check(&model);
    assert_eq!(model.placed(1.0)[0].world_from_part[3], [0.0, 0.5, 0.0, 1.0]);
    assert_eq!(moved(&[0.0, 4.0], &rise, "STEP").unwrap().placed(3.9)[0].world_from_part[3][1], 0.0);

    let says = |times: &[f32], values: &[f32], kind: &str, expected: &str| {
        let message = moved(times, values, kind).unwrap_err().to_string();
        assert_eq!(
            message,
            format!("m/a.gltf: animation 0 \"rise\", channel 0: {expected}; export the model again")
        );
    };
    let backwards = "the times of its key frames do not run forwards from 0";
    for times in [[4.0, 0.0], [1.0, 1.0], [f32::NAN, 1.0], [0.0, f32::INFINITY], [-1.0, 0.0]] {
        says(&times, &rise, "LINEAR", backwards);
    }
    says(&[0.0, 4.0], &rise[..3], "LINEAR", "2 key frames need 2 values but have 1");
    says(&[0.0, 4.0], &rise, "CUBICSPLINE", "2 key frames need 6 values but have 2");
    says(&[0.0, 4.0], &[0.0, 0.0, 0.0, f32::NAN, 0.0, 0.0], "LINEAR", "value 1 is not finite");
    says(&[0.0, 4.0], &rise, "BEZIER", "its interpolation is not known");
}

#[test]
fn a_binary_file_that_is_cut_off_says_so() {
    let village = sample("blender-village.glb");
    for length in 0..village.len() {
        let message = read("a.glb", &village[..length], b"").unwrap_err().to_string();
        assert!(length < 12 || message.contains(&format!("the last {} are missing", village.len() - length)));
    }
    let mut old = village.clone();
    old[4] = 1;
    let message = read("a.glb", &old, b"").unwrap_err().to_string();
    assert_eq!(message, "a.glb: it is binary glTF 1; export it as glTF 2.0");
}

#[test]
fn other_versions_and_formats_are_named() {
    let message = refusal(&[(r#""version":"2.0""#, r#""version":"1.0""#)]);
    assert_eq!(message, "m/a.gltf: asset: it is glTF 1.0; export it as glTF 2.0");
    let message = read("a.fbx", b"Kaydara", b"").unwrap_err().to_string();
    assert_eq!(
        message,
        "a.fbx: models are read from `.gltf`, `.glb` and `.obj` files; convert this one to one of them"
    );
    let message = read("a.gltf", b"{\"asset\":{\"version\":\"2.0\"},\n  12}", b"").unwrap_err().to_string();
    assert!(
        message.starts_with("a.gltf: not a readable glTF 2.0 document (")
            && message.contains("at line 2 column 3")
    );
}

#[test]
fn obj_errors_name_the_line() {
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let cases = [
        ("v 1 2\n", "a.obj, line 1: `v` needs 3 numbers but has `1 2`; export it again"),
        ("\n\nvn x\n", "a.obj, line 3: `vn` needs 3 numbers but has `x`; export it again"),
        (
            &format!("{triangle}f 1 2 812\n"),
            "a.obj, line 4: index 812 is not among the 3 vertices above it; export it again",
        ),
        (
            &format!("{triangle}f 1 2 0\n"),
            "a.obj, line 4: index 0 is not among the 3 vertices above it; export it again",
        ),
        (
            &format!("{triangle}f 1 2 -4\n"),
            "a.obj, line 4: index -4 is not among the 3 vertices above it; export it again",
        ),
        (
            &format!("{triangle}f 1/1 2/1 3/1\n"),
            "a.obj, line 4: index 1 is not among the 0 texture coordinates above it; export it again",
        ),
        (&format!("{triangle}f 1 2 three\n"), "a.obj, line 4: `three` is no index; export it again"),
        (
            &format!("{triangle}f 1 2 3/1/1/1\n"),
            "a.obj, line 4: index 1 is not among the 0 texture coordinates above it; export it again",
        ),
        (
            &format!("{triangle}f /1 2 3\n"),
            "a.obj, line 4: index 1 is not among the 0 texture coordinates above it; export it again",
        ),
        (&format!("{triangle}f // 2 3\n"), "a.obj, line 4: `//` is no corner of a face; export it again"),
    ];
    for (text, expected) in cases {
        assert_eq!(obj_refusal(text), expected);
    }
}

#[test]
fn obj_that_wants_much_work_is_done_soon() {
    let line = |corner: &str, count: usize| format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nf{}\n", corner.repeat(count));
    // A face of many corners that goes back and forth, many libraries, and groups with a long name.
    let _ = read("a.obj", line(" 1 2 3", 100_000).as_bytes(), b"");
    let libraries: String = (0..20_000).map(|i| format!("mtllib {i}\n")).collect();
    let _ = read("a.obj", libraries.as_bytes(), b"newmtl a\n");
    let name = "n".repeat(100_000);
    let switching = "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n".repeat(20_000);
    let model =
        read("a.obj", format!("v 0 0 0\nv 1 0 0\nv 1 1 0\ng {name}\n{switching}").as_bytes(), b"").unwrap();
    assert_eq!((model.parts.len(), model.triangle_count()), (2, 40_000));
}

fn sample(name: &str) -> Vec<u8> {
    fs::read(format!("{}/tests/fixtures/models/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// Small files of every kind, and one that they need.
fn samples() -> Vec<(&'static str, Vec<u8>, Vec<u8>)> {
    let jpeg = sample("my textures/four quarters.jpg");
    let picture = |gltf: Vec<u8>| {
        // With its buffer inside, so that the companion is the picture.
        let text = String::from_utf8(gltf).unwrap();
        let mut bytes = String::new();
        for byte in sample("blender-picture.bin") {
            bytes += &format!("%{byte:02x}");
        }
        text.replace("blender-picture.bin", &format!("data:application/octet-stream,{bytes}")).into_bytes()
    };
    vec![
        ("a.glb", sample("blender-village.glb"), Vec::new()),
        ("a.glb", sample("blender-windmill-keys.glb"), Vec::new()),
        ("a.glb", sample("trimesh-square.glb"), Vec::new()),
        ("a.gltf", ROOF.as_bytes().to_vec(), buffer()),
        ("a.gltf", picture(sample("blender-picture.gltf")), jpeg),
        ("a.obj", sample("blender-village.obj"), sample("blender-village.mtl")),
        ("a.obj", sample("trimesh-square.obj"), sample("trimesh-square.mtl")),
    ]
}

#[test]
fn the_samples_are_in_order() {
    for (name, bytes, companion) in samples() {
        read(name, &bytes, &companion).unwrap();
    }
}

/// A change to a file.
#[derive(Clone, Debug)]
enum Mutation {
    /// A byte overwritten.
    Set(Index, u8),
    /// Bytes cut out.
    Cut(Index, usize),
    /// Bytes put in.
    Insert(Index, Vec<u8>),
    /// A number in the text replaced by another one.
    Number(Index, &'static str),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    // Digits and separators keep text plausible, so that mutants get beyond the first check.
    let byte = prop_oneof![any::<u8>(), prop::sample::select(b"0123456789 \n-.e,\"/{}[]".to_vec())];
    let numbers =
        ["0", "1", "2", "3", "4", "5", "7", "12", "36", "-1", "1e39", "0.5", "255", "65535", "4294967295"];
    let kinds =
        ["5120", "5121", "5122", "5123", "5125", "5126", "18446744073709551615", "4611686018427387904"];
    let number = prop::sample::select([&numbers[..], &kinds].concat());
    prop_oneof![
        1 => (any::<Index>(), byte.clone()).prop_map(|(at, byte)| Mutation::Set(at, byte)),
        1 => (any::<Index>(), 1..20_usize).prop_map(|(at, length)| Mutation::Cut(at, length)),
        1 => (any::<Index>(), prop::collection::vec(byte, 1..20)).prop_map(|(at, bytes)| Mutation::Insert(at, bytes)),
        4 => (any::<Index>(), number).prop_map(|(at, number)| Mutation::Number(at, number)),
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
        Mutation::Number(at, number) => {
            let start = at.index(bytes.len());
            let Some(first) = bytes[start..].iter().position(u8::is_ascii_digit) else { return };
            let start = start + first;
            let length = bytes[start..].iter().take_while(|byte| byte.is_ascii_digit()).count();
            bytes.splice(start..start + length, number.bytes());
        }
    }
}

/// Makes the lengths in a binary file's headers fit its JSON again, or mutants would not get beyond
/// them.
fn mend_lengths(bytes: &mut [u8], json_grown: isize) {
    let total = bytes.len() as u32;
    if let Some(length) = bytes.get_mut(8..12) {
        length.copy_from_slice(&total.to_le_bytes());
    }
    if let Some(length) = bytes.get_mut(12..16) {
        let json = u32::from_le_bytes(length.try_into().unwrap()).wrapping_add_signed(json_grown as i32);
        length.copy_from_slice(&json.to_le_bytes());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutated_models_keep_their_promises_or_are_refused(
        sample in 0..samples().len(),
        mutations in prop::collection::vec(mutation(), 1..5),
        in_companion in any::<bool>(),
    ) {
        let (name, mut bytes, mut companion) = samples().swap_remove(sample);
        let length = bytes.len() as isize;
        for mutation in &mutations {
            mutate(if in_companion { &mut companion } else { &mut bytes }, mutation);
        }
        let _ = read(name, &bytes, &companion);
        if name == "a.glb" {
            let grown = bytes.len() as isize - length;
            mend_lengths(&mut bytes, grown);
            let _ = read(name, &bytes, &companion);
        }
    }

    #[test]
    fn random_bytes_are_refused(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        for (name, sample, companion) in samples() {
            let _ = read(name, &bytes, &companion);
            // Behind a valid start, too, and beside a valid file.
            let _ = read(name, &[&sample[..sample.len().min(20)], &bytes].concat(), &companion);
            let _ = read(name, &sample, &bytes);
        }
    }
}

#[test]
fn a_file_that_is_not_there_is_no_reason_to_stop_for_a_texture() {
    let (name, bytes, _) = samples().swap_remove(4);
    let mut read = |_: &str| Err(io::ErrorKind::NotFound.into());
    let model = read_model(name, &bytes, ModelOptions::default(), &mut read).unwrap();
    check(&model);
    let expected = "a.gltf: material 0 \"quarters\": goes without its picture, for `my textures/four quarters.jpg` \
                    cannot be read (entity not found)";
    assert_eq!(model.notes, [expected]);
}
