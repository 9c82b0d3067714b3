//! The ways to compute a formula, each compiled as one piece, so that nothing is called through a pointer while it is timed.

use super::exact::{self, Exact, Point, Points};
use super::forward::{Jet, differentiate, to_array};
use super::{Curve, Errors, Figures, WayFigures};
use crate::formula::{Fields, Formula};
use crate::verify::{entries, exactly, jacobian_by_ad, rounded};
use crate::{Octuple, Single};
use std::hint::black_box;

/// One way to compute `F`: its value, its Jacobian, or both.
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
/// let way: Way<ContactForce> = Way::new("plain", "the square root of the sum", plain, plain);
/// ```
pub struct Way<F: Formula> {
    pub(super) id: &'static str,
    title: &'static str,
    step: Option<f64>,
    pub(super) value: Option<Kernel<F>>,
    pub(super) jacobian: Option<Kernel<F>>,
}

impl<F: Formula> Way<F> {
    /// A way to compute the value, given twice: for the value itself, and for automatic differentiation of it.
    pub fn new(
        id: &'static str,
        title: &'static str,
        value: impl Fn(&F::Inputs<f64>) -> F::Outputs<f64> + Copy + 'static,
        differentiated: impl Fn(&F::Inputs<Jet>) -> F::Outputs<Jet> + Copy + 'static,
    ) -> Self {
        let jacobian = move |i: &_| differentiate::<F>(i, differentiated);
        Self::of(id, title).value(Kernel::new(same, value, |out| out.components())).jacobian(Kernel::new(
            same,
            jacobian,
            |(_, jacobian)| entries::<F, _>(jacobian),
        ))
    }

    fn of(id: &'static str, title: &'static str) -> Self {
        Self { id, title, step: None, value: None, jacobian: None }
    }

    fn value(self, kernel: Kernel<F>) -> Self {
        Self { value: Some(kernel), ..self }
    }

    fn jacobian(self, kernel: Kernel<F>) -> Self {
        Self { jacobian: Some(kernel), ..self }
    }

    /// Its errors, without times.
    pub(super) fn errors(&self, points: &Points<F>) -> WayFigures {
        let figures = |kernel: &Kernel<F>, exact: fn(&Point<F>) -> Option<&Vec<Exact>>| Figures {
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
}

/// Runs over the points from an index on, so many of them.
pub(super) type Runner = Box<dyn FnMut(usize, usize)>;

/// A computation, to be looked at and to be timed.
pub(super) struct Kernel<F: Formula> {
    /// What it computes, as doubles in order.
    results: Box<dyn Fn(&F::Inputs<f64>) -> Vec<f64>>,
    /// The loop to be timed, over inputs converted beforehand.
    pub(super) runner: Box<dyn Fn(&[F::Inputs<f64>]) -> Runner>,
}

impl<F: Formula> Kernel<F> {
    /// `convert` makes the computation's own inputs, `compute` is what is timed, `doubles` reads the result.
    pub(super) fn new<I: 'static, O>(
        convert: impl Fn(&F::Inputs<f64>) -> I + Copy + 'static,
        compute: impl Fn(&I) -> O + Copy + 'static,
        doubles: impl Fn(&O) -> Vec<f64> + 'static,
    ) -> Self {
        Self {
            results: Box::new(move |i| doubles(&compute(&convert(i)))),
            runner: Box::new(move |points| {
                let points: Vec<I> = points.iter().map(convert).collect();
                Box::new(move |from, count| {
                    for i in &points[from..from + count] {
                        black_box(&compute(black_box(i)));
                    }
                })
            }),
        }
    }

    fn errors(&self, points: &[Point<F>], exact: fn(&Point<F>) -> Option<&Vec<Exact>>) -> Errors {
        exact::errors(points.iter().filter_map(|point| Some((exact(point)?, (self.results)(&point.inputs)))))
    }
}

/// Every way to compute `F`, the closed form first.
pub(super) fn all<F: Formula>(curves: &[Curve]) -> Vec<Way<F>> {
    let mut ways = vec![closed(), single(), ad()];
    ways.extend(curves.iter().filter_map(differences));
    ways.extend([octuple(), octuple_ad()]);
    ways.extend(F::ways());
    ways
}

fn closed<F: Formula>() -> Way<F> {
    Way::of("closed", "closed form")
        .value(Kernel::new(same, F::eval::<f64>, |out| out.components()))
        .jacobian(Kernel::new(same, F::linearized, |(_, jacobian)| entries::<F, _>(jacobian)))
}

fn single<F: Formula>() -> Way<F> {
    let doubles = |x: Vec<Single>| x.into_iter().map(Single::to_f64).collect();
    let convert = |i: &F::Inputs<f64>| {
        let x = to_array(i);
        let mut x = x.as_ref().iter();
        F::Inputs::from_components(&mut || x.next().map_or(Single::from(f64::NAN), |&x| Single::from(x)))
    };
    Way::of("single", "closed form in single precision")
        .value(Kernel::new(convert, F::eval::<Single>, move |out| doubles(out.components())))
        .jacobian(Kernel::new(convert, F::linearized, move |(_, jacobian)| doubles(entries::<F, _>(jacobian))))
}

fn ad<F: Formula>() -> Way<F> {
    let jacobian = |i: &_| super::value_and_jacobian_by_ad::<F>(i);
    Way::of("ad", "automatic differentiation")
        .jacobian(Kernel::new(same, jacobian, |(_, jacobian)| entries::<F, _>(jacobian)))
}

/// Differences with the step that is best on this formula.
fn differences<F: Formula>(curve: &Curve) -> Option<Way<F>> {
    let scheme = curve.scheme;
    let step = curve.best()?.step;
    let jacobian = move |i: &_| scheme.value_and_jacobian::<F>(step, i);
    let kernel = Kernel::new(same, jacobian, |(_, jacobian)| entries::<F, _>(jacobian));
    Some(Way { step: Some(step), ..Way::of(scheme.id(), scheme.title()).jacobian(kernel) })
}

fn octuple<F: Formula>() -> Way<F> {
    Way::of("octuple", "closed form in 237 bits")
        .value(Kernel::new(exactly::<F>, F::eval::<Octuple>, |out| rounded(&out.components())))
        .jacobian(Kernel::new(exactly::<F>, F::linearized, |(_, jacobian)| rounded(&entries::<F, _>(jacobian))))
}

fn octuple_ad<F: Formula>() -> Way<F> {
    Way::of("octuple-ad", "automatic differentiation in 237 bits").jacobian(Kernel::new(
        exactly::<F>,
        |i| (F::eval(i), jacobian_by_ad::<F, Octuple>(i)),
        |(_, jacobian)| rounded(&entries::<F, _>(jacobian)),
    ))
}

fn same<T: Copy>(x: &T) -> T {
    *x
}
