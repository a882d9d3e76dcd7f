use crate::limits::Limit;
use crate::report::{Log, Severity};
use crate::text::{Node, Value};

/// A place in the tree, which need not exist in the text: a default's place is where it is missing.
#[derive(Clone, Copy)]
pub(crate) struct At<'a> {
    log: &'a Log,
    file: &'a str,
    /// The node, or the innermost one that exists around it.
    nearest: &'a Node,
    /// Where the text has no such key: the outermost one that is missing.
    missing: Option<&'static str>,
    key: &'static str,
    /// Numbers of the items on the way from `key`, outer and inner.
    index: [Option<usize>; 2],
}

impl<'a> At<'a> {
    /// The root of a text, called `key` in messages.
    pub(crate) fn root(log: &'a Log, file: &'a str, node: &'a Node, key: &'static str) -> Self {
        Self { log, file, nearest: node, missing: None, key, index: [None; 2] }
    }

    /// The value of `key` in this table.
    pub(crate) fn key(&self, key: &'static str) -> Self {
        let child = self.node().and_then(|node| node.as_table()?.get(key));
        let missing = if child.is_some() { None } else { self.missing.or(Some(key)) };
        Self { nearest: child.unwrap_or(self.nearest), missing, key, index: [None; 2], ..*self }
    }

    /// An element of this array; a lone table counts as its own only element.
    pub(crate) fn item(&self, index: usize) -> Self {
        match self.node().map(|node| &node.value) {
            Some(Value::Array(array)) if index < array.items.len() => {
                let (outer, here) = (self.index[0], Some(array.index_in_text(index)));
                Self { nearest: &array.items[index], index: [outer.or(here), outer.and(here)], ..*self }
            }
            _ => *self,
        }
    }

    /// Whether the text has it.
    pub(crate) fn exists(&self) -> bool {
        self.missing.is_none()
    }

    fn node(&self) -> Option<&'a Node> {
        self.exists().then_some(self.nearest)
    }

    /// What messages call it: `eye`, `particles[3]`.
    pub(crate) fn name(&self) -> String {
        let indices = self.index.iter().flatten().map(|index| format!("[{index}]"));
        self.key.to_owned() + &indices.collect::<String>()
    }

    /// Reports an error here.
    pub(crate) fn error(&self, code: &'static str, message: String, help: impl Into<String>) {
        self.report(Severity::Error, code, message, help.into());
    }

    /// Reports a warning here.
    pub(crate) fn warning(&self, code: &'static str, message: String, help: impl Into<String>) {
        self.report(Severity::Warning, code, message, help.into());
    }

    /// Where something was already reported and taken out, what is left may look wrong because of
    /// that alone, so nothing more is said about it.
    fn report(&self, severity: Severity, code: &'static str, message: String, help: String) {
        let removed_here = |key: &str| {
            self.nearest.as_table().is_some_and(|table| table.removed.iter().any(|removed| removed == key))
        };
        let damaged = self.missing.map_or_else(|| self.nearest.is_damaged(), removed_here);
        if !damaged {
            self.log.report(severity, code, self.file, Some(&self.nearest.place), message, Some(help));
        }
    }

    /// Reports a number outside its range.
    pub(crate) fn within(&self, value: f32, limit: &Limit, help: &str) {
        let value = f64::from(value);
        if !limit.contains(value) {
            let message = format!("`{}` must be {}, not {value}", self.name(), limit.wanted(value));
            self.error("out-of-range", message, help);
        }
    }
}
