//! The points at which errors are measured, with the exact value and Jacobian there.

use super::options::random;
use super::{Errors, Options};
use crate::Octuple;
use crate::formula::proof::{Convention, Flag};
use crate::toolkit::verify::{Sensitivity, Subject, U, beside_kinks, eta, exact, relative};
use num_traits::Signed;

/// Random and hard points of a formula.
pub(super) struct Points {
    pub(super) random: Vec<Point>,
    pub(super) hard: Vec<Point>,
}

impl Points {
    pub(super) fn new(subject: &Subject, options: &Options) -> Self {
        let point = |inputs: Vec<f64>| Point::new(subject, inputs);
        let random = random(subject, options.seed, options.random_points).into_iter().map(point).collect();
        let hard = hard(subject).into_iter().map(|hard| point(hard.inputs)).collect();
        Self { random, hard }
    }
}

/// A hard point with its name.
pub(super) struct HardPoint {
    pub(super) case: String,
    pub(super) inputs: Vec<f64>,
}

/// The cases flagged hard, and points on and near every kink, as far as they are valid.
pub(super) fn hard(subject: &Subject) -> Vec<HardPoint> {
    let cases = (subject.cases)().into_iter().filter(|case| case.flag == Flag::Hard);
    let cases = cases.map(|case| HardPoint { case: case.id, inputs: case.inputs });
    let kinks = beside_kinks(subject).map(|(case, inputs)| HardPoint { case, inputs });
    cases.chain(kinks).filter(|point| (subject.check)(&point.inputs).is_ok()).collect()
}

impl HardPoint {
    /// Whether every number has a size that occurs in models: zero, or so far from the limits of the exponent range
    /// that its square is representable.
    pub(super) fn is_ordinary(&self) -> bool {
        self.inputs.iter().all(|x| *x == 0.0 || (1e-100..=1e100).contains(&x.abs()))
    }
}

/// A point, with the exact results there.
pub(super) struct Point {
    pub(super) inputs: Vec<f64>,
    /// Output by output.
    pub(super) value: Vec<Exact>,
    /// Output by output, each over all inputs; `None` if the formula has no derivative here.
    pub(super) jacobian: Option<Vec<Exact>>,
}

impl Point {
    fn new(subject: &Subject, inputs: Vec<f64>) -> Self {
        let x = exact(&inputs);
        let jacobian = (subject.exact_jacobian)(&x);
        let values = (subject.exact_value)(&x);
        let value = values.iter().zip(jacobian.chunks(x.len()));
        let value = value.map(|(&y, gradient)| Exact::new(y, Sensitivity::new(gradient, &x))).collect();
        let differentiable = subject.kink(&x) != Some(Convention::Switch);
        let jacobian = differentiable.then(|| {
            let gradients = subject.second_derivative(&x);
            let exact = jacobian.iter().zip(&gradients);
            exact.map(|(&entry, gradient)| Exact::new(entry, Sensitivity::new(gradient, &x))).collect()
        });
        Self { inputs, value, jacobian }
    }
}

/// An exact number, prepared so that the error of a double is computed by a few operations.
pub(super) struct Exact {
    number: Octuple,
    sensitivity: Sensitivity,
    /// The nearest double, the remainder, and the size that η refers to; `None` at the limits of the exponent range,
    /// where doubles lose digits.
    near: Option<(f64, f64, f64)>,
}

impl Exact {
    fn new(exact: Octuple, sensitivity: Sensitivity) -> Self {
        let near = exact.to_f64();
        let rest = (exact - Octuple::from(near)).to_f64();
        let size = sensitivity.plus(exact).size().to_f64();
        let ordinary = |x: f64| (1e-250..1e250).contains(&x);
        let exact_zero = near == 0.0 && exact.abs() == 0.0;
        let usable = (exact_zero && size == 0.0) || (ordinary(size) && (exact_zero || ordinary(near.abs())));
        Self { number: exact, sensitivity, near: usable.then_some((near, rest, size + f64::MIN_POSITIVE)) }
    }

    /// η and the relative error of a computed number.
    fn error(&self, computed: f64) -> (f64, f64) {
        let Some((near, rest, size)) = self.near else {
            return (eta(computed, self.number, self.sensitivity), relative(Octuple::from(computed), self.number));
        };
        let difference = ((computed - near) - rest).abs();
        if difference == 0.0 {
            return (0.0, 0.0);
        }
        // In this order of divisions, neither subnormal nor huge differences leave the range.
        let eta = if difference < size { difference / U / size } else { difference / size / U };
        let largest = if near.abs() > computed.abs() { near } else { computed };
        let finite = |x: f64| if x.is_nan() { f64::INFINITY } else { x };
        (finite(eta), finite(difference / largest.abs()))
    }
}

