//! Elements that come, go and change places.

use toml_edit::Value as Literal;

use super::apply::Draft;
use super::blocks::keys;
use super::names::{default_name, free_name, name_of};
use super::set::step;
use super::syntax::{Syntax, Written};
use super::{EditError, Item, Path, Step, Value, array, write};

/// Puts a new element into the array at `list`.
pub(super) fn insert(draft: &mut Draft<'_>, list: &Path, index: usize, item: &Item) -> Result<(), EditError> {
    let found = draft.syntax.follow(list.steps());
    let len = match found.written.len() {
        _ if found.taken < list.steps().len() => 0,
        Some(len) => len,
        None if found.written.is_table() => 1,
        None => return Err(EditError::NotAnArray(list.clone())),
    };
    if index > len {
        return Err(EditError::OutOfRange { list: list.clone(), len, index });
    }
    let is_there = found.taken == list.steps().len();
    let steps: Vec<Step> =
        found.steps.into_iter().chain(list.steps()[found.taken..].iter().cloned()).collect();
    let element = Element::new(draft.syntax, list, &steps, item)?;
    if !is_there {
        return element.first(draft, list);
    }
    element.put(draft, &steps, found.written, index);
    Ok(())
}

/// Puts a copy of the element at `path` behind it.
pub(super) fn duplicate(draft: &mut Draft<'_>, path: &Path) -> Result<(), EditError> {
    let (steps, written) = draft.find(path)?;
    // A table that stands alone is its own only element.
    let (list, index) = match steps.split_last() {
        Some((Step::Index(index), list)) => (list.to_vec(), *index),
        Some(_) if written.is_table() => (steps.clone(), 0),
        _ => return Err(EditError::NotAnArray(path.clone())),
    };
    let Some((_, owner)) = draft.syntax.find(&list) else { return Err(EditError::Missing(path.clone())) };
    let mut block = matches!(written, Written::Table(_)).then(|| draft.block_text(&steps));
    if owner.is_table() {
        block = block.and_then(|text| as_element(&text, &list));
    }
    let mut element = Element { value: written.value(), block: block.filter(|text| !text.is_empty()) };
    if let Some(name) = name_of(&list, written) {
        element.rename(&list, &free_name(draft.syntax, &list, &name));
    }
    element.put(draft, &list, owner, index + 1);
    Ok(())
}

/// Takes an element or a key away.
pub(super) fn remove_item(draft: &mut Draft<'_>, steps: &[Step], written: Written<'_>) {
    let Some((last, owner)) = steps.split_last() else { return };
    match (last, draft.syntax.find(owner)) {
        (Step::Index(index), Some((_, Written::Literal(Literal::Array(array))))) => {
            array::remove(draft, array, *index..index + 1);
        }
        (Step::Index(_), _) => draft.remove_sections(steps),
        (Step::Key(_), _) => draft.remove_key(steps, written),
    }
}

/// Gives an element another place.
pub(super) fn reorder(draft: &mut Draft<'_>, path: &Path, to: usize) -> Result<(), EditError> {
    let (steps, written) = draft.find(path)?;
    let (from, list) = match steps.split_last() {
        Some((Step::Index(index), list)) => (*index, list),
        _ if written.is_table() && to == 0 => return Ok(()),
        _ => return Err(EditError::NotAnArray(path.clone())),
    };
    let owner = draft.syntax.find(list).map(|(_, owner)| owner);
    let len = owner.and_then(Written::len).unwrap_or(0);
    if to >= len {
        return Err(EditError::OutOfRange { list: Path::from(list.to_vec()), len, index: to });
    }
    match owner {
        Some(Written::Literal(Literal::Array(array))) => array::reorder(draft, array, from, to),
        _ if from != to => {
            let block = draft.block_text(&steps);
            let at = draft.before_element(list, if to > from { to + 1 } else { to });
            draft.remove_sections(&steps);
            draft.insert_block(at, &block);
        }
        _ => {}
    }
    Ok(())
}

/// A new element, in both ways in which it can be written.
struct Element {
    value: Value,
    /// Under its full header, with comments.
    block: Option<String>,
}

impl Element {
    fn new(syntax: &Syntax, list: &Path, steps: &[Step], item: &Item) -> Result<Self, EditError> {
        let mut element = match item {
            Item::Value(value) => Self { value: value.clone(), block: None },
            Item::Snippet(text) => {
                let value = element_of(steps, text).ok_or_else(|| EditError::BadSnippet(list.clone()))?;
                Self { value, block: Some(text.trim_matches(['\n', '\r']).to_owned()) }
            }
        };
        let said = element.value.get("name").and_then(Value::as_str).map(str::to_owned);
        if let Some(name) = said.or_else(|| default_name(steps).filter(|_| element.value.is_table())) {
            let free = free_name(syntax, steps, &name);
            if free != name {
                element.rename(steps, &free);
            }
        }
        Ok(element)
    }

