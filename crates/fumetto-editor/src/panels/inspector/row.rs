//! The line of one value: what it is called, what it is, and a way back to its default.

use egui::{Align, Label, Layout, Response, RichText, Role, Sense, Ui, WidgetInfo, vec2};
use fumetto_scene::edit::form::{Docs, Field};

use super::sheet::Sheet;
use crate::icons::Icon;

/// In points.
pub(super) const HEIGHT: f32 = 22.0;
/// The place of the button that resets.
const RESET_WIDTH: f32 = 18.0;
const GAP: f32 = 6.0;

/// Shows a field's label, what `value_ui` shows beside it, and the way back.
pub(super) fn ui(
    ui: &mut Ui,
    sheet: &mut Sheet<'_>,
    field: &Field,
    value_ui: impl FnOnce(&mut Ui, &mut Sheet<'_>),
) {
    line(ui, |ui| {
        let width = (sheet.value_x - ui.cursor().left() - GAP).max(40.0);
        label_ui(ui, field, width);
        value(ui, sheet, field.is_set, value_ui);
        reset_ui(ui, sheet, field);
    });
}

/// A line over the whole width.
pub(super) fn line<R>(ui: &mut Ui, content: impl FnOnce(&mut Ui) -> R) -> R {
    let size = vec2(ui.available_width(), HEIGHT);
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_size(size);
        ui.spacing_mut().item_spacing.x = 4.0;
        content(ui)
    })
    .inner
}

fn label_ui(ui: &mut Ui, field: &Field, width: f32) -> Response {
    let text = RichText::new(&field.label);
    let text = if field.is_set { text } else { text.color(ui.visuals().weak_text_color()) };
    ui.allocate_ui_with_layout(vec2(width, HEIGHT), Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_size(vec2(width, HEIGHT));
        ui.add(Label::new(text).truncate().selectable(false).sense(Sense::hover()))
    })
    .inner
    .on_hover_ui(|ui| docs_ui(ui, &field.docs))
}

/// The room for a value; what is not set is shown weak.
fn value(ui: &mut Ui, sheet: &mut Sheet<'_>, is_set: bool, value_ui: impl FnOnce(&mut Ui, &mut Sheet<'_>)) {
    let size = vec2((ui.available_width() - RESET_WIDTH).max(40.0), HEIGHT);
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_size(size);
        ui.set_max_width(size.x);
        if !is_set {
            ui.visuals_mut().override_text_color = Some(ui.visuals().weak_text_color());
        }
        value_ui(ui, sheet);
    });
}

/// The way back to the default, where a value is set that need not be.
pub(super) fn reset_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, field: &Field) {
    if field.is_set && !field.is_required {
        let name = format!("Reset {}", field.label.to_lowercase());
        if icon_button(ui, Icon::Reset, &name).clicked() {
            sheet.remove(&field.path);
        }
    }
}

/// A small button without a frame.
pub(super) fn icon_button(ui: &mut Ui, icon: Icon, name: &str) -> Response {
    let (rect, button) = ui.allocate_exact_size(vec2(RESET_WIDTH - 4.0, HEIGHT), Sense::click());
    button.widget_info(|| WidgetInfo::labeled(Role::Button, ui.is_enabled(), name));
    let colour =
        if button.hovered() { ui.visuals().strong_text_color() } else { ui.visuals().weak_text_color() };
    icon.paint(ui.painter(), rect.shrink2(vec2(0.0, 5.0)), colour);
    button.on_hover_text(name)
}

/// What a key means, in the words of the format.
pub(super) fn docs_ui(ui: &mut Ui, docs: &Docs) {
    ui.set_max_width(300.0);
    ui.label(&docs.summary);
    if !docs.details.is_empty() {
        ui.weak(&docs.details);
    }
}
