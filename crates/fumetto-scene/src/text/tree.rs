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
    Array(Array),
    Table(Table),
}

/// Values in a row.
#[derive(Clone, Debug, Default)]
pub(crate) struct Array {
    pub(crate) items: Vec<Node>,
    /// Rising numbers, in the text, of the items that were reported and taken out.
    pub(crate) removed: Vec<usize>,
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

    /// Takes some keys out and remembers that they were there.
    pub(crate) fn remove_where(&mut self, go: impl Fn(&str) -> bool) -> Vec<Entry> {
        let entries = std::mem::take(&mut self.entries);
        let (gone, kept) = entries.into_iter().partition::<Vec<_>, _>(|entry| go(&entry.key));
        self.entries = kept;
        self.removed.extend(gone.iter().map(|entry| entry.key.clone()));
        gone
    }
}

impl Array {
    /// Keeps what `fits`, and remembers what it took out.
    pub(crate) fn retain(&mut self, fits: &[bool]) {
        self.removed = fits.iter().enumerate().filter(|(_, fits)| !**fits).map(|(i, _)| i).collect();
        let mut fits = fits.iter();
        self.items.retain(|_| fits.next().is_none_or(|fits| *fits));
    }

    /// The number that an item, now number `index`, has in the text.
    pub(crate) fn index_in_text(&self, index: usize) -> usize {
        self.removed.iter().fold(index, |index, removed| index + usize::from(*removed <= index))
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
            Value::Array(array) => !array.removed.is_empty() || array.items.iter().any(Self::is_damaged),
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
            Value::Array(array) if array.items.is_empty() => "an empty array".into(),
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
            Value::Array(array) => toml::Value::Array(array.items.iter().map(Self::to_toml).collect()),
            Value::Table(table) => toml::Value::Table(
                table.entries.iter().map(|entry| (entry.key.clone(), entry.node.to_toml())).collect(),
            ),
        }
    }
}
