//! Values that can have several shapes.

use egui::{RichText, Ui};
use fumetto_scene::edit::Path;
use fumetto_scene::edit::form::{Alternative, Field, Kind};

use super::row::docs_ui;
use super::sheet::{Sheet, Slot};
use super::{choice, field, row};

/// How much of a line the choice of the shape has, where its value stands beside it.
const CHOICE_SHARE: f32 = 0.45;

/// The line of a value with the choice of its shape, and below it what does not fit into the line.
pub(super) fn ui(ui: &mut Ui, sheet: &mut Sheet<'_>, field: &Field) {
    let Kind::Union(alternatives) = &field.kind else { return };
    let present = field.present.and_then(|i| alternatives.get(i));
    let is_inline = present.is_some_and(|present| field::is_inline(&present.kind));
    row::ui(ui, sheet, field, |ui, sheet| {
        let width = if is_inline { CHOICE_SHARE * ui.available_width() } else { ui.available_width() };
        shape_ui(ui, sheet, field, alternatives, width);
        if let Some(present) = present.filter(|_| is_inline) {
            inner_ui(ui, sheet, field, present, field::inline_ui);
        }
    });
    if let Some(present) = present.filter(|_| !is_inline) {
        field::indented(ui, |ui| inner_ui(ui, sheet, field, present, field::block_ui));
    }
}

/// The choice of what an element is, such as a light or a force, above its keys.
pub(super) fn whole_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, field: &Field) {
    let Kind::Union(alternatives) = &field.kind else { return };
    row::line(ui, |ui| {
        let width = sheet.value_x - ui.cursor().left() - 6.0;
        ui.add_sized([width, row::HEIGHT], |ui: &mut Ui| {
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                ui.label(RichText::new("Kind"))
            })
            .inner
        });
        shape_ui(ui, sheet, field, alternatives, ui.available_width() - 18.0);
    });
}

fn shape_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, field: &Field, alternatives: &[Alternative], width: f32) {
    let slot = Slot { name: &format!("{} as", field.label), ..Slot::of(field) };
    let present = field.present.and_then(|i| alternatives.get(i));
    let shown = present.map_or("—", |present| present.name.as_str());
    let chosen = choice::combo_ui(ui, &slot, width, shown, &mut |ui| {
        let mut chosen = None;
        for (i, alternative) in alternatives.iter().enumerate() {
            let entry = ui.selectable_label(field.present == Some(i), &alternative.name);
            let entry = match alternative.docs.summary.is_empty() {
                true => entry,
                false => entry.on_hover_ui(|ui| docs_ui(ui, &alternative.docs)),
            };
            if entry.clicked() {
                chosen = Some(i);
            }
        }
        chosen
    });
    let Some(i) = chosen.filter(|i| field.present != Some(*i)) else { return };
    let present = sheet.document.get(&field.path).or_else(|| field.default.clone());
    if let Some(value) = field.switched(i, present.as_ref()) {
        sheet.set(&field.path, value);
    }
}

/// What the present shape holds: the value itself, or what is under the shape's key.
fn inner_ui(
    ui: &mut Ui,
    sheet: &mut Sheet<'_>,
    field: &Field,
    present: &Alternative,
    show: fn(&mut Ui, &mut Sheet<'_>, &Slot<'_>),
) {
    let whole = Slot::of(field);
    let path: Path = present.key.as_ref().map_or_else(|| field.path.clone(), |key| field.path.key(key));
    let within = |value| match &present.key {
        Some(key) => fumetto_scene::edit::Value::get(value, key.as_str()),
        None => Some(value),
    };
    let start = within(&present.start).unwrap_or(&present.start);
    let value = whole.value.and_then(within);
    show(ui, sheet, &Slot { path: &path, name: whole.name, kind: &present.kind, value, start });
}
