use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

use crate::desk::Desk;

#[test]
fn a_light_is_added_named_and_taken_back() {
    let mut desk = Desk::open();
    desk.settle();
    let before = desk.window.state().text().to_owned();
    desk.menu(&["Add…", "Point"]);
    assert_eq!(desk.window.state().selected(), "light[1]");
    assert!(desk.window.state().text().contains("kind = \"point\""));
    desk.settle();
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    desk.window.run_steps(2);
    assert_eq!(desk.window.state().text(), before);
}

#[test]
fn an_object_is_renamed_in_its_place() {
    let mut desk = Desk::open();
    desk.settle();
    desk.click("cumulus");
    desk.window.key_press(Key::Enter);
    desk.window.run_steps(2);
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::A);
    desk.window.event(egui::Event::Text("tower".into()));
    desk.window.run_steps(2);
    desk.window.key_press(Key::Enter);
    desk.window.run_steps(2);
    assert!(desk.window.state().text().contains("name = \"tower\""));
}

#[test]
fn the_last_object_can_go_and_the_picture_stays() {
    let mut desk = Desk::open();
    desk.settle();
    desk.click("cumulus");
    desk.window.key_press(Key::Delete);
    desk.window.run_steps(2);
    desk.settle();
    assert_eq!(desk.window.state().selected(), "");
    desk.window.get_by_label_contains("the scene has no object");
}
