use egui::{PointerButton, Pos2};
use egui_kittest::kittest::Queryable;

use fumetto_editor::App;

use crate::desk::Desk;

#[test]
fn a_drag_turns_the_picture_and_a_key_turns_it_back() {
    let mut desk = Desk::open();
    desk.settle();
    let first = desk.look("first");
    let middle = desk.window.get_by_label("Picture").rect().center();
    drag(&mut desk, middle, middle + egui::vec2(160.0, 40.0));
    desk.settle();
    let turned = desk.look("turned");
    assert!(share_of_difference(&first, &turned) > 0.01);
    desk.window.key_press(egui::Key::Num0);
    desk.window.run_steps(2);
    desk.settle();
    let back = desk.look("back");
    assert!(share_of_difference(&first, &back) < 0.001);
}

fn drag(desk: &mut Desk, from: Pos2, to: Pos2) {
    hold(desk, from, to);
    desk.window.drop_at(to);
    desk.window.remove_cursor();
    desk.window.step();
}

/// A drag that is not let go yet.
fn hold(desk: &mut Desk, from: Pos2, to: Pos2) {
    desk.window.hover_at(from);
    desk.window.step();
    desk.window.event(egui::Event::PointerButton {
        pos: from,
        button: PointerButton::Primary,
        pressed: true,
        modifiers: egui::Modifiers::NONE,
    });
    for step in 1..=8 {
        desk.window.hover_at(from.lerp(to, step as f32 / 8.0));
        desk.window.step();
    }
}

fn share_of_difference(a: &[u8], b: &[u8]) -> f32 {
    let differing =
        a.chunks(4).zip(b.chunks(4)).filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 8));
    differing.count() as f32 / (a.len() / 4) as f32
}

#[test]
fn the_gallery_shows_the_scene_in_every_style_and_a_click_takes_one() {
    let mut desk = Desk::open();
    desk.window.key_press(egui::Key::F4);
    desk.wait_until("a full gallery", App::has_full_gallery);
    let before = desk.look("gallery");
    desk.click("comic");
    desk.settle();
    let after = desk.look("comic");
    assert!(share_of_difference(&before, &after) > 0.005);
    assert!(desk.window.state().text().contains("preset = \"comic\""));
    desk.window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    desk.window.run_steps(2);
    assert!(!desk.window.state().text().contains("comic"));
    desk.menu(&["File", "Examples", "cloud-simple.toml"]);
    assert!(!desk.window.state().has_full_gallery(), "what it shows is another scene's");
    desk.wait_until("a full gallery", App::has_full_gallery);
}

#[test]
fn smoke_plays_and_goes_on_where_it_was_when_its_colour_changes() {
    let mut desk = Desk::open();
    desk.menu(&["File", "Examples", "chimney.toml"]);
    desk.settle();
    desk.window.key_press(egui::Key::Space);
    desk.wait_until("frame 12", |app| app.frame() >= 12);
    desk.window.key_press(egui::Key::Space);
    desk.settle();
    desk.look("chimney");
    assert!(desk.window.state().frame() >= 12);
}

#[test]
fn a_particle_is_dragged_and_the_drag_is_one_step() {
    let mut desk = Desk::open();
    desk.menu(&["File", "Examples", "cloud-simple.toml"]);
    desk.settle();
    let before = desk.window.state().text().to_owned();
    let picture = desk.window.get_by_label("Picture").rect();
    // The first particle, as this scene's camera sees it.
    let particle = picture.min + picture.size() * egui::vec2(0.296, 0.64);
    drag(&mut desk, particle, particle - egui::vec2(80.0, 0.0));
    desk.settle();
    desk.look("dragged");
    assert_ne!(desk.window.state().text(), before);
    desk.window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    desk.window.run_steps(2);
    assert_eq!(desk.window.state().text(), before);
}

#[test]
fn a_click_selects_what_is_under_it() {
    let mut desk = Desk::open();
    desk.menu(&["File", "Examples", "cloud-simple.toml"]);
    desk.settle();
    let picture = desk.window.get_by_label("Picture").rect();
    let inside = picture.min + picture.size() * egui::vec2(0.25, 0.6);
    desk.press(inside);
    assert_eq!(desk.window.state().selected(), "object[0].particles[0]");
    let sky = picture.min + picture.size() * egui::vec2(0.05, 0.05);
    desk.press(sky);
    assert_eq!(desk.window.state().selected(), "object[0].particles[0]", "the sky is nothing to select");
}

#[test]
fn a_stroke_lays_a_chain_of_particles_in_one_step() {
    let mut desk = Desk::open();
    desk.menu(&["File", "Examples", "cloud-simple.toml"]);
    desk.settle();
    desk.click("cloud");
    let before = desk.window.state().text().to_owned();
    let picture = desk.window.get_by_label("Picture").rect();
    desk.window.key_down(egui::Key::A);
    desk.window.step();
    let start = picture.min + picture.size() * egui::vec2(0.2, 0.15);
    drag(&mut desk, start, start + egui::vec2(0.6 * picture.width(), 0.0));
    desk.window.key_up(egui::Key::A);
    desk.window.run_steps(2);
    desk.settle();
    desk.look("chain");
    let particles = |text: &str| text.matches("center").count();
    assert!(particles(desk.window.state().text()) >= particles(&before) + 3);
    desk.window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    desk.window.run_steps(2);
    assert_eq!(desk.window.state().text(), before);
}

#[test]
fn a_key_during_a_drag_takes_nothing_from_the_hand() {
    let mut desk = Desk::open();
    desk.menu(&["File", "Examples", "cloud-simple.toml"]);
    desk.settle();
    desk.click("cloud");
    let before = desk.window.state().text().to_owned();
    let picture = desk.window.get_by_label("Picture").rect();
    let particle = picture.min + picture.size() * egui::vec2(0.296, 0.64);
    hold(&mut desk, particle, particle - egui::vec2(40.0, 0.0));
    desk.window.key_down(egui::Key::A);
    desk.window.hover_at(particle - egui::vec2(80.0, 0.0));
    desk.window.step();
    desk.window.drop_at(particle - egui::vec2(80.0, 0.0));
    desk.window.step();
    desk.window.key_up(egui::Key::A);
    desk.settle();
    let count = |text: &str| text.matches("center").count();
    assert_eq!(count(desk.window.state().text()), count(&before), "no chain is laid");
    assert_ne!(desk.window.state().text(), before);
}

#[test]
fn what_went_wrong_is_said_until_it_goes_right() {
    let mut desk = Desk::open();
    let scene = desk.folder.path().join("sky.toml");
    let text = include_str!("../../../../scenes/cloud-simple.toml");
    let text = text.replace("gradient = [\"#5fa9e6\", \"#d9eef2\"]", "image = \"sky.png\"");
    std::fs::write(&scene, text).expect("there is room");
    desk.show(&scene);
    desk.window.run_steps(3);
    desk.window.get_by_label_contains("No such file");
    std::fs::write(desk.folder.path().join("sky.png"), include_bytes!("../../../../scenes/roof.png"))
        .expect("there is room");
    desk.click("cloud");
    desk.window.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::D);
    desk.settle();
    assert!(desk.window.query_by_label_contains("No such file").is_none());
}
