//! Every method of computing a formula: the closed form in several number types, derivatives by other means, and its own.

use super::complex;
use super::exact::{self, Exact, Point, Points};
use super::{Curve, Errors, Figures, MethodFigures, Options, Scheme};
use crate::formula::proof::method::Kernel;
use crate::formula::proof::{Method, Proved, value_and_jacobian_by_ad};
use crate::formula::{Fields, entries, typed, value, value_and_jacobian};
use crate::toolkit::verify::{Subject, exact, rounded};
use crate::{Octuple, Single};
use std::hint::black_box;

/// Every method of computing `F`, the closed form first.
pub(super) fn all<F: Proved>(curves: &[Curve]) -> Vec<Method> {
    let mut methods = vec![closed::<F>(), checked::<F>(), single::<F>(), ad::<F>(), complex_step::<F>()];
    for (scheme, step) in best(curves) {
        methods.push(differences::<F>(scheme, step));
    }
    methods.extend(octuple(&Subject::of::<F>()));
    methods.extend(F::methods());
    methods
}

/// The schemes of differences with their best steps.
fn best(curves: &[Curve]) -> Vec<(Scheme, f64)> {
    curves.iter().filter_map(|curve| Some((curve.scheme, curve.best()?.0))).collect()
}

/// The errors of a method, without times.
pub(super) fn errors(method: &Method, points: &Points) -> MethodFigures {
    let figures = |kernel: &Kernel, exact: fn(&Point) -> Option<&Vec<Exact>>| Figures {
        time: None,
        ratio: None,
        hard_times: Vec::new(),
        random: errors_of(kernel, &points.random, exact),
        hard: (!points.hard.is_empty()).then(|| errors_of(kernel, &points.hard, exact)),
    };
    MethodFigures {
        id: method.id.into(),
        title: method.title.into(),
        step: method.step,
        value: method.value.as_ref().map(|kernel| figures(kernel, |point| Some(&point.value))),
        jacobian: method.jacobian.as_ref().map(|kernel| figures(kernel, |point| point.jacobian.as_ref())),
    }
}

/// The errors of a method's Jacobian at these points.
fn jacobian_errors(method: &Method, points: &[Point]) -> Errors {
    let errors = |kernel: &Kernel| errors_of(kernel, points, |point| point.jacobian.as_ref());
    method.jacobian.as_ref().map_or_else(|| Errors::of([]), errors)
}

/// The error of a scheme as a function of its step, from 1e-2 to 1e-16; `method` makes the method with a given step.
pub(super) fn curve(
    scheme: Scheme,
    method: &dyn Fn(Scheme, f64) -> Method,
    points: &Points,
    options: &Options,
) -> Curve {
    let errors = |step| jacobian_errors(&method(scheme, step), &points.random);
    let found: Vec<_> = Curve::steps(options.steps_per_decade.max(1)).map(errors).collect();
    let errors = found.iter().map(|found| found.relative).collect();
    let least = |a: &&Errors, b: &&Errors| a.not_finite.cmp(&b.not_finite).then(a.relative.total_cmp(&b.relative));
    let best = found.iter().enumerate().min_by(|(_, a), (_, b)| least(a, b)).map_or(0, |(k, _)| k);
    Curve { scheme, errors, best }
}

fn errors_of(kernel: &Kernel, points: &[Point], exact: fn(&Point) -> Option<&Vec<Exact>>) -> Errors {
    exact::errors(points.iter().filter_map(|point| Some((exact(point)?, (kernel.results)(&point.inputs)))))
}

fn closed<F: Proved>() -> Method {
    let value = Kernel::with_loop(typed, F::eval::<f64>, Fields::components, values::<F>);
    let entries = |(_, jacobian): &_| entries(jacobian);
    let jacobian = Kernel::with_loop(typed, F::linearized::<f64>, entries, linearizations::<F>);
    in_closed_form::<F>(Method::of("closed", "closed form").value(value), jacobian)
}

/// The method with its Jacobian if that is in closed form; an automatic one is measured as `ad`.
fn in_closed_form<F: Proved>(method: Method, jacobian: Kernel) -> Method {
    if F::SPEC.is_closed() { method.jacobian(jacobian) } else { method }
}

#[inline(never)]
fn values<F: Proved>(points: &[F::Inputs<f64>]) {
    for i in points {
        black_box(&F::eval(i));
    }
}

