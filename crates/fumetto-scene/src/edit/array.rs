//! Arrays in brackets: in one line, or with a line for each element.

use std::ops::Range;

use toml_edit::{Array, Value as Literal};

use super::apply::Draft;
use super::inline::without;
use super::sections::{comments_above, line_end, line_start, next_line};

/// Where an element is written.
struct Slot {
    /// The value alone.
    value: Range<usize>,
    /// With the comma behind it, where there is one.
    comma: Range<usize>,
    /// With the comments above it and behind it, if it has lines of its own; up to the next line.
    lines: Option<Range<usize>>,
}

/// Puts `items` before element `index`.
pub(super) fn insert(draft: &mut Draft<'_>, array: &Array, index: usize, items: &[String]) {
    let text = draft.text();
    let (slots, Some(span)) = (slots(text, array), array.span()) else { return };
    if items.is_empty() {
        return;
    }
    let rows = rows(&slots);
    match (slots.get(index), slots.last(), rows) {
        (Some(_), _, Some(rows)) => {
            let indent = indent(text, &slots[index]);
            let new: String = items.iter().map(|item| format!("{indent}{item},\n")).collect();
            draft.splices.insert(rows[index].start, new);
        }
        (Some(slot), ..) => draft.splices.insert(slot.value.start, items.join(", ") + ", "),
        (None, Some(last), Some(_)) => {
            let has_comma = last.comma.end > last.value.end;
            if !has_comma {
                draft.splices.insert(last.value.end, ",");
            }
            let indent = indent(text, last);
            let new: Vec<String> = items.iter().map(|item| format!("\n{indent}{item}")).collect();
            let end = if has_comma { "," } else { "" };
            draft.splices.insert(line_end(text, last.comma.end), new.join(",") + end);
        }
        (None, Some(last), None) => draft.splices.insert(last.value.end, format!(", {}", items.join(", "))),
        (None, None, _) => draft.splices.insert(span.start + 1, items.join(", ")),
    }
}

/// Takes the elements of `range` away.
pub(super) fn remove(draft: &mut Draft<'_>, array: &Array, range: Range<usize>) {
    let slots = slots(draft.text(), array);
    if range.is_empty() || range.end > slots.len() {
        return;
    }
    if let Some(rows) = rows(&slots) {
        draft.splices.remove(rows[range.start].start..rows[range.end - 1].end);
        return;
    }
    let values: Vec<Range<usize>> = slots.iter().map(|slot| slot.value.clone()).collect();
    let gone: Vec<bool> = (0..slots.len()).map(|index| range.contains(&index)).collect();
    let is_empty = !gone.contains(&false);
    for removed in without(&values, &gone) {
        draft.splices.remove(removed);
    }
    // A comma behind the last element cannot stand alone.
    if let (true, Some(last)) = (is_empty, slots.last()) {
        draft.splices.remove(last.value.end..last.comma.end);
    }
}

/// Moves element `from` to where element `to` is.
pub(super) fn reorder(draft: &mut Draft<'_>, array: &Array, from: usize, to: usize) {
    let text = draft.text();
    let slots = slots(text, array);
    let mut order: Vec<usize> = (0..slots.len()).collect();
    if from >= order.len() || to >= order.len() {
        return;
    }
    let moved = order.remove(from);
    order.insert(to, moved);
    let rows = rows(&slots);
    for (slot, other) in order.into_iter().enumerate().filter(|(slot, other)| slot != other) {
        match &rows {
            Some(rows) => draft.splices.replace(rows[slot].clone(), row(text, &slots[other], &rows[other])),
            None => {
                draft.splices.replace(slots[slot].value.clone(), &text[slots[other].value.clone()]);
            }
        }
    }
}

/// The lines of an element, with a comma.
fn row(text: &str, slot: &Slot, lines: &Range<usize>) -> String {
    let comma = if slot.comma.end > slot.value.end { "" } else { "," };
    [&text[lines.start..slot.value.end], comma, &text[slot.value.end..lines.end]].concat()
}

/// The lines of each element, where all have lines of their own.
fn rows(slots: &[Slot]) -> Option<Vec<Range<usize>>> {
    slots.iter().map(|slot| slot.lines.clone()).collect()
}

fn indent<'t>(text: &'t str, slot: &Slot) -> &'t str {
    &text[line_start(text, slot.value.start)..slot.value.start]
}

fn slots(text: &str, array: &Array) -> Vec<Slot> {
    let Some(span) = array.span() else { return Vec::new() };
    let mut slots = Vec::with_capacity(array.len());
    // What lies before is the array's own line, or the element before.
    let mut above = span.start + 1;
    for (index, literal) in array.iter().enumerate() {
        let Some(value) = literal.span() else { continue };
        let has_comma = index + 1 < array.len() || array.trailing_comma();
        let comma = value.start..if has_comma { comma_end(literal, &value) } else { value.end };
        let (start, end) = (line_start(text, value.start), line_end(text, comma.end));
        let is_alone = start >= above
            && text[start..value.start].trim().is_empty()
            && (text[comma.end..end].trim().is_empty() || text[comma.end..end].trim().starts_with('#'))
            && end < span.end;
        let lines = is_alone.then(|| comments_above(text, above, value.start)..next_line(text, end));
        above = if is_alone { end } else { comma.end };
        slots.push(Slot { value, comma, lines });
    }
    slots
}

/// Where the comma behind an element ends.
fn comma_end(literal: &Literal, value: &Range<usize>) -> usize {
    let suffix = literal.decor().suffix().and_then(toml_edit::RawString::span);
    suffix.map_or(value.end, |suffix| suffix.end.max(value.end)) + 1
}
