//! Tables in braces.

use std::ops::Range;

use toml_edit::{InlineTable, Value as Literal};

use super::Step;
use super::apply::Draft;
use super::syntax::{Syntax, Written};

/// One key of a table in braces, as far as it is written as one.
struct Entry {
    /// Its keys: several where there are dots.
    keys: Vec<String>,
    /// From the key to the end of the value.
    range: Range<usize>,
}

/// Whether this is no table in braces of its own, but made by dots in the keys of one.
pub(super) fn is_dotted(literal: &Literal) -> bool {
    literal.as_inline_table().is_some_and(InlineTable::is_dotted)
}

/// Where its last value ends.
pub(super) fn end(table: &InlineTable) -> Option<usize> {
    entries(table).last().map(|entry| entry.range.end)
}

/// Whether any of its keys have dots.
pub(super) fn has_dots(table: &InlineTable) -> bool {
    table.is_dotted() || table.iter().any(|(_, literal)| is_dotted(literal))
}

/// The table in braces of its own that `path` leads to or into, and how many steps lead there.
pub(super) fn braces<'a>(syntax: &'a Syntax, path: &[Step]) -> Option<(usize, &'a Literal)> {
    (0..=path.len()).rev().find_map(|len| match syntax.find(&path[..len]) {
        Some((_, Written::Literal(literal))) if literal.is_inline_table() && !is_dotted(literal) => {
            Some((len, literal))
        }
        _ => None,
    })
}

/// Takes keys away, all of them of the same table.
pub(super) fn remove(draft: &mut Draft<'_>, paths: &[Vec<Step>]) {
    let parent = paths.first().and_then(|path| path.split_last()).map(|(_, parent)| parent);
    let Some((len, braces)) = parent.and_then(|parent| braces(draft.syntax, parent)) else { return };
    let entries = braces.as_inline_table().map(entries).unwrap_or_default();
    let leads_to = |entry: &Entry, path: &[Step]| {
        let mut keys = entry.keys.iter();
        path[len..].iter().all(|step| matches!((step, keys.next()), (Step::Key(a), Some(b)) if a == b))
    };
    let gone: Vec<bool> =
        entries.iter().map(|entry| paths.iter().any(|path| leads_to(entry, path))).collect();
    let ranges: Vec<Range<usize>> = entries.into_iter().map(|entry| entry.range).collect();
    for range in without(&ranges, &gone) {
        draft.splices.remove(range);
    }
}

/// What to take out of a list with commas so that those marked are gone: each with the comma behind it, and the last
/// ones with the comma before them.
pub(super) fn without(ranges: &[Range<usize>], gone: &[bool]) -> Vec<Range<usize>> {
    let kept = gone.iter().rposition(|gone| !gone);
    let mut removed = Vec::new();
    for (i, range) in
        ranges.iter().enumerate().filter(|(i, _)| gone[*i] && kept.is_some_and(|kept| *i < kept))
    {
        removed.push(range.start..ranges[i + 1].start);
    }
    let tail = kept.map_or(0, |kept| kept + 1);
    if let (Some(first), Some(last)) = (ranges.get(tail), ranges.last()) {
        let start = kept.map_or(first.start, |kept| ranges[kept].end);
        removed.push(start..last.end);
    }
    removed
}

/// Its keys in the order of the text.
fn entries(table: &InlineTable) -> Vec<Entry> {
    let mut found = Vec::new();
    collect(table, &mut Vec::new(), &mut found);
    found.sort_by_key(|entry| entry.range.start);
    found
}

fn collect(table: &InlineTable, keys: &mut Vec<String>, found: &mut Vec<Entry>) {
    for (name, literal) in table {
        keys.push(name.to_owned());
        let key = table.key(name);
        let prefix = key.and_then(|key| key.leaf_decor().prefix()?.span());
        match literal {
            Literal::InlineTable(dotted) if dotted.is_dotted() => collect(dotted, keys, found),
            _ => {
                let start = prefix.map(|prefix| prefix.end).or_else(|| Some(key?.span()?.start));
                if let (Some(start), Some(span)) = (start, literal.span()) {
                    found.push(Entry { keys: keys.clone(), range: start..span.end });
                }
            }
        }
        keys.pop();
    }
}
