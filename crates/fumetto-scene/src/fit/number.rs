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
            let value = if value.is_nan() { "nan".to_owned() } else { value.to_string() };
            let message = format!("`{name}` must be a finite number, not {value}");
            self.error("not-finite", &node.place, message, about.map(describe::first_paragraph));
            return false;
        }
        let limit = Limit::from_schemas(whole, schemas);
        let kept = if whole { value } else { as_kept(value) };
        if !limit.contains(kept) {
            let shown = if value.abs() < 1e15 { value.to_string() } else { format!("{value:e}") };
            let message = format!("`{name}` must be {}, not {shown}", limit.wanted(kept));
            self.error("out-of-range", &node.place, message, about.map(describe::first_paragraph));
            return false;
        }
        true
    }
}

/// What is left of a number in the model's 32 bits, and on GPUs, which take the tiniest for zero.
fn as_kept(value: f64) -> f64 {
    let value = value as f32;
    if value.is_subnormal() { 0.0 } else { value.into() }
}
