//! The JSON Schema of scene files, generated from the types of [`crate::file`].

use schemars::{
    JsonSchema, Schema, generate::SchemaSettings, transform::Transform, transform::transform_subschemas,
};
use serde_json::Value;

use crate::file::SceneFile;

/// The JSON Schema (draft 2020-12) of a scene file.
#[must_use]
pub fn schema() -> Value {
    schema_of::<SceneFile>()
}

/// The JSON Schema of one wire type.
pub(crate) fn schema_of<T: JsonSchema>() -> Value {
    let settings = SchemaSettings::draft2020_12().with_transform(WithoutNull);
    settings.into_generator().into_root_schema_for::<T>().to_value()
}

/// Takes `null` out of the schema: TOML has none, an optional key is simply left out.
#[derive(Clone)]
struct WithoutNull;

impl Transform for WithoutNull {
    fn transform(&mut self, schema: &mut Schema) {
        transform_subschemas(self, schema);
        if let Some(Value::Array(types)) = schema.get_mut("type") {
            types.retain(|name| name != "null");
            if let [only] = types.as_slice() {
                let only = only.clone();
                schema.insert("type".into(), only);
            }
        }
        if let Some(Value::Array(branches)) = schema.get_mut("anyOf") {
            branches.retain(|branch| branch.get("type").is_none_or(|name| name != "null"));
            if let [Value::Object(only)] = branches.as_slice() {
                let only = only.clone();
                schema.remove("anyOf");
                for (key, value) in only {
                    schema.ensure_object().entry(key).or_insert(value);
                }
            }
        }
        if schema.get_mut("default").is_some_and(|default| !keep_without_null(default)) {
            schema.remove("default");
        }
    }
}

/// Takes absent keys out of a default; whether anything is left of it.
fn keep_without_null(default: &mut Value) -> bool {
    match default {
        Value::Null => false,
        Value::Object(keys) => {
            keys.retain(|_, value| keep_without_null(value));
            !keys.is_empty()
        }
        _ => true,
    }
}
