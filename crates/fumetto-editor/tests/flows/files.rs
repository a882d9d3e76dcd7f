#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::fs;
use std::path::Path;

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use crate::desk::Desk;

const SCENE: &str = "# mine\nformat = 1\n\n[[object]]\nname = \"ball\"\nkind = \"cloud\"\nparticles = [{ center = [0.0, 0.0, 0.0], radius = 1.0 }] # one\n\n[output]\nsize = [64, 36]\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n";

#[test]
fn a_scene_is_opened_changed_and_saved_with_its_comments() {
    let mut desk = Desk::open();
    let scene = desk.folder.path().join("ball.toml");
    fs::write(&scene, SCENE).unwrap();
    desk.show(&scene);
    desk.settle();
    desk.click("ball");
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::D);
    desk.window.run_steps(2);
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    desk.window.run_steps(2);
    let saved = fs::read_to_string(&scene).unwrap();
    assert!(saved.contains("ball 2") && saved.starts_with("# mine\n") && saved.contains("# one"), "{saved}");
    assert_eq!(saved, desk.window.state().text());
}

#[test]
fn changes_are_not_left_without_a_question() {
    let mut desk = Desk::open();
    let scene = desk.folder.path().join("ball.toml");
    fs::write(&scene, SCENE).unwrap();
    desk.show(&scene);
    desk.settle();
    desk.click("ball");
    desk.window.key_press(Key::Delete);
    desk.window.run_steps(2);
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::N);
    desk.window.run_steps(2);
    desk.click("Cancel");
    assert!(desk.window.state().text().starts_with("# mine"), "cancelling stays");
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::N);
    desk.window.run_steps(2);
    desk.window.get_by_role_and_label(egui::Role::Button, "Save").click();
    desk.window.run_steps(4);
    assert!(!desk.window.state().text().starts_with("# mine"), "then the new scene is there");
    assert!(!fs::read_to_string(&scene).unwrap().contains("ball"), "and the old one is saved");
}

/// What an editor leaves that ends unexpectedly.
fn leave(folder: &Path, name: &str, kept: &str) {
    fs::write(folder.join(name).with_extension("lock"), "").unwrap();
    fs::write(folder.join(name).with_extension("toml"), kept).unwrap();
}

/// The texts that would be offered after a crash.
fn kept(folder: &Path) -> Vec<String> {
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let texts = files.filter(|file| file.extension().is_some_and(|ending| ending == "toml"));
    texts.map(|file| fs::read_to_string(file).unwrap()).collect()
}

#[test]
fn what_a_crash_left_is_offered_again() {
    let folder = tempfile::tempdir().unwrap();
    leave(folder.path(), "scene-1", &format!("#fumetto-autosave \n{SCENE}"));
    let mut desk = Desk::open_with(folder);
    desk.window.run_steps(2);
    desk.click("Recover");
    assert_eq!(desk.window.state().text(), SCENE);
    assert!(!desk.folder.path().join("scene-1.toml").exists(), "it is offered once");
    assert_eq!(kept(desk.folder.path()), [format!("#fumetto-autosave \n{SCENE}")], "and kept anew");
}

#[test]
fn of_two_scenes_that_a_crash_left_none_is_lost() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("ball.scene");
    fs::write(&scene, SCENE).unwrap();
    let own = format!("#fumetto-autosave {}\n{SCENE}# more\n", scene.display());
    leave(folder.path(), "scene-1", &own);
    leave(folder.path(), "scene-2", &own.replace("# more", "# most"));
    let mut desk = Desk::open_with(folder);
    desk.window.run_steps(2);
    desk.click("Recover");
    desk.window.run_steps(2);
    let first = desk.window.state().text().to_owned();
    assert!(desk.window.query_by_label("Recover").is_none(), "one after the other");
    assert_eq!(kept(desk.folder.path()).len(), 2);
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    desk.window.run_steps(3);
    assert_eq!(fs::read_to_string(&scene).unwrap(), first);
    desk.click("Recover");
    let second = desk.window.state().text();
    assert!(second != first && second.contains("# mo") && kept(desk.folder.path())[0].ends_with(second));
}

#[test]
fn what_is_typed_into_one_scene_is_not_taken_back_in_another() {
    let mut desk = Desk::open();
    desk.window.key_press(Key::F6);
    desk.window.run_steps(2);
    let type_into = |desk: &mut Desk, text: &str| {
        let field = desk.window.get_by(|node| node.role() == egui::Role::MultilineTextInput);
        field.focus();
        desk.window.run_steps(2);
        desk.window.event(egui::Event::Text(text.into()));
        desk.window.run_steps(2);
    };
    type_into(&mut desk, "# first\n");
    let scene = desk.folder.path().join("ball.toml");
    fs::write(&scene, SCENE).unwrap();
    desk.show(&scene);
    desk.window.run_steps(2);
    type_into(&mut desk, "# second\n");
    for _ in 0..4 {
        desk.window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        desk.window.run_steps(2);
    }
    assert!(desk.window.state().text().contains("# mine"), "{}", desk.window.state().text());
    assert!(!desk.window.state().text().contains("# first"));
}

#[test]
fn a_disk_that_refuses_costs_nothing() {
    let mut desk = Desk::open();
    let folder = desk.folder.path().join("gone");
    fs::create_dir(&folder).unwrap();
    let scene = folder.join("ball.toml");
    fs::write(&scene, SCENE).unwrap();
    desk.show(&scene);
    fs::remove_dir_all(&folder).unwrap();
    desk.settle();
    desk.click("ball");
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::D);
    desk.window.run_steps(2);
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    desk.window.run_steps(2);
    desk.window.get_by_label_contains("there is no folder");
    assert!(desk.window.state().text().contains("ball 2"), "the work is still there");
}

#[test]
fn what_another_program_wrote_is_not_lost_unseen() {
    let mut desk = Desk::open();
    let scene = desk.folder.path().join("ball.toml");
    fs::write(&scene, SCENE).unwrap();
    desk.show(&scene);
    desk.settle();
    desk.click("ball");
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::D);
    desk.window.run_steps(2);
    fs::write(&scene, "# another's\n").unwrap();
    let save = |desk: &mut Desk| {
        desk.window.key_press_modifiers(Modifiers::COMMAND, Key::S);
        desk.window.run_steps(2);
        fs::read_to_string(&scene).unwrap()
    };
    assert_eq!(save(&mut desk), "# another's\n");
    desk.window.get_by_label_contains("changed by another program");
    assert!(save(&mut desk).contains("ball 2"), "who saves once more means it");
}
