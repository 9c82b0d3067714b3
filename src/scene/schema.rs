//! The JSON Schema of scene files, generated from the tables that read them.

use super::abaqus::SAME_OUTPUTS;
use super::angles::AngleUnit;
use super::kind::{Dimension, Kind};
use super::read::keys;
use crate::contact::slide_line::SlideLine;
use crate::formula::quantity::{Domain, EXTENSION_ZONE, Quantity, SMOOTH};
use serde_json::{Map, Value, json};

/// The schema: an editor that uses it completes names and marks mistakes during writing.
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

fn text() -> Value {
    json!({ "type": "string" })
}

fn of_dimension(dimension: Dimension) -> Value {
    let kinds: Vec<_> = Kind::all().filter(|kind| kind.dimension == dimension).collect();
    let at = or_array(vector(dimension.coordinates()));
    let mut node = record(&entries(keys::NODE, [at, text(), text()]), &[]);
    node["oneOf"] = json!(["at", "with"].map(|key| json!({ "required": [key] })));
    let elements: Vec<_> = kinds.iter().map(|kind| of_kind(kind)).collect();
    let mut outputs: Vec<_> = kinds.iter().flat_map(|kind| kind.outputs()).map(|(name, _)| name).collect();
    outputs.sort_unstable();
    outputs.dedup();
    let outputs = with_names_in_abaqus(outputs);
    let mut properties = entries(
        keys::SCENE,
        [
            text(),
            json!({ "const": dimension.name() }),
            json!({ "enum": AngleUnit::NAMES.map(|(name, _)| name), "default": "radians",
                "description": "the unit of the angles in the file and its arrays; results are in radians" }),
            json!({ "type": "string", "description": "a .npz file beside the scene, with the arrays that it names" }),
            named(&orientation(dimension)),
            named(&node),
            named(&slide_line()),
            named(&json!({ "oneOf": elements })),
            frames(dimension, &kinds),
            json!({ "type": "array", "items": { "enum": outputs }, "uniqueItems": true }),
        ],
    );
    if dimension != Dimension::Axisymmetric {
        properties.remove("slide_lines");
    }
    let mut schema = record(&properties, &["dimension", "nodes", "elements"]);
    // Without a file of columns, the name of an array is not allowed in place of numbers.
    let numbers =
        kinds.iter().flat_map(|kind| kind.parameters()).map(|(name, _)| (name.into(), json!({ "type": "number" })));
    let of_each = |properties: Map<String, Value>| json!({ "additionalProperties": { "properties": properties } });
    schema["if"] = json!({ "required": ["columns"] });
    schema["else"] = json!({ "properties": {
        "nodes": of_each(entries(["at"], [json!({ "type": "array" })])),
        "elements": of_each(numbers.collect()),
        "frames": { "type": "array" },
    } });
    schema
}

/// The same, or the name of an array: constraints on a value apply only to values of its type.
fn or_array(mut schema: Value) -> Value {
    schema["type"] = json!([schema["type"], "string"]);
    schema
}

fn orientation(dimension: Dimension) -> Value {
    if dimension != Dimension::Space {
        let angle = entries(keys::PLANE_ORIENTATION, [json!({ "type": "number" })]);
        return record(&angle, &keys::PLANE_ORIENTATION);
    }
    let axes = json!({ "type": "array", "items": vector(3), "minItems": 2, "maxItems": 2,
        "description": "along the first axis, and in the plane of the first two" });
    let mut schema = record(&entries(keys::SPACE_ORIENTATION, [axes, vector(3), vector(4)]), &[]);
    schema["minProperties"] = json!(1);
    schema["maxProperties"] = json!(1);
    schema
}

/// A slide line; the reader checks which parameters of a law go together.
fn slide_line() -> Value {
    let numbers = |keys: &[(&str, Domain)], required: &[&str]| {
        record(&keys.iter().map(|&(name, domain)| (name.into(), of_domain(domain))).collect(), required)
    };
    let all = entries(
        keys::SLIDE_LINE,
        [
            json!({ "enum": keys::TYPES.map(|(name, _)| name) }),
            json!({ "type": "array", "items": text(), "minItems": 2 }),
            record(
                &entries(keys::GENERATE, [text(), text(), json!({ "type": "integer", "minimum": 1 })]),
                &["first", "last"],
            ),
            with_default(number(Some(&SMOOTH)), 0.0),
            with_default(number(Some(&EXTENSION_ZONE)), SlideLine::EXTENSION),
            numbers(&keys::PRESSURE, &[]),
            numbers(&keys::DAMPING, &keys::DAMPING.map(|(name, _)| name)),
            numbers(&keys::FRICTION, &keys::FRICTION.map(|(name, _)| name)),
            json!({ "type": "integer", "minimum": 0, "default": 1 }),
        ],
    );
    let mut schema = record(&all, &["type"]);
    schema["oneOf"] = json!(["nodes", "generate"].map(|key| json!({ "required": [key] })));
    schema
}

