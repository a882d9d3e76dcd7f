//! The scene as a list of rows, each below what it belongs to.

use std::collections::BTreeSet;

use fumetto_scene::edit::templates;
use fumetto_scene::edit::{Document, Path, Value};

use crate::icons::Icon;

/// A list with more elements than this is folded until it is wanted.
const FEW: usize = 8;

/// One line of the tree.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    /// What it selects.
    pub(super) path: Path,
    pub(super) depth: usize,
    pub(super) label: String,
    /// What it is, where the label is a name.
    pub(super) detail: String,
    pub(super) icon: Icon,
    /// Of objects: whether it is drawn.
    pub(super) visible: Option<bool>,
    /// Of what has rows below it: whether they are shown.
    pub(super) open: Option<bool>,
    pub(super) has_name: bool,
}

/// All rows that are shown. What is `toggled` is folded where it would be open, and the other way round.
pub(super) fn rows(document: &Document, toggled: &BTreeSet<Path>) -> Vec<Row> {
    let mut rows = Rows { document, toggled, rows: Vec::new() };
    let root = Path::root();
    rows.push(Row { label: "Scene".to_owned(), icon: Icon::Scene, ..Row::at(root.clone(), 0) });
    let cameras = root.key("camera");
    for i in 0..document.count(&cameras) {
        let path = cameras.index(i);
        let label = rows.text(&path.key("name")).unwrap_or_else(|| "Camera".to_owned());
        let row = Row { label, icon: Icon::Camera, has_name: true, ..Row::at(path, 1) };
        rows.push(row);
    }
    rows.elements(&root.key("light"), "Light", 1);
    let objects = root.key("object");
    for i in 0..document.count(&objects) {
        rows.object(&objects.index(i));
    }
    rows.rows
}

struct Rows<'a> {
    document: &'a Document,
    toggled: &'a BTreeSet<Path>,
    rows: Vec<Row>,
}

impl Row {
    fn at(path: Path, depth: usize) -> Self {
        let (label, detail) = (String::new(), String::new());
        Self { path, depth, label, detail, icon: Icon::Dot, visible: None, open: None, has_name: false }
    }
}

impl Rows<'_> {
    fn push(&mut self, row: Row) {
        self.rows.push(row);
    }

    fn text(&self, path: &Path) -> Option<String> {
        match self.document.get(path) {
            Some(Value::String(text)) => Some(text),
            _ => None,
        }
    }

    fn object(&mut self, path: &Path) {
        let kind = self.text(&path.key("kind")).unwrap_or_default();
        let label = self.text(&path.key("name")).unwrap_or_else(|| "nameless".to_owned());
        let visible = self.document.get(&path.key("visible")) != Some(Value::Boolean(false));
        let parts: Vec<_> =
            parts(&kind).filter(|(key, _)| self.document.count(&path.key(*key)) > 0).collect();
        let is_open = !self.toggled.contains(path);
        self.push(Row {
            label,
            icon: Icon::of_object(&kind),
            detail: kind,
            visible: Some(visible),
            open: (!parts.is_empty()).then_some(is_open),
            has_name: true,
            ..Row::at(path.clone(), 1)
        });
        for (key, name) in parts.into_iter().filter(|_| is_open) {
            self.part(&path.key(key), name);
        }
    }

    /// The elements of a list in an object, in a row of their own where there are many.
    fn part(&mut self, list: &Path, name: &str) {
        let count = self.document.count(list);
        if count <= FEW {
            return self.elements(list, name, 2);
        }
        let is_open = self.toggled.contains(list);
        let (label, detail) = (name.to_owned(), format!("{count}"));
        let icon = Icon::of_part(name);
        self.push(Row { label, detail, icon, open: Some(is_open), ..Row::at(list.clone(), 2) });
        if is_open {
            self.elements(list, name, 3);
        }
    }

    /// Each by its kind, or as `name`; those alike are numbered.
    fn elements(&mut self, list: &Path, name: &str, depth: usize) {
        let mut seen: Vec<(String, usize)> = Vec::new();
        for i in 0..self.document.count(list) {
            let path = list.index(i);
            let word =
                self.text(&path.key("kind")).map_or_else(|| name.to_owned(), |kind| capitalised(&kind));
            let icon = Icon::of_part(&word);
            let number = match seen.iter_mut().find(|(seen, _)| *seen == word) {
                Some((_, number)) => {
                    *number += 1;
                    *number
                }
                None => {
                    seen.push((word.clone(), 1));
                    1
                }
            };
            let label = if number == 1 { word } else { format!("{word} {number}") };
            self.push(Row { label, icon, ..Row::at(path, depth) });
        }
    }
}

/// The lists that an object of this kind can have, and what an element is called.
fn parts(kind: &str) -> impl Iterator<Item = (&'static str, &'static str)> {
    let mut last = "";
    templates::for_object(kind).filter_map(move |template| {
        let key = template.list.strip_prefix("object.")?;
        let is_new = key != last;
        last = key;
        is_new.then_some((key, template.name))
    })
}

/// The word with a capital.
fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(toml: &str, toggled: &[&str]) -> Vec<String> {
        let document = Document::open(toml).expect("it is short");
        let toggled = toggled.iter().map(|path| path.parse().expect("a path")).collect();
        let rows = rows(&document, &toggled);
        rows.iter().map(|row| format!("{}{}", "-".repeat(row.depth), row.label)).collect()
    }

    const SCENE: &str = "[camera]\neye = [0, 0, 5]\n[[light]]\nkind = \"sun\"\n[[light]]\nkind = \"sun\"\n\
        [[object]]\nname = \"steam\"\nkind = \"smoke\"\n[object.emitter]\nrate = 3\n[[object.force]]\nkind = \"wind\"\n";

    #[test]
    fn parts_stand_below_their_object() {
        let all = ["Scene", "-Camera", "-Sun", "-Sun 2", "-steam", "--Emitter", "--Wind"];
        assert_eq!(labels(SCENE, &[]), all);
        assert_eq!(labels(SCENE, &["object[0]"]), all[..5]);
    }

    #[test]
    fn many_elements_are_folded_until_they_are_wanted() {
        let particles = ["{ center = [0, 0, 0], radius = 1 }"; 9].join(", ");
        let toml = format!("[[object]]\nname = \"c\"\nkind = \"cloud\"\nparticles = [{particles}]\n");
        assert_eq!(labels(&toml, &[]), ["Scene", "-c", "--Particle"]);
        assert_eq!(labels(&toml, &["object[0].particles"]).last().map(String::as_str), Some("---Particle 9"));
    }
}
