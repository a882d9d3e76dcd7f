//! Tables under headers, as whole blocks of lines.

use super::apply::Draft;
use super::sections::under;
use super::set::step;
use super::{Step, Value, write};

/// The order in which a hand writes the tables of a scene.
const ORDER: [&str; 9] =
    ["format", "seed", "camera", "light", "background", "time", "output", "style", "object"];

impl Draft<'_> {
    /// Adds the table `path`, of which there is nothing yet.
    pub(super) fn add_block(&mut self, path: &[Step], table: &toml::Table) {
        let keys = keys(path);
        self.insert_block(self.room_for(path), &write::block(&format!("[{keys}]"), &keys, table));
    }

    /// Adds tables behind those of `path` that there are.
    pub(super) fn add_blocks(&mut self, path: &[Step], items: &[Value]) {
        let keys = keys(path);
        let block = |table| write::block(&format!("[[{keys}]]"), &keys, table);
        let blocks: Vec<String> = items.iter().filter_map(Value::as_table).map(block).collect();
        if !blocks.is_empty() {
            self.insert_block(self.room_for(path), &blocks.join("\n"));
        }
    }

    /// Adds a header to a table that so far has only headers of what is in it.
    pub(super) fn add_with_header(&mut self, path: &[Step], entries: &str) {
        let first = under(&self.sections, path).next().map(|first| first.range.start);
        if let (Some(at), false) = (first, entries.is_empty()) {
            self.insert_block(at, &format!("[{}]\n{entries}\n", keys(path)));
        }
    }

    /// Where another header of `path` goes: behind those that there are, or behind all else of the table it is in, and
    /// in a scene where a hand would put it.
    pub(super) fn room_for(&self, path: &[Step]) -> usize {
        let end_of = |path: &[Step]| under(&self.sections, path).map(|section| section.range.end).max();
        let end = self.text().len();
        if let Some(end) = end_of(path) {
            return end;
        }
        let [Step::Key(key)] = path else {
            return path.split_last().and_then(|(_, owner)| end_of(owner)).unwrap_or(end);
        };
        let rank = |key: &str| ORDER.iter().position(|known| *known == key).unwrap_or(ORDER.len());
        let is_later =
            |first: Option<&Step>| matches!(first, Some(Step::Key(other)) if rank(other) > rank(key));
        let later = self.sections.iter().find(|section| is_later(section.path.first()));
        later.map_or(end, |section| section.range.start)
    }

    /// Inserts whole lines with an empty line before and after them.
    pub(super) fn insert_block(&mut self, at: usize, block: &str) {
        let (before, after) = self.text().split_at(at);
        let gap = match () {
            () if before.is_empty() || before.ends_with("\n\n") || before.ends_with("\n\r\n") => "",
            () if before.ends_with('\n') => "\n",
            () => "\n\n",
        };
        let rest = if after.is_empty() || after.starts_with(['\n', '\r']) { "" } else { "\n" };
        self.splices.insert(at, format!("{gap}{}\n{rest}", block.trim_matches(['\n', '\r'])));
    }

    /// Takes away all headers of `path` and of what is in it, with their keys.
    pub(super) fn remove_sections(&mut self, path: &[Step]) {
        let gone: Vec<_> = under(&self.sections, path).map(|section| section.range.clone()).collect();
        for range in gone {
            self.splices.remove(range);
        }
    }

    /// Where the headers of element `index` of a list begin, or where those of one more would.
    pub(super) fn before_element(&self, list: &[Step], index: usize) -> usize {
        let element = step(list, Step::Index(index));
        let first = under(&self.sections, &element).next();
        first.map_or_else(|| self.room_for(list), |section| section.range.start)
    }

    /// The text of all that is under the headers of `path`, without empty lines around it.
    pub(super) fn block_text(&self, path: &[Step]) -> String {
        let pieces = under(&self.sections, path).map(|section| &self.text()[section.range.clone()]);
        let mut block = String::new();
        for piece in pieces {
            if !block.is_empty() && !block.ends_with('\n') {
                block.push('\n');
            }
            block.push_str(piece);
        }
        block.trim_matches(['\n', '\r']).replace("\r\n", "\n")
    }
}

/// The keys of a path, as a header has them.
pub(super) fn keys(path: &[Step]) -> String {
    let key = |step: &Step| if let Step::Key(key) = step { Some(write::key(key)) } else { None };
    path.iter().filter_map(key).collect::<Vec<_>>().join(".")
}
