//! A key of the scene, shown as what it is.

use egui::collapsing_header::CollapsingState;
use egui::{RichText, Sense, Ui};
use fumetto_scene::edit::Value;
use fumetto_scene::edit::form::{Field, Kind};

use super::sheet::{Sheet, Slot};
use super::{choice, colour, curve, list, number, ramp, row, sections, text, union};
use crate::icons::Icon;

/// The field's line, and below it what does not fit into a line.
pub(super) fn ui(ui: &mut Ui, sheet: &mut Sheet<'_>, field: &Field) {
    match &field.kind {
        Kind::Table => table_ui(ui, sheet, field),
        Kind::List { .. } => list::ui(ui, sheet, field),
        Kind::Union(_) => union::ui(ui, sheet, field),
        Kind::Curve { .. } | Kind::Ramp => {
            row::ui(ui, sheet, field, |ui, sheet| unset_ui(ui, sheet, field));
            if field.is_set || field.default.is_some() {
                block_ui(ui, sheet, &Slot::of(field));
            }
        }
        _ => row::ui(ui, sheet, field, |ui, sheet| inline_ui(ui, sheet, &Slot::of(field))),
    }
}

/// What fits into a line, as wide as there is room.
pub(super) fn inline_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>) {
    match slot.kind {
        Kind::Bool => switch_ui(ui, sheet, slot),
        Kind::Integer { range, unit } => number::ui(ui, sheet, slot, &number::Look::new(*range, unit, true)),
        Kind::Number { range, unit } => number::ui(ui, sheet, slot, &number::Look::new(*range, unit, false)),
        Kind::Vector { len, whole, range, unit } => {
            number::vector_ui(ui, sheet, slot, *len, &number::Look::new(*range, unit, *whole));
        }
        Kind::Text => text::ui(ui, sheet, slot),
        Kind::File { formats, names } => text::file_ui(ui, sheet, slot, formats, names),
        Kind::Choice(words) => choice::ui(ui, sheet, slot, words),
        Kind::Colour => colour::ui(ui, sheet, slot),
        Kind::Union(_) | Kind::Table | Kind::List { .. } | Kind::Curve { .. } | Kind::Ramp => {}
    }
}

/// Whether a value fits into a line.
pub(super) fn is_inline(kind: &Kind) -> bool {
    !matches!(kind, Kind::Union(_) | Kind::Table | Kind::List { .. } | Kind::Curve { .. } | Kind::Ramp)
}

/// What needs more than a line.
pub(super) fn block_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>) {
    match slot.kind {
        Kind::Curve { x, x_unit, y, y_unit } => {
            curve::ui(ui, sheet, slot, &curve::Axes { x: *x, x_unit, y: *y, y_unit });
        }
        Kind::Ramp => ramp::ui(ui, sheet, slot),
        Kind::List { .. } | Kind::Union(_) => {
            if let Some(field) = sheet.field(slot.path) {
                list::elements_ui(ui, sheet, &field, slot.kind);
            }
        }
        Kind::Table => {
            if let Some(form) = sheet.form(slot.path) {
                indented(ui, |ui| sections::element_ui(ui, sheet, &form));
            }
        }
        _ => inline_ui(ui, sheet, slot),
    }
}

/// What lies in something else.
pub(super) fn indented(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        ui.add_space(12.0);
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing = egui::vec2(4.0, 2.0);
            content(ui);
        });
    });
}

/// Where nothing is said and nothing counts: a button that begins.
pub(super) fn unset_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, field: &Field) {
    if field.is_set || field.default.is_some() {
        return;
    }
    let add = ui.add(egui::Button::new("Add").frame_when_inactive(false));
    if add.accessible_name(format!("Add {}", field.label.to_lowercase())).clicked() {
        sheet.set(&field.path, field.start.clone());
    }
}

fn switch_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>) {
    let is_on = slot.value.and_then(Value::as_bool);
    let mut on = is_on.unwrap_or_default();
    let switch = ui.add(egui::Checkbox::without_text(&mut on).indeterminate(is_on.is_none()));
    if switch.accessible_name(slot.name).changed() {
        sheet.set(slot.path, Value::Boolean(on));
    }
}

/// A table: a heading that folds, and its keys below it.
fn table_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, field: &Field) {
    if !field.is_set && field.default.is_none() {
        return row::ui(ui, sheet, field, |ui, sheet| unset_ui(ui, sheet, field));
    }
    let is_open = heading_ui(ui, sheet, field, field.is_set);
    if is_open && let Some(form) = sheet.form(&field.path) {
        indented(ui, |ui| sections::element_ui(ui, sheet, &form));
    }
}

/// A heading that folds; whether it is open.
pub(super) fn heading_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, field: &Field, is_open: bool) -> bool {
    let id = ui.make_persistent_id(("heading", &field.path));
    let mut state = CollapsingState::load_with_default_open(ui.ctx(), id, is_open);
    row::line(ui, |ui| {
        let openness = state.openness(ui.ctx());
        let text = RichText::new(&field.label);
        let text = if field.is_set { text.strong() } else { text.color(ui.visuals().weak_text_color()) };
        let (icon, fold) = ui.allocate_exact_size(egui::vec2(12.0, row::HEIGHT), Sense::click());
        let heading = ui.add(egui::Label::new(text).selectable(false).sense(Sense::click()));
        let heading = heading.on_hover_ui(|ui| row::docs_ui(ui, &field.docs));
        fold.widget_info(|| {
            let name =
                format!("{} {}", if state.is_open() { "Fold" } else { "Unfold" }, field.label.to_lowercase());
            egui::WidgetInfo::labeled(egui::Role::DisclosureTriangle, true, name)
        });
        let small = egui::Rect::from_center_size(icon.center(), egui::Vec2::splat(9.0));
        Icon::fold(ui.painter(), small, openness, ui.visuals().weak_text_color());
        if heading.clicked() || fold.clicked() {
            state.toggle(ui);
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            row::reset_ui(ui, sheet, field);
        });
    });
    state.store(ui.ctx());
    state.is_open()
}
