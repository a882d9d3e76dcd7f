//! Values that are set and keys that are taken away.

use toml_edit::{InlineTable, Item, Table, Value as Literal};

use super::apply::Draft;
use super::sections::{last_key, line_end, root_end};
use super::syntax::Written;
use super::{EditError, Path, Step, Value, array, inline, write};

impl Draft<'_> {
    /// Puts `value` at `path`, making what is missing on the way.
    pub(super) fn set(&mut self, path: &Path, value: &Value) -> Result<(), EditError> {
        let found = self.syntax.follow(path.steps());
        let (steps, written) = (found.steps, found.written);
        let Some((first, rest)) = path.steps()[found.taken..].split_first() else {
            if steps.is_empty() && !value.is_table() {
                return Err(EditError::NotATable(path.clone()));
            }
            self.replace(&steps, written, value);
            return Ok(());
        };
        let mut missing = value.clone();
        for step in rest.iter().rev() {
            let Step::Key(key) = step else { return Err(EditError::Missing(path.clone())) };
            missing = Value::Table([(key.clone(), missing)].into_iter().collect());
        }
        match first {
            Step::Key(key) if written.is_table() => {
                self.add(&steps, written, key, &missing);
                Ok(())
            }
            _ if written.is_table() || written.len().is_some() => Err(EditError::Missing(path.clone())),
            _ => Err(EditError::NotATable(Path::from(steps))),
        }
    }

    /// Makes `value` of what is at `path`, and leaves alone what is the same in both.
    pub(super) fn replace(&mut self, path: &[Step], written: Written<'_>, value: &Value) {
        if write::same(&written.value(), value) {
            return;
        }
        match (written, value) {
            (_, Value::Table(table)) if written.is_table() => self.replace_table(path, written, table),
            (Written::Literal(Literal::Array(old)), Value::Array(items)) => {
                for (index, item) in items.iter().enumerate().take(old.len()) {
                    let Some(old) = written.item(index) else { continue };
                    self.replace(&step(path, Step::Index(index)), old, item);
                }
                if items.len() < old.len() {
                    array::remove(self, old, items.len()..old.len());
                } else {
                    let new: Vec<String> = items[old.len()..].iter().map(write::inline).collect();
                    array::insert(self, old, old.len(), &new);
                }
            }
            (Written::Tables(old), Value::Array(items)) if items.iter().all(Value::is_table) => {
                for (index, item) in items.iter().enumerate().take(old.len()) {
                    let Some(old) = written.item(index) else { continue };
                    self.replace(&step(path, Step::Index(index)), old, item);
                }
                for index in items.len()..old.len() {
                    self.remove_sections(&step(path, Step::Index(index)));
                }
                self.add_blocks(path, items.get(old.len()..).unwrap_or_default());
            }
            (Written::Literal(literal), _) if inline::is_dotted(literal) => self.rewrite_braces(path, value),
            (Written::Literal(literal), _) => {
                if let Some(span) = literal.span() {
                    self.splices.replace(span, write::like(literal, value));
                }
            }
            _ => self.rewrite(path, written, value),
        }
    }

    /// Takes away what stands under headers and writes it anew where its table has its keys.
    pub(super) fn rewrite(&mut self, path: &[Step], written: Written<'_>, value: &Value) {
        let Some((last, parent)) = path.split_last() else { return };
        let Some((_, owner)) = self.syntax.find(parent) else { return };
        match last {
            Step::Key(key) => {
                self.remove_key(path, written);
                self.add(parent, owner, key, value);
            }
            // Among tables under headers there can be nothing else.
            Step::Index(index) => {
                let mut all = owner.value();
                if let Some(item) = all.get_mut(*index) {
                    *item = value.clone();
                }
                self.rewrite(parent, owner, &all);
            }
        }
    }

    /// Writes the braces anew in which `path` is written, with `value` there.
    fn rewrite_braces(&mut self, path: &[Step], value: &Value) {
        let Some((at, braces)) = inline::braces(self.syntax, path) else { return };
        let mut all = Written::Literal(braces).value();
        let inner = path[at..].iter().try_fold(&mut all, |all, step| match step {
            Step::Key(key) => all.get_mut(key.as_str()),
            Step::Index(index) => all.get_mut(*index),
        });
        if let (Some(inner), Some(span)) = (inner, braces.span()) {
            *inner = value.clone();
            self.splices.replace(span, write::inline(&all));
        }
    }

    fn replace_table(&mut self, path: &[Step], written: Written<'_>, table: &toml::Table) {
        let fresh = written.keys().into_iter().all(|key| !table.contains_key(key));
        if let Written::Literal(Literal::InlineTable(braces)) = written
            && (fresh || inline::has_dots(braces))
        {
            self.rewrite_braces(path, &Value::Table(table.clone()));
            return;
        }
        let has_header = path.is_empty() || self.sections.iter().any(|section| section.path == path);
        let is_bare = matches!(written, Written::Table(table) if !table.is_dotted() && !has_header);
        if is_bare && fresh {
            self.rewrite(path, written, &Value::Table(table.clone()));
            return;
        }
        let mut gone = Vec::new();
        for key in written.keys() {
            let Some(old) = written.key(key) else { continue };
            let path = step(path, Step::Key(key.to_owned()));
            match (table.get(key), written) {
                (Some(new), _) if is_bare && !old.keeps_headers(new) => self.remove_key(&path, old),
                (Some(new), _) => self.replace(&path, old, new),
                (None, Written::Literal(_)) => gone.push(path),
                (None, _) => self.remove_key(&path, old),
            }
        }
        inline::remove(self, &gone);
        if is_bare {
            // All that needs the header comes under one.
            let is_there = |key| written.key(key).is_some_and(|old| old.keeps_headers(&table[key]));
            let lines = table.iter().filter(|(key, _)| !is_there(key.as_str()));
            let lines: Vec<String> = lines.map(|(key, value)| write::entry(key, value)).collect();
            self.add_with_header(path, &lines.join("\n"));
        } else {
            for (key, value) in table.iter().filter(|(key, _)| written.key(key).is_none()) {
                self.add(path, written, key, value);
            }
        }
    }

    /// Adds `key` to the table at `path`, which has none yet.
    pub(super) fn add(&mut self, path: &[Step], table: Written<'_>, key: &str, value: &Value) {
        match table {
            Written::Table(table) => self.add_under_header(path, table, key, value),
            Written::Literal(Literal::InlineTable(table)) => self.add_inline(path, table, key, value),
            _ => {}
        }
    }

    fn add_under_header(&mut self, path: &[Step], table: &Table, key: &str, value: &Value) {
        let entry = write::entry(key, value);
        let whole = step(path, Step::Key(key.to_owned()));
        let own = self.sections.iter().find(|section| section.path == path).map(|section| section.end);
        let is_block = write::is_blocks(key, value) && (own.is_some() || path.is_empty());
        match (value, last_key(table)) {
            (_, Some(end)) if table.is_dotted() => {
                let (keys, end) = (self.dotted_keys(path), line_end(self.text(), end));
                self.splices.insert(end, format!("\n{keys}{entry}"));
            }
            (Value::Array(items), _) if is_block => self.add_blocks(&whole, items),
            (Value::Table(table), _) if path.is_empty() => self.add_block(&whole, table),
            _ if path.is_empty() => self.add_at_root(&entry),
            _ => match own {
                Some(end) => self.splices.insert(end, format!("\n{entry}")),
                None => self.add_with_header(path, &entry),
            },
        }
    }

    /// Adds a line above all headers.
    fn add_at_root(&mut self, entry: &str) {
        let end = root_end(self.syntax);
        if end > 0 {
            self.splices.insert(end, format!("\n{entry}"));
            return;
        }
        let at = self.sections.first().map_or(self.text().len(), |first| first.range.start);
        let is_whole = at == 0 || self.text()[..at].ends_with('\n');
        self.splices.insert(at, format!("{}{entry}\n", if is_whole { "" } else { "\n" }));
    }

    fn add_inline(&mut self, path: &[Step], table: &InlineTable, key: &str, value: &Value) {
        let entry = format!("{} = {}", write::key(key), write::inline(value));
        match (inline::end(table), table.span()) {
            (Some(end), _) => {
                let keys = if table.is_dotted() { self.dotted_keys(path) } else { String::new() };
                self.splices.insert(end, format!(", {keys}{entry}"));
            }
            (None, Some(span)) => self.splices.replace(span, format!("{{ {entry} }}")),
            (None, None) => {}
        }
    }

    /// What keys in a table that is itself written with dots begin with.
    fn dotted_keys(&self, path: &[Step]) -> String {
        let is_dotted = |path: &[Step]| match self.syntax.find(path) {
            Some((_, Written::Table(table))) => table.is_dotted(),
            Some((_, Written::Literal(literal))) => inline::is_dotted(literal),
            _ => false,
        };
        let dotted = (1..=path.len()).rev().take_while(|len| is_dotted(&path[..*len])).count();
        let keys = path[path.len() - dotted..].iter();
        keys.filter_map(|step| if let Step::Key(key) = step { Some(write::key(key) + ".") } else { None })
            .collect()
    }

    /// Takes the key at `path` away.
    pub(super) fn remove_key(&mut self, path: &[Step], written: Written<'_>) {
        let Some((Step::Key(key), parent)) = path.split_last() else { return };
        match (written, self.syntax.find(parent)) {
            (Written::Literal(literal), Some((_, Written::Table(table)))) => {
                self.remove_line(table, key, literal);
            }
            (Written::Literal(_), _) => inline::remove(self, &[path.to_vec()]),
            (Written::Table(table), _) => {
                self.remove_dotted(table);
                self.remove_sections(path);
            }
            (Written::Tables(_), _) => self.remove_sections(path),
        }
    }

    /// Takes away the lines of keys with dots.
    fn remove_dotted(&mut self, table: &Table) {
        for (key, item) in table.iter().filter(|_| table.is_dotted()) {
            match item {
                Item::Value(literal) => self.remove_line(table, key, literal),
                Item::Table(table) => self.remove_dotted(table),
                Item::None | Item::ArrayOfTables(_) => {}
            }
        }
    }

    /// Takes away a key's line, or lines, with the comment behind it and the line break before it.
    fn remove_line(&mut self, table: &Table, key: &str, literal: &Literal) {
        let text = self.text();
        if let (Some(key), Some(value)) = (table.key(key).and_then(toml_edit::Key::span), literal.span()) {
            let before = text[..key.start].rfind('\n').unwrap_or(0);
            let start = if text[..before].ends_with('\r') { before - 1 } else { before };
            self.splices.remove(start..line_end(text, value.end));
        }
    }
}

/// A path and one step more.
pub(super) fn step(path: &[Step], last: Step) -> Vec<Step> {
    path.iter().cloned().chain([last]).collect()
}
