//! Headers and what stands under them, as pieces of the text.

use std::ops::Range;

use toml_edit::{Item, Table, Value as Literal};

use super::Step;
use super::syntax::Syntax;

/// A header with its keys.
#[derive(Clone, Debug)]
pub(super) struct Section {
    /// The table that it begins.
    pub(super) path: Vec<Step>,
    /// The header alone, from bracket to bracket.
    pub(super) header: Range<usize>,
    /// Where its last key ends: the end of that line, without the line break.
    pub(super) end: usize,
    /// All of it: with the empty lines and the comments right above the header, up to those of the next one.
    pub(super) range: Range<usize>,
}

/// All sections, in the text's order. What stands above the first is in none.
pub(super) fn sections(syntax: &Syntax) -> Vec<Section> {
    let mut found = Vec::new();
    collect(syntax, syntax.root(), &mut Vec::new(), &mut found);
    found.sort_by_key(|section| section.header.start);
    let text = syntax.text();
    let mut above = root_end(syntax);
    for section in &mut found {
        section.range.start = begin(text, above, section.header.start);
        above = section.end;
    }
    let starts: Vec<usize> = found.iter().skip(1).map(|section| section.range.start).collect();
    for (section, end) in found.iter_mut().zip(starts.into_iter().chain([text.len()])) {
        section.range.end = end;
    }
    found
}

/// The sections of `path` and of all in it.
pub(super) fn under<'s>(sections: &'s [Section], path: &[Step]) -> impl Iterator<Item = &'s Section> {
    sections.iter().filter(move |section| section.path.starts_with(path))
}

/// Where the last key above all headers ends; 0 where there is none.
pub(super) fn root_end(syntax: &Syntax) -> usize {
    last_key(syntax.root()).map_or(0, |end| line_end(syntax.text(), end))
}

fn collect(syntax: &Syntax, table: &Table, path: &mut Vec<Step>, found: &mut Vec<Section>) {
    for (key, item) in table {
        path.push(Step::Key(key.to_owned()));
        match item {
            Item::Table(table) => {
                if !table.is_implicit() {
                    add(syntax, table, path, found);
                }
                collect(syntax, table, path, found);
            }
            Item::ArrayOfTables(tables) => {
                for (index, table) in tables.iter().enumerate() {
                    path.push(Step::Index(index));
                    add(syntax, table, path, found);
                    collect(syntax, table, path, found);
                    path.pop();
                }
            }
            Item::None | Item::Value(_) => {}
        }
        path.pop();
    }
}

fn add(syntax: &Syntax, table: &Table, path: &[Step], found: &mut Vec<Section>) {
    let Some(header) = table.span() else { return };
    let end = line_end(syntax.text(), last_key(table).unwrap_or(header.end).max(header.end));
    found.push(Section { path: path.to_vec(), header, end, range: 0..0 });
}

/// Where the last value ends that is written right under the table's header.
pub(super) fn last_key(table: &Table) -> Option<usize> {
    let end = |(_, item): (&str, &Item)| match item {
        Item::Value(literal) => literal_end(literal),
        Item::Table(dotted) if dotted.is_dotted() => last_key(dotted),
        _ => None,
    };
    table.iter().filter_map(end).max()
}

fn literal_end(literal: &Literal) -> Option<usize> {
    literal.span().map(|span| span.end)
}

/// The end of the line in which byte `at` is, without the line break.
pub(super) fn line_end(text: &str, at: usize) -> usize {
    text[at..].find('\n').map_or(text.len(), |length| {
        let end = at + length;
        if text[at..end].ends_with('\r') { end - 1 } else { end }
    })
}

/// The beginning of the line in which byte `at` is.
pub(super) fn line_start(text: &str, at: usize) -> usize {
    text[..at].rfind('\n').map_or(0, |newline| newline + 1)
}

/// The beginning of the line after the one in which byte `at` is.
pub(super) fn next_line(text: &str, at: usize) -> usize {
    text[at..].find('\n').map_or(text.len(), |length| at + length + 1)
}

/// Where the comments right above byte `at` begin, but nothing before byte `above`.
pub(super) fn comments_above(text: &str, above: usize, at: usize) -> usize {
    climb(text, above, line_start(text, at), |line| line.starts_with('#'))
}

/// Where a section whose header is at byte `at` begins, when the one above it ends at byte `above`.
fn begin(text: &str, above: usize, at: usize) -> usize {
    let comments = comments_above(text, above, at);
    climb(text, above, comments, str::is_empty)
}

/// Goes up from line to line while they are `wanted`; only whole lines after byte `above`.
fn climb(text: &str, above: usize, mut at: usize, wanted: impl Fn(&str) -> bool) -> usize {
    while at > 0 {
        let start = line_start(text, at - 1);
        if start < above || (start == above && above > 0) || !wanted(text[start..at].trim()) {
            break;
        }
        at = start;
    }
    at
}
