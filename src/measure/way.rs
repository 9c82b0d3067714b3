//! The ways to compute a formula, each compiled as one piece, so that nothing is called through a pointer while it is timed.

use super::exact::{self, Exact, Point, Points};
use super::forward::{Jet, differentiate};
use super::{Curve, Errors, Figures, Scheme, WayFigures};
use crate::formula::{Fields, Formula};
use crate::verify::{Subject, entries, exact, rounded, typed};
use crate::{Octuple, Single};
use std::hint::black_box;

/// One way to compute a formula: its value, its Jacobian, or both.
///
/// A formula registers its own in [`Formula::ways`], by one function that is generic over the scalar:
///
/// ```
/// use jointproof::Scalar;
/// use jointproof::measure::Way;
/// use jointproof::slot::{Contact, ContactForce, CrossForces};
///
/// fn plain<D: Scalar>(i: &CrossForces<D>) -> Contact<D> {
///     Contact { fc: (i.f2 * i.f2 + i.f3 * i.f3).sqrt() }
/// }
/// let way = Way::new::<ContactForce>("plain", "the square root of the sum", plain, plain);
/// ```
pub struct Way {
    pub(super) id: &'static str,
    title: &'static str,
    step: Option<f64>,
    pub(super) value: Option<Kernel>,
    pub(super) jacobian: Option<Kernel>,
}

impl Way {
    /// A way to compute the value, given twice: for the value itself, and for automatic differentiation of it.
    pub fn new<F: Formula>(
        id: &'static str,
        title: &'static str,
        value: impl Fn(&F::Inputs<f64>) -> F::Outputs<f64> + Copy + 'static,
        differentiated: impl Fn(&F::Inputs<Jet>) -> F::Outputs<Jet> + Copy + 'static,
    ) -> Self {
        let jacobian = move |i: &_| differentiate::<F>(i, differentiated);
        Self::of(id, title).value(Kernel::new(typed::<F, f64>, value, Fields::components)).jacobian(Kernel::new(
            typed::<F, f64>,
            jacobian,
            |(_, jacobian)| entries::<F, _>(jacobian),
        ))
    }

    /// A way to compute the value whose derivative is another: equal where the inputs keep to conditions among themselves.
    pub fn of_value<F: Formula>(
        id: &'static str,
        title: &'static str,
        value: impl Fn(&F::Inputs<f64>) -> F::Outputs<f64> + Copy + 'static,
    ) -> Self {
        Self::of(id, title).value(Kernel::new(typed::<F, f64>, value, Fields::components))
    }

    fn of(id: &'static str, title: &'static str) -> Self {
        Self { id, title, step: None, value: None, jacobian: None }
    }

    fn value(self, kernel: Kernel) -> Self {
        Self { value: Some(kernel), ..self }
    }

    fn jacobian(self, kernel: Kernel) -> Self {
        Self { jacobian: Some(kernel), ..self }
    }

    /// Its errors, without times.
    pub(super) fn errors(&self, points: &Points) -> WayFigures {
        let figures = |kernel: &Kernel, exact: fn(&Point) -> Option<&Vec<Exact>>| Figures {
            time: None,
            ratio: None,
            random: kernel.errors(&points.random, exact),
            hard: (!points.hard.is_empty()).then(|| kernel.errors(&points.hard, exact)),
        };
        WayFigures {
            id: self.id.into(),
            title: self.title.into(),
            step: self.step,
            value: self.value.as_ref().map(|kernel| figures(kernel, |point| Some(&point.value))),
            jacobian: self.jacobian.as_ref().map(|kernel| figures(kernel, |point| point.jacobian.as_ref())),
        }
    }

    /// The errors of the Jacobian at these points.
    pub(super) fn jacobian_errors(&self, points: &[Point]) -> Errors {
        let errors = |kernel: &Kernel| kernel.errors(points, |point| point.jacobian.as_ref());
        self.jacobian.as_ref().map_or_else(|| Errors::of([]), errors)
    }
}

/// Runs over the points from an index on, so many of them.
pub(super) type Runner = Box<dyn FnMut(usize, usize)>;

/// The results at components, as doubles in order.
type Results = Box<dyn Fn(&[f64]) -> Vec<f64>>;
/// Makes the loop to be timed over points.
type MakeRunner = Box<dyn Fn(&[Vec<f64>]) -> Runner>;

