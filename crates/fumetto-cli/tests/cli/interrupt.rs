//! Ctrl-C leaves whole files only.
#![cfg(unix)]

use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::run::{Folder, Ran};

/// Long enough for the slowest processor to begin and to stop.
const PATIENCE: Duration = Duration::from_secs(30);

fn start(folder: &Folder, args: &[&str]) -> Child {
    folder.command(args).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

fn wait_until(is_so: impl Fn() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < PATIENCE, "nothing happened");
        sleep(Duration::from_millis(20));
    }
}

fn interrupt(mut child: Child) -> Ran {
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > PATIENCE {
            child.kill().unwrap();
            panic!("it goes on; is Ctrl-C ignored here, as `nohup` and a shell's `&` have it?");
        }
        sleep(Duration::from_millis(20));
    }
    Ran::of(&child.wait_with_output().unwrap()).ends(130).says(&["interrupted"])
}

#[test]
fn an_unfinished_animation_leaves_nothing() {
    let folder = Folder::with_smoke();
    let child = start(&folder, &["render", "smoke.toml", "-o", "a.gif", "--frames", "0..1000000"]);
    wait_until(|| folder.files().iter().any(|name| name.ends_with(".tmp")));
    // Well into the frames.
    sleep(Duration::from_secs(2));
    interrupt(child);
    assert!(folder.files().is_empty(), "{:?}", folder.files());
}

#[test]
fn the_finished_pictures_of_a_sequence_stay_and_can_be_gone_on_with() {
    let folder = Folder::with_smoke();
    let child = start(&folder, &["render", "smoke.toml", "-o", "s.{}.png", "--frames", "0..1000000"]);
    wait_until(|| folder.path("s.3.png").exists());
    interrupt(child);
    for name in folder.files() {
        assert!(name.ends_with(".png"), "{name}");
        assert_eq!(folder.png(&name).width, 64, "{name} is whole");
    }
    folder.run(&["render", "smoke.toml", "-o", "s.{}.png", "--frames", "0..3", "--resume"]).ends(0);
}

#[test]
fn baking_goes_on_after_an_interruption() {
    let folder = Folder::with_smoke();
    let child = start(&folder, &["bake", "smoke.toml", "-o", "cache", "--frames", "0..1000000"]);
    wait_until(|| folder.path("cache/0010.frame").exists());
    interrupt(child);
    assert!(folder.path("cache/checkpoint.frame").exists());
    let last = std::fs::read_dir(folder.path("cache")).unwrap().count() as u32 * 2;
    let more = ["bake", "smoke.toml", "-o", "cache", "--frames", &format!("0..{last}")];
    folder.run(&more).ends(0).says(&["were there already"]);
}

#[test]
fn the_way_to_a_late_frame_can_be_stopped() {
    let folder = Folder::with_smoke();
    let child = start(&folder, &["render", "smoke.toml", "-o", "a.png", "--frame", "100000000"]);
    sleep(Duration::from_secs(2));
    interrupt(child);
    assert!(folder.files().is_empty());
}