    /// Gives it another name, wherever it is written.
    fn rename(&mut self, list: &[Step], name: &str) {
        let name = Value::String(name.to_owned());
        if let Some(text) = &self.block
            && let Ok(syntax) = Syntax::parse(text)
        {
            let mut draft = Draft::new(&syntax);
            let keys = list.iter().filter(|step| matches!(step, Step::Key(_))).cloned();
            let path = deepest(&syntax, &keys.collect::<Vec<_>>()).key("name");
            self.block = draft.set(&path, &name).is_ok().then(|| draft.finish());
        }
        if let Value::Table(table) = &mut self.value {
            table.insert("name".to_owned(), name);
        }
    }

    /// Makes an array with this alone.
    fn first(self, draft: &mut Draft<'_>, list: &Path) -> Result<(), EditError> {
        let found = draft.syntax.follow(list.steps());
        let is_next = found.taken + 1 == list.steps().len();
        if let (Some(block), Some(Step::Key(key)), true) = (&self.block, list.steps().last(), is_next) {
            let has_header = draft.sections.iter().any(|section| section.path == found.steps);
            if found.steps.is_empty() || has_header {
                let at = draft.room_for(&step(&found.steps, Step::Key(key.clone())));
                draft.insert_block(at, block);
                return Ok(());
            }
        }
        draft.set(list, &Value::Array(vec![self.value]))
    }

    /// Puts it into an array that is there, or beside a table that stands alone.
    fn put(self, draft: &mut Draft<'_>, list: &[Step], owner: Written<'_>, index: usize) {
        let keys = keys(list);
        match (owner, &self.value) {
            (Written::Literal(Literal::Array(array)), value) => {
                array::insert(draft, array, index, &[write::inline(value)]);
            }
            (Written::Tables(_), Value::Table(table)) => {
                let block = self.block.unwrap_or_else(|| write::block(&format!("[[{keys}]]"), &keys, table));
                let at = draft.before_element(list, index);
                draft.insert_block(at, &block);
            }
            (Written::Literal(literal), value) if literal.span().is_some() => {
                let Some(span) = literal.span() else { return };
                let new = write::inline(value);
                let (before, after) = if index == 0 {
                    (format!("[{new}, "), "]".to_owned())
                } else {
                    ("[".to_owned(), format!(", {new}]"))
                };
                draft.splices.insert(span.start, before);
                draft.splices.insert(span.end, after);
            }
            (Written::Table(_), Value::Table(table)) if draft.sections.iter().any(|one| one.path == list) => {
                let Some(own) = draft.sections.iter().find(|one| one.path == list) else { return };
                let (header, start) = (own.header.clone(), own.range.start);
                let block = self.block.unwrap_or_else(|| write::block(&format!("[[{keys}]]"), &keys, table));
                let at = if index == 0 { start } else { draft.room_for(list) };
                draft.insert_block(at, &block);
                draft.splices.insert(header.start, "[");
                draft.splices.insert(header.end, "]");
            }
            (_, value) => {
                let mut all = match owner.value() {
                    Value::Array(items) => items,
                    alone => vec![alone],
                };
                all.insert(index.min(all.len()), value.clone());
                draft.rewrite(list, owner, &Value::Array(all));
            }
        }
    }
}

/// A table under the header of one that stands alone, with that of an element.
fn as_element(text: &str, list: &[Step]) -> Option<String> {
    let syntax = Syntax::parse(text).ok()?;
    let mut draft = Draft::new(&syntax);
    let keys: Vec<Step> = list.iter().filter(|step| matches!(step, Step::Key(_))).cloned().collect();
    let header = draft.sections.iter().find(|section| section.path == keys)?.header.clone();
    draft.splices.insert(header.start, "[");
    draft.splices.insert(header.end, "]");
    Some(draft.finish())
}

/// The element of the array `list` that a snippet holds.
fn element_of(list: &[Step], text: &str) -> Option<Value> {
    let syntax = Syntax::parse(text).ok()?;
    let keys: Vec<Step> = list.iter().filter(|step| matches!(step, Step::Key(_))).cloned().collect();
    let element = syntax.get(&deepest(&syntax, &keys))?;
    element.is_table().then_some(element)
}

/// The path that `keys` lead to in a snippet, through the only element of each array.
fn deepest(syntax: &Syntax, keys: &[Step]) -> Path {
    let mut path = Path::root();
    for key in keys {
        path = path.with(key.clone());
        if syntax.find(path.steps()).is_some_and(|(_, written)| written.len() == Some(1)) {
            path = path.index(0);
        }
    }
    path
}
