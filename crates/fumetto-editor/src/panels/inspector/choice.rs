//! One of several words.

use egui::{ComboBox, Ui};
use fumetto_scene::edit::Value;
use fumetto_scene::edit::form::Word;

use super::row::docs_ui;
use super::sheet::{Sheet, Slot};

pub(super) fn ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>, words: &[Word]) {
    let present = slot.value.and_then(Value::as_str);
    let names: Vec<&str> = words.iter().map(|word| word.word.as_str()).collect();
    let place = present.and_then(|present| names.iter().position(|name| *name == present));
    let chosen = combo_ui(ui, slot, ui.available_width(), present.unwrap_or("—"), &mut |ui| {
        let mut chosen = None;
        for (i, word) in words.iter().enumerate() {
            let entry = ui.selectable_label(place == Some(i), &word.word);
            let entry = match word.docs.summary.is_empty() {
                true => entry,
                false => entry.on_hover_ui(|ui| docs_ui(ui, &word.docs)),
            };
            if entry.clicked() {
                chosen = Some(i);
            }
        }
        chosen
    });
    if let Some(i) = chosen.filter(|i| place != Some(*i)) {
        sheet.set(slot.path, Value::String(words[i].word.clone()));
    }
}

/// A list that drops down; what was chosen of it.
pub(super) fn combo_ui(
    ui: &mut Ui,
    slot: &Slot<'_>,
    width: f32,
    shown: &str,
    entries_ui: &mut dyn FnMut(&mut Ui) -> Option<usize>,
) -> Option<usize> {
    // A weak label is for what is not set; what could be set is not weak.
    let combo = ComboBox::from_id_salt(("choice", slot.path)).width(width).truncate().selected_text(shown);
    let combo = combo.show_ui(ui, |ui| {
        ui.visuals_mut().override_text_color = None;
        entries_ui(ui)
    });
    combo.response.accessible_name(slot.name);
    combo.inner.flatten()
}
