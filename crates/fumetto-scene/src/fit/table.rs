use serde_json::{Map, Value as Schema};

use super::{Fit, describe, did_you_mean, suggest::nearest};
use crate::text::{Place, Table};

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
            if !self.visit(node, key_schema, key) {
                fits &= !required(key);
                table.remove(key);
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
        let unknown: Vec<_> = table
            .entries
            .iter()
            .filter(|entry| !keys.contains_key(&entry.key))
            .map(|entry| (entry.key.clone(), entry.key_place.clone()))
            .collect();
        for (key, place) in unknown {
            table.remove(&key);
            let absent = keys.keys().map(String::as_str).filter(|known| table.get(known).is_none());
            let absent: Vec<&str> = absent.collect();
            slips.extend(nearest(&key, absent.iter().copied()));
            let help = self.other_kind(&key, schema).unwrap_or_else(|| did_you_mean(&key, &absent));
            self.error("unknown-key", &place, format!("unknown key `{key}` in `{name}`"), Some(help));
        }
        slips
    }

    fn missing(&self, key: &str, schema: &Schema, place: &Place, name: &str) {
        let help = schema["description"]
            .as_str()
            .map(|about| format!("`{key}`: {}", describe::first_paragraph(about)));
        self.error("missing-key", place, format!("`{name}` lacks the key `{key}`"), help);
    }
}
