//! The guarantees of the layout of golden files: scales by which a port can be judged, matrices as rows, a version.

use crate::common;
use jointproof::catalog::{AnyFormula, CATALOG};
use jointproof::formula::proof::{Case, Proved};
use jointproof::formula::quantity::{Domain, Quantity, Shape, Unit};
use jointproof::formula::{Component, Described, Document, Field, Formula, Jacobian, Spec};
use jointproof::toolkit::verify::golden::{File, components};
use jointproof::{Scalar, fields};
use nalgebra::Matrix3;
use serde_json::{Map, Value, json};

/// The leaves of nested values in order.
fn leaves(value: &Value) -> Vec<f64> {
    match value {
        Value::Object(parts) => parts.values().flat_map(leaves).collect(),
        Value::Array(parts) => parts.iter().flat_map(leaves).collect(),
        Value::String(text) => vec![text.parse().unwrap()],
        number => vec![number.as_f64().unwrap()],
    }
}

fn all(named: &Map<String, Value>) -> Vec<f64> {
    named.values().flat_map(leaves).collect()
}

/// The numbers by output, output component, input and input component, as golden files nest them.
fn as_nested(formula: &dyn AnyFormula, rows: &[f64]) -> Vec<f64> {
    let columns = formula.inputs().iter().map(Field::len).sum();
    let mut rows = rows.chunks(columns);
    let mut nested = Vec::new();
    for output in formula.outputs() {
        let rows: Vec<_> = rows.by_ref().take(output.len()).collect();
        let mut start = 0;
        for input in formula.inputs() {
            nested.extend(rows.iter().flat_map(|row| &row[start..start + input.len()]));
            start += input.len();
        }
    }
    nested
}

/// η as a reader computes it. The golden number is rounded, too, which may increase η by 1.
fn eta(computed: f64, golden: f64, scale: f64) -> f64 {
    2.0_f64.powi(53) * ((computed - golden).abs() / (scale + f64::MIN_POSITIVE))
}

#[test]
fn the_formulas_keep_their_bounds_by_what_stands_in_the_files() {
    for formula in CATALOG {
        let file = common::golden(*formula);
        for case in file.cases.iter().filter(|case| case.error.is_none()) {
            let inputs = components(formula.inputs(), &case.inputs).unwrap();
            let worst = |computed: &[f64], golden: &[f64], scales: &[f64]| {
                assert!(computed.len() == golden.len() && golden.len() == scales.len(), "{} {}", file.formula, case.id);
                let each = computed.iter().zip(golden).zip(scales);
                each.map(|((&computed, &golden), &scale)| eta(computed, golden, scale)).fold(0.0, f64::max)
            };
            let (out, scale) = (all(case.out.as_ref().unwrap()), all(case.out_scale.as_ref().unwrap()));
            let found = worst(&formula.value(&inputs).unwrap(), &out, &scale);
            assert!(found <= file.eta.value + 1.0, "{} {}: {found}", file.formula, case.id);
            let Some(bound) = file.eta.jacobian else { continue };
            let Some((jac, scale)) = case.jac.as_ref().zip(case.jac_scale.as_ref()) else { continue };
            let computed = as_nested(*formula, &formula.jacobian(&inputs).unwrap());
            let found = worst(&computed, &all(jac), &all(scale));
            assert!(found <= bound + 1.0, "{} {}: Jacobian {found}", file.formula, case.id);
        }
    }
}

#[test]
fn scales_have_four_digits_and_are_not_below_their_numbers() {
    for formula in CATALOG {
        for case in common::golden(*formula).cases {
            let pairs = [(case.out, case.out_scale), (case.jac, case.jac_scale)];
            for (numbers, scales) in pairs.into_iter().filter_map(|(numbers, scales)| numbers.zip(scales)) {
                for (number, scale) in all(&numbers).into_iter().zip(all(&scales)) {
                    let context = format!("{} {}: {scale} of {number}", formula.spec().id, case.id);
                    assert!(scale >= number.abs() * (1.0 - 1e-12), "{context}");
                    assert!(scale.is_infinite() || format!("{scale:.3e}").parse() == Ok(scale), "{context}");
                }
            }
        }
    }
}

