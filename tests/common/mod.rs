//! Shared by test files: golden files, and strategies for inputs of any formula, drawn from the domains that its fields declare.

use jointproof::catalog::{AnyElement, AnyFormula};
use jointproof::formula::Field;
use jointproof::formula::quantity::{Domain, Node, Shape};
use jointproof::toolkit::verify::ElementFile;
use jointproof::toolkit::verify::golden::File;
use proptest::prelude::*;

/// The committed golden file of a formula, which is much faster to read than to compute. Its agreement with the code is tested in
/// `golden.rs`.
pub fn golden(formula: &dyn AnyFormula) -> File {
    let path = format!("{}/golden/{}.json", env!("CARGO_MANIFEST_DIR"), formula.spec().id);
    let text =
        std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}; run: cargo xtask golden"));
    File::parse(&text).unwrap()
}

/// The committed golden file of an element.
pub fn golden_of_element(element: &dyn AnyElement) -> ElementFile {
    let path = format!("{}/golden/elements/{}.json", env!("CARGO_MANIFEST_DIR"), element.spec().id);
    serde_json::from_str(&std::fs::read_to_string(&path).expect(&path)).expect(&path)
}

/// A number of either sign with a magnitude from 2⁻¹⁰ to 2¹⁰, the range for which the bounds are stated.
pub fn signed() -> impl Strategy<Value = f64> {
    (magnitude(), any::<bool>()).prop_map(|(x, negative)| if negative { -x } else { x })
}

/// A positive number from 2⁻¹⁰ to 2¹⁰, the range for which the bounds are stated, with every power of two equally likely.
pub fn magnitude() -> impl Strategy<Value = f64> {
    (1.0..2.0_f64, -10..10).prop_map(|(mantissa, exponent)| mantissa * 2.0_f64.powi(exponent))
}

/// Any double: including NaN, infinities, zeros and subnormals.
pub fn anything() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => any::<f64>(),
        1 => prop::sample::select(vec![0.0, -0.0, 1.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN_POSITIVE, 5e-324]),
    ]
}

/// A right-handed orthonormal triad, one row per vector.
pub fn rotation() -> impl Strategy<Value = [[f64; 3]; 3]> {
    let component = || prop_oneof![-1.0..-0.1, 0.1..1.0];
    [component(), component(), component(), component()].prop_map(|q: [f64; 4]| {
        let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [w, x, y, z] = q.map(|x| x / length);
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
            [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
            [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
        ]
    })
}

/// Inputs of a formula that its domains allow; `validate` may still reject them.
pub fn inputs(formula: &'static dyn AnyFormula) -> BoxedStrategy<Vec<f64>> {
    let fields = formula.inputs();
    let plane = fields.iter().any(|field| field.quantity.shape == Shape::Vec2);
    let numbers: usize = fields.iter().map(Field::len).sum();
    (
        rotation(),
        rotation(),
        0.1..6.2_f64,
        prop::collection::vec((magnitude(), any::<bool>(), 0.001..0.999_f64), numbers),
    )
        .prop_map(move |(a, b, angle, raw)| {
            let (s, c) = angle.sin_cos();
            let triads = if plane { [[[c, s, 0.0], [-s, c, 0.0], [0.0; 3]]; 2] } else { [a, b] };
            let mut raw = raw.into_iter();
            let mut number = |domain: Domain, component: usize| {
                let (size, negative, fraction) = raw.next().unwrap();
                match domain {
                    Domain::NonNegative | Domain::Positive => size,
                    Domain::Angle => (fraction - 0.5) * std::f64::consts::TAU,
                    Domain::Between(low, high) | Domain::Within(low, high) => low + fraction * (high - low),
                    Domain::Triad(node, axis) => triads[usize::from(node == Node::B)][axis - 1][component],
                    Domain::Direction => (0.1 + 0.9 * fraction) * if negative { -1.0 } else { 1.0 },
                    _ if negative => -size,
                    _ => size,
                }
            };
            let components = fields.iter().flat_map(|field| (0..field.len()).map(|k| (field.quantity.domain, k)));
            components.map(|(domain, k)| number(domain, k)).collect()
        })
        .boxed()
}
