//! What new values begin as.

use serde_json::Value as Schema;

use super::node::Node;
use super::read::to_toml;
use crate::edit::Value;
use crate::limits::Limit;

/// Keys whose new values mean something only if they are not zero, or not the same all along.
const VECTORS: [(&str, &[f64]); 9] = [
    ("direction", &[-0.4, -1.0, -0.3]),
    ("eye", &[0.0, 1.5, 6.0]),
    ("target", &[0.0, 1.0, 0.0]),
    ("position", &[2.0, 3.0, 2.0]),
    ("to", &[1.0, 0.0, 0.0]),
    ("velocity", &[1.0, 0.0, 0.0]),
    ("during", &[0.0, 1.0]),
    ("depth", &[1.0, 10.0]),
    ("size", &[2.0, 2.0, 2.0]),
];

/// A sensible value for what is called `key`: its default where it has one, and only what must be said.
pub(super) fn start(node: Node, key: &str) -> Value {
    if let Some(default) = node.get("default").and_then(to_toml).filter(|default| !is_empty(default)) {
        return default;
    }
    if let Some(first) = node.branches().first() {
        return start(*first, key);
    }
    match node.text("type") {
        "boolean" => Value::Boolean(true),
        "integer" => Value::Integer(number(node, true, key) as i64),
        "number" => Value::Float(number(node, false, key)),
        "string" => Value::String(text(node, key)),
        "object" => table(node),
        _ => array(node, key),
    }
}

/// A table with only what it must have.
pub(super) fn table(node: Node) -> Value {
    let required = node.keys().into_iter().filter(|key| node.is_required(key));
    let entry = |key: &str| Some((key.to_owned(), start(node.key(key)?, key)));
    Value::Table(required.filter_map(entry).collect())
}

fn is_empty(value: &Value) -> bool {
    value.as_array().is_some_and(Vec::is_empty)
}

fn number(node: Node, whole: bool, key: &str) -> f64 {
    let limit = Limit::from_schemas(whole, &node.layers());
    let wanted = match key {
        "fov" | "smooth" => 40.0,
        "height" => 720.0,
        "pixels" => 8.0,
        "px" => 3.0,
        "cell" | "near" | "start" => 0.1,
        "step" => 0.05,
        "amplitude" => 0.5,
        "count" => 100.0,
        "size" if whole => 64.0,
        _ => 1.0,
    };
    [wanted, 0.5, 0.1].into_iter().find(|value| limit.contains(*value)).unwrap_or_else(|| limit.min().ceil())
}

fn text(node: Node, key: &str) -> String {
    let first = |keyword: &str| node.words(keyword).into_iter().next();
    let pattern = node.text("pattern");
    if let Some(word) = node.constant().map(str::to_owned).or_else(|| first("examples")) {
        return word;
    }
    if let Some(format) = first("x-files") {
        return format!("file.{format}");
    }
    match pattern.strip_prefix("^(").and_then(|rest| rest.split(['|', ')']).next()) {
        Some(word) => word.to_owned(),
        None if pattern.starts_with("^#") => "#808080".to_owned(),
        None => key.to_owned(),
    }
}

fn array(node: Node, key: &str) -> Value {
    let Some(items) = node.items() else { return Value::Array(Vec::new()) };
    let known = VECTORS.iter().find(|(known, _)| *known == key).map(|(_, numbers)| *numbers);
    let is_number = items.is("number") || items.is("integer");
    match (node.len(), known) {
        (Some(len), Some(numbers)) if items.is("number") && numbers.len() == len => {
            Value::Array(numbers.iter().map(|number| Value::Float(*number)).collect())
        }
        (Some(2), _) if items.is("number") && key != "dash" => {
            Value::Array(vec![Value::Float(0.5), Value::Float(1.0)])
        }
        (Some(len), _) if is_number => {
            let limit = Limit::from_schemas(items.is("integer"), &items.layers());
            let whole = items.is("integer");
            let item = if limit.contains(0.0) { 0.0 } else { number(items, whole, key) };
            let item = if whole { Value::Integer(item as i64) } else { Value::Float(item) };
            Value::Array(vec![item; len])
        }
        (Some(len), _) => Value::Array(vec![start(items, key); len]),
        (None, _) if items.len() == Some(2) => points(&[[0.0, 1.0], [1.0, 1.0]]),
        (None, _) if items.len() == Some(3) => points(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]),
        (None, _) => Value::Array(vec![start(items, key)]),
    }
}

fn points<const N: usize>(points: &[[f64; N]]) -> Value {
    let point = |point: &[f64; N]| Value::Array(point.iter().map(|number| Value::Float(*number)).collect());
    Value::Array(points.iter().map(point).collect())
}

/// The schema's own default.
pub(super) fn default_of(node: Node) -> Option<Value> {
    node.get("default").filter(|default: &&Schema| !default.is_null()).and_then(to_toml)
}
