//! Octuple and Single as numbers: special values, agreement with the hardware, and derivatives under num-dual.

use jointproof::number::scalar::{Leaf, e_minus_one, nearest_integer, pi};
use jointproof::{Octuple, Single};
use nalgebra::{SVector, vector};
use num_dual::{DualNum, first_derivative, gradient, hessian, jacobian, second_derivative, second_partial_derivative};
use num_traits::{FromPrimitive, Inv, Num, One, Signed, Zero};
use proptest::prelude::*;

/// Zeros, ones, simple numbers and infinities of both signs, and NaN.
const SPECIAL: [f64; 15] =
    [0.0, -0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5, 2.0, -2.0, 3.0, -3.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

/// Equal as special values are: NaN equals NaN, infinities and zeros must have equal signs; other numbers agree to 1e-13.
fn alike(wide: f64, double: f64) -> bool {
    wide.is_nan() && double.is_nan()
        || wide.to_bits() == double.to_bits()
        || wide.is_finite() && wide != 0.0 && ((wide - double) / wide).abs() < 1e-13
}

/// The same functions of two scalar types, by name.
macro_rules! functions {
    ($($function:ident)*) => { [$((stringify!($function), <Octuple as DualNum>::$function, <f64 as DualNum>::$function)),*] };
}

#[test]
fn functions_of_one_special_value_are_those_of_f64() {
    type Unary<T> = fn(&T) -> T;
    let functions: [(&str, Unary<Octuple>, Unary<f64>); 22] = functions!(recip sqrt cbrt exp exp2 exp_m1 ln log2 log10
        ln_1p sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh);
    for (name, wide, double) in functions {
        for x in SPECIAL {
            let (wide, double) = (wide(&Octuple::from(x)).to_f64(), double(&x));
            assert!(alike(wide, double), "{name}({x}): {wide} against {double}");
        }
    }
}

#[test]
fn constants_have_the_digits_of_their_type() {
    assert_eq!([pi::<Octuple>(), e_minus_one()], [Octuple::PI, Octuple::E - 1.0]);
    assert_eq!([pi::<Single>(), e_minus_one()], [std::f64::consts::PI, 1.0_f64.exp_m1()].map(Single::from));
}

/// Also beside halves, where adding ½ and taking the integer below would round twice.
#[test]
fn the_nearest_integer_is_that_of_f64_and_has_no_derivative() {
    fn of<L: Leaf>(x: f64) -> f64 {
        nearest_integer(L::from(x)).re()
    }
    let halves = [0.5, 1.5, 2.5, 8_388_607.5].map(|half: f64| [half.next_down(), half, half.next_up()]);
    let all = halves.as_flattened().iter().copied().chain(SPECIAL).chain([4_503_599_627_370_495.5, 1e300]);
    for x in all.flat_map(|x| [x, -x]) {
        let same = |wide: f64| wide == x.round() || wide.is_nan() && x.is_nan();
        assert!(same(of::<f64>(x)) && same(of::<Octuple>(x)), "{x}: {} {}", of::<f64>(x), of::<Octuple>(x));
    }
    assert_eq!([0.5, 1.5, 2.5, -2.5].map(of::<Single>), [1.0, 2.0, 3.0, -3.0]);
    let below = Octuple::from(0.5) - Octuple::EPSILON;
    assert_eq!([below, -below].map(|x| nearest_integer(x).to_f64()), [1.0, -1.0]);
    assert_eq!(first_derivative(nearest_integer, 2.7), (3.0, 0.0));
}

#[test]
fn functions_of_two_special_values_are_those_of_f64() {
    type Binary<T> = fn(T, T) -> T;
    let functions: [(&str, Binary<Octuple>, Binary<f64>); 9] = [
        ("+", |x, y| x + y, |x, y| x + y),
        ("-", |x, y| x - y, |x, y| x - y),
        ("*", |x, y| x * y, |x, y| x * y),
        ("/", |x, y| x / y, |x, y| x / y),
        ("%", |x, y| x % y, |x, y| x % y),
        ("atan2", |y, x| y.atan2(x), f64::atan2),
        ("powd", |x, y| x.powd(y), f64::powf),
        ("powf", |x, y| x.powf(y.to_f64()), f64::powf),
        ("log", |x, base| x.log(base.to_f64()), f64::log),
    ];
    for (name, wide, double) in functions {
        for (x, y) in SPECIAL.into_iter().flat_map(|x| SPECIAL.map(|y| (x, y))) {
            let (wide, double) = (wide(x.into(), y.into()).to_f64(), double(x, y));
            assert!(alike(wide, double), "{name}({x}, {y}): {wide} against {double}");
        }
    }
}

#[test]
fn fused_and_whole_powers_of_special_values_are_those_of_f64() {
    for (x, y) in SPECIAL.into_iter().flat_map(|x| SPECIAL.map(|y| (x, y))) {
        for z in SPECIAL {
            let (wide, double) = (Octuple::from(x).mul_add(y.into(), z.into()).to_f64(), x.mul_add(y, z));
            assert!(alike(wide, double), "mul_add({x}, {y}, {z}): {wide} against {double}");
        }
    }
    for (x, n) in SPECIAL.into_iter().flat_map(|x| [i32::MIN, -3, -2, -1, 0, 1, 2, 3, i32::MAX].map(|n| (x, n))) {
        let (wide, double) = (Octuple::from(x).powi(n).to_f64(), x.powf(n.into()));
        assert!(alike(wide, double), "{x}^{n}: {wide} against {double}");
    }
}

#[test]
fn spherical_bessel_functions_at_zero_and_infinity() {
    for x in [0.0, -0.0].map(Octuple::from) {
        let values = [x.sph_j0(), x.sph_j1(), x.sph_j2()].map(|j| j.to_f64().to_bits());
        assert_eq!(values, [1.0, x.to_f64(), 0.0].map(f64::to_bits));
    }
    for x in [f64::INFINITY, f64::NEG_INFINITY].map(Octuple::from) {
        assert!([x.sph_j0(), x.sph_j1(), x.sph_j2()].iter().all(Zero::is_zero));
    }
    let nan = Octuple::NAN;
    assert!(nan.sph_j0().is_nan() && nan.sph_j1().is_nan() && nan.sph_j2().is_nan());
}

/// Numbers of both signs over the whole range of Octuple, including its ends.
fn all_over_the_range() -> Vec<Octuple> {
    let two = Octuple::from(2.0);
    let smallest = two.powi(-262_378);
    let exponents = [
        -262_142, -262_000, -131_072, -5000, -493, -257, -240, -121, -20, -1, 0, 1, 20, 236, 237, 241, 493, 5000,
        131_071, 262_143,
    ];
    let scaled = exponents.into_iter().flat_map(|e| [two.powi(e), two.powi(e) * 1.3 / 1.1]);
    let arguments_of_exp = [181_704.37, 181_705.0, 181_900.0, 262_143.5, 262_377.5, 262_379.5, 1e6].map(Octuple::from);
    let one = [Octuple::one() - Octuple::EPSILON, Octuple::one() + Octuple::EPSILON, Octuple::PI];
    let ends = [
        Octuple::zero(),
        smallest,
        smallest * 3.0,
        Octuple::MIN_POSITIVE - smallest,
        Octuple::MAX,
        Octuple::INFINITY,
        Octuple::NAN,
    ];
    let positive: Vec<_> = scaled.chain(arguments_of_exp).chain(one).chain(ends).collect();
    positive.iter().flat_map(|x| [*x, -x]).collect()
}

/// Debug assertions are enabled in tests, so this also checks that f256 never computes something it does not expect.
#[test]
fn nothing_panics() {
    let points = all_over_the_range();
    for x in &points {
        let _ = (x.recip(), x.sqrt(), x.cbrt(), x.exp(), x.exp2(), x.exp_m1(), x.ln(), x.log2(), x.log10(), x.ln_1p());
        let _ = (x.sin(), x.cos(), x.tan(), x.sin_cos(), x.asin(), x.acos(), x.atan(), x.sinh(), x.cosh(), x.tanh());
        let _ = (x.asinh(), x.acosh(), x.atanh(), x.sph_j0(), x.sph_j1(), x.sph_j2(), x.ulp(), x.to_f64());
        for n in [i32::MIN, i32::MIN + 1, -262_144, -3, -1, 0, 1, 2, 3, 262_144, i32::MAX] {
            let _ = x.powi(n);
        }
        let _ = (x.signum(), x.inv(), x.abs());
    }
    // In decimal the largest and the smallest numbers have tens of thousands of digits.
    for x in points.iter().step_by(9) {
        let _ = format!("{x} {x:e} {x:?} {x:.3} {x:.3e}");
    }
    for (x, y) in points.iter().flat_map(|x| points.iter().map(move |y| (*x, *y))) {
        let _ = (x + y, x - y, x * y, x / y, x % y, x.atan2(y), x.powd(y), x.log(y.to_f64()), x.abs_sub(&y));
        for z in [Octuple::zero(), Octuple::one(), x, y, -(x * y), Octuple::MIN_POSITIVE, Octuple::MAX] {
            let _ = x.mul_add(y, z);
        }
    }
}

#[test]
fn fused_multiply_add_does_not_depend_on_the_scale() {
    let two = Octuple::from(2.0);
    let (x, y) = (Octuple::from(1.0) / 3.0, Octuple::from(5.0) / 7.0);
    let addends = [
        -(x * y),
        Octuple::from(1.0) / 9.0,
        two.powi(-238),
        two.powi(-474),
        -two.powi(-477),
        two.powi(-700),
        two.powi(237),
        -two.powi(600),
    ];
    for addend in addends {
        let expected = x.mul_add(y, addend);
        for (s, t) in
            [(100_000, 100_000), (-100_000, -100_000), (-100_000, 100_000), (262_000, -262_000), (200_000, 30_000)]
        {
            let scale = two.powi(s + t);
            let scaled = (x * two.powi(s)).mul_add(y * two.powi(t), addend * scale);
            assert_eq!(scaled, expected * scale, "{addend:e} at 2^{s}, 2^{t}");
        }
    }
}

#[test]
fn subnormal_results_of_exponentials() {
    for (x, tolerance) in [(-181_001.0, 1e-65), (-181_710.0, 1e-60), (-181_800.0, 1e-25), (-181_860.0, 1e-2)] {
        let back = Octuple::from(x).exp().ln();
        assert!((back - x).abs() < tolerance, "ln exp {x} = {back}");
    }
    assert!((Octuple::from(-262_150.5).exp2().log2() + 262_150.5).abs() < 1e-60);
    assert_eq!(Octuple::from(-262_378.0).exp2(), Octuple::from(2.0).powi(-262_378));
    assert!(Octuple::from(-262_380.5).exp2().is_zero() && Octuple::from(-181_870.0).exp().is_zero());
}

#[test]
fn number_traits() {
    let x = Octuple::from(-2.5);
    assert_eq!(Octuple::from_str_radix("-2.5", 10).unwrap(), x);
    assert!(Octuple::from_str_radix("ff", 16).is_err() && Single::from_str_radix("ff", 16).is_err());
    assert_eq!(x.signum(), -1.0);
    assert!(x.is_negative() && Octuple::from(-0.0).is_negative() && Octuple::from(0.0).is_positive());
    assert_eq!(x.abs_sub(&Octuple::from(-4.0)), 1.5);
    assert_eq!([x, x, x].iter().sum::<Octuple>(), -7.5);
    assert_eq!([x, x].into_iter().product::<Octuple>(), 6.25);
    let mut y = x;
    y += 1.0;
    y *= x;
    y -= x;
    y /= 2.0;
    y %= 2.0;
    assert_eq!(y, 1.125);
    assert!(x < 0.0 && x > -3.0 && Octuple::NAN.partial_cmp(&0.0).is_none());
    assert!(Octuple::from(0.1) * 3.0 > 0.3 && Octuple::from(0.1) == 0.1);
}

fn any_f64() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), -1e3..1e3, (1..1000_u64).prop_map(f64::from_bits)]
        .prop_filter("a number", |x| !x.is_nan())
}