/// The errors of computed numbers at points; each point counts with its worst number.
pub(super) fn errors<'a>(points: impl IntoIterator<Item = (&'a Vec<Exact>, Vec<f64>)>) -> Errors {
    Errors::of(points.into_iter().map(|(exact, computed)| {
        let errors = exact.iter().zip(computed).map(|(exact, computed)| exact.error(computed));
        errors.fold((0.0, 0.0), |(eta, relative): (f64, f64), error| (eta.max(error.0), relative.max(error.1)))
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The quick computation must agree with the exact one.
    #[test]
    fn errors_by_doubles_are_those_by_237_bits() {
        let third = Octuple::from(1.0) / 3.0;
        for (exact, gradient) in [(third, 2.0), (third * 1e200, -1e199), (-third * 1e-200, 0.0), (third * 0.0, 1.0)] {
            let sensitivity = Sensitivity::new(&[Octuple::from(gradient)], &[Octuple::from(1.5)]);
            let quick = Exact::new(exact, sensitivity);
            assert!(quick.near.is_some());
            let near = exact.to_f64();
            for computed in [near, near.next_up(), near * 1.001, near * -3.0, near + gradient, 0.0] {
                let (by_doubles, relative_by_doubles) = quick.error(computed);
                let by_octuple = eta(computed, exact, sensitivity);
                assert!((by_doubles - by_octuple).abs() <= 1e-12 * by_octuple, "{by_doubles} {by_octuple}");
                let relative_by_octuple = relative(Octuple::from(computed), exact);
                assert!((relative_by_doubles - relative_by_octuple).abs() <= 1e-12 * relative_by_octuple);
            }
        }
    }

    #[test]
    fn doubles_decide_only_where_number_and_size_are_ordinary() {
        let is_quick = |exact: f64, size: f64| {
            let sensitivity = Sensitivity::new(&[Octuple::from(size)], &[Octuple::from(1.0)]);
            Exact::new(exact.into(), sensitivity).near.is_some()
        };
        for (exact, size) in [(1.0, 1.0), (0.0, 0.0), (0.0, 1.0), (1e-249, 1.0), (1e200, 1e249)] {
            assert!(is_quick(exact, size), "{exact} {size}");
        }
        for (exact, size) in [(1e-251, 1.0), (1.0, 1e251), (0.0, 1e-251), (1e251, 0.0), (1e-251, 1e-251)] {
            assert!(!is_quick(exact, size), "{exact} {size}");
        }
    }

    /// A number far below all doubles is not zero, and an error relative to zero is undefined.
    #[test]
    fn what_is_nearly_zero_is_not_taken_for_it() {
        let sensitivity = Sensitivity::new(&[Octuple::from(1.0)], &[Octuple::from(1.0)]);
        let tiny = Octuple::from(1e-200) * Octuple::from(1e-200);
        for exact in [tiny, -tiny] {
            let exact = Exact::new(exact, sensitivity);
            assert!(exact.near.is_none());
            assert!(exact.error(0.0).1 > 0.0, "no digit is right");
        }
        let zero = Exact::new(Octuple::from(0.0), Sensitivity::none());
        assert!(zero.near.is_some());
        assert_eq!([zero.error(0.0), zero.error(1.0)], [(0.0, 0.0), (f64::INFINITY, 1.0)]);
    }

    #[test]
    fn an_error_of_one_is_one() {
        let exact = Exact::new(1.0.into(), Sensitivity::none());
        assert_eq!(exact.error(2.0), (1.0 / U, 0.5));
        assert_eq!(exact.error(1.0), (0.0, 0.0));
        let found = errors([(&vec![exact], vec![1.0])]);
        assert_eq!((found.points, found.eta.max, found.relative), (1, 0.0, 0.0));
    }

    #[test]
    fn ordinary_numbers_are_zero_or_far_from_the_ends() {
        let is_ordinary = |x: f64| HardPoint { case: String::new(), inputs: vec![1.0, x] }.is_ordinary();
        for x in [0.0, 1e-100, -1e-100, 1e100, -1e100] {
            assert!(is_ordinary(x), "{x}");
        }
        for x in [1e-100_f64.next_down(), 1e100_f64.next_up(), -1e101, 5e-324, f64::INFINITY, f64::NAN] {
            assert!(!is_ordinary(x), "{x}");
        }
    }

    /// A point counts with its worst number, separately in each measure.
    #[test]
    fn errors_are_of_points() {
        let sensitivity = Sensitivity::new(&[Octuple::from(1.0)], &[Octuple::from(3.0)]);
        let point = vec![Exact::new(1.0.into(), Sensitivity::none()), Exact::new(1.0.into(), sensitivity)];
        // The first number has size 1, the second 4.
        let found = errors([(&point, vec![1.0 + 4.0 * U, 1.0 + 8.0 * U]), (&point, vec![1.0, f64::NAN])]);
        assert_eq!((found.points, found.not_finite), (2, 1));
        assert!((found.eta.max - 4.0).abs() < 1e-12 && (found.relative / (8.0 * U) - 1.0).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn what_is_not_finite_has_an_infinite_error() {
        let exact = Exact::new(Octuple::from(1.0), Sensitivity::new(&[], &[]));
        assert_eq!(exact.error(f64::NAN), (f64::INFINITY, f64::INFINITY));
        assert_eq!(exact.error(f64::INFINITY).0, f64::INFINITY);
    }

    #[test]
    fn at_the_ends_of_the_exponent_range_237_bits_decide() {
        let tiny = Octuple::from(5e-324) / 3.0;
        let exact = Exact::new(tiny, Sensitivity::new(&[], &[]));
        assert!(exact.near.is_none() && exact.error(0.0).0 < 1.0);
    }
}
