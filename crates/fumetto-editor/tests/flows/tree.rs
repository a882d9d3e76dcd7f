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

#[test]
fn a_row_for_many_parts_is_not_its_object() {
    let mut desk = Desk::open();
    let particles = ["{ center = [0, 0, 0], radius = 1 }"; 9].join(", ");
    let scene = desk.folder.path().join("many.toml");
    let text = format!(
        "format = 1\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n[[object]]\nname = \"ball\"\nkind = \"cloud\"\nparticles = [{particles}]\n"
    );
    std::fs::write(&scene, &text).expect("there is room");
    desk.show(&scene);
    desk.window.run_steps(2);
    desk.click("Particle");
    assert_eq!(desk.window.state().selected(), "object[0].particles");
    desk.window.key_press(Key::Delete);
    desk.window.run_steps(2);
    desk.window.key_press_modifiers(Modifiers::COMMAND, Key::D);
    desk.window.run_steps(2);
    assert_eq!(desk.window.state().text(), text);
}

#[test]
fn a_row_leads_to_its_place_in_the_text() {
    let mut desk = Desk::open();
    desk.window.get_by_label("cumulus").click_secondary();
    desk.window.run_steps(2);
    desk.click("Show in the text");
    let field = desk.window.get_by(|node| node.role() == egui::Role::MultilineTextInput);
    assert!(field.is_focused());
}
