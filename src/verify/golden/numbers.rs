//! Numbers of golden files by the names of their fields.

use crate::Error;
use crate::formula::Field;
use serde_json::{Map, Value};

/// `jac[out][in]`, nested by the shape of the output and within it by that of the input.
pub(super) fn named_jacobian(outputs: &[Field], inputs: &[Field], entries: &[f64]) -> Map<String, Value> {
    let mut rows = entries.chunks(inputs.iter().map(Field::len).sum());
    let of_output = |output: &Field| {
        let rows: Vec<_> = rows.by_ref().take(output.len()).collect();
        let mut start = 0;
        let of_input = |input: &Field| {
            let columns = start..start + input.len();
            start = columns.end;
            let shape = [output.quantity.shape.dimensions(), input.quantity.shape.dimensions()].concat();
            let mut numbers = rows.iter().flat_map(|row| &row[columns.clone()]);
            (input.name.to_string(), nested(&shape, &mut numbers))
        };
        (output.name.to_string(), Value::Object(inputs.iter().map(of_input).collect()))
    };
    outputs.iter().map(of_output).collect()
}

/// Components by the names of their fields, as in golden files.
///
/// # Panics
/// If there are fewer components than the fields have.
pub fn named(fields: &[Field], components: &[f64]) -> Map<String, Value> {
    let mut rest = components.iter();
    let part = |field: &Field| (field.name.to_string(), nested(&field.quantity.shape.dimensions(), &mut rest));
    fields.iter().map(part).collect()
}

/// The next numbers in this shape, row by row.
fn nested(shape: &[usize], numbers: &mut dyn Iterator<Item = &f64>) -> Value {
    match shape {
        [] => number(*numbers.next().expect("there is a number for every component of the fields")),
        [len, rest @ ..] => (0..*len).map(|_| nested(rest, numbers)).collect(),
    }
}

/// A scale as golden files print it: rounded up to four digits, so that no η comes out larger than it is.
///
/// What is above four digits by less than a part in 2⁴⁰ is not rounded up, so that rounding in the last of 237 bits, where
/// the scale has four digits or fewer, does not decide.
pub(super) fn four_digits_up(scale: f64) -> f64 {
    let least = scale * (1.0 - 2.0_f64.powi(-40));
    let text = format!("{scale:.3e}");
    let parse = |text: &str| text.parse().expect("digits with an exponent are a number");
    match (parse(&text), text.split_once('e')) {
        (nearest, Some((digits, exponent))) if nearest < least => {
            let [digits, exponent] = [&digits.replace('.', ""), exponent].map(parse);
            parse(&format!("{}e{}", digits + 1.0, exponent - 3.0))
        }
        (nearest, _) => nearest,
    }
}

/// The components of inputs that are given by name, as in golden files.
///
/// # Errors
/// [`Error::Unreadable`] naming what is missing, unknown, or not of its shape.
pub fn components(fields: &[Field], inputs: &Map<String, Value>) -> Result<Vec<f64>, Error> {
    if let Some(unknown) = inputs.keys().find(|name| fields.iter().all(|field| field.name != *name)) {
        let names: Vec<_> = fields.iter().map(|field| field.name).collect();
        return Err(Error::Unreadable { name: unknown.clone(), found: "no input".into(), allowed: names.join(", ") });
    }
    let mut components = Vec::new();
    for field in fields {
        let value = inputs.get(field.name).unwrap_or(&Value::Null);
        let shape = field.quantity.shape.dimensions();
        flatten(&shape, value, &mut components).ok_or_else(|| unreadable(field, &shape, value))?;
    }
    Ok(components)
}

/// The reverse of [`nested`]; `None` where the value is not of this shape.
fn flatten(shape: &[usize], value: &Value, into: &mut Vec<f64>) -> Option<()> {
    match (shape, value) {
        ([], value) => into.push(double(value)?),
        ([len, rest @ ..], Value::Array(parts)) if parts.len() == *len => {
            parts.iter().try_for_each(|part| flatten(rest, part, into))?;
        }
        _ => return None,
    }
    Some(())
}

fn unreadable(field: &Field, shape: &[usize], value: &Value) -> Error {
    let allowed = match shape {
        [] => "a number".into(),
        [len] => format!("an array of {len} numbers"),
        [rows, columns, ..] => format!("an array of {rows} rows of {columns} numbers"),
    };
    let found = if value.is_null() { "missing".into() } else { value.to_string() };
    Error::Unreadable { name: field.name.into(), found, allowed }
}

/// The reverse of [`number`].
pub(in crate::verify) fn double(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some("NaN") => Some(f64::NAN),
        Some("Infinity") => Some(f64::INFINITY),
        Some("-Infinity") => Some(f64::NEG_INFINITY),
        _ => value.as_f64(),
    }
}

/// A double, in JSON, which has no NaN and no infinity.
pub(in crate::verify) fn number(x: f64) -> Value {
    serde_json::Number::from_f64(x).map_or_else(
        || {
            Value::from(if x.is_nan() {
                "NaN"
            } else if x > 0.0 {
                "Infinity"
            } else {
                "-Infinity"
            })
        },
        Value::Number,
    )
}
