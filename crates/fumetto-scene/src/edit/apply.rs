//! One edit, as changes of the text.

use super::list::{duplicate, insert, remove_item, reorder};
use super::names::free_name;
use super::sections::{Section, sections};
use super::splices::Splices;
use super::syntax::{Syntax, Written};
use super::{Edit, EditError, Path, Step, Value};

/// A text with the changes that are gathered for it.
pub(super) struct Draft<'a> {
    pub(super) syntax: &'a Syntax,
    pub(super) sections: Vec<Section>,
    pub(super) splices: Splices,
}

impl<'a> Draft<'a> {
    pub(super) fn new(syntax: &'a Syntax) -> Self {
        Self { syntax, sections: sections(syntax), splices: Splices::default() }
    }

    pub(super) fn text(&self) -> &'a str {
        self.syntax.text()
    }

    pub(super) fn finish(self) -> String {
        self.splices.apply(self.syntax.text())
    }

    /// What is at `path`, and the path without names of elements.
    pub(super) fn find(&self, path: &Path) -> Result<(Vec<Step>, Written<'a>), EditError> {
        self.syntax.find(path.steps()).ok_or_else(|| EditError::Missing(path.clone()))
    }
}

/// The text after `edit`, which is neither the whole text nor several edits.
pub(super) fn changed(syntax: &Syntax, edit: &Edit) -> Result<String, EditError> {
    let mut draft = Draft::new(syntax);
    match edit {
        Edit::Set { path, value } => draft.set(path, value)?,
        Edit::Remove { path } => {
            if let Some((steps, written)) = syntax.find(path.steps()) {
                remove_item(&mut draft, &steps, written);
            }
        }
        Edit::Insert { list, index, item } => insert(&mut draft, list, *index, item)?,
        Edit::Duplicate { path } => duplicate(&mut draft, path)?,
        Edit::Move { path, to } => reorder(&mut draft, path, *to)?,
        Edit::Rename { path, name } => {
            let (steps, written) = draft.find(path)?;
            if name.is_empty() {
                return Err(EditError::EmptyName);
            }
            let own = written.key("name").map(Written::value);
            if own.as_ref().and_then(Value::as_str) != Some(name) && free_name(syntax, &steps, name) != *name
            {
                return Err(EditError::NameTaken(name.clone()));
            }
            draft.set(&Path::from(steps).key("name"), &Value::String(name.clone()))?;
        }
        Edit::ReplaceText(_) | Edit::All { .. } => {}
    }
    Ok(draft.finish())
}
