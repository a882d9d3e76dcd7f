//! A scene's text, read so that every value is known with its place.

use std::ops::Range;

use toml_edit::{ArrayOfTables, Document as Tree, Item, Table, Value as Literal};

use super::{Path, Step, Value};

/// Why a text is no TOML.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: this is not valid TOML: {message}")]
pub struct SyntaxError {
    /// What is wrong.
    pub message: String,
    /// The line it is in, from 1.
    pub line: usize,
    /// The offending bytes of the text.
    pub span: Range<usize>,
}

/// A text that is TOML.
#[derive(Clone, Debug)]
pub(super) struct Syntax {
    tree: Tree<String>,
}

/// How a value is written.
#[derive(Clone, Copy, Debug)]
pub(super) enum Written<'a> {
    /// Under a header, or by keys with dots.
    Table(&'a Table),
    /// Under several headers `[[…]]`.
    Tables(&'a ArrayOfTables),
    /// After an equals sign, or in an array.
    Literal(&'a Literal),
}

/// How far a path leads.
pub(super) struct Found<'a> {
    /// The steps that exist, with names of elements replaced by their numbers.
    pub(super) steps: Vec<Step>,
    /// What they lead to.
    pub(super) written: Written<'a>,
    /// How many of the path's own steps they are.
    pub(super) taken: usize,
}

impl Syntax {
    pub(super) fn parse(text: &str) -> Result<Self, SyntaxError> {
        Tree::parse(text.to_owned()).map(|tree| Self { tree }).map_err(|error| {
            let end = text.len();
            let span = error.span().map_or(end..end, |span| span.start.min(end)..span.end.min(end));
            let before = text.as_bytes()[..span.start].iter().filter(|byte| **byte == b'\n');
            SyntaxError { message: error.message().to_owned(), line: before.count() + 1, span }
        })
    }

    pub(super) fn text(&self) -> &str {
        self.tree.raw()
    }

    pub(super) fn root(&self) -> &Table {
        self.tree.as_table()
    }

    /// Follows `path` as far as there is something.
    pub(super) fn follow(&self, path: &[Step]) -> Found<'_> {
        let mut found = Found { steps: Vec::new(), written: Written::Table(self.root()), taken: 0 };
        for step in path {
            let Some((step, written)) = found.written.child(step) else { break };
            found.steps.extend(step);
            found.written = written;
            found.taken += 1;
        }
        found
    }

    /// What is at `path`, and the path without names of elements.
    pub(super) fn find(&self, path: &[Step]) -> Option<(Vec<Step>, Written<'_>)> {
        let found = self.follow(path);
        (found.taken == path.len()).then_some((found.steps, found.written))
    }

    /// The value at `path`.
    pub(super) fn get(&self, path: &Path) -> Option<Value> {
        self.find(path.steps()).map(|(_, written)| written.value())
    }
}

impl<'a> Written<'a> {
    pub(super) fn of(item: &'a Item) -> Option<Self> {
        match item {
            Item::None => None,
            Item::Value(literal) => Some(Self::Literal(literal)),
            Item::Table(table) => Some(Self::Table(table)),
            Item::ArrayOfTables(tables) => Some(Self::Tables(tables)),
        }
    }

    /// What `step` leads to, and that step without a name; no step at all where a table stands for its own element.
    fn child(self, step: &Step) -> Option<(Option<Step>, Self)> {
        let index = match (step, self.is_table()) {
            (Step::Index(0), true) => return Some((None, self)),
            (Step::Index(_), true) => return None,
            (Step::Key(key), true) => return Some((Some(step.clone()), self.key(key)?)),
            (Step::Index(index), false) => *index,
            (Step::Key(name), false) => {
                let named = |index: &usize| self.item(*index).and_then(Self::name) == Some(name);
                (0..self.len()?).find(named).or_else(|| name.parse().ok())?
            }
        };
        Some((Some(Step::Index(index)), self.item(index)?))
    }

    pub(super) fn is_table(self) -> bool {
        matches!(self, Self::Table(_) | Self::Literal(Literal::InlineTable(_)))
    }

    /// Whether `value` can stand under the headers that this has.
    pub(super) fn keeps_headers(self, value: &Value) -> bool {
        match self {
            Self::Table(_) => value.is_table(),
            Self::Tables(_) => value.as_array().is_some_and(|items| items.iter().all(Value::is_table)),
            Self::Literal(_) => false,
        }
    }

    /// The value of `key` in this table.
    pub(super) fn key(self, key: &str) -> Option<Self> {
        match self {
            Self::Table(table) => Self::of(table.get(key)?),
            Self::Literal(Literal::InlineTable(table)) => table.get(key).map(Self::Literal),
            _ => None,
        }
    }

    /// The keys of this table.
    pub(super) fn keys(self) -> Vec<&'a str> {
        match self {
            Self::Table(table) => table.iter().map(|(key, _)| key).collect(),
            Self::Literal(Literal::InlineTable(table)) => table.iter().map(|(key, _)| key).collect(),
            _ => Vec::new(),
        }
    }

    /// How many elements this array has.
    pub(super) fn len(self) -> Option<usize> {
        match self {
            Self::Tables(tables) => Some(tables.len()),
            Self::Literal(Literal::Array(array)) => Some(array.len()),
            _ => None,
        }
    }

    /// An element of this array.
    pub(super) fn item(self, index: usize) -> Option<Self> {
        match self {
            Self::Tables(tables) => tables.get(index).map(Self::Table),
            Self::Literal(Literal::Array(array)) => array.get(index).map(Self::Literal),
            _ => None,
        }
    }

    fn name(self) -> Option<&'a str> {
        match self.key("name")? {
            Self::Literal(Literal::String(name)) => Some(name.value()),
            _ => None,
        }
    }

    /// What it says.
    pub(super) fn value(self) -> Value {
        match self {
            Self::Table(_) | Self::Literal(Literal::InlineTable(_)) => {
                let entry = |key: &'a str| Some((key.to_owned(), self.key(key)?.value()));
                Value::Table(self.keys().into_iter().filter_map(entry).collect())
            }
            Self::Tables(_) | Self::Literal(Literal::Array(_)) => {
                let items = 0..self.len().unwrap_or(0);
                Value::Array(items.filter_map(|index| self.item(index)).map(Self::value).collect())
            }
            Self::Literal(Literal::String(text)) => Value::String(text.value().clone()),
            Self::Literal(Literal::Integer(number)) => Value::Integer(*number.value()),
            Self::Literal(Literal::Float(number)) => Value::Float(*number.value()),
            Self::Literal(Literal::Boolean(truth)) => Value::Boolean(*truth.value()),
            Self::Literal(Literal::Datetime(moment)) => Value::Datetime(*moment.value()),
        }
    }
}
