//! From the schema to what a form shows.

use serde_json::Value as Schema;

use super::docs::{Docs, stated_range, unit};
use super::node::Node;
use super::start::start;
use super::{Alternative, Kind, Word};
use crate::edit::Value;
use crate::limits::{DISTANCE, Limit, SHARE};

/// What a value can be, as `about` describes it; `None` where no form can show it.
pub(super) fn kind_of(node: Node, about: &str) -> Option<Kind> {
    let branches = node.branches();
    if branches.is_empty() {
        return plain(node, about);
    }
    if branches.iter().all(|branch| branch.constant().is_some()) {
        let word = |branch: &Node| Word {
            word: branch.constant().unwrap_or_default().to_owned(),
            docs: Docs::new(branch.about()),
        };
        return Some(Kind::Choice(branches.iter().map(word).collect()));
    }
    if is_colour(&branches) {
        return Some(Kind::Colour);
    }
    if let [one, many] = branches.as_slice()
        && one.is("object")
        && many.items().is_some_and(|item| std::ptr::eq(item.layers()[0], one.layers()[0]))
    {
        return list(*many, true);
    }
    alternatives(node, about).map(Kind::Union)
}

/// The shapes that a value can have.
pub(super) fn alternatives(node: Node, about: &str) -> Option<Vec<Alternative>> {
    let mut branches = node.branches();
    let mut found = Vec::new();
    if branches.len() > 2 && is_colour(&branches[..2]) {
        let docs = Docs::new("One colour.");
        let (kind, start) = (Kind::Colour, start(branches[0], ""));
        found.push(Alternative { name: "colour".to_owned(), docs, kind, key: None, start });
        branches.drain(..2);
    }
    for branch in branches {
        found.push(alternative(branch, about)?);
    }
    Some(found)
}

fn alternative(branch: Node, about: &str) -> Option<Alternative> {
    let description = branch.about();
    let key = branch.only_key();
    let inner = key.and_then(|key| branch.key(key));
    let words = if unit(description).is_empty() { about } else { description };
    let kind = match (inner, branch.tag()) {
        (Some(inner), _) => kind_of(inner, description)?,
        (None, Some(_)) => Kind::Table,
        (None, None) => kind_of(branch, words)?,
    };
    let name = key.or(branch.tag()).unwrap_or_else(|| name_of(&kind)).to_owned();
    let start = start(branch, key.unwrap_or_default());
    Some(Alternative { name, docs: Docs::new(description), kind, key: key.map(str::to_owned), start })
}

/// What an alternative is called that has neither key nor tag.
fn name_of(kind: &Kind) -> &'static str {
    match kind {
        Kind::Bool => "switch",
        Kind::Integer { .. } | Kind::Number { .. } => "one value",
        Kind::Text => "text",
        Kind::File { .. } => "file",
        Kind::Colour => "colour",
        Kind::Vector { len: 2, .. } => "from, to",
        Kind::Vector { .. } => "each axis",
        Kind::Choice(_) => "ready-made",
        Kind::Union(_) => "several",
        Kind::Table => "own values",
        Kind::List { .. } => "list",
        Kind::Curve { .. } => "curve",
        Kind::Ramp => "tones",
    }
}

fn plain(node: Node, about: &str) -> Option<Kind> {
    let unit = unit(about);
    match node.text("type") {
        "boolean" => Some(Kind::Bool),
        "integer" => Some(Kind::Integer { range: range(node, true, about), unit }),
        "number" => Some(Kind::Number { range: range(node, false, about), unit }),
        "string" => Some(text(node)),
        "object" if node.only_key().is_some() => Some(Kind::Union(vec![alternative(node, about)?])),
        "object" => Some(Kind::Table),
        "array" => array(node, about, unit),
        _ => None,
    }
}

fn text(node: Node) -> Kind {
    let (formats, names) = (node.words("x-files"), node.words("examples"));
    let pattern = node.text("pattern").strip_prefix("^(").and_then(|rest| rest.strip_suffix(")$"));
    let word = |word: &str| Word { word: word.to_owned(), docs: Docs::default() };
    match pattern {
        Some(words) => Kind::Choice(words.split('|').map(word).collect()),
        None if !formats.is_empty() => Kind::File { formats, names },
        None if !names.is_empty() => Kind::Choice(names.iter().map(|name| word(name)).collect()),
        None if node.text("pattern").starts_with("^#") => Kind::Colour,
        None => Kind::Text,
    }
}

