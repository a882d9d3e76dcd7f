//! What is simulated once is drawn as if it were simulated then.

use std::fs;

use crate::run::{Folder, SMOKE};

const FRAME: &str = "cache/0004.frame";

/// The scene with a solver.
fn with_solver(solver: &str) -> Folder {
    let folder = Folder::with_smoke();
    let kind = "kind = \"smoke\"";
    folder.put("smoke.toml", SMOKE.replace(kind, &format!("{kind}\n{solver}")));
    folder
}

#[test]
fn frames_out_of_a_cache_are_those_of_the_simulation() {
    for solver in [
        "solver = \"vortex\"",
        "solver = \"grid\"\ngrid = { box = { center = [0, 2, 0], size = [2, 4, 2] }, cells = 16 }",
    ] {
        let folder = with_solver(solver);
        folder.run(&["render", "smoke.toml", "-o", "straight.{}.png"]).ends(0);
        let baked = folder.run(&["bake", "smoke.toml", "-o", "cache", "--json"]).ends(0);
        assert_eq!(baked.out.lines().count(), 4, "frames 0, 2 and 4, on twos, and the end:\n{}", baked.out);
        // In any order, each by itself.
        for frame in [4, 0, 5, 2] {
            let (name, frame) = (format!("{frame}.png"), frame.to_string());
            let args = ["render", "smoke.toml", "-o", &name, "--frame", &frame, "--cache", "cache"];
            assert_eq!(folder.run(&args).ends(0).err.matches("note:").count(), 0);
            assert_eq!(
                folder.bytes(&name),
                folder.bytes(&format!("straight.{frame}.png")),
                "{solver}, frame {frame}"
            );
        }
    }
}

#[test]
fn baking_goes_on_where_it_ended() {
    let folder = with_solver("solver = \"vortex\"");
    folder.run(&["bake", "smoke.toml", "-o", "whole", "--frames", "0..9"]).ends(0);
    folder.run(&["bake", "smoke.toml", "-o", "parts", "--frames", "0..5"]).ends(0);
    fs::remove_file(folder.path("parts/0002.frame")).unwrap();
    let more = folder.run(&["bake", "smoke.toml", "-o", "parts", "--frames", "0..9"]).ends(0);
    more.says(&["3 frames", "2 were there already"]);
    for name in ["0000", "0002", "0004", "0006", "0008", "checkpoint"] {
        let [whole, parts] = ["whole", "parts"].map(|cache| folder.bytes(&format!("{cache}/{name}.frame")));
        assert_eq!(whole, parts, "{name}");
    }
}

#[test]
fn what_is_baked_is_exported() {
    let folder = with_solver("solver = \"vortex\"");
    folder.run(&["bake", "smoke.toml", "-o", "cache"]).ends(0);
    folder.run(&["export", "smoke.toml", "-o", "a.csv", "--frame", "4"]).ends(0);
    folder.run(&["export", "smoke.toml", "-o", "b.csv", "--frame", "4", "--cache", "cache"]).ends(0);
    assert_eq!(folder.bytes("a.csv"), folder.bytes("b.csv"));
}

#[test]
fn a_look_may_change_and_a_motion_may_not() {
    let folder = with_solver("solver = \"vortex\"");
    folder.run(&["bake", "smoke.toml", "-o", "cache"]).ends(0);
    let render = ["render", "smoke.toml", "-o", "a.png", "--frame", "4", "--cache", "cache"];
    let other_look = [&render[..], &["--set", "style.form=0"]].concat();
    assert!(!folder.run(&other_look).ends(0).err.contains("note:"));
    let other_motion = ["--set", "object.smoke.emitter.rate=30"];
    folder.run(&[&render[..], &other_motion].concat()).ends(0).says(&["note: cache holds another scene's"]);
    folder
        .run(&[&["bake", "smoke.toml", "-o", "cache"], &other_motion[..]].concat())
        .ends(1)
        .says(&["0000.frame is of another scene", "another folder"]);
    let late = ["render", "smoke.toml", "-o", "b.png", "--frame", "7", "--cache", "cache"];
    folder.run(&late).ends(0).says(&["note: frame 6 is not in cache"]);
}

#[test]
fn broken_caches_are_told() {
    let folder = with_solver("solver = \"vortex\"");
    let render = ["render", "smoke.toml", "-o", "a.png", "--frame", "4", "--cache", "cache"];
    folder.run(&render).ends(1).says(&["there is no folder cache", "fumetto bake"]);
    folder.run(&["bake", "smoke.toml", "-o", "cache"]).ends(0);
    let whole = folder.bytes(FRAME);
    folder.put(FRAME, &whole[..whole.len() / 2]);
    folder.run(&render).ends(1).says(&["0004.frame", "damaged", "bake again"]);
    folder.put(FRAME, "no cache at all, and rather long");
    folder.run(&render).ends(1).says(&["0004.frame", "no cache of Fumetto's"]);
    folder.put(FRAME, folder.bytes("cache/0002.frame"));
    folder.run(&render).ends(1).says(&["0004.frame is of frame 2"]);
    folder.put("empty.toml", "format = 1\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n");
    folder.run(&["bake", "empty.toml", "-o", "none"]).ends(1).says(&["nothing to bake"]);
    assert!(!folder.path("none").exists());
}
