use std::fs::File;
use std::path::Path;

use serde_json::Value;

use crate::run::{Folder, Ran, SMOKE};

const PAPER: [u8; 4] = [0xf3, 0xea, 0xd8, 0xff];

fn gif_frames(path: &Path) -> Vec<(Vec<u8>, u16)> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(File::open(path).unwrap()).unwrap();
    let mut frames = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        frames.push((frame.buffer.to_vec(), frame.delay));
    }
    frames
}

#[test]
fn a_single_picture_shows_the_last_frame() {
    let folder = Folder::with_smoke();
    folder.run(&["render", "smoke.toml", "-o", "last.png"]).ends(0).says(&["wrote last.png"]);
    folder.run(&["render", "-o", "five.png", "--frame", "5", "smoke.toml"]).ends(0);
    folder.run(&["render", "smoke.toml", "-o", "zero.png", "--frame", "0"]).ends(0);

    let last = folder.png("last.png");
    assert_eq!((last.width, last.height), (64, 36));
    assert_eq!(last.pixels[..4], PAPER, "a picked colour stays what it is");
    assert!(last.pixels.as_chunks::<4>().0.iter().filter(|pixel| **pixel != PAPER).count() > 100);
    assert_eq!(folder.bytes("last.png"), folder.bytes("five.png"), "the same frame has the same bytes");
    assert_ne!(folder.bytes("last.png"), folder.bytes("zero.png"));
    assert_eq!(folder.files(), ["five.png", "last.png", "zero.png"]);
}

#[test]
fn a_sequence_has_a_file_for_each_frame_and_holds_drawings() {
    let folder = Folder::with_smoke();
    folder.run(&["render", "smoke.toml", "-o", "s.##.png", "--frames", "1..4"]).ends(0);
    assert_eq!(folder.files(), ["s.01.png", "s.02.png", "s.03.png", "s.04.png"]);
    assert_ne!(folder.bytes("s.01.png"), folder.bytes("s.02.png"));
    assert_eq!(folder.bytes("s.02.png"), folder.bytes("s.03.png"), "drawn on twos");
    assert_ne!(folder.bytes("s.03.png"), folder.bytes("s.04.png"));
}

#[test]
fn a_gif_holds_the_scene_and_its_clear_background() {
    let folder = Folder::with_smoke();
    folder.put("clear.toml", SMOKE.replace("[background]\ncolour = \"#f3ead8\"\n", ""));
    folder.run(&["render", "smoke.toml", "-o", "smoke.gif"]).ends(0);
    folder.run(&["render", "clear.toml", "-o", "clear.gif", "--frames", "2..3"]).ends(0);

    let frames = gif_frames(&folder.path("smoke.gif"));
    assert_eq!(frames.len(), 3, "six frames on twos");
    assert!(frames.iter().all(|(pixels, delay)| pixels[..4] == PAPER && *delay == 20));
    let clear = gif_frames(&folder.path("clear.gif"));
    assert_eq!(clear.len(), 1);
    assert_eq!(clear[0].0[3], 0, "the corner is transparent");
    assert!(clear[0].0.as_chunks::<4>().0.iter().any(|pixel| pixel[3] == 255));
}

#[test]
fn json_tells_of_each_frame_and_of_the_whole() {
    let folder = Folder::with_smoke();
    let ran = folder.run(&["render", "smoke.toml", "-o", "s{}.png", "--frames", "0..2", "--json"]).ends(0);
    let lines: Vec<Value> = ran.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines.len(), 4);
    for (frame, line) in lines[..3].iter().enumerate() {
        assert_eq!(line["frame"], frame);
        assert_eq!(line["file"], format!("s{frame}.png"));
        assert!(line["ms"].as_f64().unwrap() > 0.0);
    }
    assert_eq!(lines[3]["done"], true);
    assert_eq!(lines[3]["frames"], 3);
    assert!(lines[3]["seconds"].as_f64().unwrap() > 0.0);
    assert!(!lines[3]["adapter"].as_str().unwrap().is_empty());
}

