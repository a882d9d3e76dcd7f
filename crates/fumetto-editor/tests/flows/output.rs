#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::fs;
use std::path::Path;

use egui::Key;
use egui_kittest::kittest::Queryable as _;

use crate::desk::Desk;

#[test]
fn a_picture_is_rendered_while_editing_goes_on() {
    if !is_built() {
        return;
    }
    let mut desk = Desk::open();
    let scene = desk.folder.path().join("ball.toml");
    fs::write(&scene, "format = 1\n[[object]]\nname = \"ball\"\nkind = \"cloud\"\nparticles = [{ center = [0, 0, 0], radius = 1 }]\n[output]\nsize = [64, 36]\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n").unwrap();
    desk.show(&scene);
    desk.settle();
    desk.window.key_press(Key::F12);
    desk.window.run_steps(2);
    desk.click("Start");
    let picture = desk.folder.path().join("ball.png");
    desk.wait_until("a rendered picture", move |_| picture.exists());
    desk.wait_until("the end of the job", |app| !app.has_jobs());
    desk.look("render");
    assert!(fs::metadata(desk.folder.path().join("ball.png")).unwrap().len() > 100);
}

/// Whether the program that renders was built too: it is, wherever the whole workspace is.
fn is_built() -> bool {
    let own = std::env::current_exe().unwrap();
    own.ancestors().skip(1).take(2).any(|folder| Path::new(folder).join("fumetto").exists())
}

#[test]
fn a_scene_with_errors_says_why_there_is_no_picture_until_it_has_none() {
    let mut desk = Desk::open();
    let scene = desk.folder.path().join("ball.toml");
    let text = "format = 1\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n[[object]]\nname = \"ball\"\nkind = \"cloud\"\nparticle = 3\n";
    fs::write(&scene, text).unwrap();
    desk.show(&scene);
    desk.window.run_steps(2);
    desk.click("ball");
    desk.window.key_press(Key::F12);
    desk.window.run_steps(2);
    desk.window.get_by_label_contains("no picture of a scene with errors");
    assert!(desk.window.query_by_label("Start").is_none());
    desk.window.key_press(Key::Delete);
    desk.window.run_steps(3);
    assert!(desk.window.query_by_label("Start").is_some());
}
