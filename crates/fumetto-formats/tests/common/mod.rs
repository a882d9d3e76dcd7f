//! A glTF file of one triangle, to be changed by tests, and what every model keeps to.

use std::io;

use fumetto_formats::{FormatError, Model, ModelOptions, read_model};

/// One triangle under a roof; its buffer is [`buffer`].
pub(crate) const ROOF: &str = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"name":"house","mesh":0}],
"meshes":[{"name":"roof","primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"uri":"b.bin","byteLength":44}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]}"#;

/// The corners (0, 0, 0), (1, 0, 0) and (0, 1, 0) with their indices.
pub(crate) fn buffer() -> Vec<u8> {
    let mut bytes = floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    bytes.extend([0, 0, 1, 0, 2, 0, 0, 0]);
    bytes
}

/// Numbers as buffers hold them.
pub(crate) fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

/// `ROOF` with some of its text replaced.
pub(crate) fn roof_with(changes: &[(&str, &str)]) -> String {
    let mut json = ROOF.to_owned();
    for (from, to) in changes {
        assert!(json.contains(from), "{from} is not there to be replaced");
        json = json.replacen(from, to, 1);
    }
    json
}

/// Reads `bytes` as the file `m/a.gltf`, beside which lies `m/b.bin`.
pub(crate) fn read_gltf(bytes: &[u8], buffer: &[u8]) -> Result<Model, FormatError> {
    let mut read = |path: &str| match path {
        "m/b.bin" => Ok(buffer.to_vec()),
        _ => Err(io::ErrorKind::NotFound.into()),
    };
    read_model("m/a.gltf", bytes, ModelOptions::default(), &mut read)
}

/// Checks what the types promise.
pub(crate) fn check(model: &Model) {
    assert!(!model.parts.is_empty() && !model.materials.is_empty());
    for part in &model.parts {
        let count = part.positions.len();
        assert!(part.material < model.materials.len());
        assert!(!part.triangles.is_empty());
        assert!(part.triangles.as_flattened().iter().all(|&vertex| (vertex as usize) < count));
        assert!(part.positions.as_flattened().iter().all(|value| value.is_finite()));
        assert_eq!(part.normals.len(), count);
        for normal in &part.normals {
            let length = normal.iter().map(|value| value * value).sum::<f32>().sqrt();
            assert!((length - 1.0).abs() < 1e-4, "{normal:?}");
        }
        assert!([0, count].contains(&part.uvs.len()) && [0, count].contains(&part.colours.len()));
        assert!(part.uvs.as_flattened().iter().all(|value| value.is_finite()));
        assert!(part.colours.as_flattened().iter().all(|value| value.is_finite()));
    }
    for texture in model.materials.iter().filter_map(|material| material.texture) {
        assert!(texture.image < model.textures.len());
    }
    let first: Vec<_> = model.placed(0.0).iter().map(|placed| placed.part).collect();
    let triangles = first.iter().map(|&part| model.parts[part].triangles.len() as u64).sum::<u64>();
    assert_eq!(model.triangle_count(), triangles);
    for time in [0.3, -5.0, 1e30, f32::NAN, f32::INFINITY] {
        let placed = model.placed(time);
        assert_eq!(placed.iter().map(|placed| placed.part).collect::<Vec<_>>(), first);
        let numbers = placed.iter().flat_map(|placed| placed.world_from_part).flatten();
        assert!(numbers.into_iter().all(f32::is_finite));
    }
}
