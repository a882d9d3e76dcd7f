//! The scene as a tree: what there is, in the order of the file.

mod add;
mod row;
mod rows;

use std::collections::BTreeSet;

use egui::{Key, Rect, ScrollArea, Ui, vec2};
use fumetto_scene::edit::{Document, Path};

use self::row::{Deed, ROW_HEIGHT};
use self::rows::{Row, rows};
use crate::request::{Request, Requests};
use crate::selection;

/// The rows, and what is being done to them.
#[derive(Default)]
pub(crate) struct Tree {
    rows: Vec<Row>,
    /// What the rows were made from.
    revision: Option<u64>,
    /// Rows that are folded where they would be open, or open where they would be folded.
    toggled: BTreeSet<Path>,
    /// What gets another name, and the name so far.
    renaming: Option<(Path, String)>,
    /// The selection that was scrolled to.
    shown: Path,
}

impl Tree {
    /// Begins to rename what is selected, if it has a name.
    pub(crate) fn rename(&mut self, selected: &Path) {
        let named = self.rows.iter().find(|row| row.has_name && row.path == *selected);
        self.renaming = named.map(|row| (row.path.clone(), row.label.clone()));
    }

    pub(crate) fn ui(&mut self, ui: &mut Ui, document: &Document, selected: &Path, requests: &mut Requests) {
        if self.revision != Some(document.revision()) {
            self.revision = Some(document.revision());
            self.rows = rows(document, &self.toggled);
        }
        ui.add_space(4.0);
        ui.horizontal(|ui| add::menu_ui(ui, document, selected, requests));
        ui.add_space(2.0);
        let current = self.current(selected);
        let is_covered = ui.memory(|memory| memory.top_modal_layer().is_some());
        if !is_covered && !ui.ctx().egui_wants_keyboard_input() {
            self.keys_ui(ui, current, requests);
        }
        ui.spacing_mut().item_spacing.y = 0.0;
        ScrollArea::vertical().auto_shrink(false).show_rows(ui, ROW_HEIGHT, self.rows.len(), |ui, range| {
            if self.shown != *selected {
                self.shown = selected.clone();
                let top = ui.max_rect().top() + (current as f32 - range.start as f32) * ROW_HEIGHT;
                let left_top = egui::pos2(ui.max_rect().left(), top);
                ui.scroll_to_rect(Rect::from_min_size(left_top, vec2(1.0, ROW_HEIGHT)), None);
            }
            for index in range {
                self.row_ui(ui, index, index == current, document, requests);
            }
        });
    }

    /// The row that is selected, or in which what is selected lies.
    fn current(&self, selected: &Path) -> usize {
        let holds = |(_, row): &(usize, &Row)| selected.starts_with(&row.path);
        let inmost = self.rows.iter().enumerate().filter(holds).max_by_key(|(_, row)| row.path.steps().len());
        inmost.map_or(0, |(index, _)| index)
    }

    fn keys_ui(&self, ui: &Ui, current: usize, requests: &mut Requests) {
        let (up, down) =
            ui.input(|input| (input.key_pressed(Key::ArrowUp), input.key_pressed(Key::ArrowDown)));
        let next = (current + usize::from(down)).saturating_sub(usize::from(up));
        if let Some(row) = self.rows.get(next).filter(|_| next != current) {
            requests.push(Request::Select(row.path.clone()));
        }
    }

    fn row_ui(
        &mut self,
        ui: &mut Ui,
        index: usize,
        is_selected: bool,
        document: &Document,
        requests: &mut Requests,
    ) {
        let row = &self.rows[index];
        let path = row.path.clone();
        let name = self.renaming.as_mut().filter(|(renamed, _)| *renamed == path).map(|(_, name)| name);
        let Some(deed) = row::ui(ui, row, name, is_selected, requests, |ui, requests| {
            add::part_ui(ui, document, &path, requests);
        }) else {
            return;
        };
        match deed {
            Deed::Fold => {
                if !self.toggled.remove(&path) {
                    self.toggled.insert(path);
                }
                self.revision = None;
                ui.request_repaint();
            }
            Deed::Rename => self.rename(&path),
            Deed::ShowText => {
                // The scene itself begins where its text does.
                requests.push(Request::ShowText(document.span(&path).unwrap_or(0..0)));
            }
            Deed::Renamed => self.renaming = None,
            Deed::Shift { down } => {
                if let Some((edit, next)) = selection::shift(document, &path, down) {
                    requests.edit(edit);
                    requests.push(Request::Select(next));
                }
            }
        }
    }
}
