//! Words and names of files.

use egui::{Key, TextEdit, Ui};
use fumetto_scene::edit::{Edit, Path, Step, Value};

use super::row;
use super::sheet::{Sheet, Slot};
use crate::icons::Icon;

pub(super) fn ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>) {
    let shown = slot.value.and_then(Value::as_str).unwrap_or_default();
    let Some(text) = field_ui(ui, slot, shown, ui.available_width(), "") else { return };
    if is_name(slot.path) {
        let path = slot.path.split_last().map(|(named, _)| named).unwrap_or_default();
        return sheet.requests.edit(Edit::Rename { path, name: text });
    }
    sheet.set(slot.path, Value::String(text));
}

/// Objects and cameras are renamed, so that no two have one name.
fn is_name(path: &Path) -> bool {
    matches!(path.steps(), [Step::Key(list), Step::Index(_), Step::Key(key)]
        if key == "name" && matches!(list.as_str(), "object" | "camera"))
}

/// The path of a file, beside the names of what is built in.
pub(super) fn file_ui(
    ui: &mut Ui,
    sheet: &mut Sheet<'_>,
    slot: &Slot<'_>,
    formats: &[String],
    names: &[String],
) {
    const MENU_WIDTH: f32 = 14.0;
    let shown = slot.value.and_then(Value::as_str).unwrap_or_default();
    let hint = formats.iter().map(|format| format!(".{format}")).collect::<Vec<_>>().join(", ");
    let menu = if names.is_empty() { 0.0 } else { MENU_WIDTH + 4.0 };
    let mut said = field_ui(ui, slot, shown, ui.available_width() - menu, &hint);
    if !names.is_empty() {
        let button = row::icon_button(ui, Icon::Down, &format!("Ready-made {}", slot.name.to_lowercase()));
        egui::Popup::menu(&button).show(|ui| {
            for name in names {
                if ui.button(name).clicked() {
                    said = Some(name.clone());
                }
            }
        });
    }
    if let Some(text) = said {
        sheet.set(slot.path, Value::String(text));
    }
}

/// A line of text. What is typed counts once the field is left; Escape leaves it as it was.
pub(super) fn field_ui(ui: &mut Ui, slot: &Slot<'_>, shown: &str, width: f32, hint: &str) -> Option<String> {
    let id = ui.make_persistent_id(("text", slot.path));
    let draft = id.with("draft");
    let mut text = ui.data(|data| data.get_temp::<String>(draft)).unwrap_or_else(|| shown.to_owned());
    let field = TextEdit::singleline(&mut text).id(id).hint_text(hint.to_owned()).clip_text(true);
    let field = ui.add_sized([width, row::HEIGHT - 2.0], field.desired_width(width));
    let field = field.accessible_name(slot.name);
    if field.has_focus() {
        ui.data_mut(|data| data.insert_temp(draft, text));
        return None;
    }
    // What was typed counts now or never: the field may be gone for a while before it is shown again.
    ui.data_mut(|data| data.remove_temp::<String>(draft));
    if !field.lost_focus() {
        return None;
    }
    let is_wanted = !ui.input(|input| input.key_pressed(Key::Escape));
    (is_wanted && text != shown).then_some(text)
}
