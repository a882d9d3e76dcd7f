//! Numbers, alone and in a row.

use egui::{DragValue, Rect, Response, Ui, pos2};
use fumetto_scene::edit::Value;
use fumetto_scene::limits::Limit;

use super::row;
use super::sheet::{Sheet, Slot};

/// Ranges up to this wide are shown as a bar below the number: shares and angles.
const WIDEST_BAR: f64 = 360.0;

/// How a number is shown and where it may lie.
pub(super) struct Look {
    range: Limit,
    unit: &'static str,
    whole: bool,
}

impl Look {
    pub(super) fn new(range: Limit, unit: &'static str, whole: bool) -> Self {
        Self { range, unit, whole }
    }

    fn span(&self) -> f64 {
        self.range.max() - self.range.min()
    }

    /// What a point of dragging changes.
    fn speed(&self, number: f64) -> f64 {
        let span = self.span();
        match self.whole {
            true => (0.01 * number.abs()).max(0.1),
            false if span <= WIDEST_BAR => span / 400.0,
            false => (0.01 * number.abs()).max(0.005),
        }
    }

    /// A number as it is written, if it may be.
    pub(super) fn value(&self, number: f64) -> Option<Value> {
        let number = self.range.clamped(number);
        let value = match self.whole {
            true => Value::Integer(number.round() as i64),
            false => Value::Float(f64::from(number as f32)),
        };
        self.range.contains(number).then_some(value)
    }

    fn field_ui(&self, ui: &mut Ui, number: &mut f64, is_known: bool, width: f32) -> Response {
        let unit = if self.unit.is_empty() || !is_known { String::new() } else { format!(" {}", self.unit) };
        let speed = self.speed(*number);
        let mut field = DragValue::new(number)
            .speed(speed)
            .range(self.range.min()..=self.range.max())
            .clamp_existing_to_range(false)
            .update_while_editing(false)
            .max_decimals(if self.whole { 0 } else { 4 })
            .suffix(unit)
            .clip_text(true);
        if !is_known {
            field = field.custom_formatter(|_, _| "auto".to_owned());
        }
        ui.add_sized([width, row::HEIGHT - 2.0], field)
    }

    /// Where in its range a number lies.
    fn bar_ui(&self, ui: &Ui, rect: Rect, number: f64) {
        if self.whole || self.span() > WIDEST_BAR {
            return;
        }
        let share = ((number - self.range.min()) / self.span()).clamp(0.0, 1.0) as f32;
        let right = rect.left() + 3.0 + share * (rect.width() - 6.0);
        let bar = Rect::from_min_max(
            pos2(rect.left() + 3.0, rect.bottom() - 2.5),
            pos2(right, rect.bottom() - 1.0),
        );
        ui.painter().rect_filled(bar, 1.0, ui.visuals().selection.bg_fill);
    }
}

/// What a value is as a number.
pub(super) fn number_of(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|number| number as f64))
}

pub(super) fn ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>, look: &Look) {
    changed_ui(ui, slot, look, |field, value| sheet.write(field, slot.path, value.clone()));
}

/// A number; what it is changed to goes to `write`.
pub(super) fn changed_ui(ui: &mut Ui, slot: &Slot<'_>, look: &Look, write: impl FnOnce(&Response, &Value)) {
    let known = slot.value.and_then(number_of);
    let mut number = known.or_else(|| number_of(slot.start)).unwrap_or_default();
    let before = number;
    let field = look.field_ui(ui, &mut number, known.is_some(), ui.available_width());
    let field = field.accessible_name(slot.name);
    if known.is_some() {
        look.bar_ui(ui, field.rect, before);
    }
    let is_said = field.changed() && (number != before || known.is_none());
    if let Some(value) = look.value(number).filter(|_| is_said) {
        write(&field, &value);
    }
}

/// Numbers that belong together, side by side.
pub(super) fn vector_ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>, len: usize, look: &Look) {
    let known = slot.value.and_then(Value::as_array);
    let Some(numbers) = known.or_else(|| slot.start.as_array()) else { return };
    ui.spacing_mut().item_spacing.x = 3.0;
    let width = (ui.available_width() - 3.0 * (len as f32 - 1.0)) / len as f32;
    let bare = Look { unit: if len > 2 { "" } else { look.unit }, ..*look };
    for (i, name) in names(slot.name, len).into_iter().enumerate() {
        let mut number = numbers.get(i).and_then(number_of).unwrap_or_default();
        let before = number;
        let field = bare.field_ui(ui, &mut number, known.is_some(), width).accessible_name(name);
        if !field.changed() || (number == before && known.is_some()) {
            continue;
        }
        if let Some(value) = look.value(number) {
            let mut numbers = numbers.clone();
            numbers.resize(len, value.clone());
            numbers[i] = value;
            sheet.write(&field, slot.path, Value::Array(numbers));
        }
    }
}

/// What each of several numbers is called.
fn names(name: &str, len: usize) -> Vec<String> {
    let axes: &[&str] = match len {
        2 => &["first", "last"],
        3 => &["x", "y", "z"],
        _ => &[],
    };
    (0..len)
        .map(|i| axes.get(i).map_or_else(|| format!("{name} {}", i + 1), |axis| format!("{name} {axis}")))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use fumetto_scene::limits;

    #[test]
    fn numbers_stay_in_their_range_and_short() {
        let share = Look::new(limits::SHARE, "", false);
        assert_eq!(share.value(1.5), Some(Value::Float(1.0)));
        let length = Look::new(limits::LENGTH, "m", false);
        assert_eq!(length.value(-1.0), None, "0 itself is excluded");
        assert_eq!(length.value(0.1), Some(Value::Float(f64::from(0.1_f32))));
    }
}
