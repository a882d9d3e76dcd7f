//! The committed JSON Schema is the one that the types make.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::path::Path;

/// Run with `UPDATE_SCHEMA=1` to write the file anew.
#[test]
fn the_schema_file_is_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schema/scene.schema.json");
    let wanted = serde_json::to_string_pretty(&fumetto_scene::schema()).unwrap() + "\n";
    if std::env::var_os("UPDATE_SCHEMA").is_some() {
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, &wanted).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(committed == wanted, "schema/scene.schema.json is out of date: run with UPDATE_SCHEMA=1");
}