#[inline(never)]
fn linearizations<F: Proved>(points: &[F::Inputs<f64>]) {
    for i in points {
        black_box(&F::linearized(i));
    }
}

/// As called by a program; NaN where an error is returned.
fn checked<F: Proved>() -> Method {
    let or_nan = |found: Option<Vec<f64>>, len| found.unwrap_or_else(|| vec![f64::NAN; len]);
    let [inputs, outputs] = [F::Inputs::<f64>::LEN, F::Outputs::<f64>::LEN];
    let value =
        Kernel::new(typed, value::<F>, move |found| or_nan(found.as_ref().ok().map(Fields::components), outputs));
    let jacobian = Kernel::new(typed, value_and_jacobian::<F>, move |found| {
        or_nan(found.as_ref().ok().map(|(_, jacobian)| entries(jacobian)), outputs * inputs)
    });
    in_closed_form::<F>(Method::of("checked", "closed form, checked").value(value), jacobian)
}

fn single<F: Proved>() -> Method {
    let convert = |i: &[f64]| typed(&singles(i));
    let value = Kernel::new(convert, F::eval::<Single>, |out| doubles(&out.components()));
    let jacobian = Kernel::new(convert, F::linearized::<Single>, |(_, jacobian)| doubles(&entries(jacobian)));
    in_closed_form::<F>(Method::of("single", "closed form in single precision").value(value), jacobian)
}

fn singles(x: &[f64]) -> Vec<Single> {
    x.iter().map(|&x| Single::from(x)).collect()
}

fn doubles(x: &[Single]) -> Vec<f64> {
    x.iter().map(|x| x.to_f64()).collect()
}

fn ad<F: Proved>() -> Method {
    let jacobian = |i: &_| value_and_jacobian_by_ad::<F, f64>(i);
    Method::of("ad", "automatic differentiation")
        .jacobian(Kernel::new(typed, jacobian, |(_, jacobian)| entries(jacobian)))
}

fn complex_step<F: Proved>() -> Method {
    let kernel = Kernel::new(typed, complex::value_and_jacobian::<F>, |(_, jacobian)| entries(jacobian));
    Method::of("complex", "complex step").jacobian(kernel)
}

/// Differences with a given step.
pub(super) fn differences<F: Proved>(scheme: Scheme, step: f64) -> Method {
    let jacobian = move |i: &_| scheme.value_and_jacobian::<F>(step, i);
    let kernel = Kernel::new(typed, jacobian, |(_, jacobian)| entries(jacobian));
    Method { step: Some(step), ..Method::of(scheme.id(), scheme.title()).jacobian(kernel) }
}

/// The methods in 237 bits. They use slices, whose cost is negligible compared with a multiplication in 237 bits.
fn octuple(subject: &Subject) -> [Method; 2] {
    let (value, jacobian, derivative) = (subject.exact_value, subject.exact_jacobian, subject.derivative_of());
    let both = move |x: &Vec<Octuple>| (value(x), jacobian(x));
    let differentiated = move |x: &Vec<Octuple>| (value(x), derivative(x));
    let octuple = Method::of("octuple", "closed form in 237 bits").value(Kernel::new(
        exact,
        move |x: &Vec<Octuple>| value(x),
        |out| rounded(out),
    ));
    let is_closed = subject.spec.is_closed();
    [
        if is_closed { octuple.jacobian(Kernel::new(exact, both, |(_, jacobian)| rounded(jacobian))) } else { octuple },
        Method::of("octuple-ad", "automatic differentiation in 237 bits").jacobian(Kernel::new(
            exact,
            differentiated,
            |(_, jacobian)| rounded(jacobian),
        )),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::ContactForce;

    /// A missing number would count as having no error.
    #[test]
    fn every_number_is_nan_where_the_checked_way_refuses() {
        let Method { value, jacobian, .. } = checked::<ContactForce>();
        let at = |inputs: &[f64]| [&value, &jacobian].map(|kernel| (kernel.as_ref().unwrap().results)(inputs));
        assert_eq!(at(&[3.0, 4.0]), [vec![5.0], vec![0.6, 0.8]]);
        let refused = at(&[f64::NAN, 4.0]);
        assert_eq!(refused.each_ref().map(Vec::len), [1, 2]);
        assert!(refused.concat().into_iter().all(f64::is_nan));
    }
}
