//! Octuple compared with exact values, with the f64 hardware, and under num-dual.
//!
//! The exact values are computed by mpmath in `tests/data/octuple_reference.py`, which writes `tests/data/octuple_reference.csv`
//! and describes its columns. To measure at more points:
//!
//! ```text
//! python3 tests/data/octuple_reference.py --random 500 --seed 7 > /tmp/more.csv
//! OCTUPLE_REFERENCE=/tmp/more.csv cargo test --test all octuple::worst -- --nocapture
//! ```

use std::collections::BTreeMap;

use jointproof::Octuple;
use num_dual::DualNum;
use num_traits::{Signed, Zero};

/// Names for two bounds: correct rounding, and nearly correct rounding.
const HALF: f64 = 0.5;
const NEARLY_HALF: f64 = 0.51;

type Function = fn(Octuple, Octuple) -> Octuple;

/// Every function of the reference file: the bound that the documentation of `Octuple` promises, in ulps, and the
/// function of (x, y). Measured on 8000 random points each, the worst are tanh 1.84, `sph_j2` 2.56, asinh 1.68.
const FUNCTIONS: [(&str, f64, Function); 35] = [
    ("add", HALF, |x, y| x + y),
    ("sub", HALF, |x, y| x - y),
    ("mul", HALF, |x, y| x * y),
    ("div", HALF, |x, y| x / y),
    ("rem", HALF, |x, y| x % y),
    ("mul_add", HALF, |x, y| x.mul_add(x, y)),
    ("mul_residual", HALF, |x, y| x.mul_add(y, -(x * y))),
    ("sqrt", HALF, |x, _| x.sqrt()),
    ("cbrt", NEARLY_HALF, |x, _| x.cbrt()),
    ("sin", NEARLY_HALF, |x, _| x.sin()),
    ("cos", NEARLY_HALF, |x, _| x.cos()),
    ("tan", 2.0, |x, _| x.tan()),
    ("asin", 1.0, |x, _| x.asin()),
    ("acos", 2.0, |x, _| x.acos()),
    ("atan", 1.0, |x, _| x.atan()),
    ("atan2", 1.0, |y, x| y.atan2(x)),
    ("exp", NEARLY_HALF, |x, _| x.exp()),
    ("exp_m1", 1.0, |x, _| x.exp_m1()),
    ("exp2", NEARLY_HALF, |x, _| x.exp2()),
    ("ln", NEARLY_HALF, |x, _| x.ln()),
    ("ln_1p", 2.0, |x, _| x.ln_1p()),
    ("log", NEARLY_HALF, |x, y| x.log(y.to_f64())),
    ("log2", NEARLY_HALF, |x, _| x.log2()),
    ("log10", NEARLY_HALF, |x, _| x.log10()),
    ("powi", NEARLY_HALF, |x, y| x.powi(whole(y))),
    ("powf", 2.0, |x, y| x.powf(y.to_f64())),
    ("sinh", 2.0, |x, _| x.sinh()),
    ("cosh", 2.0, |x, _| x.cosh()),
    ("tanh", 2.0, |x, _| x.tanh()),
    ("asinh", 2.0, |x, _| x.asinh()),
    ("acosh", 2.0, |x, _| x.acosh()),
    ("atanh", 2.0, |x, _| x.atanh()),
    ("sph_j0", 2.0, |x, _| x.sph_j0()),
    ("sph_j1", 4.0, |x, _| x.sph_j1()),
    ("sph_j2", 4.0, |x, _| x.sph_j2()),
];

/// A literal of the reference file.
fn octuple(text: &str) -> Octuple {
    if text.contains('p') {
        return hexadecimal(text);
    }
    text.parse().unwrap_or_else(|error| panic!("{text:?}: {error}"))
}

#[expect(clippy::cast_possible_truncation, reason = "the reference file holds whole numbers there")]
fn whole(y: Octuple) -> i32 {
    y.to_f64() as i32
}

/// One line of the reference file: the function's exact result at (x, y) is value + tail.
struct Row<'a> {
    function: &'a str,
    x: &'a str,
    y: &'a str,
    value: &'a str,
    tail: &'a str,
}

impl Row<'_> {
    /// The error of `result` in ulps of the exact value. The difference of neighbours is exact.
    fn error(&self, result: Octuple) -> f64 {
        let value = octuple(self.value);
        let mut unit = value.ulp();
        if matches!(self.function, "sph_j1" | "sph_j2") && octuple(self.x).abs() > 1.0 {
            let envelope = octuple(self.x).recip().ulp();
            unit = if envelope > unit { envelope } else { unit };
        }
        (((result - value) - octuple(self.tail)) / unit).to_f64().abs()
    }
}

