//! Models from files that other programs wrote (by `tools/fixtures/models.py`).
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::fs;

use fumetto_formats::{Model, ModelOptions, read_model};

fn path(name: &str) -> String {
    format!("{}/tests/fixtures/models/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Reads a fixture as if it lay in the folder `models`.
fn fixture(name: &str, options: ModelOptions) -> Model {
    let bytes = fs::read(path(name)).unwrap();
    let mut read = |asked: &str| fs::read(path(asked.strip_prefix("models/").unwrap()));
    read_model(&format!("models/{name}"), &bytes, options, &mut read).unwrap()
}

fn table(name: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path(name)).unwrap();
    text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[test]
fn every_model_has_as_many_triangles_as_its_program_says() {
    for row in table("counts.csv") {
        let [name, triangles, placed] = row.as_slice() else { panic!("{row:?}") };
        if name.ends_with(".obj") {
            continue;
        }
        let model = fixture(name, ModelOptions::default());
        assert_eq!(model.triangle_count(), triangles.parse::<u64>().unwrap(), "{name}: {:?}", model.notes);
        assert_eq!(model.placed(0.0).len(), placed.parse::<usize>().unwrap(), "{name}");
        assert_eq!(model.notes, [""; 0], "{name}");
    }
}
