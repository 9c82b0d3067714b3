//! The defects of `f256` 0.11.3, as tests that pass while they exist.
//!
//! When one of them fails after an update, the repair it names can be deleted. The results of the repaired functions
//! are tested elsewhere.

use std::panic::{UnwindSafe, catch_unwind};

use f256::f256;

use super::bits::power_of_two;

/// Asserts that `f256` still has the defect.
fn still(wrong: bool, defect: &str) {
    assert!(wrong, "mended upstream: {defect}; its repair can go");
}

/// Whether the call panics or returns something other than `right`. Without debug assertions some defects go
/// unnoticed, so the result is then always true.
fn fails<T: PartialEq>(right: &T, call: impl FnOnce() -> T + UnwindSafe) -> bool {
    !cfg!(debug_assertions) || catch_unwind(call).map_or(true, |value| value != *right)
}

fn positive(x: f256) -> bool {
    x.is_sign_positive()
}

#[test]
fn atan2() {
    let (one, infinity) = (f256::ONE, f256::INFINITY);
    still(one.atan2(&one) != ::f256::consts::FRAC_PI_4, "atan2(x, x) = π/2");
    still(positive(f256::NEG_ZERO.atan2(&-one)), "atan2(−0, −1) = +π");
    still(!one.atan2(&infinity).eq_zero(), "atan2(1, ∞) = π/4");
    still(power_of_two(-600).atan2(&one).eq_zero(), "atan2(2^-600, 1) = 0");
}

#[test]
fn asin_acos() {
    let x = f256::ONE - power_of_two(-100) / f256::from(3);
    // arccos(1 − d) = √(2d) (1 + d/12 + 3d²/160 + …)
    let d = f256::ONE - x;
    let expected = d.mul2().sqrt() * (f256::ONE + d / f256::from(12));
    still(((x.acos() - expected) / expected).abs() > power_of_two(-200), "acos near 1");
    let complement = ::f256::consts::FRAC_PI_2 - expected;
    still((x.asin() - complement).abs() > power_of_two(-220), "asin near 1");
}

#[test]
fn sin_tan() {
    still(positive(f256::NEG_ZERO.sin()) && positive(f256::NEG_ZERO.tan()), "sin −0 = tan −0 = +0");
    still(positive(f256::NEG_ZERO.sin_cos().0), "sin_cos −0 = (+0, 1)");
    let small = power_of_two(-490) / f256::from(3);
    still(fails(&small, move || small.sin()), "sin 2^-490 has two bits");
}

#[test]
fn exponentials_and_logarithms() {
    still((-f256::from(181_710)).exp().eq_zero(), "exp −181710 = 0");
    still((-f256::from(262_150.5)).exp2().eq_zero(), "exp2 −262150.5 = 0");
    still(positive(f256::NEG_ZERO.exp_m1()), "exp_m1 −0 = +0");
    still(f256::MIN_GT_ZERO.exp_m1().eq_zero(), "exp_m1 of a subnormal number = 0");
    still(positive(f256::ONE.log(&f256::from(0.5))), "log 1 to a base below 1 = +0");
    still(f256::from(-0.25).ln_1p().is_nan(), "ln_1p −1/4 = NaN");
}

#[test]
fn powers() {
    still(f256::from(0.9).powi(300_000).eq_zero(), "powi underflows early below 1");
    still(fails(&f256::ZERO, || f256::TEN.powi(i32::MIN)), "powi panics at i32::MIN");
    still(positive(f256::NEG_ZERO.powi(3)), "(−0)³ = +0");
    still(fails(&f256::ONE, || f256::TEN.powf(&power_of_two(-600))), "powf panics at a tiny exponent");
    still(fails(&f256::INFINITY, || f256::from(1.5).powf(&power_of_two(40))), "powf panics at a huge whole exponent");
    still(fails(&f256::INFINITY, || f256::TEN.powf(&f256::INFINITY)), "powf panics at an infinite exponent");
}

#[test]
fn rem() {
    still(positive(-f256::ONE % f256::ONE), "−1 % 1 = +0");
}

#[test]
fn mul_add() {
    let tiny = f256::MIN_GT_ZERO;
    still(fails(&tiny, || f256::EPSILON.mul_add(f256::MIN_GT_ZERO, f256::MIN_GT_ZERO)), "mul_add near underflow");
}

#[test]
fn decimal() {
    still(fails(&80, || format!("{:.78}", f256::ONE).len()), "more than 75 digits panic");
    still(
        format!("{:.75e}", f256::MIN_GT_ZERO).parse::<f256>().is_ok_and(f256::eq_zero),
        "the smallest number reads as 0",
    );
    still(".".parse::<f256>().is_ok() && "1e+".parse::<f256>().is_ok(), "literals that f64 refuses");
}
