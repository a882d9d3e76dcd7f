//! What is printed or written without drawing.

use serde_json::Value;

use crate::run::Folder;

#[test]
fn new_scenes_are_whole_and_overwrite_nothing() {
    let folder = Folder::with_smoke();
    for template in ["smoke", "cloud", "explosion"] {
        let file = format!("{template}.new.toml");
        folder.run(&["new", &format!("{template}.new"), "--template", template]).ends(0).says(&[&file]);
        folder.run(&["check", &file]).ends(0);
        let small = ["--size", "32x18", "--frame", "3", "-o", "a.png"];
        folder.run(&[&["render", &file][..], &small].concat()).ends(0);
    }
    let before = folder.bytes("smoke.toml");
    folder.run(&["new", "smoke"]).ends(1).says(&["smoke.toml exists already"]);
    assert_eq!(folder.bytes("smoke.toml"), before);
    folder.run(&["new", "no/smoke"]).ends(1).says(&["mkdir -p no"]);
    folder.run(&["new", "x", "--template", "rain"]).ends(2).says(&["explosion"]);
}

#[test]
fn info_counts_what_the_scene_costs() {
    let folder = Folder::with_smoke();
    let text = folder.run(&["info", "smoke.toml"]).ends(0).out;
    assert!(text.contains("64 x 36") && text.contains("`smoke`") && text.contains("1 emitter"), "{text}");
    assert!(text.contains("vortices  at most 72 at once"), "{text}");

    let out = folder.run(&["info", "smoke.toml", "--json"]).ends(0).out;
    let info: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(info["frames"], serde_json::json!([0, 5]));
    // 20 a second for 3 seconds and one step, one for rounding, and the burst.
    assert_eq!(info["objects"][0]["particles"], 62 + 1 + 8);
    // The ring of the burst, one that the stream has shed, and one for rounding.
    let vortices = 3 * 24;
    assert_eq!(info["objects"][0]["vortices"], vortices);
    assert_eq!(info["bytes"], 96 * 71 + 64 * vortices + 120 * 2048);
    assert_eq!(info["objects"][0]["style"]["tones"][2], "#f4f7f9");
}

#[test]
fn the_schema_is_that_of_scenes() {
    let folder = Folder::with_smoke();
    // As text: numbers that are read again may be off by their last bit.
    let schema = serde_json::to_string_pretty(&fumetto_scene::schema()).unwrap();
    assert_eq!(folder.run(&["schema"]).ends(0).out.trim_end(), schema);
}

#[test]
fn the_doctor_names_the_adapter() {
    let out = Folder::with_smoke().run(&["doctor"]).ends(0).out;
    assert!(out.contains("fumetto draws with: ") && out.contains("driver"), "{out}");
}

#[test]
fn help_and_version_are_no_failures() {
    let folder = Folder::with_smoke();
    assert!(folder.run(&["--version"]).ends(0).out.starts_with("fumetto "));
    assert!(folder.run(&["render", "--help"]).ends(0).out.contains("--resume"));
}
