//! Errors of methods that are wrong by a known amount, at random and at hard points, and the accuracy of differences.

use jointproof::catalog::AnyFormula;
use jointproof::fields;
use jointproof::formula::proof::{Case, Kink, Method, Proved};
use jointproof::formula::quantity::{Domain, Quantity, Unit};
use jointproof::formula::{Component, Document, Fields, Formula, Jacobian, Spec};
use jointproof::number::scalar::Scalar;
use jointproof::toolkit::measure::{Errors, Measurement, Options, Quantiles, Scheme, errors, measure};
use jointproof::toolkit::verify::Sampler;
use std::sync::LazyLock;

const A: Quantity = Quantity::scalar("a", Unit::ONE, Domain::Real, "a number");
const B: Quantity = Quantity::scalar("b", Unit::ONE, Domain::Real, "another");
const Y: Quantity = Quantity::scalar("y", Unit::ONE, Domain::Real, "a³ b");
fields! { struct Inputs<T> { a: T = A, b: T = B } }
fields! { struct Outputs<T> { y: T = Y } }

#[derive(Clone, Copy)]
struct Cube;

impl Formula for Cube {
    const SPEC: Spec =
        Spec::new("measured.cube", "Cube", Document::new("Cubes").printed("")).equation("y = a^3 b").eta(4.0, 4.0);
    type Inputs<T: Component> = Inputs<T>;
    type Outputs<T: Component> = Outputs<T>;
    fn eval<D: Scalar>(i: &Inputs<D>) -> Outputs<D> {
        Outputs { y: i.a * i.a * i.a * i.b }
    }
    fn jacobian<D: Scalar>(i: &Inputs<D>) -> Jacobian<Self, D> {
        let square = i.a * i.a;
        Outputs { y: Inputs { a: square * i.b * 3.0, b: square * i.a } }
    }
}

/// A relative error that is large enough to be noticed.
const OFF: f64 = 1e-4;
/// The component of the only hard case.
const HARD: f64 = 1e7;

/// The value and its derivative, both too large by the relative error `OFF` if a number is above a limit.
fn off<D: Scalar>(i: &Inputs<D>, above: f64) -> Outputs<D> {
    let Outputs { y } = Cube::eval(i);
    Outputs { y: if i.a * i.a > above * above { y * (1.0 + OFF) } else { y } }
}

fn nan_if_hard<D: Scalar>(i: &Inputs<D>) -> Outputs<D> {
    let Outputs { y } = Cube::eval(i);
    Outputs { y: if i.a == HARD { y * f64::NAN } else { y } }
}

impl Proved for Cube {
    fn cases() -> Vec<Case<Inputs<f64>>> {
        let case = |a, b| Inputs { a, b };
        vec![
            Case::hand("two", "2³ × 3", case(2.0, 3.0)),
            Case::hard("large", "", case(HARD, -2.0)),
            Case::limit("one", "", case(1.0, 1.0)),
        ]
    }
    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switched_off(Inputs { a: 1.0, b: 2.0 }, |i| [i.a])]
    }
    fn methods() -> Vec<Method> {
        vec![
            Method::new::<Self>("off", "off everywhere", |i| off(i, 0.0), |i| off(i, 0.0)),
            Method::new::<Self>("off-far", "off at the hard case", |i| off(i, 1e6), |i| off(i, 1e6)),
            Method::new::<Self>("nan", "none at the hard case", nan_if_hard, nan_if_hard),
            Method::of_value::<Self>("value", "the value alone", |i| off(i, 0.0)),
        ]
    }
}

const OPTIONS: Options = Options { random_points: 40, timing_points: 7, steps_per_decade: 2, ..Options::quick() };

static MEASURED: LazyLock<Measurement> = LazyLock::new(|| errors::<Cube>(&OPTIONS));

/// Errors at random and at hard points, of the value and of the Jacobian.
fn errors_of(id: &str) -> [Option<[Errors; 2]>; 2] {
    let method = MEASURED.method(id).unwrap_or_else(|| panic!("there is no {id}"));
    [&method.value, &method.jacobian]
        .map(|figures| figures.as_ref().map(|figures| [figures.random, figures.hard.unwrap()]))
}

fn assert_near(found: f64, expected: f64, context: &str) {
    assert!((found / expected - 1.0).abs() < 1e-3, "{context}: {found} is not {expected}");
}

#[test]
fn points_are_counted_and_on_a_switch_there_is_no_derivative() {
    // The case flagged hard, and five points on and next to the kink.
    assert_eq!((MEASURED.random_points, MEASURED.hard_points, MEASURED.inputs, MEASURED.outputs), (40, 6, 2, 1));
    let [Some(value), Some(jacobian)] = errors_of("closed") else { panic!("both are measured") };
    assert_eq!([value, jacobian].map(|errors| errors.map(|errors| errors.points)), [[40, 6], [40, 5]]);
}

