//! Everything that is wrong with a scene, each problem with its file, place and remedy.

mod log;
mod render;

use std::fmt;
use std::ops::Range;

pub(crate) use log::Log;

/// How bad a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The scene cannot be used.
    Error,
    /// The scene can be used, but likely does not do what was meant.
    Warning,
}

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// How bad it is.
    pub severity: Severity,
    /// A short name that stays the same when the message's wording changes.
    pub code: &'static str,
    /// What is wrong.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
    /// The scene or style file, or `--set` or `--style`.
    pub file: String,
    /// The offending bytes of that file's text.
    pub span: Option<Range<usize>>,
}

/// All problems of a scene, in the order of the text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    problems: Vec<Problem>,
    texts: Vec<Text>,
    left_out: usize,
}

/// A text that was read, and what it is called.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Text {
    name: String,
    text: String,
}

impl Report {
    /// Every problem.
    #[must_use]
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }

    /// Whether nothing is wrong.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.problems.is_empty()
    }

    /// How many problems are of this severity.
    #[must_use]
    pub fn count(&self, severity: Severity) -> usize {
        self.problems.iter().filter(|problem| problem.severity == severity).count()
    }

    /// How many problems were found beyond those that the report lists.
    #[must_use]
    pub fn left_out(&self) -> usize {
        self.left_out
    }

    /// The text of a file that a problem names.
    #[must_use]
    pub fn text(&self, file: &str) -> Option<&str> {
        self.texts.iter().find(|text| text.name == file).map(|text| text.text.as_str())
    }

    /// Line and column of a problem's beginning, both counted from 1; columns count characters.
    #[must_use]
    pub fn position(&self, problem: &Problem) -> Option<(usize, usize)> {
        let start = problem.span.as_ref()?.start;
        let before = self.text(&problem.file)?.get(..start)?;
        let line = before.rsplit('\n').next().unwrap_or(before);
        Some((before.matches('\n').count() + 1, line.chars().count() + 1))
    }
}

/// The plain rendering: what [`Report::render`] gives without colour.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Report {}
