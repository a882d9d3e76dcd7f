use std::ops::Range;

/// Where something stood: which text, and which bytes of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Place {
    /// Index of the text in the [`Log`](crate::report::Log).
    pub(crate) text: usize,
    pub(crate) span: Range<usize>,
}

/// A value and its place.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub(crate) place: Place,
    pub(crate) value: Value,
}

/// What TOML can say.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    String(String),
    /// Wider than TOML's 64 bits, so that a number too large is seen as that.
    Integer(i128),
    Float(f64),
    Bool(bool),
    Datetime,
    Array(Vec<Node>),
    Table(Table),
}

/// Keys and their values.
#[derive(Clone, Debug, Default)]
pub(crate) struct Table {
    pub(crate) entries: Vec<Entry>,
    /// Keys whose values were reported and taken out, so that the rest can be checked.
    pub(crate) removed: Vec<String>,
}

/// A key and its value.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) key_place: Place,
    pub(crate) node: Node,
}

impl Table {
    pub(crate) fn get(&self, key: &str) -> Option<&Node> {
        self.entries.iter().find(|entry| entry.key == key).map(|entry| &entry.node)
    }

    pub(crate) fn get_mut(&mut self, key: &str) -> Option<&mut Node> {
        self.entries.iter_mut().find(|entry| entry.key == key).map(|entry| &mut entry.node)
    }

    /// Puts `entry` in, in the place of one with the same key.
    pub(crate) fn insert(&mut self, entry: Entry) {
        self.entries.retain(|old| old.key != entry.key);
        self.entries.push(entry);
    }

    /// Takes `key` out and remembers that it was there.
    pub(crate) fn remove(&mut self, key: &str) {
        self.entries.retain(|entry| entry.key != key);
        self.removed.push(key.to_owned());
    }
}

impl Node {
    pub(crate) fn as_table(&self) -> Option<&Table> {
        match &self.value {
            Value::Table(table) => Some(table),
            _ => None,
        }
    }

    pub(crate) fn as_str(&self) -> Option<&str> {
        match &self.value {
            Value::String(text) => Some(text),
            _ => None,
        }
    }

    /// Whether something was taken out of it, or of anything in it.
    pub(crate) fn is_damaged(&self) -> bool {
        match &self.value {
            Value::Table(table) => {
                !table.removed.is_empty() || table.entries.iter().any(|entry| entry.node.is_damaged())
            }
            Value::Array(items) => items.iter().any(Self::is_damaged),
            _ => false,
        }
    }

    /// What it is, for people: "a number", "a table".
    pub(crate) fn type_name(&self) -> String {
        match &self.value {
            Value::String(text) if text.chars().count() <= 24 => format!("the string {text:?}"),
            Value::String(_) => "a string".into(),
            Value::Integer(value) => format!("the whole number {value}"),
            Value::Float(value) => format!("the number {value}"),
            Value::Bool(value) => format!("`{value}`"),
            Value::Datetime => "a date".into(),
            Value::Array(items) if items.is_empty() => "an empty array".into(),
            Value::Array(_) => "an array".into(),
            Value::Table(_) => "a table".into(),
        }
    }

    /// The same without places, for serde.
    pub(crate) fn to_toml(&self) -> toml::Value {
        match &self.value {
            Value::String(text) => text.clone().into(),
            Value::Integer(value) => match i64::try_from(*value) {
                Ok(value) => value.into(),
                Err(_) => (*value as f64).into(),
            },
            Value::Float(value) => (*value).into(),
            Value::Bool(value) => (*value).into(),
            Value::Datetime => toml::Value::String("a date".into()),
            Value::Array(items) => toml::Value::Array(items.iter().map(Self::to_toml).collect()),
            Value::Table(table) => toml::Value::Table(
                table.entries.iter().map(|entry| (entry.key.clone(), entry.node.to_toml())).collect(),
            ),
        }
    }
}
