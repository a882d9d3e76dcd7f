//! The scene file as text, for those who write by hand.

use std::ops::Range;

use egui::text::{CCursor, CCursorRange};
use egui::{TextEdit, Ui};
use fumetto_scene::edit::Edit;

use crate::project::Project;
use crate::request::{Request, Requests};

/// Edits of the text join each other until the field is left.
const GESTURE: &str = "text";

/// The text's field. `jump` is a place to go to, in bytes.
pub(crate) fn ui(ui: &mut Ui, project: &Project, jump: &mut Option<Range<usize>>, requests: &mut Requests) {
    let mut text = project.document().text().to_owned();
    egui::ScrollArea::both().auto_shrink(false).show(ui, |ui| {
        let editor =
            TextEdit::multiline(&mut text).code_editor().desired_width(f32::INFINITY).desired_rows(12);
        // What the field itself takes back belongs to one scene.
        let editor = editor.id_salt(project.id());
        let mut shown = editor.show(ui);
        let response = &shown.response.response;
        if response.changed() {
            requests.drag(GESTURE, Edit::ReplaceText(text.clone()));
        }
        if response.lost_focus() {
            requests.push(Request::EndGesture);
        }
        if let Some(span) = jump.take() {
            let at = |byte: usize| CCursor::new(text.get(..byte).map_or(0, |before| before.chars().count()));
            let range = CCursorRange::two(at(span.start), at(span.end));
            shown.state.cursor.set_char_range(Some(range));
            shown.state.store(ui.ctx(), response.id);
            response.request_focus();
            let place = shown.galley.pos_from_cursor(range.primary).translate(shown.galley_pos.to_vec2());
            ui.scroll_to_rect(place, Some(egui::Align::Center));
        }
    });
}
