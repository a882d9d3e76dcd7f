use serde_json::{Map, Value as Schema};

use super::{Fit, describe, did_you_mean, suggest::nearest};
use crate::text::{Entry, Place, Table};

impl<'a> Fit<'a> {
    /// Checks the keys of a table; whether it can stay.
    pub(super) fn visit_table(
        &self,
        table: &mut Table,
        place: &Place,
        schema: &'a Schema,
        name: &str,
    ) -> bool {
        let Some(keys) = schema["properties"].as_object() else { return true };
        let required =
            |key: &str| schema["required"].as_array().is_some_and(|all| all.iter().any(|k| k == key));
        let slips = self.remove_unknown(table, keys, name, schema);
        let mut fits = true;
        for (key, key_schema) in keys {
            let Some(node) = table.get_mut(key) else {
                if required(key) {
                    fits = false;
                    if !slips.contains(&key.as_str()) {
                        self.missing(key, key_schema, place, name);
                    }
                }
                continue;
            };
            if !self.visit(node, key_schema, key, None) {
                fits &= !required(key);
                table.remove_where(|other| other == key);
            }
        }
        fits
    }

    /// Reports and removes unknown keys; gives the known ones that they are slips of.
    fn remove_unknown(
        &self,
        table: &mut Table,
        keys: &'a Map<String, Schema>,
        name: &str,
        schema: &Schema,
    ) -> Vec<&'a str> {
        let mut slips = Vec::new();
        if schema["additionalProperties"] != false {
            return slips;
        }
        let unknown = table.remove_where(|key| !keys.contains_key(key));
        let all: Vec<&str> = keys.keys().map(String::as_str).collect();
        for Entry { key, key_place, .. } in &unknown {
            slips.extend(nearest(key, all.iter().copied().filter(|known| table.get(known).is_none())));
            let help = self.other_kind(key, schema).unwrap_or_else(|| did_you_mean(key, &all));
            self.unknown_key(key, key_place, name, help);
        }
        slips
    }

    /// Reports an unknown key in the table called `name`, which at the root is nothing.
    pub(super) fn unknown_key(&self, key: &str, place: &Place, name: &str, help: String) {
        let table = if name.is_empty() { String::new() } else { format!(" in `{name}`") };
        self.error("unknown-key", place, format!("unknown key `{key}`{table}"), Some(help));
    }

    fn missing(&self, key: &str, schema: &Schema, place: &Place, name: &str) {
        let help = schema["description"]
            .as_str()
            .map(|about| format!("`{key}`: {}", describe::first_paragraph(about)));
        self.error("missing-key", place, format!("`{name}` lacks the key `{key}`"), help);
    }
}
