//! Flat tones from dark to light: a bar of colours whose edges are dragged.

use egui::{Color32, CursorIcon, Pos2, Rect, Response, Role, Sense, Stroke, Ui, WidgetInfo, vec2};
use fumetto_scene::edit::Value;
use fumetto_scene::limits;

use super::number::{self, Look, number_of};
use super::sheet::{Sheet, Slot};
use super::{colour, row};
use crate::icons::Icon;

/// In points.
const HEIGHT: f32 = 30.0;
/// How near an edge the pointer has to be.
const REACH: f32 = 5.0;
/// The narrowest tone that a hand makes.
const NARROWEST: f64 = 0.01;

/// The bar, and below it the tone that was touched last.
pub(super) fn ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>) {
    let Some(tones) = slot.value.and_then(Tones::read) else { return };
    let id = ui.make_persistent_id(("tones", slot.path));
    let mut chosen = ui.data(|data| data.get_temp::<usize>(id)).unwrap_or_default().min(tones.0.len() - 1);
    let (rect, bar) =
        ui.allocate_exact_size(vec2(ui.available_width() - 18.0, HEIGHT), Sense::click_and_drag());
    bar.widget_info(|| WidgetInfo::labeled(Role::Group, true, "Bar of tones"));
    if let Some(changed) = hand(ui, &bar, rect, &tones, &mut chosen) {
        sheet.slide(slot.path, changed.write());
    }
    paint(ui, rect, &tones, chosen);
    bar.on_hover_text("Drag where two tones meet; click a tone to change it");
    ui.push_id(id, |ui| tone_ui(ui, sheet, slot, &tones, &mut chosen));
    ui.data_mut(|data| data.insert_temp(id, chosen));
}

/// What the pointer does to the bar.
fn hand(ui: &Ui, bar: &Response, rect: Rect, tones: &Tones, chosen: &mut usize) -> Option<Tones> {
    let held = bar.id.with("edge");
    let edge_at = |pointer: Pos2| {
        let far = |i: &usize| (x_of(rect, tones.from(*i)) - pointer.x).abs();
        (1..tones.0.len()).min_by(|a, b| far(a).total_cmp(&far(b))).filter(|i| far(i) < REACH)
    };
    if bar.hover_pos().and_then(edge_at).is_some() || bar.dragged() {
        ui.set_cursor_icon(CursorIcon::ResizeHorizontal);
    }
    let pointer = bar.interact_pointer_pos()?;
    let share = f64::from(((pointer.x - rect.left()) / rect.width()).clamp(0.0, 1.0));
    if bar.clicked() {
        *chosen = tones.at(share);
    }
    if bar.drag_started() {
        let from = ui.input(|input| input.pointer.press_origin()).unwrap_or(pointer);
        ui.data_mut(|data| data.insert_temp(held, edge_at(from)));
    }
    let edge = ui.data(|data| data.get_temp::<Option<usize>>(held)).flatten().filter(|_| bar.dragged())?;
    Some(tones.moved(edge, (share * 200.0).round() / 200.0)).filter(|changed| changed != tones)
}

fn x_of(rect: Rect, share: f64) -> f32 {
    rect.left() + share as f32 * rect.width()
}

fn paint(ui: &Ui, rect: Rect, tones: &Tones, chosen: usize) {
    let painter = ui.painter();
    let band = |i: usize| {
        let to = if i + 1 < tones.0.len() { tones.from(i + 1) } else { 1.0 };
        Rect::from_x_y_ranges(x_of(rect, tones.from(i))..=x_of(rect, to), rect.y_range())
    };
    for (i, tone) in tones.0.iter().enumerate() {
        painter.rect_filled(band(i), 0.0, colour::colour32(&tone.colour));
    }
    let visuals = ui.visuals();
    let outline = visuals.widgets.noninteractive.bg_stroke;
    painter.rect_stroke(rect, 0.0, outline, egui::StrokeKind::Outside);
    let mark = band(chosen.min(tones.0.len() - 1));
    let on = visuals.strong_text_color();
    painter.hline(mark.x_range(), rect.bottom() + 2.5, Stroke::new(2.0, on));
}

