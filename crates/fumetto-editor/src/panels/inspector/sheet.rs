//! What all parts of the inspector need: the forms, and a way to change what they show.

use std::collections::BTreeMap;
use std::rc::Rc;

use egui::Response;
use fumetto_scene::edit::form::{Field, Form, Kind};
use fumetto_scene::edit::{Document, Edit, Path, Value};

use crate::request::Requests;

/// Forms that were made from the document as it is. They are made once for each of its revisions.
#[derive(Default)]
pub(super) struct Forms {
    revision: Option<u64>,
    forms: BTreeMap<Path, Option<Rc<Form>>>,
    fields: BTreeMap<Path, Option<Rc<Field>>>,
}

impl Forms {
    pub(super) fn keep_up(&mut self, document: &Document) {
        if self.revision != Some(document.revision()) {
            *self = Self { revision: Some(document.revision()), ..Self::default() };
        }
    }
}

/// Of these keys of one table only one may be set.
const EITHER: [&[&str]; 2] = [&["tones", "ramp", "gooch"], &["colour", "gradient", "image", "paper"]];

/// What is shown and what is asked for.
pub(super) struct Sheet<'a> {
    pub(super) document: &'a Document,
    forms: &'a mut Forms,
    pub(super) requests: &'a mut Requests,
    /// Where values begin, so that they stand in one column however deep they are.
    pub(super) value_x: f32,
}

/// One value, by itself or as one shape of several.
#[derive(Clone, Copy)]
pub(super) struct Slot<'a> {
    pub(super) path: &'a Path,
    /// For those who hear the window.
    pub(super) name: &'a str,
    pub(super) kind: &'a Kind,
    /// What is said, or else what counts.
    pub(super) value: Option<&'a Value>,
    /// What it is first set to.
    pub(super) start: &'a Value,
}

impl<'a> Slot<'a> {
    pub(super) fn of(field: &'a Field) -> Self {
        Self {
            path: &field.path,
            name: &field.label,
            kind: &field.kind,
            value: field.value.as_ref().or(field.default.as_ref()),
            start: &field.start,
        }
    }
}

impl<'a> Sheet<'a> {
    pub(super) fn new(document: &'a Document, forms: &'a mut Forms, requests: &'a mut Requests) -> Self {
        Self { document, forms, requests, value_x: 0.0 }
    }

    pub(super) fn form(&mut self, path: &Path) -> Option<Rc<Form>> {
        let make = || Form::at(self.document, path).map(Rc::new);
        self.forms.forms.entry(path.clone()).or_insert_with(make).clone()
    }

    pub(super) fn field(&mut self, path: &Path) -> Option<Rc<Field>> {
        let make = || Field::at(self.document, path).map(Rc::new);
        self.forms.fields.entry(path.clone()).or_insert_with(make).clone()
    }

    /// Sets a value, as a step of its own or, where `response` is dragged, as part of one.
    pub(super) fn write(&mut self, response: &Response, path: &Path, value: Value) {
        if response.dragged() { self.slide(path, value) } else { self.set(path, value) }
    }

    /// Sets a value as a step of its own.
    pub(super) fn set(&mut self, path: &Path, value: Value) {
        let edit = self.setting(path, value);
        self.requests.edit(edit);
    }

    /// Sets a value that will be set again until the pointer is let go.
    pub(super) fn slide(&mut self, path: &Path, value: Value) {
        let edit = self.setting(path, value);
        self.requests.drag(path.to_string(), edit);
    }

    pub(super) fn remove(&mut self, path: &Path) {
        self.requests.edit(Edit::Remove { path: path.clone() });
    }

    /// The edit that sets a value and takes away what cannot be beside it.
    fn setting(&self, path: &Path, value: Value) -> Edit {
        let set = Edit::Set { path: path.clone(), value };
        let rivals = rivals(path).into_iter().filter(|rival| self.document.get(rival).is_some());
        let mut edits: Vec<Edit> = rivals.map(|path| Edit::Remove { path }).collect();
        if edits.is_empty() {
            return set;
        }
        let label = set.label();
        edits.push(set);
        Edit::All { label, edits }
    }
}

/// The keys beside `path` that exclude it.
fn rivals(path: &Path) -> Vec<Path> {
    let mut found = Vec::new();
    let steps = path.steps();
    for (at, step) in steps.iter().enumerate().skip(1) {
        let parent = Path::from(steps[..at].to_vec());
        let fumetto_scene::edit::Step::Key(key) = step else { continue };
        let is_owner = matches!(parent.steps().last(), Some(fumetto_scene::edit::Step::Key(owner))
            if matches!(owner.as_str(), "style" | "background" | "inside" | "outside"));
        let group = EITHER.iter().find(|group| group.contains(&key.as_str()));
        let others = group.filter(|_| is_owner).into_iter().flat_map(|group| group.iter());
        found.extend(others.filter(|other| **other != key).map(|other| parent.key(*other)));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_excludes_each_other_is_replaced() {
        let shown = |path: &str| {
            let path = path.parse().expect("it is a path");
            rivals(&path).iter().map(Path::to_string).collect::<Vec<_>>()
        };
        assert_eq!(shown("style.gooch.warm"), ["style.tones", "style.ramp"]);
        assert_eq!(shown("object[0].style.tones"), ["object[0].style.ramp", "object[0].style.gooch"]);
        assert_eq!(
            shown("background.paper"),
            ["background.colour", "background.gradient", "background.image"]
        );
        assert_eq!(shown("style.ink.colour"), [""; 0]);
    }
}