/// A computation, to be looked at and to be timed.
pub(super) struct Kernel {
    /// What it computes of components, as doubles in order.
    results: Results,
    /// The loop to be timed, over inputs converted beforehand.
    pub(super) runner: MakeRunner,
}

impl Kernel {
    /// `convert` makes the computation's own inputs, `compute` is what is timed, `doubles` reads the result.
    pub(super) fn new<I: 'static, O>(
        convert: impl Fn(&[f64]) -> I + Copy + 'static,
        compute: impl Fn(&I) -> O + Copy + 'static,
        doubles: impl Fn(&O) -> Vec<f64> + 'static,
    ) -> Self {
        Self {
            results: Box::new(move |i| doubles(&compute(&convert(i)))),
            runner: Box::new(move |points| {
                let points: Vec<I> = points.iter().map(|point| convert(point)).collect();
                Box::new(move |from, count| {
                    for i in &points[from..from + count] {
                        black_box(&compute(black_box(i)));
                    }
                })
            }),
        }
    }

    fn errors(&self, points: &[Point], exact: fn(&Point) -> Option<&Vec<Exact>>) -> Errors {
        exact::errors(points.iter().filter_map(|point| Some((exact(point)?, (self.results)(&point.inputs)))))
    }
}

/// Every way to compute `F`, the closed form first.
pub(super) fn all<F: Formula>(curves: &[Curve]) -> Vec<Way> {
    let mut ways = vec![closed::<F>(), single::<F>(), ad::<F>()];
    ways.extend(curves.iter().filter_map(|curve| Some(differences::<F>(curve.scheme, curve.best()?.step))));
    ways.extend(octuple(&Subject::of::<F>()));
    ways.extend(F::ways());
    ways
}

fn closed<F: Formula>() -> Way {
    let jacobian = Kernel::new(typed::<F, f64>, F::linearized, |(_, jacobian)| entries::<F, _>(jacobian));
    Way::of("closed", "closed form").value(Kernel::new(typed::<F, f64>, F::eval, Fields::components)).jacobian(jacobian)
}

fn single<F: Formula>() -> Way {
    let doubles = |x: Vec<Single>| x.into_iter().map(Single::to_f64).collect();
    let convert = |i: &[f64]| typed::<F, Single>(&i.iter().map(|&x| Single::from(x)).collect::<Vec<_>>());
    Way::of("single", "closed form in single precision")
        .value(Kernel::new(convert, F::eval, move |out| doubles(out.components())))
        .jacobian(Kernel::new(convert, F::linearized, move |(_, jacobian)| doubles(entries::<F, _>(jacobian))))
}

fn ad<F: Formula>() -> Way {
    let jacobian = |i: &_| super::value_and_jacobian_by_ad::<F>(i);
    Way::of("ad", "automatic differentiation")
        .jacobian(Kernel::new(typed::<F, f64>, jacobian, |(_, jacobian)| entries::<F, _>(jacobian)))
}

/// Differences with a step.
pub(super) fn differences<F: Formula>(scheme: Scheme, step: f64) -> Way {
    let jacobian = move |i: &_| scheme.value_and_jacobian::<F>(step, i);
    let kernel = Kernel::new(typed::<F, f64>, jacobian, |(_, jacobian)| entries::<F, _>(jacobian));
    Way { step: Some(step), ..Way::of(scheme.id(), scheme.title()).jacobian(kernel) }
}

/// The ways in 237 bits. They go through slices, which costs nothing beside what a multiplication costs there.
fn octuple(subject: &Subject) -> [Way; 2] {
    let (value, jacobian, derivative) = (subject.exact_value, subject.exact_jacobian, subject.derivative_of());
    let both = move |x: &Vec<Octuple>| (value(x), jacobian(x));
    let differentiated = move |x: &Vec<Octuple>| (value(x), derivative(x));
    [
        Way::of("octuple", "closed form in 237 bits")
            .value(Kernel::new(exact, move |x: &Vec<Octuple>| value(x), |out| rounded(out)))
            .jacobian(Kernel::new(exact, both, |(_, jacobian)| rounded(jacobian))),
        Way::of("octuple-ad", "automatic differentiation in 237 bits").jacobian(Kernel::new(
            exact,
            differentiated,
            |(_, jacobian)| rounded(jacobian),
        )),
    ]
}