/// An array of frames, or one frame whose values are arrays over all states.
fn frames(dimension: Dimension, kinds: &[&Kind]) -> Value {
    let time = json!({ "type": "number" });
    let turn = if dimension == Dimension::Space { vector(3) } else { time.clone() };
    let loads = |kind: &Kind| kind.loads().map(|name| (name.into(), number(kind.quantity(name)))).collect();
    let pressure = of_domain(Domain::NonNegative);
    let frame = frame(dimension, kinds, [time, vector(dimension.coordinates()), turn, pressure], loads);
    let array = || json!({ "type": "string" });
    let loads = |kind: &Kind| kind.loads().map(|name| (name.into(), array())).collect();
    let mut frames = self::frame(dimension, kinds, [array(), array(), array(), array()], loads);
    frames["type"] = json!(["array", "object"]);
    // Instead of arrays of a file of columns, the names of tables.
    let properties = frames["properties"].as_object_mut().into_iter().flatten();
    for (_, schema) in properties.filter(|(key, _)| keys::TABLES.contains(&key.as_str())) {
        schema["type"] = json!(["object", "string"]);
    }
    frames["required"] = json!([]);
    frames["items"] = frame;
    frames["minItems"] = json!(1);
    frames
}

fn frame(
    dimension: Dimension,
    kinds: &[&Kind],
    [time, displacement, turn, pressure]: [Value; 4],
    loads: impl Fn(&Kind) -> Map<String, Value>,
) -> Value {
    let motion = |turn: Option<Value>| {
        let all = std::iter::once(displacement.clone()).chain(turn);
        named(&record(&entries(keys::MOTION, all), &[]))
    };
    if dimension == Dimension::Axisymmetric {
        return record(&entries(keys::SLIDING_FRAME, [time, motion(None), named(&pressure)]), &["time"]);
    }
    let loads: Vec<_> = kinds.iter().map(|kind| record(&loads(kind), &[])).collect();
    let all = entries(keys::FRAME, [time, motion(Some(turn)), named(&json!({ "anyOf": loads }))]);
    record(&all, &["time"])
}

/// Outputs, and those names of Abaqus that are accepted for one of them.
fn with_names_in_abaqus(mut outputs: Vec<&'static str>) -> Vec<&'static str> {
    let theirs: Vec<_> =
        SAME_OUTPUTS.iter().filter(|(_, ours)| outputs.contains(ours)).map(|(theirs, _)| *theirs).collect();
    outputs.extend(theirs);
    outputs
}

/// A number of a quantity.
fn number(quantity: Option<&Quantity>) -> Value {
    let Some(quantity) = quantity else { return json!({ "type": "number" }) };
    let mut schema = of_domain(quantity.domain);
    let unit =
        if quantity.domain == Domain::Angle { "in the unit of \"angles\"".into() } else { quantity.unit.to_string() };
    schema["description"] = json!(format!("{} ({unit})", quantity.meaning));
    schema
}

fn with_default(mut schema: Value, default: f64) -> Value {
    schema["default"] = json!(default);
    schema
}

fn of_domain(domain: Domain) -> Value {
    let mut schema = json!({ "type": "number" });
    let bounds: &[(&str, f64)] = match domain {
        Domain::NonNegative => &[("minimum", 0.0)],
        Domain::Positive => &[("exclusiveMinimum", 0.0)],
        Domain::Between(low, high) => &[("exclusiveMinimum", low), ("exclusiveMaximum", high)],
        Domain::Within(low, high) => &[("minimum", low), ("maximum", high)],
        Domain::HalfOpen(low, high) => &[("minimum", low), ("exclusiveMaximum", high)],
        _ => &[],
    };
    for &(key, bound) in bounds {
        schema[key] = json!(bound);
    }
    schema
}

fn of_kind(kind: &Kind) -> Value {
    let count = kind.nodes.len();
    let outputs = with_names_in_abaqus(kind.outputs().map(|(name, _)| name).collect());
    let mut properties = entries(
        keys::SLIDING_ELEMENT,
        [
            json!({ "const": kind.name }),
            json!({ "type": "array", "items": { "type": "string" }, "minItems": count, "maxItems": count,
                "description": kind.nodes.join(", ") }),
            json!({ "type": "array", "items": { "enum": outputs }, "uniqueItems": true }),
            text(),
        ],
    );
    if !kind.slides() {
        properties.remove("slide_line");
    }
    for (name, fallback) in kind.parameters() {
        let schema = or_array(number(kind.quantity(name)));
        let schema = fallback.number().map_or(schema.clone(), |fallback| with_default(schema, fallback));
        properties.insert(name.into(), schema);
    }
    record(&properties, if kind.slides() { &["kind", "nodes", "slide_line"] } else { &["kind", "nodes"] })
}
