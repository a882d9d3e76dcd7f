use serde_json::Value as Schema;

use super::{Fit, describe};
use crate::limits::Limit;
use crate::text::{Node, Value};

impl Fit<'_> {
    /// Checks a number against the ranges of all `schemas`, of which the first says its type.
    pub(super) fn visit_number(
        &self,
        node: &Node,
        schemas: &[&Schema],
        name: &str,
        about: Option<&str>,
    ) -> bool {
        let whole = schemas[0]["type"] == "integer";
        let value = match node.value {
            Value::Integer(value) => value as f64,
            Value::Float(value) if !whole => value,
            _ => {
                self.mismatch(node, &describe::kind(schemas[0]), name, about);
                return false;
            }
        };
        if !value.is_finite() {
            let message = format!("`{name}` must be a finite number, not {value}");
            self.error("not-finite", &node.place, message, about.map(describe::first_paragraph));
            return false;
        }
        let limit = Limit::from_schemas(whole, schemas);
        if !limit.contains(value) {
            let message = format!("`{name}` must be {}, not {value}", limit.wanted(value));
            self.error("out-of-range", &node.place, message, about.map(describe::first_paragraph));
            return false;
        }
        true
    }
}
