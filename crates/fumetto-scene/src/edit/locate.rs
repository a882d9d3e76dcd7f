//! Places in the text and the paths of what is written there.

use std::ops::Range;

use toml_edit::Value as Literal;

use super::sections::{sections, under};
use super::syntax::Written;
use super::{Document, Path, Step};

impl Document {
    /// The innermost value that is written at byte `at` of the text; where a problem says it is.
    #[must_use]
    pub fn path_at(&self, at: usize) -> Option<Path> {
        let syntax = self.syntax().filter(|syntax| at <= syntax.text().len())?;
        let sections = sections(syntax);
        let section = sections.iter().rfind(|section| section.range.contains(&at));
        let mut path = section.map_or_else(Vec::new, |section| section.path.clone());
        let (_, mut written) = syntax.find(&path)?;
        while let Some((step, inner)) = inner(written, at) {
            path.push(step);
            written = inner;
        }
        Some(Path::from(path))
    }

    /// Where in the text the value at `path` is written; of a table under a header, its header.
    #[must_use]
    pub fn span(&self, path: &Path) -> Option<Range<usize>> {
        let syntax = self.syntax()?;
        let (steps, written) = syntax.find(path.steps())?;
        match written {
            Written::Literal(literal) => literal.span(),
            _ => under(&sections(syntax), &steps).next().map(|section| section.header.clone()),
        }
    }
}

/// What of this is written at byte `at`, without a look under other headers.
fn inner(written: Written<'_>, at: usize) -> Option<(Step, Written<'_>)> {
    let holds = |start: usize, inner: Written<'_>| match inner {
        Written::Literal(Literal::InlineTable(table)) if table.is_dotted() => {
            self::inner(inner, at).is_some()
        }
        Written::Literal(literal) => literal.span().is_some_and(|span| (start..span.end).contains(&at)),
        Written::Table(table) => table.is_dotted() && self::inner(inner, at).is_some(),
        Written::Tables(_) => false,
    };
    let by_key = |key: &str| {
        let start = match written {
            Written::Table(table) => table.key(key),
            Written::Literal(Literal::InlineTable(table)) => table.key(key),
            _ => None,
        };
        let start = start.and_then(toml_edit::Key::span).map_or(at + 1, |span| span.start);
        let inner = written.key(key).filter(|inner| holds(start, *inner))?;
        Some((Step::Key(key.to_owned()), inner))
    };
    let by_index = |index: usize| {
        let inner = written.item(index)?;
        let Written::Literal(literal) = inner else { return None };
        literal.span().is_some_and(|span| span.contains(&at)).then_some((Step::Index(index), inner))
    };
    match written.len() {
        Some(len) => (0..len).find_map(by_index),
        None => written.keys().into_iter().find_map(by_key),
    }
}
