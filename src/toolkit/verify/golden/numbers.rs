//! Numbers of golden files, named by their fields.

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

/// A scale as printed in golden files: rounded up to four digits, so that no η is overestimated.
///
/// An excess over four digits of less than a part in 2⁴⁰ is ignored, so that a rounding error in the last of 237 bits
/// does not decide if the scale has four digits or fewer.
pub(in crate::toolkit::verify) fn four_digits_up(scale: f64) -> f64 {
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
/// [`Error::Unreadable`], naming the input that is missing, unknown, or of the wrong shape.
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

/// The reverse of [`nested`]; `None` if the value has another shape.
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
pub(in crate::toolkit::verify) fn double(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some("NaN") => Some(f64::NAN),
        Some("Infinity") => Some(f64::INFINITY),
        Some("-Infinity") => Some(f64::NEG_INFINITY),
        _ => value.as_f64(),
    }
}

/// A double as JSON, which has no NaN and no infinity.
pub(in crate::toolkit::verify) fn number(x: f64) -> Value {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::quantity::{F2, K_U1_U1_PLANE, MU, XA, XB_PLANE};
    use serde_json::json;

    #[test]
    fn scales_are_rounded_up_to_four_digits() {
        for (scale, expected) in [
            (0.0, 0.0),
            (1.0, 1.0),
            (12.345, 12.35),
            (12.3401, 12.35),
            (12.34, 12.34),
            // An excess over four digits due to rounding is ignored.
            (12.340_000_000_000_002, 12.34),
            (12.340_000_001, 12.35),
            (9999.5, 10000.0),
            (9.9991e-7, 1e-6),
            (1.2346e-20, 1.235e-20),
            (6.78949e22, 6.79e22),
        ] {
            assert_eq!(four_digits_up(scale), expected, "{scale}");
        }
        // Of twelve digits, a part in 2⁴⁰ is the last one.
        assert_eq!(four_digits_up(2.0 * (1.0 + 1.5 * 2.0_f64.powi(-41))), 2.0);
        assert_eq!(four_digits_up(2.0 * (1.0 + 2.0_f64.powi(-39))), 2.001);
    }

    const FIELDS: [Field; 3] = [Field::new("mu", &MU), Field::new("xa", &XA), Field::new("k", &K_U1_U1_PLANE)];

    #[test]
    fn numbers_have_names_and_shapes() {
        let components = [0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
        let named = named(&FIELDS, &components);
        let expected = json!({"mu": 0.5, "xa": [1.0, 2.0, 3.0], "k": [[4.0, 5.0], [6.0, 7.0]]});
        assert_eq!(Value::from(named.clone()), expected);
        assert_eq!(super::components(&FIELDS, &named).unwrap(), components);
    }

    /// Rows are outputs, columns are inputs: nested by the shape of the output and within it by that of the input.
    #[test]
    fn entries_of_a_jacobian_are_nested_by_both_shapes() {
        let [inputs, outputs] =
            [[Field::new("x", &XB_PLANE), Field::new("mu", &MU)], [Field::new("f", &F2), Field::new("g", &XB_PLANE)]];
        let entries: Vec<_> = (1..=9).map(f64::from).collect();
        let expected = json!({
            "f": {"x": [1.0, 2.0], "mu": 3.0},
            "g": {"x": [[4.0, 5.0], [7.0, 8.0]], "mu": [6.0, 9.0]},
        });
        assert_eq!(Value::from(named_jacobian(&outputs, &inputs, &entries)), expected);
    }

    #[test]
    fn what_is_missing_unknown_or_of_another_shape_is_named() {
        let refused = |changed: &str, value: Option<Value>| {
            let mut inputs = named(&FIELDS, &[1.0; 8]);
            match value {
                Some(value) => drop(inputs.insert(changed.into(), value)),
                None => drop(inputs.remove(changed)),
            }
            components(&FIELDS, &inputs).unwrap_err().to_string()
        };
        for (found, expected) in [
            (refused("nu", Some(json!(1))), "nu is no input; allowed is mu, xa, k"),
            (refused("mu", None), "mu is missing; allowed is a number"),
            (refused("mu", Some(json!("much"))), "mu is \"much\"; allowed is a number"),
            (refused("xa", Some(json!([1.0, 2.0]))), "xa is [1.0,2.0]; allowed is an array of 3 numbers"),
            (refused("xa", Some(json!([1, "b", 3]))), "xa is [1,\"b\",3]; allowed is an array of 3 numbers"),
            (refused("k", Some(json!([1, 2]))), "k is [1,2]; allowed is an array of 2 rows of 2 numbers"),
        ] {
            assert_eq!(found, expected);
        }
    }

    #[test]
    fn what_json_has_no_number_for_is_a_word() {
        for (x, expected) in [
            (f64::NAN, json!("NaN")),
            (f64::INFINITY, json!("Infinity")),
            (f64::NEG_INFINITY, json!("-Infinity")),
            (-0.5, json!(-0.5)),
        ] {
            assert_eq!(number(x), expected);
            assert_eq!(double(&expected).map(f64::to_bits), Some(x.to_bits()));
        }
        assert_eq!(double(&json!("infinity")), None);
        assert_eq!(double(&json!(7)), Some(7.0));
    }
}
