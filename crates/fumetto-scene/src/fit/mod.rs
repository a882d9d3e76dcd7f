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
use crate::text::{Array, Node, Place, Value};

pub(crate) use suggest::did_you_mean;
use suggest::list;

/// Reads a `T` from `root`; `None` where too little is left of it. Problems go to `log`.
pub(crate) fn read<T: JsonSchema + DeserializeOwned>(log: &Log, file: &str, root: &mut Node) -> Option<T> {
    let schema = schema_of::<T>();
    let fit = Fit { log, file, schema: &schema };
    if !fit.visit(root, &schema, "", None) {
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

    /// Checks `node`, called `name`, and all in it; whether it can stay. What the schema does not tell
    /// about it, `about` does, the description of what it lies in.
    fn visit(&self, node: &mut Node, schema: &'a Schema, name: &str, about: Option<&str>) -> bool {
        let about = schema["description"].as_str().or(about);
        let Some(target) = self.choose(node, self.resolve(schema), name, about) else { return false };
        let place = &node.place;
        match (&mut node.value, target["type"].as_str()) {
            (Value::Table(table), Some("object")) => self.visit_table(table, place, target, name),
            (Value::Array(array), Some("array")) => self.visit_array(array, place, target, name, about),
            (Value::Integer(_) | Value::Float(_), Some("number" | "integer")) => {
                // A field may narrow the range of the type it refers to.
                self.visit_number(node, &[target, schema], name, about)
            }
            (Value::String(_), Some("string")) | (Value::Bool(_), Some("boolean")) => true,
            _ => {
                self.mismatch(node, &describe::kind(target), name, about);
                false
            }
        }
    }

    /// An array of fixed length stands or falls whole; from others, misfits are taken out.
    fn visit_array(
        &self,
        array: &mut Array,
        place: &Place,
        schema: &'a Schema,
        name: &str,
        about: Option<&str>,
    ) -> bool {
        let count = array.items.len();
        let fixed = schema["minItems"].as_u64().filter(|_| schema["minItems"] == schema["maxItems"]);
        if let Some(needed) = fixed.filter(|&needed| needed != count as u64) {
            let message = format!("`{name}` needs {needed} values, but has {count}");
            self.error("wrong-length", place, message, about.map(describe::first_paragraph));
            return false;
        }
        let visit = |(i, item)| self.visit(item, &schema["items"], &format!("{name}[{i}]"), about);
        let fits: Vec<bool> = array.items.iter_mut().enumerate().map(visit).collect();
        if fixed.is_some() {
            return !fits.contains(&false);
        }
        array.retain(&fits);
        true
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