/// The tone that is chosen: its colour, where it begins, and what else can be done with it.
fn tone_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>, tones: &Tones, chosen: &mut usize) {
    ui.add_space(4.0);
    let i = *chosen;
    let tone = &tones.0[i];
    row::line(ui, |ui| {
        let count = tones.0.len();
        let (name, path) = (format!("Tone {}", i + 1), slot.path.index(i));
        let width = (sheet.value_x - ui.cursor().left() - 6.0).max(40.0);
        ui.allocate_ui_with_layout(
            vec2(width, row::HEIGHT),
            egui::Layout::left_to_right(egui::Align::Center),
            |ui| {
                ui.set_min_width(width);
                ui.spacing_mut().item_spacing.x = 2.0;
                ui.weak(format!("{} of {count}", i + 1));
                change_ui(ui, sheet, slot, tones, chosen);
            },
        );
        let room = ui.available_width() - 18.0;
        let part = Slot {
            path: &path,
            name: &name,
            kind: slot.kind,
            value: Some(&tone.colour),
            start: &tone.colour,
        };
        ui.allocate_ui(vec2(0.62 * room, row::HEIGHT), |ui| {
            ui.set_max_width(0.62 * room);
            if let Some((said, is_dragged)) = colour::edited_ui(ui, &part, &tone.colour) {
                let changed = tones.coloured(i, said).write();
                if is_dragged { sheet.slide(slot.path, changed) } else { sheet.set(slot.path, changed) }
            }
        });
        let (name, from) = (format!("{name} from"), Value::Float(tones.from(i)));
        let path = path.key("from");
        let part = Slot { path: &path, name: &name, value: Some(&from), ..part };
        ui.add_enabled_ui(i > 0, |ui| {
            ui.set_max_width(0.38 * room - 4.0);
            number::changed_ui(ui, &part, &Look::new(limits::SHARE, "", false), |field, said| {
                let changed = tones.moved(i, number_of(said).unwrap_or_default());
                sheet.write(field, slot.path, changed.write());
            });
        });
    });
}

fn change_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>, tones: &Tones, chosen: &mut usize) {
    let count = tones.0.len();
    ui.add_enabled_ui(count < limits::MAX_TONES, |ui| {
        if row::icon_button(ui, Icon::Plus, "Add a tone").clicked() {
            sheet.set(slot.path, tones.split(*chosen).write());
            *chosen += 1;
        }
    });
    ui.add_enabled_ui(count > 1, |ui| {
        if row::icon_button(ui, Icon::Cross, "Remove the tone").clicked() {
            sheet.set(slot.path, tones.without(*chosen).write());
        }
    });
    if tones.is_placed() && row::icon_button(ui, Icon::Reset, "Space the tones evenly").clicked() {
        sheet.set(slot.path, tones.even().write());
    }
}

/// A colour and the light from which it is drawn, where that is said.
#[derive(Clone, Debug, PartialEq)]
struct Tone {
    colour: Value,
    from: Option<f64>,
}

/// Never none.
#[derive(Clone, Debug, PartialEq)]
struct Tones(Vec<Tone>);

impl Tones {
    fn read(value: &Value) -> Option<Self> {
        let tone = |value: &Value| match value {
            Value::Table(table) => Some(Tone {
                colour: table.get("colour")?.clone(),
                from: Some(table.get("from").and_then(number_of)?),
            }),
            colour => Some(Tone { colour: colour.clone(), from: None }),
        };
        let tones: Option<Vec<_>> = value.as_array()?.iter().map(tone).collect();
        tones.filter(|tones| !tones.is_empty()).map(Self)
    }

    fn write(&self) -> Value {
        let tone = |tone: &Tone| match tone.from {
            None => tone.colour.clone(),
            Some(from) => {
                let from = Value::Float(f64::from(from as f32));
                let keys = [("colour".to_owned(), tone.colour.clone()), ("from".to_owned(), from)];
                Value::Table(keys.into_iter().collect())
            }
        };
        Value::Array(self.0.iter().map(tone).collect())
    }

