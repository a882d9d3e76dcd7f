use serde_json::Value as Schema;

/// The first paragraph of what the schema says about a value, for a help line.
pub(super) fn first_paragraph(description: &str) -> String {
    description.split("\n\n").next().unwrap_or(description).replace('\n', " ")
}

/// What a value must be: "a number", "3 numbers", "a string or a table".
pub(super) fn kind(schema: &Schema) -> String {
    match schema["type"].as_str() {
        Some("number") => "a number".into(),
        Some("integer") => "a whole number".into(),
        Some("boolean") => "true or false".into(),
        Some("string") => "a string".into(),
        Some("array") => array(schema),
        _ => only_key(schema).map_or_else(|| "a table".into(), |key| format!("{{ {key} = … }}")),
    }
}

/// The key of a table that has exactly one, as serde writes enums.
pub(super) fn only_key(schema: &Schema) -> Option<&str> {
    let keys = schema["properties"].as_object()?;
    let only = keys.keys().next().filter(|_| keys.len() == 1)?;
    (schema["required"] == serde_json::json!([only])).then_some(only.as_str())
}

fn array(schema: &Schema) -> String {
    let items = match schema["items"]["type"].as_str() {
        Some("number") => "numbers",
        Some("integer") => "whole numbers",
        Some("array") => "arrays",
        _ => "values",
    };
    match schema["minItems"].as_u64() {
        Some(count) => format!("an array of {count} {items}"),
        None => "an array".into(),
    }
}
