//! What an inspector shows: every key of the scene format with its words, its range and its default, from the schema.

mod docs;
mod inherit;
mod kind;
mod node;
mod read;
mod start;

pub use docs::Docs;
pub use kind::{Alternative, Kind, Word};

use super::{Document, Path, Step, Value};
use crate::check::is_key_of;
use inherit::inherited;
use node::{Node, kind};
use read::{alternatives, is_present, kind_of};

/// Lists longer than this are not copied into forms; their elements have forms of their own.
const LONGEST: usize = 1024;

/// The keys of one table.
#[derive(Clone, Debug, PartialEq)]
pub struct Form {
    /// What the table is.
    pub docs: Docs,
    /// Its keys, in the order of the format; of an object only those that its kind has.
    pub fields: Vec<Field>,
}

/// One value and what can be said about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Where it is, or would be.
    pub path: Path,
    /// Its key for people.
    pub label: String,
    /// What it is.
    pub docs: Docs,
    /// What it can be.
    pub kind: Kind,
    /// Of several shapes, the one that it has, or that counts where the text says nothing: which of [`Kind::Union`]'s.
    pub present: Option<usize>,
    /// Whether it must be there.
    pub is_required: bool,
    /// Whether the text says it.
    pub is_set: bool,
    /// What the text says. Of tables and of very long lists only [`Field::is_set`] is known.
    pub value: Option<Value>,
    /// What counts where the text says nothing, as far as that is known: the default, or what the preset or the
    /// scene's style says.
    pub default: Option<Value>,
    /// What to set it to when it is first wanted: the default where it is known, else something that may stand there.
    pub start: Value,
}

impl Form {
    /// The form of the table at `path`, be it there or not; `None` where the format has no table there.
    ///
    /// Of tables with a `kind`, such as lights, the fields are those of their kind without `kind` itself, which
    /// [`Field::at`] shows as a [`Kind::Union`].
    #[must_use]
    pub fn at(document: &Document, path: &Path) -> Option<Self> {
        let kind = kind(document, path);
        let table = Node::at(document, path)?.table(None, kind.as_deref())?;
        let is_object = matches!(path.steps(), [Step::Key(object), _] if object == "object");
        let keys = table.keys().into_iter().filter(|key| {
            (table.tag().is_none() || *key != "kind") && (!is_object || is_key_of(key, kind.as_deref()))
        });
        let field = |key: &str| field(document, path.key(key), table.key(key)?, table.is_required(key));
        Some(Self { docs: Docs::new(table.about()), fields: keys.filter_map(field).collect() })
    }

    /// The field of `key`.
    #[must_use]
    pub fn field(&self, key: &str) -> Option<&Field> {
        let is_it = |field: &&Field| matches!(field.path.steps().last(), Some(Step::Key(own)) if own == key);
        self.fields.iter().find(is_it)
    }
}

impl Field {
    /// The field at `path`, which may be an element of an array; `None` where the format has nothing there.
    #[must_use]
    pub fn at(document: &Document, path: &Path) -> Option<Self> {
        let is_required = match path.split_last()? {
            (parent, Step::Key(key)) => {
                let kind = kind(document, &parent);
                let table = Node::at(document, &parent)?.table(Some(key), kind.as_deref());
                table.is_some_and(|table| table.is_required(key))
            }
            _ => true,
        };
        field(document, path.clone(), Node::at(document, path)?, is_required)
    }

    /// What the value becomes when alternative `index` is chosen: what it starts with, with the keys that the present
    /// value has too.
    #[must_use]
    pub fn switched(&self, index: usize, present: Option<&Value>) -> Option<Value> {
        let Kind::Union(alternatives) = &self.kind else { return None };
        let mut start = alternatives.get(index)?.start.clone();
        if let Some(old) = present.and_then(number) {
            fill(&mut start, &old);
        } else if number(&start).is_some() {
            return Some(present.and_then(first_number).unwrap_or(start));
        }
        let (Value::Table(table), Some(Value::Table(old))) = (&mut start, present) else {
            return Some(start);
        };
        let inner = |table: &toml::Table| match table.iter().next() {
            Some((key, Value::Table(_))) if table.len() == 1 => Some(key.clone()),
            _ => None,
        };
        let (to, from) = (inner(table), inner(old));
        let nested = to.as_ref().and_then(|key| table.get_mut(key)).and_then(Value::as_table_mut);
        let old = from.and_then(|key| old.get(&key)).and_then(Value::as_table).unwrap_or(old);
        let table = match nested {
            Some(nested) => nested,
            None => table,
        };
        for (key, value) in table.iter_mut().filter(|(key, _)| *key != "kind") {
            if let Some(old) = old.get(key).filter(|old| old.same_type(value)) {
                *value = old.clone();
            }
        }
        Some(start)
    }
}

fn number(value: &Value) -> Option<Value> {
    (value.is_integer() || value.is_float()).then(|| value.clone())
}

/// The value of the first point, or the first number, of an array.
fn first_number(value: &Value) -> Option<Value> {
    let first = value.as_array()?.first()?;
    number(first).or_else(|| number(first.as_array()?.last()?))
}

/// Lets one number count all along a curve, along all axes, or from the least to the most.
fn fill(start: &mut Value, old: &Value) {
    for item in start.as_array_mut().into_iter().flatten() {
        match item {
            Value::Array(point) => {
                if let Some(y) = point.last_mut() {
                    *y = old.clone();
                }
            }
            item => *item = old.clone(),
        }
    }
}

fn field(document: &Document, path: Path, node: Node, is_required: bool) -> Option<Field> {
    let about = node.about();
    let kind = match kind_of(node, about)? {
        Kind::Table if !node.branches().is_empty() => Kind::Union(alternatives(node, about)?),
        kind => kind,
    };
    let count = document.count(&path);
    let value = match count > LONGEST {
        true => document.get(&path.index(0)).map(|first| Value::Array(vec![first])),
        false => document.get(&path),
    };
    let shown = value.as_ref().filter(|_| count <= LONGEST && !matches!(kind, Kind::Table)).cloned();
    let key = match path.steps().last() {
        Some(Step::Key(key)) => docs::label(key),
        Some(Step::Index(index)) => format!("{}", index + 1),
        None => String::new(),
    };
    let default = inherited(document, &path).or_else(|| start::default_of(node));
    let default = default.or_else(|| docs::stated_default(about));
    let present = match (&kind, value.as_ref().or(default.as_ref())) {
        (Kind::Union(all), Some(value)) => all.iter().position(|one| is_present(one, value)),
        _ => None,
    };
    let own = match path.steps().last() {
        Some(Step::Key(key)) => key.as_str(),
        _ => "",
    };
    Some(Field {
        start: match &default {
            _ if matches!(kind, Kind::Table) => start::table(node),
            Some(default) => default.clone(),
            None => start::start(node, own),
        },
        default,
        label: key,
        docs: Docs::new(about),
        present,
        is_required,
        is_set: value.is_some(),
        value: shown,
        kind,
        path,
    })
}
