//! The menus: every command by name, and the examples.

use egui::Ui;

use crate::app::Goal;
use crate::commands::{self, Command, Menu};
use crate::examples::EXAMPLES;
use crate::project::Project;
use crate::request::{Request, Requests};
use crate::settings::Settings;
use crate::view::Navigation;

/// The bar at the top of the window.
pub(crate) fn ui(ui: &mut Ui, project: &Project, settings: &mut Settings, requests: &mut Requests) {
    egui::MenuBar::new().ui(ui, |ui| {
        for menu in Menu::ALL {
            ui.menu_button(menu.name(), |ui| {
                entries_ui(ui, menu, project, settings, requests);
                if menu == Menu::File {
                    ui.separator();
                    examples_ui(ui, requests);
                    recent_ui(ui, settings, requests);
                }
                if menu == Menu::View {
                    ui.separator();
                    navigation_ui(ui, settings);
                }
            });
        }
        ui.separator();
        let changed = if project.document().is_changed() { " •" } else { "" };
        ui.weak(format!("{}{changed}", project.name()));
    });
}

fn entries_ui(ui: &mut Ui, menu: Menu, project: &Project, settings: &Settings, requests: &mut Requests) {
    for entry in commands::ALL.iter().filter(|entry| entry.menu == menu) {
        let document = project.document();
        let (name, enabled) = match entry.command {
            Command::Undo => step_name("Undo", document.undo_label()),
            Command::Redo => step_name("Redo", document.redo_label()),
            _ => (entry.name.to_owned(), true),
        };
        let mut button = egui::Button::new(name);
        if let Some(keys) = &entry.shortcut {
            button = button.shortcut_text(ui.ctx().format_shortcut(keys));
        }
        button = button.selected(is_on(entry.command, settings));
        if ui.add_enabled(enabled, button).clicked() {
            requests.push(Request::Do(entry.command));
        }
    }
}

fn step_name(verb: &str, label: Option<&str>) -> (String, bool) {
    match label {
        Some(label) => (format!("{verb} “{label}”"), true),
        None => (verb.to_owned(), false),
    }
}

/// Whether a command shows something that is shown already.
fn is_on(command: Command, settings: &Settings) -> bool {
    match command {
        Command::ToggleTree => settings.tree,
        Command::ToggleInspector => settings.inspector,
        Command::ToggleStyles => settings.styles,
        Command::ToggleText => settings.text,
        Command::ToggleGrid => settings.grid,
        Command::ToggleTimes => settings.times,
        _ => false,
    }
}

fn examples_ui(ui: &mut Ui, requests: &mut Requests) {
    ui.menu_button("Examples", |ui| {
        for (index, example) in EXAMPLES.iter().enumerate() {
            if ui.button(example.name).on_hover_text(example.shows).clicked() {
                requests.push(Request::Leave(Goal::Example(index)));
            }
        }
    });
}

fn recent_ui(ui: &mut Ui, settings: &Settings, requests: &mut Requests) {
    ui.add_enabled_ui(!settings.recent.is_empty(), |ui| {
        ui.menu_button("Recent", |ui| {
            for path in &settings.recent {
                let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
                if ui.button(name).on_hover_text(path.display().to_string()).clicked() {
                    requests.push(Request::Leave(Goal::File(path.clone())));
                }
            }
        });
    });
}

fn navigation_ui(ui: &mut Ui, settings: &mut Settings) {
    ui.menu_button("Moving about", |ui| {
        for navigation in Navigation::ALL {
            ui.radio_value(&mut settings.navigation, navigation, navigation.name());
        }
    });
}
