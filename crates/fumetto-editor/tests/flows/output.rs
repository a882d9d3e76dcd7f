#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::fs;
use std::path::Path;

use egui::Key;

use crate::desk::Desk;

#[test]
fn a_picture_is_rendered_while_editing_goes_on() {
    if !is_built() {
        return;
    }
    let mut desk = Desk::open();
    let scene = desk.folder.path().join("ball.toml");
    fs::write(&scene, "format = 1\n[[object]]\nname = \"ball\"\nkind = \"cloud\"\nparticles = [{ center = [0, 0, 0], radius = 1 }]\n[output]\nsize = [64, 36]\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n").unwrap();
    desk.window.state_mut().open(&scene).unwrap();
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