#[test]
fn resuming_draws_only_what_is_missing() {
    let folder = Folder::with_smoke();
    folder.run(&["render", "smoke.toml", "-o", "whole.#.png"]).ends(0);
    folder.run(&["render", "smoke.toml", "-o", "s.#.png"]).ends(0);
    std::fs::remove_file(folder.path("s.4.png")).unwrap();
    folder.put("s.1.png", "left alone");

    let ran = folder.run(&["render", "smoke.toml", "-o", "s.#.png", "--resume", "--json"]).ends(0);
    let lines: Vec<Value> = ran.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let drawn = lines.iter().filter(|line| line["frame"].is_u64() && line["skipped"].is_null());
    assert_eq!(drawn.map(|line| line["frame"].as_u64().unwrap()).collect::<Vec<_>>(), [4]);
    assert_eq!(folder.bytes("s.1.png"), b"left alone");
    assert_eq!(folder.bytes("s.4.png"), folder.bytes("whole.4.png"), "the simulation ran through");

    let ran = folder.run(&["render", "smoke.toml", "-o", "s.#.png", "--resume"]).ends(0);
    assert!(ran.err.contains("nothing to do"), "{}", ran.err);
}

#[test]
fn the_command_line_changes_the_scene() {
    let folder = Folder::with_smoke();
    let set = ["--set", "background.colour=#102030", "--set", "object.smoke.visible=false"];
    let args = ["render", "smoke.toml", "-o", "a.png", "--frame", "0", "--size", "20x10", "--antialias", "2"];
    folder.run(&[&args[..], &set].concat()).ends(0);
    let picture = folder.png("a.png");
    assert_eq!((picture.width, picture.height), (20, 10));
    assert!(picture.pixels.as_chunks::<4>().0.iter().all(|pixel| *pixel == [0x10, 0x20, 0x30, 0xff]));
}

#[test]
fn cameras_and_styles_are_chosen_by_name() {
    let folder = Folder::with_smoke();
    let two = "[[camera]]\nname = \"front\"\neye = [0, 1, 5]\ntarget = [0, 1, 0]\n\
               [[camera]]\nname = \"away\"\neye = [0, 1, 5]\ntarget = [0, 1, 9]\n";
    folder.put("two.toml", SMOKE.replace("[camera]\neye = [0, 1, 5]\ntarget = [0, 1, 0]\n", two));
    folder.put("red.style.toml", "preset = \"flat\"\ntones = [\"#ff0000\"]\nink = { on = false }\n");
    let has = |name: &str, colour: [u8; 4]| folder.png(name).pixels.as_chunks::<4>().0.contains(&colour);

    folder.run(&["render", "two.toml", "-o", "away.png", "--camera", "away"]).ends(0);
    assert!(folder.png("away.png").pixels.as_chunks::<4>().0.iter().all(|pixel| *pixel == PAPER));
    folder.run(&["render", "two.toml", "-o", "red.png", "--style", "red.style.toml"]).ends(0);
    assert!(has("red.png", [255, 0, 0, 255]));
    folder.run(&["render", "two.toml", "-o", "flat.png", "--style", "flat"]).ends(0);
    assert!(has("flat.png", [0xee, 0xf2, 0xf5, 255]));
    folder
        .run(&["render", "two.toml", "-o", "x.png", "--camera", "back"])
        .ends(2)
        .says(&["back", "front, away"]);
    folder.run(&["render", "two.toml", "-o", "x.png", "--style", "nice"]).ends(2).says(&["nice", "cartoon"]);
    assert!(!folder.path("x.png").exists());
}

