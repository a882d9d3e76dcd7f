//! What is wrong with the command line alone: exit code 2, and nothing is opened.

use crate::run::Folder;

#[track_caller]
fn refused(args: &[&str], says: &[&str]) {
    let folder = Folder::with_smoke();
    folder.run(args).ends(2).says(says);
    assert!(folder.files().is_empty());
}

#[test]
fn commands_and_scenes_are_needed() {
    refused(&[], &["Usage"]);
    refused(&["draw"], &["draw"]);
    refused(&["render", "smoke.toml"], &["--output"]);
    refused(&["render", "-o", "a.png"], &["SCENE"]);
    refused(&["edit", "-"], &["standard input", "name a scene's file"]);
}

#[test]
fn unknown_extensions_list_those_known() {
    refused(&["render", "smoke.toml", "-o", "a.bmp"], &["a.bmp", ".png", ".gif"]);
    refused(&["render", "smoke.toml", "-o", "a"], &[".png", ".gif"]);
    refused(&["render", "smoke.toml", "-o", "a.####.gif"], &["all frames"]);
    refused(&["export", "smoke.toml", "-o", "a.eps"], &["a.eps", ".svg", ".glb", ".png"]);
    refused(&["export", "smoke.toml", "-o", "a.glb", "--plotter"], &["--plotter", ".svg"]);
    refused(&["export", "smoke.toml", "-o", "a.svg", "--width-mm", "0"], &["--width-mm", "millimetres"]);
}

#[test]
fn exports_fit_their_files() {
    let export =
        |args: &[&str], says: &[&str]| refused(&[&["export", "smoke.toml", "-o"], args].concat(), says);
    export(&["a.glb", "--what", "particles"], &["a.glb", ".ply or .csv"]);
    export(&["a.csv", "--what", "meshes"], &["a.csv", ".glb, .obj or .ply"]);
    export(&["a.png", "--frame", "3"], &["a.png", "same in every frame"]);
    export(&["a.####.png"], &["same in every frame"]);
    export(&["a.glb", "--frames", "1..2"], &["a.####.glb"]);
    export(&["a.glb", "--frame", "1", "--frames", "1..2"], &["--frame"]);
}

#[test]
fn sizes_have_bounds() {
    let size = |size| refused(&["render", "smoke.toml", "-o", "a.png", "--size", size], &[size]);
    for wrong in ["0x0", "0x36", "32769x8", "100000x100000", "64", "ax3", "99999999999x1"] {
        size(wrong);
    }
    refused(&["render", "smoke.toml", "-o", "a.png", "--size", "100000x100000"], &["from 1 to 32768"]);
}

#[test]
fn frames_have_an_order_and_a_place() {
    let render = ["render", "smoke.toml", "-o"];
    refused(&[&render[..], &["a.##.png", "--frames", "5..2"]].concat(), &["5", "2"]);
    refused(&[&render[..], &["a.##.png", "--frame", "1", "--frames", "1..2"]].concat(), &["--frame"]);
    refused(&[&render[..], &["a.png", "--frames", "1..2"]].concat(), &["a.####.png"]);
    refused(&[&render[..], &["a.png", "--frame", "-1"]].concat(), &["-1"]);
    refused(&[&render[..], &["a.png", "--frame", "4294967296"]].concat(), &["4294967296"]);
}

#[test]
fn options_that_do_not_fit_the_output_are_refused() {
    refused(&["render", "smoke.toml", "-o", "a.gif", "--resume"], &["--resume"]);
    refused(&["render", "smoke.toml", "-o", "a.png", "--resume"], &["a.png", "--resume"]);
    refused(&["render", "smoke.toml", "-o", "a.gif", "--layers", "normal"], &["--layers"]);
    refused(&["render", "smoke.toml", "-o", "a.png", "--layers", "colour"], &["normal, depth"]);
    refused(&["render", "smoke.toml", "-o", "a.png", "--antialias", "5"], &["5"]);
    refused(&["render", "smoke.toml", "-o", "a.png", "--set", "fps"], &["fps"]);
}