fn array(node: Node, about: &str, unit: &'static str) -> Option<Kind> {
    let items = node.items()?;
    let is_number = items.is("number") || items.is("integer");
    match node.len() {
        Some(len) if is_number => {
            let whole = items.is("integer");
            Some(Kind::Vector { len, whole, range: range(items, whole, about), unit })
        }
        None if items.len() == Some(2) && items.items().is_some_and(|item| item.is("number")) => {
            let is_life = node.about().contains("age");
            let (x, x_unit) = if is_life { (SHARE, "") } else { (DISTANCE, "s") };
            Some(Kind::Curve {
                x,
                x_unit,
                y: stated_range(about).unwrap_or(crate::limits::FACTOR),
                y_unit: unit,
            })
        }
        None if is_tone(items) => Some(Kind::Ramp),
        _ => list(node, false),
    }
}

fn list(node: Node, alone: bool) -> Option<Kind> {
    let items = node.items()?;
    let item = Box::new(kind_of(items, items.about())?);
    Some(Kind::List { item, start: start(items, ""), len: node.len(), alone })
}

fn range(node: Node, whole: bool, about: &str) -> Limit {
    let layers = node.layers();
    let is_said =
        layers.iter().any(|layer| ["maximum", "exclusiveMaximum"].iter().any(|key| layer.get(key).is_some()));
    let stated = if is_said || whole { None } else { stated_range(about) };
    stated.unwrap_or_else(|| Limit::from_schemas(whole, &layers))
}

/// Hexadecimal digits, or three shares.
fn is_colour(branches: &[Node]) -> bool {
    matches!(branches, [hex, linear] if hex.text("pattern").starts_with("^#") && linear.len() == Some(3))
}

/// A colour, or a colour with its place.
fn is_tone(node: Node) -> bool {
    let branches = node.branches();
    branches.len() == 3 && is_colour(&branches[..2]) && branches[2].key("from").is_some()
}

/// Whether `value` has the shape of an alternative.
pub(super) fn is_present(alternative: &Alternative, value: &Value) -> bool {
    if let Some(key) = &alternative.key {
        return value.get(key).is_some();
    }
    let is_number = |value: &Value| value.is_integer() || value.is_float();
    let items = value.as_array();
    match &alternative.kind {
        Kind::Bool => value.is_bool(),
        Kind::Integer { .. } | Kind::Number { .. } => is_number(value),
        Kind::Text | Kind::File { .. } | Kind::Choice(_) => value.is_str(),
        Kind::Colour => value.is_str() || items.is_some_and(|items| items.iter().all(is_number)),
        Kind::Vector { .. } => items.is_some_and(|items| items.iter().all(is_number)),
        Kind::Table => {
            let tag = alternative.start.get("kind");
            value.is_table() && (tag.is_none() || value.get("kind") == tag)
        }
        Kind::List { .. } | Kind::Curve { .. } | Kind::Ramp => items.is_some(),
        Kind::Union(inner) => inner.iter().any(|inner| is_present(inner, value)),
    }
}

/// A value of the schema in TOML, which has no null; numbers of 32 bits as short as they were written.
pub(super) fn to_toml(json: &Schema) -> Option<Value> {
    let mut value = Value::try_from(json).ok()?;
    shorten(&mut value);
    Some(value)
}

fn shorten(value: &mut Value) {
    match value {
        Value::Float(number) => *number = (*number as f32).to_string().parse().unwrap_or(*number),
        Value::Array(items) => items.iter_mut().for_each(shorten),
        Value::Table(table) => table.iter_mut().for_each(|(_, value)| shorten(value)),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whoever adds a key to the format in a shape that no form can show learns it here.
    #[test]
    fn every_key_of_the_format_can_be_shown() {
        let mut seen = 0;
        let mut waiting = vec![Node::root()];
        waiting.extend(Node::definitions());
        while let Some(node) = waiting.pop() {
            waiting.extend(node.own_branches());
            for key in node.keys().into_iter().filter(|key| *key != "kind" || node.tag().is_none()) {
                let value = node.key(key).expect("a key of the table");
                let about = value.about();
                assert!(kind_of(value, about).is_some(), "`{key}` cannot be shown: {value:?}");
                let is_alternative = node.only_key() == Some(key);
                assert!(is_alternative || !about.is_empty(), "`{key}` has no words: {value:?}");
                seen += 1;
            }
        }
        assert!(seen > 300, "only {seen} keys");
    }
}
