//! Colours, as they are written.

use egui::color_picker::color_edit_button_srgb;
use egui::{Color32, Rgba, Ui};
use fumetto_scene::edit::Value;

use super::number::number_of;
use super::sheet::{Sheet, Slot};
use super::text;

pub(super) fn ui(ui: &mut Ui, sheet: &mut Sheet<'_>, slot: &Slot<'_>) {
    let shown = slot.value.unwrap_or(slot.start);
    if let Some((value, is_dragged)) = edited_ui(ui, slot, shown) {
        if is_dragged { sheet.slide(slot.path, value) } else { sheet.set(slot.path, value) }
    }
}

/// A swatch and the digits; the new colour, and whether it is under way.
pub(super) fn edited_ui(ui: &mut Ui, slot: &Slot<'_>, shown: &Value) -> Option<(Value, bool)> {
    let mut rgb = srgb(shown).unwrap_or([128; 3]);
    ui.spacing_mut().interact_size.x = 26.0;
    let swatch =
        color_edit_button_srgb(ui, &mut rgb).accessible_name(format!("Pick {}", slot.name.to_lowercase()));
    if swatch.changed() {
        return Some((written(rgb, shown), true));
    }
    let digits = match shown {
        Value::String(digits) => digits.clone(),
        _ => hex(rgb),
    };
    let typed = text::field_ui(ui, slot, &digits, ui.available_width(), "#rrggbb")?;
    parse(&typed).map(|_| (Value::String(with_hash(&typed)), false))
}

/// What is seen of a colour.
pub(super) fn colour32(value: &Value) -> Color32 {
    let [r, g, b] = srgb(value).unwrap_or([128; 3]);
    Color32::from_rgb(r, g, b)
}

fn srgb(value: &Value) -> Option<[u8; 3]> {
    match value {
        Value::String(digits) => parse(digits),
        Value::Array(linear) => {
            let share = |i: usize| linear.get(i).and_then(number_of).map(|share| share as f32);
            let rgba = Rgba::from_rgb(share(0)?, share(1)?, share(2)?);
            let [r, g, b, _] = Color32::from(rgba).to_array();
            Some([r, g, b])
        }
        _ => None,
    }
}

/// A colour written as the one before it: digits, or shares of linear light.
pub(super) fn written(rgb: [u8; 3], before: &Value) -> Value {
    match before {
        Value::Array(_) => {
            let [r, g, b] = rgb;
            let linear = Rgba::from(Color32::from_rgb(r, g, b)).to_array();
            let share = |share: &f32| Value::Float(f64::from((1e4 * share).round() / 1e4));
            Value::Array(linear[..3].iter().map(share).collect())
        }
        _ => Value::String(hex(rgb)),
    }
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn with_hash(digits: &str) -> String {
    format!("#{}", digits.trim().trim_start_matches('#'))
}

fn parse(digits: &str) -> Option<[u8; 3]> {
    let digits = digits.trim().trim_start_matches('#');
    let is_hex = digits.len() == 6 && digits.chars().all(|digit| digit.is_ascii_hexdigit());
    let number = u32::from_str_radix(digits, 16).ok().filter(|_| is_hex)?;
    let [_, r, g, b] = number.to_be_bytes();
    Some([r, g, b])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_stay_as_they_are_written() {
        assert_eq!(srgb(&"#A0B0c0".into()), Some([0xa0, 0xb0, 0xc0]));
        assert_eq!((parse("12345"), parse("1234567"), parse("+12345")), (None, None, None));
        let linear: Value = vec![1.0, 0.5, 0.0].into();
        let seen = srgb(&linear).expect("three shares");
        let Value::Array(again) = written(seen, &linear) else { panic!("shares stay shares") };
        assert!((number_of(&again[1]).expect("a number") - 0.5).abs() < 0.01);
        assert_eq!(written([1, 2, 255], &"#000000".into()), Value::from("#0102ff"));
    }
}
