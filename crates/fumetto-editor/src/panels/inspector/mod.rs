//! All that the scene says about what is selected, and all that it could say.

mod choice;
mod colour;
mod curve;
mod field;
mod header;
mod list;
mod number;
mod points;
mod ramp;
mod row;
mod sections;
mod sheet;
mod text;
mod union;

use egui::{ScrollArea, Ui};
use fumetto_scene::edit::form::Kind;
use fumetto_scene::edit::{Document, Path, Step};

use self::sheet::{Forms, Sheet};
use crate::request::{Request, Requests};

/// How much of the panel's width labels have.
const LABEL_SHARE: f32 = 0.4;

/// The forms that are shown.
#[derive(Default)]
pub(crate) struct Inspector {
    forms: Forms,
}

impl Inspector {
    pub(crate) fn ui(&mut self, ui: &mut Ui, document: &Document, selected: &Path, requests: &mut Requests) {
        self.forms.keep_up(document);
        ui.add_space(4.0);
        header::ui(ui, document, selected, requests);
        ui.separator();
        let mut sheet = Sheet::new(document, &mut self.forms, requests);
        ScrollArea::vertical().auto_shrink(false).id_salt(selected).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 2.0;
            sheet.value_x = ui.max_rect().left() + LABEL_SHARE * ui.available_width();
            body_ui(ui, &mut sheet, selected);
            ui.add_space(12.0);
        });
        // Whatever was being dragged is let go of now: what comes next is another step.
        if ui.input(|input| input.pointer.any_released()) {
            requests.push(Request::EndGesture);
        }
    }
}

fn body_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, selected: &Path) {
    if let Some(field) = sheet.field(selected).filter(|field| !matches!(field.kind, Kind::Table)) {
        match &field.kind {
            Kind::Union(_) => union::whole_ui(ui, sheet, &field),
            _ => return field::ui(ui, sheet, &field),
        }
    }
    let Some(form) = sheet.form(selected) else {
        ui.weak("Nothing can be set here.");
        return;
    };
    match selected.steps().last() {
        Some(Step::Key(key)) if key == "style" => sections::style_ui(ui, sheet, &form),
        None => sections::scene_ui(ui, sheet, &form),
        _ => sections::element_ui(ui, sheet, &form),
    }
}
