//! What can be added, as menus.

use egui::Ui;
use fumetto_scene::edit::templates::{self, Template};
use fumetto_scene::edit::{Document, Path, Value};

use crate::request::{Request, Requests};
use crate::selection;

/// The button above the tree.
pub(super) fn menu_ui(ui: &mut Ui, document: &Document, selected: &Path, requests: &mut Requests) {
    let menu = ui.menu_button("Add…", |ui| part_ui(ui, document, selected, requests));
    menu.response.on_hover_text("Add an object, a light, or a part of what is selected");
}

/// What can be added to what is at `path`, and to the scene.
pub(super) fn part_ui(ui: &mut Ui, document: &Document, path: &Path, requests: &mut Requests) {
    ui.set_min_width(150.0);
    if let Some(object) = selection::object(path) {
        let text = |key: &str| match document.get(&object.key(key)) {
            Some(Value::String(text)) => text,
            _ => String::new(),
        };
        let kind = text("kind");
        let mut parts = templates::for_object(&kind).peekable();
        if parts.peek().is_some() {
            ui.weak(format!("To {}", text("name")));
            parts.for_each(|template| entry_ui(ui, template, document, &object, requests));
            ui.separator();
        }
    }
    ui.weak("To the scene");
    let mut last = "";
    for template in templates::for_scene() {
        if !last.is_empty() && last != template.list && template.list != "camera" {
            ui.separator();
        }
        last = template.list;
        entry_ui(ui, template, document, &Path::root(), requests);
    }
}

fn entry_ui(ui: &mut Ui, template: &Template, document: &Document, object: &Path, requests: &mut Requests) {
    if ui.button(template.name).on_hover_text(template.docs()).clicked() {
        let list = template.list_in(object);
        requests.edit(template.add(document, object));
        requests.push(Request::Select(list.index(document.count(&list))));
    }
}
