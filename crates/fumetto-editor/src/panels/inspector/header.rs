//! What is selected, and the way to it.

use egui::{RichText, Ui};
use fumetto_scene::edit::{Document, Path, Step, Value};

use crate::request::{Request, Requests};
use crate::selection;

/// The way from the scene to what is selected, and for the scene and its objects the choice between them and their
/// style.
pub(super) fn ui(ui: &mut Ui, document: &Document, selected: &Path, requests: &mut Requests) {
    let mut way = Vec::new();
    let mut here = Some(selected.clone());
    while let Some(path) = here {
        here = path.split_last().map(|(parent, _)| parent);
        if !matches!(path.steps(), [Step::Key(_)]) || document.count(&path) == 0 {
            way.push(path);
        }
    }
    way.retain(|path| !is_style(path) && !is_plain_list(path));
    way.reverse();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let last = way.len().saturating_sub(1);
        for (i, path) in way.iter().enumerate() {
            let name = name(document, path);
            if i == last {
                ui.label(RichText::new(name).strong());
            } else {
                if ui.link(RichText::new(name).weak()).clicked() {
                    requests.push(Request::Select(path.clone()));
                }
                ui.weak("›");
            }
        }
    });
    tabs_ui(ui, selected, requests);
}

/// Between what a thing is and how it is drawn.
fn tabs_ui(ui: &mut Ui, selected: &Path, requests: &mut Requests) {
    let thing = selection::object(selected).unwrap_or_default();
    let style = thing.key("style");
    if *selected != thing && *selected != style {
        return;
    }
    let name = if thing == Path::root() { "Scene" } else { "Object" };
    ui.add_space(2.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        let width = 0.5 * (ui.available_width() - 2.0);
        for (name, path) in [(name, thing), ("Style", style)] {
            let tab = egui::Button::new(name).selected(*selected == path).min_size(egui::vec2(width, 22.0));
            if ui.add(tab).clicked() {
                requests.push(Request::Select(path));
            }
        }
    });
}

fn is_style(path: &Path) -> bool {
    matches!(path.steps().last(), Some(Step::Key(key)) if key == "style")
}

/// Lists on the way to an element say nothing that the element does not.
fn is_plain_list(path: &Path) -> bool {
    matches!(path.steps(), [Step::Key(list)] if matches!(list.as_str(), "object" | "light" | "camera"))
}

/// What something is called.
fn name(document: &Document, path: &Path) -> String {
    let text = |key: &str| match document.get(&path.key(key)) {
        Some(Value::String(text)) => Some(text),
        _ => None,
    };
    match path.split_last() {
        None => "Scene".to_owned(),
        Some((_, Step::Key(key))) => plain(key),
        Some((list, Step::Index(index))) => {
            let number = || match list.steps().last() {
                Some(Step::Key(key)) => format!("{} {}", plain(key), index + 1),
                _ => format!("{}", index + 1),
            };
            text("name").or_else(|| text("kind").map(|kind| plain(&kind))).unwrap_or_else(number)
        }
    }
}

/// A key for people.
fn plain(key: &str) -> String {
    let mut letters = key.chars().map(|letter| if matches!(letter, '_' | '-') { ' ' } else { letter });
    letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect()
}
