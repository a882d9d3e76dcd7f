//! Lists: their elements, each with a way to move it and to take it away.

use egui::Ui;
use fumetto_scene::edit::form::{Field, Kind};
use fumetto_scene::edit::{Edit, Item, Path, Step, Value};

use super::sheet::{Sheet, Slot};
use super::{field, row};
use crate::icons::Icon;
use crate::request::Request;

/// Longer lists are shown by pages.
const PAGE: usize = 20;

/// A list among other keys. Those that the tree shows too have a line that leads there.
pub(super) fn ui(ui: &mut Ui, sheet: &mut Sheet<'_>, list: &Field) {
    let count = sheet.document.count(&list.path);
    if is_in_tree(&list.path) {
        return row::ui(ui, sheet, list, |ui, sheet| way_ui(ui, sheet, list, count));
    }
    if count == 0 && list.default.is_none() {
        return row::ui(ui, sheet, list, |ui, sheet| field::unset_ui(ui, sheet, list));
    }
    if field::heading_ui(ui, sheet, list, list.is_set) {
        field::indented(ui, |ui| elements_ui(ui, sheet, list, &list.kind));
    }
}

/// The parts of an object.
fn is_in_tree(path: &Path) -> bool {
    let [Step::Key(object), Step::Index(_), Step::Key(key)] = path.steps() else { return false };
    let is_part = |template: &fumetto_scene::edit::templates::Template| {
        template.list.strip_prefix("object.") == Some(key.as_str())
    };
    object == "object" && fumetto_scene::edit::templates::ALL.iter().any(is_part)
}

fn way_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, list: &Field, count: usize) {
    if count == 0 {
        return add_ui(ui, sheet, list, 0);
    }
    let text = if count == 1 { "1 in the tree".to_owned() } else { format!("{count} in the tree") };
    if ui.link(text).clicked() {
        sheet.requests.push(Request::Select(list.path.index(0)));
    }
    add_ui(ui, sheet, list, count);
}

fn add_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, list: &Field, count: usize) {
    let Kind::List { start, len: None, .. } = list_kind(&list.kind) else { return };
    let name = format!("Add to {}", list.label.to_lowercase());
    if row::icon_button(ui, Icon::Plus, &name).clicked() {
        let item = Item::Value(start.clone());
        sheet.requests.edit(Edit::Insert { list: list.path.clone(), index: count, item });
    }
}

/// The list itself, or the one among several shapes.
fn list_kind(kind: &Kind) -> &Kind {
    match kind {
        Kind::Union(shapes) => {
            let list = shapes.iter().find(|shape| matches!(shape.kind, Kind::List { .. }));
            list.map_or(kind, |list| &list.kind)
        }
        kind => kind,
    }
}

/// All elements of a list, or a page of them.
pub(super) fn elements_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, list: &Field, kind: &Kind) {
    let Kind::List { item, start, len, .. } = list_kind(kind) else { return };
    let said = sheet.document.count(&list.path);
    let inherited = list.default.as_ref().and_then(Value::as_array).filter(|_| !list.is_set);
    let count = inherited.map_or(said, Vec::len);
    let first = page_ui(ui, list, count);
    for index in first..count.min(first + PAGE) {
        let path = list.path.index(index);
        let inherited = inherited.and_then(|values| values.get(index));
        let own = sheet.document.get(&path).filter(|_| inherited.is_none());
        let name = format!("{} {}", list.label, index + 1);
        let slot = Slot { path: &path, name: &name, kind: item, value: own.as_ref().or(inherited), start };
        // What is inherited can be looked at; it becomes the list's own as a whole.
        ui.add_enabled_ui(inherited.is_none(), |ui| {
            element_ui(ui, sheet, &slot, (index, count), len.is_none());
        });
    }
    row::line(ui, |ui| match inherited {
        Some(values) => {
            if ui.button("Change").clicked() {
                sheet.set(&list.path, Value::Array(values.clone()));
            }
        }
        None => add_ui(ui, sheet, &Field { kind: kind.clone(), ..list.clone() }, count),
    });
}

/// Turns the pages of long lists; the first element that is shown.
fn page_ui(ui: &mut Ui, list: &Field, count: usize) -> usize {
    if count <= PAGE {
        return 0;
    }
    let id = ui.make_persistent_id(("page", &list.path));
    let last = (count - 1) / PAGE;
    let mut page = ui.data(|data| data.get_temp::<usize>(id)).unwrap_or_default().min(last);
    row::line(ui, |ui| {
        if ui.add_enabled(page > 0, egui::Button::new("‹")).accessible_name("Previous page").clicked() {
            page -= 1;
        }
        if ui.add_enabled(page < last, egui::Button::new("›")).accessible_name("Next page").clicked() {
            page += 1;
        }
        ui.weak(format!("{} to {} of {count}", page * PAGE + 1, count.min((page + 1) * PAGE)));
    });
    ui.data_mut(|data| data.insert_temp(id, page));
    page * PAGE
}

fn element_ui(
    ui: &mut Ui,
    sheet: &mut Sheet<'_>,
    slot: &Slot<'_>,
    (index, count): (usize, usize),
    is_free: bool,
) {
    const BUTTONS_WIDTH: f32 = 60.0;
    let is_inline = field::is_inline(slot.kind);
    row::line(ui, |ui| {
        ui.weak(format!("{}", index + 1));
        let width = (ui.available_width() - if is_free { BUTTONS_WIDTH } else { 0.0 }).max(40.0);
        let size = egui::vec2(width, row::HEIGHT);
        ui.allocate_ui_with_layout(size, egui::Layout::left_to_right(egui::Align::Center), |ui| {
            ui.set_min_size(size);
            ui.set_max_width(width);
            if is_inline {
                field::inline_ui(ui, sheet, slot);
            }
        });
        if is_free {
            order_ui(ui, sheet, slot, (index, count));
        }
    });
    if is_inline {
        return;
    }
    match slot.kind {
        Kind::Union(_) => {
            let Some(element) = sheet.field(slot.path) else { return };
            field::indented(ui, |ui| field::ui(ui, sheet, &element));
        }
        _ => field::block_ui(ui, sheet, slot),
    }
}

fn order_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>, (index, count): (usize, usize)) {
    let name = slot.name.to_lowercase();
    let path = slot.path.clone();
    ui.add_enabled_ui(index > 0, |ui| {
        if row::icon_button(ui, Icon::Up, &format!("Move {name} up")).clicked() {
            sheet.requests.edit(Edit::Move { path: path.clone(), to: index - 1 });
        }
    });
    ui.add_enabled_ui(index + 1 < count, |ui| {
        if row::icon_button(ui, Icon::Down, &format!("Move {name} down")).clicked() {
            sheet.requests.edit(Edit::Move { path: path.clone(), to: index + 1 });
        }
    });
    if row::icon_button(ui, Icon::Cross, &format!("Remove {name}")).clicked() {
        sheet.remove(&path);
    }
}
