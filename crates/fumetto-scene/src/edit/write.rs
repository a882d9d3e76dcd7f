//! Values as a hand would write them.

use toml_edit::{Formatted, Key, Value as Literal};

use super::Value;

/// Width beyond which an array of tables goes over several lines.
const LINE: usize = 100;

/// Keys of the format whose tables a hand writes under headers of their own, `[[object.force]]`, and not in line.
const BLOCKS: [&str; 10] =
    ["camera", "light", "object", "emitter", "force", "transform", "drop", "stroke", "pour", "detail"];

/// Whether `value` of `key` is written as tables under headers of their own.
pub(super) fn is_blocks(key: &str, value: &Value) -> bool {
    let tables = |items: &Vec<Value>| !items.is_empty() && items.iter().all(Value::is_table);
    BLOCKS.contains(&key) && value.as_array().is_some_and(tables)
}

/// A key, in quotes where it needs them.
pub(super) fn key(key: &str) -> String {
    Key::new(key).display_repr().into_owned()
}

/// `key = value`.
pub(super) fn entry(name: &str, value: &Value) -> String {
    format!("{} = {}", key(name), lines(value))
}

/// A value after an equals sign: in one line, or a line for each of many tables.
fn lines(value: &Value) -> String {
    let short = inline(value);
    match value {
        Value::Array(items)
            if short.len() > LINE && items.iter().any(|item| item.is_table() || item.is_array()) =>
        {
            let rows: String = items.iter().map(|item| format!("  {},\n", inline(item))).collect();
            format!("[\n{rows}]")
        }
        _ => short,
    }
}

/// A value in one line.
pub(super) fn inline(value: &Value) -> String {
    match value {
        Value::Array(items) => {
            format!("[{}]", items.iter().map(inline).collect::<Vec<_>>().join(", "))
        }
        Value::Table(table) if table.is_empty() => "{}".to_owned(),
        Value::Table(table) => {
            let entry = |(name, value): (&String, &Value)| format!("{} = {}", key(name), inline(value));
            format!("{{ {} }}", table.iter().map(entry).collect::<Vec<_>>().join(", "))
        }
        Value::Float(number) => float(*number),
        Value::Integer(number) => number.to_string(),
        Value::Boolean(truth) => truth.to_string(),
        Value::Datetime(moment) => moment.to_string(),
        Value::String(text) if text.contains(['\n', '\r']) => escaped(text),
        Value::String(text) => Literal::String(Formatted::new(text.clone())).to_string(),
    }
}

/// Text over several lines, in one.
fn escaped(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            '\n' => quoted.push_str("\\n"),
            letter if letter.is_control() => quoted.push_str(&format!("\\u{:04X}", u32::from(letter))),
            letter => quoted.push(letter),
        }
    }
    quoted.push('"');
    quoted
}

/// The shortest number that is read back as the same 32 bits where 32 bits were all there is.
fn float(number: f64) -> String {
    let single = number as f32;
    match number {
        _ if number.is_nan() => "nan".to_owned(),
        _ if f64::from(single) == number => format!("{single:?}"),
        _ => format!("{number:?}"),
    }
}

/// A number in the place of `old`: what was written without a point stays so where it can.
pub(super) fn like(old: &Literal, value: &Value) -> String {
    match (old, value) {
        (Literal::Integer(_), Value::Float(number)) if number.fract() == 0.0 && number.abs() < 1e15 => {
            (*number as i64).to_string()
        }
        (Literal::Float(_), Value::Integer(number)) => float(*number as f64),
        _ => inline(value),
    }
}

/// Whether both say the same to the engine, which keeps 32 bits of a number.
pub(super) fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Float(a), Value::Float(b)) => a == b || *a as f32 == *b as f32 || a.is_nan() && b.is_nan(),
        (Value::Integer(a), Value::Float(b)) | (Value::Float(b), Value::Integer(a)) => *a as f64 == *b,
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b)),
        (Value::Table(a), Value::Table(b)) => {
            a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| same(a, b)))
        }
        _ => a == b,
    }
}

/// A table under a header of its own, `header` with its brackets, and the tables in it that get theirs. `keys` are
/// the keys of its path, joined with dots.
pub(super) fn block(header: &str, keys: &str, table: &toml::Table) -> String {
    let mut text = format!("{header}\n");
    let (blocks, entries): (Vec<_>, Vec<_>) = table.iter().partition(|(name, value)| is_blocks(name, value));
    for (name, value) in entries {
        text.push_str(&entry(name, value));
        text.push('\n');
    }
    for (name, value) in blocks {
        let keys = format!("{keys}.{}", key(name));
        for item in value.as_array().into_iter().flatten().filter_map(Value::as_table) {
            text.push('\n');
            text.push_str(&block(&format!("[[{keys}]]"), &keys, item));
        }
    }
    text
}
