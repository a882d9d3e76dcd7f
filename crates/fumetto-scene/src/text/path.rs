//! Paths into a scene, as in `object.smoke.emitter[0].rate`.

use std::borrow::Cow;

/// One step of a path: `eye`, `smoke` or `[0]`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PathStep<'a> {
    /// The key, the name of an element, or the digits of its number.
    pub(crate) name: Cow<'a, str>,
    /// Which bytes of the path say so.
    pub(crate) at: usize,
    pub(crate) len: usize,
    pub(crate) is_index: bool,
}

/// What is wrong with a path, and in which of its bytes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BadPath {
    pub(crate) at: usize,
    pub(crate) len: usize,
    pub(crate) message: &'static str,
    pub(crate) help: &'static str,
}

/// Cuts a path into its steps. Names with dots and brackets in them go in quotes, as in `object."a.b"`.
pub(crate) fn parse_path(path: &str) -> Result<Vec<PathStep<'_>>, BadPath> {
    if path.is_empty() {
        let (message, help) = ("the path is empty", "write it as in `--set camera.fov=30`");
        return Err(BadPath { at: 0, len: 0, message, help });
    }
    let mut steps = Vec::new();
    let mut at = 0;
    loop {
        let step = name(path, at)?;
        at = step.at + step.len;
        steps.push(step);
        while path[at..].starts_with('[') {
            let step = index(path, at)?;
            at = step.at + step.len + 1;
            steps.push(step);
        }
        match path[at..].chars().next() {
            None => return Ok(steps),
            Some('.') => at += 1,
            Some(_) => {
                let (message, help) = ("a `.` is missing in the path", "write it as in `camera.eye[0]`");
                return Err(BadPath { at, len: path.len() - at, message, help });
            }
        }
    }
}

fn name(path: &str, at: usize) -> Result<PathStep<'_>, BadPath> {
    let rest = &path[at..];
    if rest.starts_with('"') {
        return quoted(path, at);
    }
    let len = rest.find(['.', '[']).unwrap_or(rest.len());
    if len == 0 {
        let help = "write it as in `--set object.smoke.opacity=0.5`";
        let len = rest.find('.').unwrap_or(rest.len());
        return Err(BadPath { at, len, message: "a name is missing in the path", help });
    }
    Ok(PathStep { name: Cow::Borrowed(&rest[..len]), at, len, is_index: false })
}

/// A name in quotes, in which a backslash goes before each quote and backslash.
fn quoted(path: &str, at: usize) -> Result<PathStep<'_>, BadPath> {
    let mut name = String::new();
    let mut letters = path[at..].char_indices().skip(1);
    while let Some((i, letter)) = letters.next() {
        match letter {
            '"' => return Ok(PathStep { name: Cow::Owned(name), at, len: i + 1, is_index: false }),
            '\\' => name.extend(letters.next().map(|(_, escaped)| escaped)),
            _ => name.push(letter),
        }
    }
    let (message, help) = ("a quote is not closed in the path", "write it as in `object.\"a.b\".opacity`");
    Err(BadPath { at, len: path.len() - at, message, help })
}

fn index(path: &str, at: usize) -> Result<PathStep<'_>, BadPath> {
    let rest = &path[at..];
    let end = rest.find(']').unwrap_or(rest.len());
    let digits = &rest[1..end];
    let is_number = digits.bytes().all(|digit| digit.is_ascii_digit()) && digits.parse::<usize>().is_ok();
    if end == rest.len() || !is_number {
        let help = "write indices as in `camera.eye[0]`, counted from 0";
        let len = (end + 1).min(rest.len());
        return Err(BadPath { at, len, message: "this is not an index", help });
    }
    Ok(PathStep { name: Cow::Borrowed(digits), at: at + 1, len: digits.len(), is_index: true })
}
