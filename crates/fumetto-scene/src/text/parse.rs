use std::ops::Range;

use toml::Spanned;
use toml::de::{DeInteger, DeTable, DeValue};

use super::{Array, Entry, Node, Place, Table, Value};
use crate::limits::MAX_TEXT_BYTES;
use crate::report::{Log, Severity};

/// Reads a whole TOML text; reports every syntax error, and is `None` where there was one.
pub(crate) fn parse_document(log: &Log, name: &str, text: &str) -> Option<Node> {
    if text.len() > MAX_TEXT_BYTES {
        let message = format!("this text has {} bytes, but at most {MAX_TEXT_BYTES} are allowed", text.len());
        let help = "put particles into a .ply or .csv file of their own".to_owned();
        log.report(Severity::Error, "too-long", name, None, message, Some(help));
        return None;
    }
    let id = log.add_text(name, text);
    let (document, errors) = DeTable::parse_recoverable(text);
    let intact = errors.is_empty();
    let mut last_line = None;
    for error in errors {
        // One slip makes the parser stumble several times on the line; the first says most.
        let line = error.span().map(|span| text[..span.start.min(text.len())].matches('\n').count());
        if line.is_none() || line != last_line {
            let place = error.span().map(|span| Place { text: id, span });
            let message = format!("this is not valid TOML: {}", error.message());
            log.report(Severity::Error, "syntax", name, place.as_ref(), message, None);
        }
        last_line = line;
    }
    intact.then(|| node(id, 0, document.span(), DeValue::Table(document.into_inner())))
}

/// Reads one TOML value that stands at byte `offset` of text `id`.
pub(crate) fn parse_value(id: usize, offset: usize, text: &str) -> Option<Node> {
    DeValue::parse(text).ok().map(|value| node(id, offset, value.span(), value.into_inner()))
}

fn node(text: usize, offset: usize, span: Range<usize>, value: DeValue<'_>) -> Node {
    let place = |span: Range<usize>| Place { text, span: span.start + offset..span.end + offset };
    let child = |child: Spanned<DeValue<'_>>| node(text, offset, child.span(), child.into_inner());
    let value = match value {
        DeValue::String(string) => Value::String(string.into_owned()),
        DeValue::Integer(integer) => number(&integer),
        DeValue::Float(float) => Value::Float(float.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(boolean) => Value::Bool(boolean),
        DeValue::Datetime(_) => Value::Datetime,
        DeValue::Array(items) => {
            Value::Array(Array { items: items.into_iter().map(child).collect(), removed: Vec::new() })
        }
        DeValue::Table(table) => {
            let entries = table.into_iter().map(|(key, value)| Entry {
                key_place: place(key.span()),
                key: key.into_inner().into_owned(),
                node: child(value),
            });
            Value::Table(Table { entries: entries.collect(), removed: Vec::new() })
        }
    };
    Node { place: place(span), value }
}

/// A whole number; one beyond 128 bits becomes the nearest float, which no whole number's range holds.
fn number(integer: &DeInteger<'_>) -> Value {
    i128::from_str_radix(integer.as_str(), integer.radix())
        .map_or_else(|_| Value::Float(integer.as_str().parse().unwrap_or(f64::INFINITY)), Value::Integer)
}