#[test]
fn files_are_looked_for_beside_the_scene() {
    let folder = Folder::with_smoke();
    std::fs::create_dir(folder.path("shots")).unwrap();
    folder.put("shots/cloud.csv", "x,y,z,radius\n0,1,0,0.8\n");
    let object = "[[object]]\nname = \"cloud\"\nkind = \"cloud\"\nparticles = \"cloud.csv\"\n";
    let start = SMOKE.find("[[object]]").unwrap();
    folder.put("shots/cloud.toml", format!("{}{object}", &SMOKE[..start]));
    folder.run(&["render", "shots/cloud.toml", "-o", "cloud.#.png"]).ends(0);
    assert_ne!(folder.png("cloud.0.png").pixels[4 * (18 * 64 + 32)..][..4], PAPER);
    assert_eq!(folder.bytes("cloud.0.png"), folder.bytes("cloud.5.png"));
    folder.run(&["check", "shots/cloud.toml"]).ends(0);
}

#[test]
fn what_was_drawn_before_a_missing_file_stays() {
    let folder = Folder::with_smoke();
    for frame in [0, 2] {
        folder.put(&format!("cloud.{frame}.csv"), format!("x,y,z,radius\n0,1,0,0.{}\n", frame + 3));
    }
    let start = SMOKE.find("[[object]]").unwrap();
    let object = "[[object]]\nname = \"cloud\"\nkind = \"cloud\"\nparticles = \"cloud.#.csv\"\n";
    folder.put("cloud.toml", format!("{}{object}", &SMOKE[..start]));
    let ran = folder.run(&["render", "cloud.toml", "-o", "s.#.png"]).ends(1);
    ran.says(&["cloud.toml: cannot read `cloud.4.csv`: No such file"]);
    assert_ne!(folder.bytes("s.0.png"), folder.bytes("s.3.png"));
    assert!(!folder.path("s.4.png").exists());
}

#[test]
fn prints_are_larger_than_a_texture_and_look_like_the_preview() {
    let folder = Folder::with_smoke();
    let sized = ["render", "smoke.toml", "--frame", "5", "--set", "style.clean={ px = 0 }", "--size"];
    let run = |more: &[&str]| folder.run(&[&sized[..], more].concat()).ends(0);
    run(&["4100x200", "--antialias", "1", "-o", "once.png"]);
    // Twice as many samples are more than a texture has.
    run(&["4100x200", "--antialias", "2", "-o", "tiles.png"]);
    let (once, tiles) = (folder.png("once.png"), folder.png("tiles.png"));
    assert_eq!([tiles.width, tiles.height], [4100, 200]);
    let pairs = || once.pixels.as_chunks::<4>().0.iter().zip(tiles.pixels.as_chunks::<4>().0);
    let far = |(a, b): &(&[u8; 4], &[u8; 4])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 160);
    let (smoke, apart) = (pairs().filter(|(a, _)| **a != PAPER).count(), pairs().filter(far).count());
    assert!(smoke > 4000 && apart < 300, "only the edges of lines are finer: {apart} of {smoke}");
}

#[test]
fn prints_of_a_held_drawing_are_the_same() {
    let folder = Folder::with_smoke();
    let args = ["render", "smoke.toml", "-o", "s.#.png", "--frames", "2..3", "--size", "8192x8"];
    folder.run(&[&args[..], &["--antialias", "4", "--json"]].concat()).ends(0);
    assert_eq!([folder.png("s.2.png").width, folder.png("s.2.png").height], [8192, 8]);
    assert_eq!(folder.bytes("s.2.png"), folder.bytes("s.3.png"), "drawn on twos");
    assert_eq!(folder.files(), ["s.2.png", "s.3.png"]);
}

#[test]
fn a_scene_may_come_by_a_pipe() {
    let folder = Folder::with_smoke();
    folder.run(&["render", "smoke.toml", "-o", "file.png"]).ends(0);
    let scene = File::open(folder.path("smoke.toml")).unwrap();
    let output = folder.command(&["render", "-", "-o", "pipe.png"]).stdin(scene).output().unwrap();
    Ran::of(&output).ends(0);
    assert_eq!(folder.bytes("file.png"), folder.bytes("pipe.png"));
    let broken =
        folder.command(&["check", "-"]).stdin(File::open(folder.path("pipe.png")).unwrap()).output().unwrap();
    Ran::of(&broken).ends(1).says(&["standard input", "UTF-8"]);
}