    fn is_placed(&self) -> bool {
        self.0.iter().any(|tone| tone.from.is_some())
    }

    /// Where a tone begins.
    fn from(&self, i: usize) -> f64 {
        self.0[i].from.unwrap_or(i as f64 / self.0.len() as f64)
    }

    /// The tone that is drawn in this light.
    fn at(&self, share: f64) -> usize {
        (0..self.0.len()).rev().find(|i| self.from(*i) <= share).unwrap_or_default()
    }

    /// All with a place of their own.
    fn placed(&self) -> Self {
        let place = |(i, tone): (usize, &Tone)| Tone { from: Some(self.from(i)), ..tone.clone() };
        Self(self.0.iter().enumerate().map(place).collect())
    }

    fn even(&self) -> Self {
        Self(self.0.iter().map(|tone| Tone { from: None, ..tone.clone() }).collect())
    }

    /// With the beginning of tone `i` elsewhere, but still between its neighbours; the first begins at 0.
    fn moved(&self, i: usize, share: f64) -> Self {
        let mut tones = self.placed();
        if i > 0 {
            let end = if i + 1 < tones.0.len() { tones.from(i + 1) } else { 1.0 };
            let least = tones.from(i - 1) + NARROWEST;
            tones.0[i].from = Some(share.min(end - NARROWEST).max(least).min(1.0));
        }
        tones
    }

    fn coloured(&self, i: usize, colour: Value) -> Self {
        let mut tones = self.clone();
        tones.0[i].colour = colour;
        tones
    }

    /// With another tone behind `i`, half way to the next.
    fn split(&self, i: usize) -> Self {
        let mut tones = self.clone();
        let (here, next) = (&self.0[i].colour, &self.0[(i + 1).min(self.0.len() - 1)].colour);
        let end = if i + 1 < self.0.len() { self.from(i + 1) } else { 1.0 };
        let from = self.is_placed().then_some(0.5 * (self.from(i) + end));
        let colour = colour::written(mixed(colour::colour32(here), colour::colour32(next)), here);
        tones.0.insert(i + 1, Tone { colour, from });
        tones
    }

    /// Without tone `i`, unless it is the only one; the darkest still begins at 0.
    fn without(&self, i: usize) -> Self {
        let mut tones = self.clone();
        if tones.0.len() > 1 {
            tones.0.remove(i);
        }
        if let Some(from) = &mut tones.0[0].from {
            *from = 0.0;
        }
        tones
    }
}

/// Half way between two colours, as the eye sees them.
fn mixed(a: Color32, b: Color32) -> [u8; 3] {
    let [r, g, b, _] = a.lerp_to_gamma(b, 0.5).to_array();
    [r, g, b]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn even() -> Tones {
        let colours = ["#000000", "#808080", "#FFFFFF", "#ffffff"].map(Value::from);
        Tones::read(&Value::Array(colours.to_vec())).expect("four tones")
    }

    #[test]
    fn tones_that_are_not_touched_stay_as_they_are_written() {
        let value = even().write();
        assert_eq!(value[2].as_str(), Some("#FFFFFF"));
        assert_eq!(Tones::read(&value), Some(even()));
    }

    #[test]
    fn an_edge_that_is_dragged_stays_between_its_neighbours() {
        let moved = even().moved(2, 0.1);
        assert!(moved.is_placed());
        assert_eq!([0, 1, 2, 3].map(|i| moved.from(i)), [0.0, 0.25, 0.25 + NARROWEST, 0.75]);
        assert_eq!(moved.moved(0, 0.5).from(0), 0.0);
        assert_eq!(moved.even(), even());
        assert_eq!(even().at(0.6), 2);
    }

    #[test]
    fn tones_come_and_go_in_their_place() {
        let more = even().split(0);
        assert_eq!((more.0.len(), more.0[1].colour.as_str(), more.is_placed()), (5, Some("#404040"), false));
        let placed = even().placed().split(3);
        assert_eq!(placed.from(4), 0.875);
        assert_eq!(even().placed().without(0).from(0), 0.0);
        assert_eq!(Tones(even().0[..1].to_vec()).without(0).0.len(), 1);
    }
}