#[test]
fn what_is_right_has_errors_of_a_few_roundings() {
    for id in ["closed", "checked", "ad", "complex", "octuple", "octuple-ad"] {
        for errors in errors_of(id).into_iter().flatten().flatten() {
            assert!(errors.not_finite == 0 && errors.eta.max < 4.0 && errors.relative < 1e-15, "{id}: {errors:?}");
        }
    }
    let [Some([closed, _]), _] = errors_of("closed") else { panic!("it has a value") };
    assert!(closed.eta.max > 0.0, "something is rounded at some point");
    // Rounded once.
    let [Some([octuple, _]), _] = errors_of("octuple") else { panic!("it has a value") };
    assert!(octuple.eta.max <= 1.0 / 5.0, "{octuple:?}");
    for errors in errors_of("single").into_iter().flatten().flatten() {
        assert!((1e-9..1e-6).contains(&errors.relative), "{errors:?}");
    }
}

/// η is relative to the effect of rounding the inputs: a³ b changes by 4 + 1 parts, its derivatives by 3 + 1.
#[test]
fn a_way_that_is_off_by_a_part_is_shown_as_such() {
    let unit = OFF / (f64::EPSILON / 2.0);
    let [value, jacobian] = errors_of("off").map(|errors| errors.expect("it has both"));
    for (errors, parts) in [(value, 5.0), (jacobian, 4.0)] {
        let [random, _] = errors;
        let Quantiles { median, p99, max } = random.eta;
        for (found, name) in [(median, "median"), (p99, "99 %"), (max, "largest")] {
            assert_near(found, unit / parts, name);
        }
        assert_near(random.relative, OFF / (1.0 + OFF), "relative");
    }
    let [alone, none] = errors_of("value");
    assert_eq!((alone, none), (Some(value), None), "a way that has no derivative of its own is not given another's");
}

/// An error at a single hard point shows in the largest error there, and not at random points.
#[test]
fn hard_points_are_measured_apart() {
    let unit = OFF / (f64::EPSILON / 2.0);
    let off_far = errors_of("off-far").map(|errors| errors.expect("it has both"));
    for ([random, hard], parts) in off_far.into_iter().zip([5.0, 4.0]) {
        assert_near(hard.eta.max, unit / parts, "the hard case");
        assert!(hard.relative < 1e-15 && random.eta.max < 4.0, "{random:?} {hard:?}");
    }
    for [random, hard] in errors_of("nan").into_iter().flatten() {
        assert_eq!((random.not_finite, hard.not_finite), (0, 1));
        assert!(hard.eta.max < 4.0, "it is left out: {hard:?}");
    }
}

#[test]
fn differences_have_their_best_step() {
    assert_eq!(MEASURED.curves.iter().map(|curve| curve.scheme).collect::<Vec<_>>(), Scheme::ALL);
    let mut reached = Vec::new();
    for (curve, between) in MEASURED.curves.iter().zip([1e-9..1e-7, 1e-6..1e-4, 1e-4..1e-2]) {
        let steps: Vec<_> = curve.points().map(|(step, _)| step).collect();
        assert_eq!((steps.len(), steps[0], steps[1]), (29, 1e-2, 10.0_f64.powf(-2.5)));
        assert!(steps.is_sorted_by(|a, b| a > b) && (steps[28] / 1e-16 - 1.0).abs() < 1e-9);
        let (best, error) = curve.best().unwrap();
        let least = curve.errors.iter().copied().fold(f64::INFINITY, f64::min);
        assert_eq!((error, curve.errors.len()), (least, 29));
        // For a polynomial of third degree the fourth-order scheme has no truncation error.
        assert!(between.contains(&best) || curve.scheme == Scheme::Fourth, "{:?}: {best:?}", curve.scheme);
        let method = MEASURED.method(curve.scheme.id()).unwrap();
        assert_eq!(method.step, Some(best));
        assert_eq!(method.jacobian.as_ref().unwrap().random.relative, error);
        assert!(method.value.is_none());
        reached.push(least);
    }
    assert!(reached.is_sorted_by(|a, b| *a > 20.0 * b), "{reached:?}");
}

#[test]
fn there_is_a_step_in_every_decade_at_least() {
    let steps = |steps_per_decade| {
        let options = Options { steps_per_decade, random_points: 2, ..OPTIONS };
        errors::<Cube>(&options).curves[0].points().count()
    };
    assert_eq!([0, 1, 3].map(steps), [15, 15, 43]);
}

#[test]
fn time_is_taken_at_the_first_of_the_points_at_which_errors_are_found() {
    let mut sampler = Sampler::new::<Cube>(OPTIONS.seed);
    let expected: Vec<_> = (0..7).map(|_| sampler.inputs::<Cube>().components()).collect();
    assert_eq!(<dyn AnyFormula>::timing_inputs(&Cube, &OPTIONS), expected.concat());
}

#[test]
fn a_measurement_has_times_beside_errors() {
    let few = Options { random_points: 5, timing_points: 4, rounds: 3, ..Options::quick() };
    let whole = measure::<Cube>(&few);
    let closed = whole.method("closed").unwrap();
    let figures = closed.value.as_ref().unwrap();
    assert!(figures.time.is_some_and(|time| time.median > 0.0) && figures.random.eta.max < 4.0, "{figures:?}");
    assert!(whole.copy.is_some() && whole.columns.is_some());
}
