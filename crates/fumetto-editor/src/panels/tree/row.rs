//! One line of the tree.

use egui::{
    Align2, Color32, FontId, Key, Rect, Response, Role, Sense, Stroke, TextEdit, TextStyle, Ui, Vec2,
    WidgetInfo, vec2,
};
use fumetto_scene::edit::{Edit, Path, Value};

use super::rows::Row;
use crate::commands::Command;
use crate::icons::Icon;
use crate::request::{Request, Requests};
use crate::selection;

/// In points.
pub(super) const ROW_HEIGHT: f32 = 22.0;
const INDENT: f32 = 14.0;
const ICON_WIDTH: f32 = 20.0;

/// What was done to a row that concerns the tree itself.
pub(super) enum Deed {
    Fold,
    Rename,
    ShowText,
    /// The name is given, or was not wanted after all.
    Renamed,
    Shift {
        down: bool,
    },
}

/// Shows a row; with a `name` it is being renamed. `add_ui` fills the menu of what can be added to it.
pub(super) fn ui(
    ui: &mut Ui,
    row: &Row,
    name: Option<&mut String>,
    is_selected: bool,
    requests: &mut Requests,
    add_ui: impl FnOnce(&mut Ui, &mut Requests),
) -> Option<Deed> {
    let (rect, line) =
        ui.allocate_exact_size(vec2(ui.available_width(), ROW_HEIGHT), Sense::click_and_drag());
    line.widget_info(|| WidgetInfo::selected(Role::TreeItem, true, is_selected, &row.label));
    let colour = background(ui, rect, &line, is_selected);
    let mut deed = None;
    let mut x = rect.left() + 4.0 + INDENT * row.depth as f32;
    let mut slot = |width: f32| {
        let slot = Rect::from_min_size(egui::pos2(x, rect.top()), vec2(width, ROW_HEIGHT));
        x += width;
        slot
    };
    let fold = slot(INDENT);
    let icon = slot(ICON_WIDTH);
    let right = rect.right() - if row.visible.is_some() { ICON_WIDTH + 6.0 } else { 6.0 };
    let text = Rect::from_x_y_ranges(icon.right() + 4.0..=right, rect.y_range());
    if let Some(open) = row.open
        && fold_ui(ui, fold, open, row, colour)
    {
        deed = Some(Deed::Fold);
    }
    let faint = if row.visible == Some(false) { 0.5 } else { 1.0 };
    row.icon.paint(ui.painter(), icon, colour.gamma_multiply(0.75 * faint));
    match name {
        Some(name) => deed = deed.or(name_ui(ui, text, row, name, requests)),
        None => label_ui(ui, text, row, colour.gamma_multiply(faint)),
    }
    if let Some(visible) = row.visible {
        let eye = Rect::from_x_y_ranges(right..=right + ICON_WIDTH, rect.y_range());
        visible_ui(ui, eye, row, visible, (line.hovered(), colour), requests);
    }
    if line.double_clicked() && row.has_name {
        deed = Some(Deed::Rename);
    } else if line.clicked() || line.secondary_clicked() {
        requests.push(Request::Select(row.path.clone()));
    }
    order_ui(ui, row, &line, requests);
    line.context_menu(|ui| deed = deed.take().or(menu_ui(ui, row, requests, add_ui)));
    deed
}

/// Fills the row and gives the colour of what stands on it.
fn background(ui: &Ui, rect: Rect, line: &Response, is_selected: bool) -> Color32 {
    let visuals = ui.visuals();
    if is_selected {
        ui.painter().rect_filled(rect, 3.0, visuals.selection.bg_fill);
        return visuals.selection.stroke.color;
    }
    if line.hovered() {
        ui.painter().rect_filled(rect, 3.0, visuals.widgets.hovered.weak_bg_fill.gamma_multiply(0.5));
    }
    visuals.text_color()
}

fn fold_ui(ui: &Ui, rect: Rect, open: bool, row: &Row, colour: Color32) -> bool {
    let fold = ui.interact(rect, ui.scope_id().with(("fold", &row.path)), Sense::click());
    let name = if open { "Fold" } else { "Unfold" };
    fold.widget_info(|| WidgetInfo::labeled(Role::DisclosureTriangle, true, format!("{name} {}", row.label)));
    let small = Rect::from_center_size(rect.center(), Vec2::splat(8.0));
    Icon::fold(ui.painter(), small, f32::from(u8::from(open)), colour.gamma_multiply(0.7));
    fold.clicked()
}

