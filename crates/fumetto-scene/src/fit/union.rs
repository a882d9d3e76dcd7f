//! Which of several shapes a value was meant to have.

use serde_json::Value as Schema;

use super::{Fit, describe, did_you_mean, list};
use crate::text::{Entry, Node, Table, Value};

impl<'a> Fit<'a> {
    /// The one shape of `schema` that `node` is nearest to; reports where there is none.
    pub(super) fn choose(
        &self,
        node: &Node,
        schema: &'a Schema,
        name: &str,
        about: Option<&str>,
    ) -> Option<&'a Schema> {
        let Some(branches) = branches(schema) else { return Some(schema) };
        let branches: Vec<&Schema> = branches.iter().map(|branch| self.resolve(branch)).collect();
        let of_type = |kind: &str| -> Vec<&'a Schema> {
            branches.iter().copied().filter(|branch| branch["type"] == kind).collect()
        };
        let candidates = match &node.value {
            Value::Table(_) => of_type("object"),
            Value::Array(_) => of_type("array"),
            Value::String(_) => of_type("string"),
            Value::Integer(_) | Value::Float(_) => of_type("number"),
            Value::Bool(_) | Value::Datetime => Vec::new(),
        };
        match (candidates.as_slice(), &node.value) {
            ([], _) => {
                self.mismatch(node, &expected(&branches), name, about);
                None
            }
            (tables, Value::Table(table)) => self.choose_table(node, table, tables, name),
            (strings, Value::String(text)) => self.choose_string(node, text, strings, name),
            ([first, ..], _) => Some(first),
        }
    }

    /// Tables differ by the value of `kind`, or by their only key.
    fn choose_table(
        &self,
        node: &Node,
        table: &Table,
        candidates: &[&'a Schema],
        name: &str,
    ) -> Option<&'a Schema> {
        if candidates.iter().all(|candidate| candidate["properties"]["kind"]["const"].is_string()) {
            return self.choose_kind(node, table, candidates, name);
        }
        let Some(keys) =
            candidates.iter().map(|candidate| describe::only_key(candidate)).collect::<Option<Vec<_>>>()
        else {
            return candidates.first().copied();
        };
        let mut named = candidates.iter().zip(&keys).filter(|(_, key)| table.get(key).is_some());
        match (named.next(), named.next()) {
            (Some((candidate, _)), None) => Some(candidate),
            (None, _) => {
                match table.entries.first() {
                    Some(Entry { key, key_place, .. }) => {
                        self.unknown_key(key, key_place, name, did_you_mean(key, &keys));
                    }
                    None => {
                        let message = format!("`{name}` lacks one of {}", list(&keys, "or"));
                        self.error("missing-key", &node.place, message, None);
                    }
                }
                None
            }
            (Some(_), Some(_)) => {
                let message = format!("`{name}` must have only one of {}", list(&keys, "and"));
                self.error("conflicting-keys", &node.place, message, None);
                None
            }
        }
    }

    fn choose_kind(
        &self,
        node: &Node,
        table: &Table,
        candidates: &[&'a Schema],
        name: &str,
    ) -> Option<&'a Schema> {
        let kinds: Vec<&str> = candidates.iter().filter_map(|candidate| kind(candidate)).collect();
        let Some(given) = table.get("kind") else {
            let help = format!("`kind` is one of {}", list(&kinds, "or"));
            self.error("missing-key", &node.place, format!("`{name}` lacks the key `kind`"), Some(help));
            return None;
        };
        let Some(text) = given.as_str() else {
            self.mismatch(given, "a string", "kind", Some(&format!("one of {}", list(&kinds, "or"))));
            return None;
        };
        let chosen = candidates.iter().copied().find(|candidate| kind(candidate) == Some(text));
        if chosen.is_none() {
            let message = format!("`kind` cannot be {text:?}");
            self.error("unknown-value", &given.place, message, Some(did_you_mean(text, &kinds)));
        }
        chosen
    }

    fn choose_string(
        &self,
        node: &Node,
        text: &str,
        candidates: &[&'a Schema],
        name: &str,
    ) -> Option<&'a Schema> {
        let names: Vec<&str> =
            candidates.iter().filter_map(|candidate| candidate["const"].as_str()).collect();
        let chosen = candidates
            .iter()
            .copied()
            .find(|candidate| candidate["const"].as_str().is_none_or(|only| only == text));
        if chosen.is_none() {
            let message = format!("`{name}` cannot be {text:?}");
            self.error("unknown-value", &node.place, message, Some(did_you_mean(text, &names)));
        }
        chosen
    }

    /// For a key that is unknown in `schema`, which is of one kind: the other kinds that have it.
    pub(super) fn other_kind(&self, key: &str, schema: &Schema) -> Option<String> {
        let own = kind(schema)?;
        let definitions = self.schema["$defs"].as_object()?;
        let siblings = definitions
            .values()
            .filter_map(branches)
            .find(|all| all.iter().any(|branch| std::ptr::eq(branch, schema)))?;
        let having: Vec<&str> = siblings
            .iter()
            .filter(|branch| branch["properties"].get(key).is_some())
            .filter_map(kind)
            .collect();
        (!having.is_empty())
            .then(|| format!("`{key}` is a key of kind {}; this is kind `{own}`", list(&having, "and")))
    }
}

fn branches(schema: &Schema) -> Option<&Vec<Schema>> {
    schema["oneOf"].as_array().or(schema["anyOf"].as_array())
}

fn kind(schema: &Schema) -> Option<&str> {
    schema["properties"]["kind"]["const"].as_str()
}

/// "a number or an array of 2 numbers".
fn expected(branches: &[&Schema]) -> String {
    let mut kinds: Vec<String> = branches.iter().map(|branch| describe::kind(branch)).collect();
    kinds.dedup();
    kinds.join(" or ")
}
