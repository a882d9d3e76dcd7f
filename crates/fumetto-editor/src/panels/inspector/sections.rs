//! In which order keys are shown, and under which headings.

use egui::{RichText, Ui};
use fumetto_scene::edit::Step;
use fumetto_scene::edit::form::{Field, Form, Kind};

use super::field;
use super::sheet::Sheet;

/// The keys of a style, by what they are for. What is new in the format comes last.
const STYLE: [(&str, &[&str]); 5] = [
    ("", &["preset", "file"]),
    ("Tones", &["tones", "ramp", "gooch", "clean", "material", "material_steps"]),
    ("Light", &["form", "form_scale", "wrap", "shadow", "highlight", "rim", "exaggerate"]),
    ("Lines", &["ink", "hatching"]),
    ("Besides", &["mask", "shading", "height"]),
];

/// The scene's own lists are in the tree, and its style has a tab; its format is not for people.
const NOT_OF_SCENE: [&str; 5] = ["format", "camera", "light", "object", "style"];

/// All keys of a style.
pub(super) fn style_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, form: &Form) {
    let known = |field: &&Field| STYLE.iter().any(|(_, keys)| keys.contains(&key(field)));
    for (heading, keys) in STYLE {
        if !heading.is_empty() {
            heading_ui(ui, heading);
        }
        for key in keys {
            if let Some(field) = form.field(key) {
                field::ui(ui, sheet, field);
            }
        }
    }
    for field in form.fields.iter().filter(|field| !known(field)) {
        field::ui(ui, sheet, field);
    }
}

/// What is said of the scene as a whole.
pub(super) fn scene_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, form: &Form) {
    for field in form.fields.iter().filter(|field| !NOT_OF_SCENE.contains(&key(field))) {
        field::ui(ui, sheet, field);
    }
}

/// The keys of any other table: those in a line first, then those that hold more.
pub(super) fn element_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, form: &Form) {
    let (tables, lines): (Vec<&Field>, Vec<&Field>) = form
        .fields
        .iter()
        .filter(|field| key(field) != "style" || !matches!(field.kind, Kind::Table) || !is_of_object(field))
        .partition(|field| matches!(field.kind, Kind::Table | Kind::List { .. }));
    for field in lines.into_iter().chain(tables) {
        field::ui(ui, sheet, field);
    }
}

/// The style of an object has a tab of its own.
fn is_of_object(field: &Field) -> bool {
    matches!(field.path.steps(), [Step::Key(list), Step::Index(_), _] if list == "object")
}

fn key(field: &Field) -> &str {
    match field.path.steps().last() {
        Some(Step::Key(key)) => key,
        _ => "",
    }
}

fn heading_ui(ui: &mut Ui, heading: &str) {
    ui.add_space(6.0);
    ui.label(RichText::new(heading).strong().size(12.0));
    ui.add_space(1.0);
}
