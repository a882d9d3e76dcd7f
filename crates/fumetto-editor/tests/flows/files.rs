#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::fs;

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use crate::desk::Desk;

const SCENE: &str = "# mine\nformat = 1\n\n[[object]]\nname = \"ball\"\nkind = \"cloud\"\nparticles = [{ center = [0.0, 0.0, 0.0], radius = 1.0 }] # one\n\n[output]\nsize = [64, 36]\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n";

#[test]
fn a_scene_is_opened_changed_and_saved_with_its_comments() {
    let mut desk = Desk::open();
    let scene = desk.folder.path().join("ball.toml");
    fs::write(&scene, SCENE).unwrap();
    desk.window.state_mut().open(&scene).unwrap();
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
    desk.window.state_mut().open(&scene).unwrap();
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

#[test]
fn what_a_crash_left_is_offered_again() {
    let folder = tempfile::tempdir().unwrap();
    let left = folder.path().join("scene-1.toml");
    fs::write(folder.path().join("scene-1.lock"), "").unwrap();
    fs::write(&left, format!("#fumetto-autosave \n{SCENE}")).unwrap();
    let mut desk = Desk::open_with(folder);
    desk.window.run_steps(2);
    desk.click("Recover");
    assert_eq!(desk.window.state().text(), SCENE);
    assert!(!left.exists(), "it is offered once");
}

#[test]
fn a_disk_that_refuses_costs_nothing() {
    let mut desk = Desk::open();
    let folder = desk.folder.path().join("gone");
    fs::create_dir(&folder).unwrap();
    let scene = folder.join("ball.toml");
    fs::write(&scene, SCENE).unwrap();
    desk.window.state_mut().open(&scene).unwrap();
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
    desk.window.state_mut().open(&scene).unwrap();
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