fn label_ui(ui: &Ui, rect: Rect, row: &Row, colour: Color32) {
    let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    let font = TextStyle::Body.resolve(ui.style());
    let label = painter.text(rect.left_center(), Align2::LEFT_CENTER, &row.label, font, colour);
    if !row.detail.is_empty() {
        let at = label.right_center() + vec2(8.0, 0.5);
        let font = FontId::proportional(11.0);
        painter.text(at, Align2::LEFT_CENTER, &row.detail, font, colour.gamma_multiply(0.55));
    }
}

/// The field for another name: Enter or a click elsewhere gives it, Escape leaves the old one.
fn name_ui(ui: &mut Ui, rect: Rect, row: &Row, name: &mut String, requests: &mut Requests) -> Option<Deed> {
    let field = ui.put(rect.shrink2(vec2(0.0, 1.0)), TextEdit::singleline(name).margin(vec2(2.0, 1.0)));
    field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, "New name"));
    if field.lost_focus() {
        let is_given = !ui.input(|input| input.key_pressed(Key::Escape)) && *name != row.label;
        if is_given {
            requests.edit(Edit::Rename { path: row.path.clone(), name: name.clone() });
        }
        return Some(Deed::Renamed);
    }
    if !field.has_focus() {
        field.request_focus();
    }
    None
}

/// The eye, which is seen where it says something or where the pointer is.
fn visible_ui(
    ui: &Ui,
    rect: Rect,
    row: &Row,
    visible: bool,
    (is_hovered, colour): (bool, Color32),
    requests: &mut Requests,
) {
    let eye = ui.interact(rect, ui.scope_id().with(("eye", &row.path)), Sense::click());
    let name = if visible { "Hide" } else { "Show" };
    eye.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("{name} {}", row.label)));
    let icon = if visible { Icon::Eye } else { Icon::Closed };
    let strength = if eye.hovered() {
        1.0
    } else if is_hovered || !visible {
        0.65
    } else {
        0.25
    };
    icon.paint(ui.painter(), rect, colour.gamma_multiply(strength));
    if eye.on_hover_text(name).clicked() {
        let path = row.path.key("visible");
        requests.edit(match visible {
            true => Edit::Set { path, value: Value::Boolean(false) },
            false => Edit::Remove { path },
        });
    }
}

/// Rows are dragged to another place in their list.
fn order_ui(ui: &Ui, row: &Row, line: &Response, requests: &mut Requests) {
    let Some((list, index)) = selection::whole(&row.path) else { return };
    line.dnd_set_drag_payload(row.path.clone());
    let is_of_list = |dragged: &Path| selection::whole(dragged).is_some_and(|(other, _)| other == list);
    let Some(dragged) = line.dnd_hover_payload::<Path>().filter(|dragged| is_of_list(dragged)) else {
        return;
    };
    let Some(pointer) = ui.pointer_latest_pos() else { return };
    let below = pointer.y > line.rect.center().y;
    let y = if below { line.rect.bottom() } else { line.rect.top() };
    ui.painter().hline(line.rect.x_range(), y, Stroke::new(2.0, ui.visuals().selection.stroke.color));
    if line.dnd_release_payload::<Path>().is_some()
        && let Some((_, from)) = selection::whole(&dragged)
    {
        let slot = index + usize::from(below);
        let to = if from < slot { slot - 1 } else { slot };
        if to != from {
            requests.edit(Edit::Move { path: (*dragged).clone(), to });
            requests.push(Request::Select(list.index(to)));
        }
    }
}

fn menu_ui(
    ui: &mut Ui,
    row: &Row,
    requests: &mut Requests,
    add_ui: impl FnOnce(&mut Ui, &mut Requests),
) -> Option<Deed> {
    ui.menu_button("Add", |ui| add_ui(ui, requests));
    let mut deed = ui.button("Show in the text").clicked().then_some(Deed::ShowText);
    if selection::whole(&row.path).is_none() {
        return deed;
    }
    ui.separator();
    if row.has_name && ui.button("Rename").clicked() {
        deed = Some(Deed::Rename);
    }
    for (name, command) in [("Duplicate", Command::Duplicate), ("Delete", Command::Delete)] {
        if ui.button(name).clicked() {
            requests.push(Request::Select(row.path.clone()));
            requests.push(Request::Do(command));
        }
    }
    ui.separator();
    for (name, down) in [("Move up", false), ("Move down", true)] {
        if ui.button(name).clicked() {
            deed = Some(Deed::Shift { down });
        }
    }
    deed
}