#[test]
fn another_layout_is_refused() {
    let text = CATALOG[0].golden().render().unwrap();
    let refused = File::parse(&text.replace("\"layout\": 2", "\"layout\": 3")).unwrap_err();
    assert_eq!(refused.to_string(), "layout 3; this version reads layout 2");
}

const TURN: Quantity = Quantity::new(r"\mathbf{A}", Shape::Mat3, Unit::ONE, Domain::Real, "any matrix");
const FACTOR: Quantity = Quantity::scalar("k", Unit::F.per(Unit::TEMPERATURE), Domain::Real, "any factor");
const SCALED: Quantity =
    Quantity::new(r"\mathbf{B}", Shape::Mat3, Unit::F.per(Unit::TEMPERATURE), Domain::Real, "its multiple");

fields! { struct Scaling<T> { a: Matrix3<T> = TURN, k: T = FACTOR } }
fields! { struct Multiple<T> { b: Matrix3<T> = SCALED } }

/// B = k A.
#[derive(Clone, Copy)]
struct Scaled;

impl Formula for Scaled {
    const SPEC: Spec = Spec::new("matrix.multiple", "Multiple", Document::new("None").printed(""))
        .equation(r"\mathbf{B} = k\mathbf{A}")
        .eta(1.0, 0.0);
    type Inputs<T: Component> = Scaling<T>;
    type Outputs<T: Component> = Multiple<T>;
    fn eval<D: Scalar>(i: &Scaling<D>) -> Multiple<D> {
        Multiple { b: i.a * i.k }
    }
    fn jacobian<D: Scalar>(i: &Scaling<D>) -> Jacobian<Self, D> {
        let (zero, one) = (D::zero(), D::one());
        let unit = |row, column| Matrix3::from_fn(|r, c| if (r, c) == (row, column) { one } else { zero });
        Multiple { b: Matrix3::from_fn(|r, c| Scaling { a: unit(r, c) * i.k, k: i.a[(r, c)] }) }
    }
}

impl Proved for Scaled {
    fn cases() -> Vec<Case<Scaling<f64>>> {
        let a = Matrix3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0);
        vec![Case::hand("counted", "every component another", Scaling { a, k: 2.0 })]
    }
}

#[test]
fn matrices_stand_as_rows_and_read_back() {
    let file = <dyn AnyFormula>::golden(&Scaled);
    assert_eq!(File::parse(&file.render().unwrap()).unwrap(), file);
    let (case, [matrix, factor]) = (&file.cases[0], [&file.inputs[0], &file.inputs[1]]);
    assert_eq!((matrix.shape.as_slice(), factor.unit.as_str()), ([3, 3].as_slice(), "F/Θ"));
    assert_eq!(case.inputs["a"], json!([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]));
    let inputs = components(Scaled.inputs(), &case.inputs).unwrap();
    assert_eq!(inputs, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 2.0]);
    let by = |named: &Option<Map<String, Value>>| named.as_ref().unwrap()["b"].clone();
    assert_eq!(by(&case.out)[1], json!([8.0, 10.0, 12.0]));
    assert_eq!(by(&case.out_scale)[1], json!([24.0, 30.0, 36.0]));
    // By row and column of B, then of A.
    assert_eq!(by(&case.jac)["k"][1], json!([4.0, 5.0, 6.0]));
    assert_eq!(by(&case.jac)["a"][1][2], json!([[0.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, 0.0, 0.0]]));
    assert_eq!(by(&case.jac_scale)["a"][1][2][1], json!([0.0, 0.0, 4.0]));

    let mut wrong = case.inputs.clone();
    wrong.insert("a".into(), json!([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]));
    let refused = components(Scaled.inputs(), &wrong).unwrap_err().to_string();
    assert!(
        refused.contains("a is [[1.0,2.0,3.0],[4.0,5.0,6.0]]; allowed is an array of 3 rows of 3 numbers"),
        "{refused}"
    );
}
