//! The methods of computing a formula, each compiled as one piece, so that nothing is called through a pointer while it is timed.

use crate::formula::{Fields, Formula, entries, typed};
use crate::formula::{Jet, differentiate};
use std::hint::black_box;

/// One method of computing a formula: its value, its Jacobian, or both.
///
/// A formula registers its own methods in [`Proved::methods`](super::Proved::methods), each as a function that is generic
/// over the scalar:
///
/// ```
/// use jointproof::Scalar;
/// use jointproof::formula::proof::Method;
/// use jointproof::connector::slot::{Contact, ContactForce, CrossForces};
///
/// fn plain<D: Scalar>(i: &CrossForces<D>) -> Contact<D> {
///     Contact { fc: (i.f2 * i.f2 + i.f3 * i.f3).sqrt() }
/// }
/// let method = Method::new::<ContactForce>("plain", "the square root of the sum", plain, plain);
/// ```
#[cfg_attr(not(feature = "measure"), expect(dead_code, reason = "what a way computes is read where it is measured"))]
pub struct Method {
    pub(crate) id: &'static str,
    pub(crate) title: &'static str,
    /// The step, if it uses finite differences.
    pub(crate) step: Option<f64>,
    pub(crate) value: Option<Kernel>,
    pub(crate) jacobian: Option<Kernel>,
}

impl Method {
    /// A method of computing the value, given twice: once for the value itself and once for its automatic differentiation.
    pub fn new<F: Formula>(
        id: &'static str,
        title: &'static str,
        value: impl Fn(&F::Inputs<f64>) -> F::Outputs<f64> + Copy + 'static,
        differentiated: impl Fn(&F::Inputs<Jet>) -> F::Outputs<Jet> + Copy + 'static,
    ) -> Self {
        let jacobian = move |i: &_| differentiate::<F, f64>(i, differentiated);
        Self::of(id, title).value(Kernel::new(typed, value, Fields::components)).jacobian(Kernel::new(
            typed,
            jacobian,
            |(_, jacobian)| entries(jacobian),
        ))
    }

    /// A method of computing the value that agrees with the formula only where the inputs satisfy conditions among
    /// themselves, so that its derivative differs.
    pub fn of_value<F: Formula>(
        id: &'static str,
        title: &'static str,
        value: impl Fn(&F::Inputs<f64>) -> F::Outputs<f64> + Copy + 'static,
    ) -> Self {
        Self::of(id, title).value(Kernel::new(typed, value, Fields::components))
    }

    /// A method without kernels.
    pub(crate) fn of(id: &'static str, title: &'static str) -> Self {
        Self { id, title, step: None, value: None, jacobian: None }
    }

    /// The method with this kernel for the value.
    pub(crate) fn value(self, kernel: Kernel) -> Self {
        Self { value: Some(kernel), ..self }
    }

    /// The method with this kernel for the Jacobian.
    pub(crate) fn jacobian(self, kernel: Kernel) -> Self {
        Self { jacobian: Some(kernel), ..self }
    }
}

/// Runs over the first `count` points.
pub(crate) type Runner = Box<dyn FnMut(usize)>;

/// The results as doubles in order, computed from components.
type Results = Box<dyn Fn(&[f64]) -> Vec<f64>>;
/// Creates the loop to be timed over points.
type MakeRunner = Box<dyn Fn(&[Vec<f64>]) -> Runner>;

/// A computation whose results can be inspected and that can be timed.
#[cfg_attr(not(feature = "measure"), expect(dead_code, reason = "what a way computes is read where it is measured"))]
pub(crate) struct Kernel {
    /// The results as doubles in order, computed from components.
    pub(crate) results: Results,
    /// Creates the loop to be timed, with inputs converted beforehand.
    pub(crate) runner: MakeRunner,
}

impl Kernel {
    /// `convert` makes the computation's own inputs, `compute` is what is timed, `doubles` reads its result.
    pub(crate) fn new<I: 'static, O>(
        convert: fn(&[f64]) -> I,
        compute: impl Fn(&I) -> O + Copy + 'static,
        doubles: impl Fn(&O) -> Vec<f64> + 'static,
    ) -> Self {
        let results = move |i: &_| doubles(&compute(i));
        Self::of(convert, results, move |points| each(points, compute))
    }

    /// With a loop of its own, `over`, that calls the formula by name and is compiled with it, as in a user's program;
    /// a function passed as a value would add another call. Like [`each`], `over` is not inlined. `compute` is a
    /// pointer, so that it is not compiled a second time.
    #[cfg(feature = "measure")]
    pub(crate) fn with_loop<I: 'static, O: 'static>(
        convert: fn(&[f64]) -> I,
        compute: fn(&I) -> O,
        doubles: impl Fn(&O) -> Vec<f64> + 'static,
        over: fn(&[I]),
    ) -> Self {
        Self::of(convert, move |i| doubles(&compute(i)), over)
    }

    /// `results` reads the results for converted inputs.
    fn of<I: 'static>(
        convert: fn(&[f64]) -> I,
        results: impl Fn(&I) -> Vec<f64> + 'static,
        over: impl Fn(&[I]) + Copy + 'static,
    ) -> Self {
        Self {
            results: Box::new(move |i| results(&convert(i))),
            runner: Box::new(move |points| {
                let points = converted(points, convert);
                Box::new(move |count| over(&points[..count]))
            }),
        }
    }
}

/// The loop, in a function that is not inlined, as in a user's program. Inlined into a function that owns the points,
/// some formulas take a sixth longer.
#[inline(never)]
fn each<I, O>(points: &[I], compute: impl Fn(&I) -> O) {
    // The black box may have changed all memory, so every point is read anew.
    for i in points {
        black_box(&compute(i));
    }
}

/// Compiled once per type of inputs, not once per method.
fn converted<I>(points: &[Vec<f64>], convert: fn(&[f64]) -> I) -> Vec<I> {
    points.iter().map(|point| convert(point)).collect()
}

#[cfg(test)]
mod tests {
    use super::Kernel;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn a_loop_computes_every_point_that_it_is_asked_for() {
        static COMPUTED: AtomicUsize = AtomicUsize::new(0);
        let double = |x: &f64| {
            COMPUTED.fetch_add(1, Ordering::Relaxed);
            2.0 * x
        };
        let kernel = Kernel::new(|components| components[0], double, |y| vec![*y]);
        assert_eq!((kernel.results)(&[3.0]), [6.0]);
        let before = COMPUTED.load(Ordering::Relaxed);
        (kernel.runner)(&[vec![1.0], vec![2.0], vec![3.0]])(2);
        assert_eq!(COMPUTED.load(Ordering::Relaxed) - before, 2);
    }
}
