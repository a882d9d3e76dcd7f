use std::fmt;
use std::str::FromStr;

use crate::text::{BadPath, parse_path};

/// One step of a [`Path`].
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Step {
    /// A key of a table, or the `name` of an element of an array.
    Key(String),
    /// The number of an element of an array, from 0. A table that stands alone where several could is its own
    /// element 0, as `[camera]` is `camera[0]`.
    Index(usize),
}

/// The way to a value of a scene, written as for `--set`: `camera.eye[0]`, `object.smoke.opacity`.
///
/// Names with dots, brackets or quotes in them are quoted: `object."a.b"`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Path {
    steps: Vec<Step>,
}

impl Path {
    /// The scene itself.
    #[must_use]
    pub fn root() -> Self {
        Self::default()
    }

    /// From the scene down.
    #[must_use]
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The path to `key` in here.
    #[must_use]
    pub fn key(&self, key: impl Into<String>) -> Self {
        self.with(Step::Key(key.into()))
    }

    /// The path to element `index` of this array.
    #[must_use]
    pub fn index(&self, index: usize) -> Self {
        self.with(Step::Index(index))
    }

    /// The path one step on.
    #[must_use]
    pub fn with(&self, step: Step) -> Self {
        let mut steps = self.steps.clone();
        steps.push(step);
        Self { steps }
    }

    /// What this lies in, and the step from there; `None` for the scene itself.
    #[must_use]
    pub fn split_last(&self) -> Option<(Self, &Step)> {
        let (last, parents) = self.steps.split_last()?;
        Some((Self { steps: parents.to_vec() }, last))
    }

    /// Whether this is `other` or lies in it.
    #[must_use]
    pub fn starts_with(&self, other: &Self) -> bool {
        self.steps.starts_with(&other.steps)
    }
}

impl From<Vec<Step>> for Path {
    fn from(steps: Vec<Step>) -> Self {
        Self { steps }
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, step) in self.steps.iter().enumerate() {
            match step {
                Step::Key(key) => {
                    f.write_str(if i > 0 { "." } else { "" })?;
                    if key.is_empty() || key.contains(['.', '[', ']', '"', '\\', '=']) {
                        write!(f, "\"{}\"", key.replace('\\', "\\\\").replace('"', "\\\""))?;
                    } else {
                        f.write_str(key)?;
                    }
                }
                Step::Index(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

/// What is wrong with a path.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message} {path:?}; {help}")]
pub struct PathError {
    path: String,
    message: &'static str,
    help: &'static str,
}

impl FromStr for Path {
    type Err = PathError;

    /// The empty text is the scene itself.
    fn from_str(path: &str) -> Result<Self, PathError> {
        if path.is_empty() {
            return Ok(Self::root());
        }
        let bad = |bad: BadPath| PathError { path: path.to_owned(), message: bad.message, help: bad.help };
        let steps = parse_path(path).map_err(bad)?;
        let step = |step: crate::text::PathStep<'_>| match step.name.parse() {
            Ok(index) if step.is_index => Step::Index(index),
            _ => Step::Key(step.name.into_owned()),
        };
        Ok(Self { steps: steps.into_iter().map(step).collect() })
    }
}
