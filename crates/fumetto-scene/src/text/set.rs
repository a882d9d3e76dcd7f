//! `--set path=value`: edits of the tree before it is read.

use super::path::{PathStep, parse_path};
use super::{Entry, Node, Place, Table, Value, parse_value};
use crate::fit::did_you_mean;
use crate::report::{Log, Severity};

/// The name under which problems of overrides are reported.
const FILE: &str = "--set";

/// Puts every value of `overrides` at its path into `root`.
///
/// All overrides are one text in reports, each on a line of its own.
pub(crate) fn apply(log: &Log, root: &mut Node, overrides: &[(String, String)]) {
    if overrides.is_empty() {
        return;
    }
    let lines: Vec<String> = overrides.iter().map(|(path, value)| format!("{path}={value}")).collect();
    let text = log.add_text(FILE, &lines.join("\n"));
    let mut start = 0;
    for ((path, value), line) in overrides.iter().zip(&lines) {
        let edit = Edit { text, start, path, value };
        if let Err(failure) = edit.apply(root) {
            log.report(
                Severity::Error,
                "bad-set",
                FILE,
                Some(&failure.place),
                failure.message,
                Some(failure.help),
            );
        }
        start += line.len() + 1;
    }
}

struct Edit<'a> {
    text: usize,
    /// Where the override begins in the text.
    start: usize,
    path: &'a str,
    value: &'a str,
}

struct Failure {
    place: Place,
    message: String,
    help: String,
}

impl Edit<'_> {
    fn apply(&self, root: &mut Node) -> Result<(), Failure> {
        let steps = parse_path(self.path).map_err(|bad| self.fail(bad.at, bad.len, bad.message, bad.help))?;
        let Some((last, parents)) = steps.split_last() else { return Ok(()) };
        let mut node = root;
        for (i, step) in parents.iter().enumerate() {
            node = self.enter(node, step, steps[i + 1].is_index)?;
        }
        let value = self.value();
        if let (Value::Table(table), false) = (&mut node.value, last.is_index) {
            let (key, key_place) = (last.name.to_string(), self.place(last.at, last.len));
            table.insert(Entry { key, key_place, node: value });
        } else {
            *self.enter(node, last, false)? = value;
        }
        Ok(())
    }

    /// Goes one step down, making a table where there is nothing yet.
    fn enter<'n>(
        &self,
        node: &'n mut Node,
        step: &PathStep<'_>,
        indexed: bool,
    ) -> Result<&'n mut Node, Failure> {
        let place = self.place(step.at, step.len);
        let kind = node.type_name();
        // `camera[0]` also names a lone `[camera]`.
        if step.is_index && step.name == "0" && node.as_table().is_some() {
            return Ok(node);
        }
        let (message, help) = match &mut node.value {
            Value::Table(_) if step.is_index => {
                (format!("there is no element {}", step.name), "only element 0 exists here".to_owned())
            }
            Value::Table(table) => {
                if table.get(&step.name).is_none() && !indexed {
                    let node = Node { place: place.clone(), value: Value::Table(Table::default()) };
                    let (key, key_place) = (step.name.to_string(), place.clone());
                    table.insert(Entry { key, key_place, node });
                }
                match table.get_mut(&step.name) {
                    Some(node) => return Ok(node),
                    None => (
                        format!("there is no `{}` to take an element of", step.name),
                        "set the whole array instead".to_owned(),
                    ),
                }
            }
            Value::Array(array) => match find(&array.items, step) {
                Ok(index) => return Ok(&mut array.items[index]),
                Err(failure) => failure,
            },
            _ => (
                format!("`{}` leads into {kind}", step.name),
                "only tables and arrays have something inside".to_owned(),
            ),
        };
        Err(Failure { place, message, help })
    }

    /// The value as TOML; what is no TOML is meant as a string, so that shells need no double quotes.
    fn value(&self) -> Node {
        let offset = self.path.len() + 1;
        parse_value(self.text, self.start + offset, self.value).unwrap_or_else(|| Node {
            place: self.place(offset, self.value.len()),
            value: Value::String(self.value.to_owned()),
        })
    }

    fn place(&self, at: usize, len: usize) -> Place {
        Place { text: self.text, span: self.start + at..self.start + at + len }
    }

    fn fail(&self, at: usize, len: usize, message: &str, help: &str) -> Failure {
        Failure { place: self.place(at, len), message: message.into(), help: help.into() }
    }
}

/// The element that a step names, by number or by its own `name`; or a message and a help line.
fn find(items: &[Node], step: &PathStep<'_>) -> Result<usize, (String, String)> {
    let name_of = |item: &Node| item.as_table()?.get("name")?.as_str().map(str::to_owned);
    let names: Vec<String> = items.iter().filter_map(name_of).collect();
    let by_name = || items.iter().position(|item| name_of(item).as_deref() == Some(&*step.name));
    if let Some(index) = by_name().filter(|_| !step.is_index) {
        return Ok(index);
    }
    match step.name.parse() {
        Ok(index) if index < items.len() => Ok(index),
        Ok(index) => {
            let help = format!("this array has {} elements, counted from 0", items.len());
            Err((format!("there is no element {index}"), help))
        }
        Err(_) if names.is_empty() => {
            let help = "count its elements from 0, as in `camera.eye[0]`".to_owned();
            Err((format!("`{}` is not the number of an element", step.name), help))
        }
        Err(_) => {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            Err((format!("nothing here is named `{}`", step.name), did_you_mean(&step.name, &names)))
        }
    }
}
