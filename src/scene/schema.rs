//! The JSON Schema of scene files, made from the tables that read them.

use super::kind::{Dimension, Fallback, Kind};
use super::{elements, read};
use crate::quantity::{Domain, Quantity};
use serde_json::{Map, Value, json};

/// The schema: an editor that knows it completes names and marks mistakes while one writes.
pub fn schema() -> Value {
    let used = |dimension: &Dimension| Kind::all().any(|kind| kind.dimension == *dimension);
    let dimensions: Vec<_> = Dimension::ALL.into_iter().filter(used).map(of_dimension).collect();
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Scene",
        "description": "Connectors and constraints to be evaluated over a history of states",
        "oneOf": dimensions,
    })
}

/// An object with fixed keys.
fn record(properties: &Map<String, Value>, required: &[&str]) -> Value {
    json!({ "type": "object", "additionalProperties": false, "required": required, "properties": properties })
}

/// An object whose keys are names.
fn named(of: &Value) -> Value {
    json!({ "type": "object", "propertyNames": { "minLength": 1 }, "additionalProperties": of })
}

fn vector(len: usize) -> Value {
    json!({ "type": "array", "items": { "type": "number" }, "minItems": len, "maxItems": len })
}

fn entries<'k>(keys: impl IntoIterator<Item = &'k str>, values: impl IntoIterator<Item = Value>) -> Map<String, Value> {
    keys.into_iter().map(String::from).zip(values).collect()
}

fn of_dimension(dimension: Dimension) -> Value {
    let space = dimension == Dimension::Space;
    let kinds: Vec<_> = Kind::all().filter(|kind| kind.dimension == dimension).collect();
    let point = vector(dimension.coordinates());
    let angle = if space { vector(3) } else { json!({ "type": "number" }) };
    let orientation = if space {
        let axes = json!({ "type": "array", "items": vector(3), "minItems": 2, "maxItems": 2,
            "description": "along the first axis, and in the plane of the first two" });
        let all = entries(read::SPACE_ORIENTATION_KEYS, [axes, vector(3), vector(4)]);
        json!({ "minProperties": 1, "maxProperties": 1, "type": "object", "additionalProperties": false, "properties": all })
    } else {
        record(&entries(read::PLANE_ORIENTATION_KEYS, [json!({ "type": "number" })]), &read::PLANE_ORIENTATION_KEYS)
    };
    let node = record(&entries(read::NODE_KEYS, [point.clone(), json!({ "type": "string" })]), &["at"]);
    let motion = record(
        &entries(
            read::MOTION_KEYS,
            [point, angle].into_iter().take(if dimension == Dimension::Axisymmetric { 1 } else { 2 }),
        ),
        &[],
    );
    let loads: Vec<_> = kinds.iter().map(|kind| of_loads(kind)).collect();
    let loads = named(&json!({ "anyOf": loads }));
    let frame = record(&entries(read::FRAME_KEYS, [json!({ "type": "number" }), named(&motion), loads]), &["time"]);
    let elements: Vec<_> = kinds.iter().map(|kind| of_kind(kind)).collect();
    let mut outputs: Vec<_> = kinds.iter().flat_map(|kind| kind.outputs).map(|(name, _)| *name).collect();
    outputs.sort_unstable();
    outputs.dedup();
    record(
        &entries(
            read::KEYS,
            [
                json!({ "type": "string" }),
                json!({ "const": dimension.name() }),
                named(&orientation),
                named(&node),
                named(&json!({ "oneOf": elements })),
                json!({ "type": "array", "items": frame, "minItems": 1 }),
                json!({ "type": "array", "items": { "enum": outputs }, "uniqueItems": true }),
            ],
        ),
        &["dimension", "nodes", "elements"],
    )
}

/// A number of a quantity.
fn number(quantity: Option<&Quantity>) -> Value {
    let Some(quantity) = quantity else { return json!({ "type": "number" }) };
    let mut schema = json!({ "type": "number", "description": format!("{} ({})", quantity.meaning, quantity.unit) });
    let bounds: &[(&str, f64)] = match quantity.domain {
        Domain::NonNegative => &[("minimum", 0.0)],
        Domain::Positive => &[("exclusiveMinimum", 0.0)],
        Domain::Between(low, high) => &[("exclusiveMinimum", low), ("exclusiveMaximum", high)],
        Domain::Within(low, high) => &[("minimum", low), ("maximum", high)],
        _ => &[],
    };
    for &(key, bound) in bounds {
        schema[key] = json!(bound);
    }
    schema
}

fn of_kind(kind: &Kind) -> Value {
    let count = kind.nodes.len();
    let outputs: Vec<_> = kind.outputs.iter().map(|(name, _)| name).collect();
    let mut properties = entries(
        elements::KEYS,
        [
            json!({ "const": kind.name }),
            json!({ "type": "array", "items": { "type": "string" }, "minItems": count, "maxItems": count,
                "description": kind.nodes.join(", ") }),
            json!({ "type": "array", "items": { "enum": outputs }, "uniqueItems": true }),
        ],
    );
    for (name, fallback) in kind.parameters() {
        let mut schema = number(kind.quantity(name));
        if let Fallback::Number(fallback) = fallback {
            schema["default"] = json!(fallback);
        }
        properties.insert(name.into(), schema);
    }
    record(&properties, &["kind", "nodes"])
}

fn of_loads(kind: &Kind) -> Value {
    record(&kind.loads().map(|name| (name.into(), number(kind.quantity(name)))).collect(), &[])
}
