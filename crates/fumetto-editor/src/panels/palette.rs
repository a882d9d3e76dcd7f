//! Every command by a few letters of its name.

use egui::{Context, Key};

use crate::commands::{self, Entry};
use crate::request::{Request, Requests};

/// The field that finds commands, while it is open.
#[derive(Default)]
pub(crate) struct Palette {
    open: bool,
    sought: String,
    chosen: usize,
}

impl Palette {
    pub(crate) fn open(&mut self) {
        *self = Self { open: true, ..Self::default() };
    }

    pub(crate) fn ui(&mut self, ctx: &Context, requests: &mut Requests) {
        if !self.open {
            return;
        }
        let shown = egui::Modal::new(egui::Id::unique("palette")).show(ctx, |ui| {
            ui.set_width(360.0);
            let field = ui.add(
                egui::TextEdit::singleline(&mut self.sought)
                    .hint_text("What do you want to do?")
                    .desired_width(f32::INFINITY),
            );
            field.request_focus();
            if field.changed() {
                self.chosen = 0;
            }
            self.list_ui(ui)
        });
        let done = shown.inner;
        if let Some(entry) = done {
            requests.push(Request::Do(entry.command));
        }
        if done.is_some() || shown.should_close() {
            self.open = false;
        }
    }

    /// The commands found; the one that was chosen.
    fn list_ui(&mut self, ui: &mut egui::Ui) -> Option<&'static Entry> {
        let found: Vec<&Entry> =
            commands::ALL.iter().filter(|entry| matches(entry.name, &self.sought)).collect();
        let (down, up, enter) = ui.input(|input| {
            (
                input.key_pressed(Key::ArrowDown),
                input.key_pressed(Key::ArrowUp),
                input.key_pressed(Key::Enter),
            )
        });
        let last = found.len().saturating_sub(1);
        self.chosen = (self.chosen + usize::from(down)).saturating_sub(usize::from(up)).min(last);
        let mut done = None;
        egui::ScrollArea::vertical().max_height(280.0).show(ui, |ui| {
            for (i, entry) in found.iter().enumerate() {
                let mut button =
                    egui::Button::new(entry.name).selected(i == self.chosen).frame_when_inactive(false);
                if let Some(keys) = &entry.shortcut {
                    button = button.shortcut_text(ui.ctx().format_shortcut(keys));
                }
                let shown = ui.add_sized([ui.available_width(), 22.0], button);
                if i == self.chosen && (down || up) {
                    shown.scroll_to_me(None);
                }
                if shown.clicked() || (enter && i == self.chosen) {
                    done = Some(*entry);
                }
            }
        });
        done
    }
}

/// Whether all letters sought are in the name, in their order.
fn matches(name: &str, sought: &str) -> bool {
    let mut letters = name.chars().flat_map(char::to_lowercase);
    sought
        .chars()
        .filter(|c| !c.is_whitespace())
        .flat_map(char::to_lowercase)
        .all(|c| letters.any(|letter| letter == c))
}

#[cfg(test)]
mod tests {
    use super::matches;

    #[test]
    fn letters_are_found_in_their_order() {
        assert!(matches("Frame selected", "frsel"));
        assert!(matches("Frame selected", ""));
        assert!(!matches("Frame selected", "sf"));
    }
}
