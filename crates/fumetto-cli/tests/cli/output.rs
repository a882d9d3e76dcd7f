//! Where files go, and what becomes of those that were there.

use std::fs;
use std::process::Stdio;

use crate::run::{Folder, Ran};

#[test]
fn a_picture_is_replaced_whole() {
    let folder = Folder::with_smoke();
    folder.put("a.png", "an old file");
    folder.run(&["render", "smoke.toml", "-o", "a.png"]).ends(0);
    assert_eq!(folder.png("a.png").width, 64);
    assert_eq!(folder.files(), ["a.png"]);
}

#[test]
fn an_old_file_survives_a_failure() {
    let folder = Folder::with_smoke();
    folder.put("a.gif", "an old file");
    folder
        .run(&["render", "smoke.toml", "-o", "a.gif", "--set", "time.fps=60"])
        .ends(1)
        .says(&["a.gif", "60"]);
    assert_eq!(folder.bytes("a.gif"), b"an old file");
    assert_eq!(folder.files(), ["a.gif"]);
}

#[test]
fn places_that_cannot_be_written_are_named_before_anything_is_drawn() {
    let folder = Folder::with_smoke();
    fs::create_dir(folder.path("folder.png")).unwrap();
    let render = |out: &str| folder.run(&["render", "smoke.toml", "-o", out]).ends(1);
    render("no/such/a.png").says(&["no/such/a.png", "mkdir -p no/such"]);
    render("no/a.gif").says(&["no/a.gif", "mkdir -p no"]);
    render("smoke.toml/a.png").says(&["smoke.toml is not a folder"]);
    render("folder.png").says(&["folder.png", "is a folder"]);
    #[cfg(target_os = "linux")]
    render("/proc/a.####.png").says(&["/proc/a.0000.png", "refuses new files", "not found"]);
    assert_eq!(folder.files(), ["folder.png"]);
}

#[cfg(unix)]
#[test]
fn pictures_are_as_readable_as_other_files() {
    use std::os::unix::fs::PermissionsExt as _;

    let folder = Folder::with_smoke();
    folder.run(&["render", "smoke.toml", "-o", "a.png", "--frame", "0"]).ends(0);
    let mode = |name: &str| fs::metadata(folder.path(name)).unwrap().permissions().mode() & 0o777;
    assert_eq!(mode("a.png"), mode("smoke.toml"));
}

#[test]
fn layers_lie_beside_the_picture() {
    let folder = Folder::with_smoke();
    let args =
        ["render", "smoke.toml", "-o", "s.##.png", "--frames", "4..5", "--layers", "normal,depth,normal"];
    folder.run(&args).ends(0);
    let names =
        ["s.04.depth.png", "s.04.normal.png", "s.04.png", "s.05.depth.png", "s.05.normal.png", "s.05.png"];
    assert_eq!(folder.files(), names);
    assert_eq!(folder.png("s.04.normal.png").width, 64);
    assert_ne!(folder.bytes("s.04.normal.png"), folder.bytes("s.04.depth.png"));

    fs::remove_file(folder.path("s.04.depth.png")).unwrap();
    folder.run(&[&args[..], &["--resume"]].concat()).ends(0);
    assert_eq!(folder.files(), names);
}

#[test]
fn the_atlas_is_exported_in_three_pictures() {
    let folder = Folder::with_smoke();
    folder.run(&["export", "smoke.toml", "-o", "puffs.png"]).ends(0).says(&["wrote puffs.normal.png"]);
    assert_eq!(folder.files(), ["puffs.coverage.png", "puffs.depth.png", "puffs.normal.png"]);
    assert!(folder.png("puffs.normal.png").width >= 128);
}

#[test]
fn a_reader_that_leaves_does_not_stop_the_work() {
    let folder = Folder::with_smoke();
    let mut command = folder.command(&["render", "smoke.toml", "-o", "s.#.png", "--json"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    Ran::of(&child.wait_with_output().unwrap()).ends(0);
    assert_eq!(folder.files().len(), 6);

    let mut child =
        folder.command(&["schema"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    Ran::of(&child.wait_with_output().unwrap()).ends(0);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_of() {
    let folder = Folder::with_smoke();
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = folder.command(&["schema"]).stdout(full).output().unwrap();
    Ran::of(&output).ends(1).says(&["No space left"]);
}