fn assert_same(wide: Octuple, double: f64) {
    assert!(
        wide.to_f64().to_bits() == double.to_bits() || wide.is_nan() && double.is_nan(),
        "{wide:e} against {double:e}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Rounding to 237 bits and then to 53 gives the same result as rounding once, for one operation on f64 (Figueroa 1995: twice
    /// the bits plus two suffice).
    #[test]
    fn one_operation_rounded_to_f64_is_that_of_the_hardware(x in any_f64(), y in any_f64()) {
        let (a, b) = (Octuple::from(x), Octuple::from(y));
        assert_same(a + b, x + y);
        assert_same(a - b, x - y);
        assert_same(a * b, x * y);
        assert_same(a / b, x / y);
        assert_same(a % b, x % y);
        assert_same(a.sqrt(), x.sqrt());
        prop_assert_eq!(a.partial_cmp(&b), x.partial_cmp(&y));
        prop_assert_eq!(a.partial_cmp(&y), x.partial_cmp(&y));
    }

    #[test]
    fn single_computes_as_f32(x: f32, y: f32) {
        let (a, b) = (Single::from(f64::from(x)), Single::from(f64::from(y)));
        for (single, float) in [(a + b, x + y), (a - b, x - y), (a * b, x * y), (a / b, x / y), (a % b, x % y), (a.sqrt(), x.sqrt()), (a.sin(), x.sin())] {
            prop_assert!(single.to_f64().to_bits() == f64::from(float).to_bits() || float.is_nan() && single.to_f64().is_nan());
        }
    }
}

#[test]
fn single_rounds_on_entry() {
    let tenth = Single::from(0.1);
    assert_eq!(tenth.to_f64().to_bits(), f64::from(0.1_f32).to_bits());
    assert_eq!(tenth, 0.1);
    assert_eq!(Single::one() + 1e-8, 1.0);
    assert_eq!("0.1".parse::<Single>().unwrap(), tenth);
    assert_eq!(Single::from_i64(16_777_217).unwrap(), 16_777_216.0);
    assert_eq!(Single::from_u64(16_777_219).unwrap(), 16_777_220.0);
    assert_eq!(Single::from_i128(-(1 << 100) - 1), Single::from_f64(-2.0_f64.powi(100)));
    assert_eq!([Single::from_f64(0.1), Single::from_f32(0.1)], [Some(tenth); 2]);
    assert_eq!(format!("{tenth} {tenth:?} {tenth:e} {tenth:.2}"), "0.1 0.1 1e-1 0.10");
    assert!(
        (Single::from(1e-3).sph_j1() * 3000.0 - 1.0).abs() < 1e-6
            && (Single::from(1e-3).sph_j2() * 1.5e7 - 1.0).abs() < 1e-6
    );
    let (value, slope) = first_derivative(|x| x.powi(3) * 0.5, Single::from(2.0));
    assert!(value == 4.0 && slope == 6.0);
}

/// `actual` is `expected` to 68 digits.
fn assert_close(actual: Octuple, expected: Octuple) {
    let error = ((actual - expected) / expected).abs();
    assert!(error < 1e-68, "{actual:e} against {expected:e}: off by {error:.3e}");
}

/// Formulas are written once, for every scalar, with plain literals.
fn wave<D: DualNum<Primitive = f64> + Copy>(x: D) -> D {
    (x * x * 0.5).exp() * x.sin() + x.atan2(D::from(2.0))
}

#[test]
fn first_and_second_derivatives() {
    let x = Octuple::from(7.0) / 11.0;
    let (bell, sin, cos) = ((x * x * 0.5).exp(), x.sin(), x.cos());
    let angle = (x * x + 4.0).recip() * 2.0;
    let slope = bell * (x * sin + cos) + angle;
    let curvature = bell * (x * (x * sin + cos) + sin + x * cos - sin) - angle * angle * x;
    let (f, df) = first_derivative(wave, x);
    assert_close(f, bell * sin + (x / 2.0).atan());
    assert_close(df, slope);
    let (f, df, d2f) = second_derivative(wave, x);
    assert_close(f, wave(x));
    assert_close(df, slope);
    assert_close(d2f, curvature);
}

/// f(x, y) = x² y / √(x² + y²) with its derivatives by hand.
fn ratio<D: DualNum<Primitive = f64> + Copy>(x: D, y: D) -> D {
    x.powi(2) * y / (x * x + y * y).sqrt()
}

fn ratio_derivatives(x: Octuple, y: Octuple) -> ([Octuple; 2], [Octuple; 3]) {
    let r = (x * x + y * y).sqrt();
    let (r3, r5) = (r.powi(3), r.powi(5));
    let first = [x * y * (x * x + y * y * 2.0) / r3, x.powi(4) / r3];
    let second =
        [y.powi(3) * (y * y * 2.0 - x * x) / r5, x.powi(3) * (x * x + y * y * 4.0) / r5, x.powi(4) * y * -3.0 / r5];
    (first, second)
}

#[test]
fn gradients_and_hessians() {
    let (x, y) = (Octuple::from(2.0).sqrt(), Octuple::PI);
    let (first, second) = ratio_derivatives(x, y);
    let (f, g) = gradient(|v| ratio(v[0], v[1]), &vector![x, y]);
    assert_close(f, ratio(x, y));
    assert_close(g[0], first[0]);
    assert_close(g[1], first[1]);
    let (_, g, h) = hessian(|v| ratio(v[0], v[1]), &vector![x, y]);
    assert_close(g[0], first[0]);
    assert_close(h[(0, 0)], second[0]);
    assert_close(h[(0, 1)], second[1]);
    assert_close(h[(1, 1)], second[2]);
    let (_, dx, dy, dxdy) = second_partial_derivative(|(x, y)| ratio(x, y), (x, y));
    assert_close(dx, first[0]);
    assert_close(dy, first[1]);
    assert_close(dxdy, second[1]);
}

#[test]
fn jacobians() {
    let point: SVector<Octuple, 2> = vector![Octuple::from(0.3), Octuple::from(1.7)];
    let (value, j) = jacobian(|v| vector![v[0] * v[1].cos(), v[0] * v[1].sin(), v[0].ln() * v[1].tanh()], &point);
    let (r, angle) = (point[0], point[1]);
    let (sin, cos) = angle.sin_cos();
    assert_close(value[1], r * sin);
    for (actual, expected) in [
        (j[(0, 0)], cos),
        (j[(0, 1)], -r * sin),
        (j[(1, 0)], sin),
        (j[(1, 1)], r * cos),
        (j[(2, 0)], angle.tanh() / r),
        (j[(2, 1)], r.ln() / angle.cosh().powi(2)),
    ] {
        assert_close(actual, expected);
    }
}
