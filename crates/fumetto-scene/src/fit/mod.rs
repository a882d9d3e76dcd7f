//! Whether a text fits the JSON Schema: keys, types and ranges, with every misfit reported.
//!
//! serde stops at the first key or type it does not know. This walks the spanned tree along the schema
//! that the wire types generate, so there is no second list of keys and all misfits are found at
//! once. What does not fit is taken out of the tree, so that what is left can still be read and
//! checked for sense.

mod describe;
mod number;
mod suggest;
mod table;
mod union;

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde_json::Value as Schema;

use crate::report::{Log, Severity};
use crate::schema::schema_of;
use crate::text::{Node, Place, Value};

pub(crate) use suggest::did_you_mean;
use suggest::list;

/// Reads a `T` from `root`; `None` where too little is left of it. Problems go to `log`.
pub(crate) fn read<T: JsonSchema + DeserializeOwned>(log: &Log, file: &str, root: &mut Node) -> Option<T> {
    let schema = schema_of::<T>();
    let fit = Fit { log, file, schema: &schema };
    if !fit.visit(root, &schema, "the file") {
        return None;
    }
    match T::deserialize(root.to_toml()) {
        Ok(read) => Some(read),
        Err(error) => {
            fit.error("unreadable", &root.place, format!("this cannot be read: {}", error.message()), None);
            None
        }
    }
}

struct Fit<'a> {
    log: &'a Log,
    file: &'a str,
    /// The whole schema, in which `$ref` points.
    schema: &'a Schema,
}

impl<'a> Fit<'a> {
    fn error(&self, code: &'static str, place: &Place, message: String, help: Option<String>) {
        self.log.report(Severity::Error, code, self.file, Some(place), message, help);
    }

    /// Checks `node`, called `name`, and all in it; whether it can stay.
    fn visit(&self, node: &mut Node, schema: &'a Schema, name: &str) -> bool {
        let about = schema["description"].as_str();
        let target = self.resolve(schema);
        let Some(target) = self.choose(node, target, name, about) else { return false };
        let place = &node.place;
        match (&mut node.value, target["type"].as_str()) {
            (Value::Table(table), Some("object")) => self.visit_table(table, place, target, name),
            (Value::Array(items), Some("array")) => self.visit_array(items, place, target, name, about),
            (Value::Integer(_) | Value::Float(_), Some("number" | "integer")) => {
                // A field may narrow the range of the type it refers to.
                self.visit_number(node, &[target, schema], name, about)
            }
            (Value::String(text), Some("string")) => match target["const"].as_str() {
                Some(only) if only != text => {
                    let message = format!("`{name}` must be {only:?}, not {text:?}");
                    self.error("unknown-value", place, message, about.map(describe::first_paragraph));
                    false
                }
                _ => true,
            },
            (Value::Bool(_), Some("boolean")) => true,
            _ => {
                self.mismatch(node, &describe::kind(target), name, about);
                false
            }
        }
    }

    fn visit_array(
        &self,
        items: &mut [Node],
        place: &Place,
        schema: &'a Schema,
        name: &str,
        about: Option<&str>,
    ) -> bool {
        let count = items.len() as u64;
        let wrong = schema["minItems"].as_u64().filter(|&min| count < min);
        if let Some(needed) = wrong.or(schema["maxItems"].as_u64().filter(|&max| count > max)) {
            let message = format!("`{name}` needs {needed} values, but has {count}");
            self.error("wrong-length", place, message, about.map(describe::first_paragraph));
            return false;
        }
        let item_schema = &schema["items"];
        let visit = |(i, item)| self.visit(item, item_schema, &format!("{name}[{i}]"));
        // Every item is visited, so `all` would stop too early.
        items.iter_mut().enumerate().map(visit).fold(true, |all, fits| all & fits)
    }

    /// Reports a value of the wrong type.
    fn mismatch(&self, node: &Node, expected: &str, name: &str, about: Option<&str>) {
        let message = format!("`{name}` must be {expected}, not {}", node.type_name());
        self.error("wrong-type", &node.place, message, about.map(describe::first_paragraph));
    }

    /// Follows `$ref`.
    fn resolve(&self, schema: &'a Schema) -> &'a Schema {
        let pointer = schema["$ref"].as_str().and_then(|reference| reference.strip_prefix('#'));
        pointer.and_then(|pointer| self.schema.pointer(pointer)).unwrap_or(schema)
    }
}
