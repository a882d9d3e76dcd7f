//! Scenes and files that are broken: exit code 1, a message that names the place, and no output.

use crate::run::{Folder, SMOKE};

/// Renders `scene` and expects a refusal that holds each of `says`.
#[track_caller]
fn refused(scene: impl AsRef<[u8]>, says: &[&str]) {
    let folder = Folder::with_smoke();
    folder.put("bad.toml", scene);
    folder.run(&["render", "bad.toml", "-o", "a.png"]).ends(1).says(says).says(&["bad.toml"]);
    assert_eq!(folder.files(), ["bad.toml"]);
}

/// The smoke with its object's matter replaced by that of a file.
fn cloud_of(path: &str) -> String {
    let start = SMOKE.find("[[object]]").unwrap();
    format!("{}[[object]]\nname = \"cloud\"\nkind = \"cloud\"\nparticles = \"{path}\"\n", &SMOKE[..start])
}

#[test]
fn a_scene_that_is_not_there() {
    let folder = Folder::with_smoke();
    folder.run(&["render", "none.toml", "-o", "a.png"]).ends(1).says(&["none.toml", "No such file"]);
    folder.run(&["check", "."]).ends(1).says(&["cannot read the scene .", "folder"]);
}

#[test]
fn malformed_toml() {
    refused("format = 1\n[camera\n", &["bad.toml:2"]);
    refused("", &["format"]);
    refused(b"format = 1\n\xff\xfe", &["line 2", "UTF-8"]);
}

#[test]
fn wrong_keys_and_values() {
    refused(SMOKE.replace("hold = 2", "holt = 2"), &["holt", "hold"]);
    refused(SMOKE.replace("size = [64, 36]", "size = [0, 0]"), &["size"]);
    refused(SMOKE.replace("size = [64, 36]", "size = [100000, 100000]"), &["size", "32768"]);
    refused(SMOKE.replace("count = 8", "count = 1_000_000_000"), &["particles"]);
    refused(SMOKE.replace("rate = 20", "rate = 1e9"), &["particles"]);
}

#[test]
fn broken_files_beside_the_scene() {
    refused(cloud_of("none.ply"), &["none.ply", "No such file"]);
    refused(cloud_of("bad.toml"), &["bad.toml", ".ply"]);
    refused(SMOKE.replace("colour = \"#f3ead8\"", "image = \"bad.toml\""), &["not a readable PNG"]);
    #[cfg(unix)]
    refused(
        SMOKE.replace("colour = \"#f3ead8\"", "image = \"/dev/zero\""),
        &["/dev/zero", "not a regular file"],
    );
}

#[test]
fn settings_are_checked_like_the_scene() {
    let folder = Folder::with_smoke();
    let set = |set: &str| folder.run(&["render", "smoke.toml", "-o", "a.png", "--set", set]).ends(1);
    set("time.holt=3").says(&["--set", "holt"]);
    set("output.size=[0, 0]").says(&["--set", "size"]);
    set("object.fog.opacity=1").says(&["--set", "fog"]);
    assert!(folder.files().is_empty());
}

#[test]
fn pictures_beyond_the_device() {
    let folder = Folder::with_smoke();
    for out in [&["a.gif"][..], &["a.png", "--layers", "id"]] {
        let args = [&["render", "smoke.toml", "--size", "9000x8", "-o"], out].concat();
        folder.run(&args).ends(1).says(&["9000 x 8", "antialias", ".png"]);
    }
    assert!(folder.files().is_empty());
}

#[cfg(target_os = "linux")]
#[test]
fn no_graphics_driver() {
    let folder = Folder::with_smoke();
    let without = |args: &[&str]| {
        let mut command = folder.command(args);
        command.env("VK_DRIVER_FILES", "none.json").env("VK_ICD_FILENAMES", "none.json");
        crate::run::Ran::of(&command.output().unwrap()).ends(1)
    };
    without(&["render", "smoke.toml", "-o", "a.gif"]).says(&["fumetto doctor"]);
    assert!(folder.files().is_empty());
    assert!(without(&["doctor"]).out.contains("mesa-vulkan-drivers"));
}

#[test]
fn check_tells_every_problem() {
    let folder = Folder::with_smoke();
    assert_eq!(folder.run(&["check", "smoke.toml"]).ends(0).out, "no problems\n");

    folder.put("two.toml", SMOKE.replace("hold = 2", "holt = 2").replace("rate = 20", "rate = -1"));
    let out = folder.run(&["check", "two.toml"]).ends(1).out;
    assert!(out.contains("two.toml:14") && out.contains("holt") && out.contains("rate"), "{out}");

    let files = cloud_of("cloud.##.ply").replace("colour = \"#f3ead8\"", "image = \"sky.png\"");
    folder.put(
        "files.toml",
        files.replace("tones = [\"#8fa3b8\", \"#c3cfda\", \"#f4f7f9\"]", "ramp = \"ramp.png\""),
    );
    let out = folder.run(&["check", "files.toml"]).ends(1).out;
    for part in ["cloud.00.ply", "cloud.02.ply", "sky.png", "ramp.png", "`cloud`"] {
        assert!(out.contains(part), "{part} is not in:\n{out}");
    }
    assert!(!out.contains("cloud.01.ply"), "frames that are held need no file:\n{out}");
}
