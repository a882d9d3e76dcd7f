//! The schema along a path.

use std::sync::LazyLock;

use serde_json::Value as Schema;

use crate::edit::{Document, Path, Step, Value};

static SCHEMA: LazyLock<Schema> = LazyLock::new(crate::schema);

/// What the schema says about a value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// Where it is referred to, with words and bounds of its own.
    outer: &'static Schema,
    /// What is referred to.
    target: &'static Schema,
    /// What it is, in words; elements without words of their own have their array's.
    about: &'static str,
}

impl Node {
    pub(super) fn root() -> Self {
        Self::new(&SCHEMA)
    }

    fn new(outer: &'static Schema) -> Self {
        let mut target = outer;
        while let Some(pointer) = target["$ref"].as_str().and_then(|reference| reference.strip_prefix('#')) {
            let Some(next) = SCHEMA.pointer(pointer) else { break };
            target = next;
        }
        let words = |schema: &'static Schema| schema["description"].as_str();
        Self { outer, target, about: words(outer).or(words(target)).unwrap_or_default() }
    }

    /// What it is, in words.
    pub(super) fn about(self) -> &'static str {
        self.about
    }

    /// What is said about it where it is referred to, or else in itself.
    pub(super) fn get(self, keyword: &str) -> Option<&'static Schema> {
        self.outer.get(keyword).or_else(|| self.target.get(keyword))
    }

    pub(super) fn text(self, keyword: &str) -> &'static str {
        self.get(keyword).and_then(Schema::as_str).unwrap_or_default()
    }

    pub(super) fn words(self, keyword: &str) -> Vec<String> {
        let words = self.get(keyword).and_then(Schema::as_array).into_iter().flatten();
        words.filter_map(|word| word.as_str().map(str::to_owned)).collect()
    }

    /// Both of what is said, the inner first.
    pub(super) fn layers(self) -> [&'static Schema; 2] {
        [self.target, self.outer]
    }

    /// The shapes that it can have; none where it has one.
    pub(super) fn branches(self) -> Vec<Self> {
        let branches = self.target["oneOf"].as_array().or(self.target["anyOf"].as_array());
        branches.into_iter().flatten().map(Self::new).collect()
    }

    pub(super) fn is(self, kind: &str) -> bool {
        self.target["type"] == kind
    }

    /// The keys of a table.
    pub(super) fn keys(self) -> Vec<&'static str> {
        self.target["properties"]
            .as_object()
            .into_iter()
            .flat_map(|keys| keys.keys().map(String::as_str))
            .collect()
    }

    pub(super) fn key(self, key: &str) -> Option<Self> {
        self.target["properties"].get(key).map(Self::new)
    }

    pub(super) fn is_required(self, key: &str) -> bool {
        self.target["required"].as_array().is_some_and(|all| all.iter().any(|required| required == key))
    }

    /// The key of a table that has exactly one and must have it.
    pub(super) fn only_key(self) -> Option<&'static str> {
        match self.keys().as_slice() {
            [only] if self.is_required(only) => Some(only),
            _ => None,
        }
    }

    /// The word that tells this table from its like.
    pub(super) fn tag(self) -> Option<&'static str> {
        self.target["properties"]["kind"]["const"].as_str()
    }

    pub(super) fn constant(self) -> Option<&'static str> {
        self.target["const"].as_str()
    }

    /// What the elements of an array are; those of the array among several shapes.
    pub(super) fn items(self) -> Option<Self> {
        let own = self.target.get("items").map(Self::new);
        let items = own.or_else(|| self.branches().into_iter().find_map(Self::items))?;
        Some(Self { about: if items.about.is_empty() { self.about } else { items.about }, ..items })
    }

    /// How many elements an array must have, where that is fixed.
    pub(super) fn len(self) -> Option<usize> {
        let least = self.target["minItems"].as_u64()?;
        (self.target["maxItems"] == least).then_some(least as usize)
    }

    /// The table that holds `key`, or the first, among all shapes that this can have; of tables with a `kind` the one
    /// that `kind` says.
    pub(super) fn table(self, key: Option<&str>, kind: Option<&str>) -> Option<Self> {
        if self.is("object") {
            return Some(self);
        }
        let tables: Vec<Self> =
            self.branches().into_iter().filter_map(|branch| branch.table(key, kind)).collect();
        let fits = |table: &&Self| match (table.tag(), kind) {
            (Some(tag), Some(kind)) => tag == kind,
            _ => key.is_none_or(|key| table.key(key).is_some()),
        };
        tables.iter().find(fits).copied()
    }

    /// What the schema says about `path`, given what the document says about the kinds of things on the way.
    pub(super) fn at(document: &Document, path: &Path) -> Option<Self> {
        let (mut node, mut here) = (Self::root(), Path::root());
        for step in path.steps() {
            node = match step {
                Step::Index(_) => node.items()?,
                Step::Key(key) => {
                    let kind = kind(document, &here);
                    let held = node.table(Some(key), kind.as_deref()).and_then(|table| table.key(key));
                    // Elements go by their names too.
                    let is_element = || document.count(&here.with(step.clone())) > 0;
                    held.or_else(|| node.items().filter(|_| is_element()))?
                }
            };
            here = here.with(step.clone());
        }
        Some(node)
    }
}

/// What the table at `path` says it is.
pub(super) fn kind(document: &Document, path: &Path) -> Option<String> {
    match document.get(&path.key("kind")) {
        Some(Value::String(kind)) => Some(kind),
        _ => None,
    }
}

#[cfg(test)]
impl Node {
    /// All that the schema gives a name.
    pub(super) fn definitions() -> Vec<Self> {
        SCHEMA["$defs"].as_object().into_iter().flat_map(|all| all.values()).map(Self::new).collect()
    }

    /// Its shapes, but for those that have names and so are found anyway.
    pub(super) fn own_branches(self) -> Vec<Self> {
        let own = |branch: &Self| branch.outer.get("$ref").is_none();
        let inner = self.keys().into_iter().filter_map(|key| self.key(key)).filter(own);
        self.branches().into_iter().filter(own).chain(inner).collect()
    }
}