fn rows(text: &str) -> impl Iterator<Item = Row<'_>> {
    text.lines().filter(|line| !line.starts_with('#')).map(|line| {
        let columns: Vec<_> = line.split(',').collect();
        let [function, x, y, value, tail] = columns[..] else { panic!("not five columns: {line}") };
        Row { function, x, y, value, tail }
    })
}

/// The committed reference file, or the one named by the environment variable.
fn reference() -> String {
    match std::env::var("OCTUPLE_REFERENCE") {
        Ok(path) => std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}")),
        Err(_) => include_str!("data/octuple_reference.csv").to_owned(),
    }
}

/// Every function stays within its bound at every point, and every function has points.
#[test]
fn worst_errors_are_within_the_bounds() {
    let text = reference();
    let mut worst: BTreeMap<&str, (f64, usize)> = BTreeMap::new();
    let mut failures = Vec::new();
    for row in rows(&text).filter(|row| row.function != "parse") {
        let (_, bound, call) = FUNCTIONS.iter().find(|entry| entry.0 == row.function).expect(row.function);
        let y = if row.y.is_empty() { Octuple::zero() } else { octuple(row.y) };
        let result = call(octuple(row.x), y);
        let error = row.error(result);
        if error.is_nan() || error > *bound {
            failures.push(format!(
                "{}({}, {})\n  is    {} and {}\n  not   {result:.79e}\n  which is off by {error:.3} ulp; the bound is {bound}",
                row.function, row.x, row.y, row.value, row.tail
            ));
        }
        let entry = worst.entry(row.function).or_default();
        *entry = (entry.0.max(error), entry.1 + 1);
    }
    for (function, (error, count)) in &worst {
        println!("{function:12} {error:.3} ulp in {count} points");
    }
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), failures.join("\n"));
    for (function, ..) in FUNCTIONS {
        assert!(worst.contains_key(function), "no reference values for {function}");
    }
}

/// Decimal literals of every length, including halfway cases, become the nearest number, ties to even.
#[test]
fn literals_are_read_to_the_nearest() {
    let text = reference();
    let mut count = 0;
    for row in rows(&text).filter(|row| row.function == "parse") {
        let (parsed, expected) = (octuple(row.x), hexadecimal(row.value));
        assert!(parsed == expected, "{}\n  is  {expected:.75e}\n  not {parsed:.75e}", row.x);
        count += 1;
    }
    assert!(count > 10);
}

/// `±0xMp±E`, the number M · 2^E: every step is exact.
fn hexadecimal(text: &str) -> Octuple {
    let (mantissa, exponent) = text.split_once('p').expect(text);
    let (sign, digits) = mantissa.split_once("0x").expect(text);
    let whole =
        digits.chars().fold(Octuple::zero(), |sum, digit| sum * 16.0 + f64::from(digit.to_digit(16).expect(text)));
    let scaled = whole * Octuple::from(2.0).powi(exponent.parse().expect(text));
    if sign == "-" { -scaled } else { scaled }
}

#[test]
fn constants_are_correctly_rounded() {
    let pi = "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534211706798";
    let e = "2.71828182845904523536028747135266249775724709369995957496696762772407663035354759457138217852516642743";
    assert_eq!(Octuple::PI, octuple(pi));
    assert_eq!(Octuple::E, octuple(e));
    assert_eq!(Octuple::EPSILON, Octuple::from(2.0).powi(-236));
    assert_eq!(Octuple::MIN_POSITIVE, Octuple::from(2.0).powi(-262_142));
    assert_eq!(Octuple::MAX, (Octuple::from(2.0) - Octuple::EPSILON) * Octuple::from(2.0).powi(262_143));
    assert!(Octuple::NAN.is_nan() && !Octuple::INFINITY.is_finite() && Octuple::INFINITY > Octuple::MAX);
}

/// Very large and very small factors are scaled, which must not be done for numbers without an exponent.
#[test]
fn what_is_zero_or_not_finite_is_multiplied_and_added_beside_what_is_huge() {
    let (one, huge) = (Octuple::from(1.0), DualNum::powi(&Octuple::from(2.0), 70_000));
    let of = |x: f64| Octuple::from(x).mul_add(huge, one);
    assert_eq!(of(0.0), one);
    assert_eq!([f64::INFINITY, f64::NEG_INFINITY].map(|x| of(x).to_f64()), [f64::INFINITY, f64::NEG_INFINITY]);
    assert!(of(f64::NAN).to_f64().is_nan());
    assert_eq!(of(1.0), huge);
}

/// The smallest positive number, plus a fraction of it that is lost to rounding.
#[test]
fn what_is_tiny_is_multiplied_and_added() {
    let tiny = Octuple::MIN_POSITIVE * Octuple::EPSILON;
    assert!(tiny > Octuple::from(0.0));
    assert_eq!(DualNum::mul_add(&Octuple::EPSILON, tiny, tiny), tiny);
}
