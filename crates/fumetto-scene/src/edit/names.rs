//! Names that no two objects, and no two cameras, share.

use super::syntax::{Syntax, Written};
use super::{Step, Value};

/// What a camera is called that does not say.
const CAMERA: &str = "main";

/// `wanted`, or with a number behind it where another element of the same array has it: "puff", "puff 2". `element` is
/// any of the array's elements, which may not be there yet.
pub(super) fn free_name(syntax: &Syntax, element: &[Step], wanted: &str) -> String {
    let list = match element.split_last() {
        Some((Step::Index(_), list)) => list,
        _ => element,
    };
    let taken = syntax.find(list).map_or_else(Vec::new, |(_, written)| names(list, written));
    if !taken.iter().any(|name| name == wanted) {
        return wanted.to_owned();
    }
    let stem = wanted.trim_end_matches(|c: char| c.is_ascii_digit());
    let stem = if stem.ends_with(' ') { stem.trim_end() } else { wanted };
    // Among as many numbers as there are names, and one more, one is free.
    let numbered = (2..taken.len() + 3).map(|number| format!("{stem} {number}"));
    numbered.into_iter().find(|name| !taken.contains(name)).unwrap_or_default()
}

/// The name of an element of `list`, said or not.
pub(super) fn name_of(list: &[Step], element: Written<'_>) -> Option<String> {
    match element.key("name").map(Written::value) {
        Some(Value::String(name)) => Some(name),
        _ => default_name(list),
    }
}

/// The name of an element of `list` that does not say its own.
pub(super) fn default_name(list: &[Step]) -> Option<String> {
    let is_camera = matches!(list, [Step::Key(key)] if key == "camera");
    is_camera.then(|| CAMERA.to_owned())
}

fn names(list: &[Step], written: Written<'_>) -> Vec<String> {
    let all: Vec<Written<'_>> = match written.len() {
        Some(len) => (0..len).filter_map(|index| written.item(index)).collect(),
        None => vec![written],
    };
    all.into_iter().filter_map(|element| name_of(list, element)).collect()
}
