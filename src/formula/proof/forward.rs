//! Forward automatic differentiation in `f64` as fast as dual numbers make it: no allocation, fixed arrays.

use crate::formula::{Component, Fields, Formula, Jacobian, ValueAndJacobian};
use nalgebra::{Const, SVector, U1};
use num_dual::{Derivative, DualSVec};

/// Directions carried at once.
const WIDTH: usize = 4;

/// A number that carries derivatives in a few directions at once.
pub type Jet = DualSVec<f64, WIDTH>;

/// The components of `I`.
pub(crate) type Array<I, T = f64> = <I as Fields<T>>::Array;

/// The rows of the Jacobian of `F`, one an output.
pub(crate) type Rows<F> = Array<<F as Formula>::Outputs<Row<F>>, Row<F>>;
type Row<F> = Array<<F as Formula>::Inputs<f64>>;

/// Value and Jacobian of `F` by differentiating `F::eval`, in chunks of a few directions.
///
/// The result is that of [`jacobian_by_ad`](crate::toolkit::verify::jacobian_by_ad), for a fraction of its time.
///
/// ```
/// use jointproof::connector::slot::{ContactForce, CrossForces};
/// let forces = CrossForces { f2: 3.0, f3: 4.0 };
/// let (value, jac) = jointproof::formula::proof::value_and_jacobian_by_ad::<ContactForce>(&forces);
/// assert_eq!((value.fc, jac.fc.f2, jac.fc.f3), (5.0, 0.6, 0.8));
/// ```
#[inline]
pub fn value_and_jacobian_by_ad<F: Formula>(i: &F::Inputs<f64>) -> ValueAndJacobian<F, f64> {
    differentiate::<F>(i, F::eval)
}

/// As [`value_and_jacobian_by_ad`], of any way to compute `F`.
#[inline]
pub(crate) fn differentiate<F: Formula>(
    i: &F::Inputs<f64>,
    eval: impl Fn(&F::Inputs<Jet>) -> F::Outputs<Jet>,
) -> ValueAndJacobian<F, f64> {
    let x = to_array(i);
    let x = x.as_ref();
    let mut value = F::Outputs::array_of(0.0);
    let mut rows = no_rows::<F>();
    for start in (0..x.len()).step_by(WIDTH) {
        let mut k = 0;
        let seeded = F::Inputs::from_components(&mut || {
            k += 1;
            seed(x[k - 1], (k - 1).wrapping_sub(start))
        });
        let mut k = 0;
        eval(&seeded).for_each_component(&mut |jet| {
            value.as_mut()[k] = jet.re;
            let gradient = jet.eps.unwrap_generic(Const::<WIDTH>, U1);
            let row = &mut rows.as_mut()[k].as_mut()[start..];
            row.iter_mut().zip(&gradient).for_each(|(entry, &derivative)| *entry = derivative);
            k += 1;
        });
    }
    (from_array(&value), jacobian_of::<F>(&rows))
}

/// Written without a store to a place known at run time only, for which the processor would wait.
#[inline]
fn seed(x: f64, direction: usize) -> Jet {
    let unit = SVector::from_fn(|d, _| if d == direction { 1.0 } else { 0.0 });
    Jet::new(x, Derivative::some(unit))
}

/// The components in order.
#[inline]
pub(crate) fn to_array<I: Fields<f64>>(i: &I) -> I::Array {
    let mut array = I::array_of(0.0);
    let mut k = 0;
    i.for_each_component(&mut |x| {
        array.as_mut()[k] = x;
        k += 1;
    });
    array
}

/// The struct of these components.
#[inline]
pub(crate) fn from_array<T: Component, I: Fields<T>>(array: &I::Array) -> I {
    let mut k = 0;
    I::from_components(&mut || {
        k += 1;
        array.as_ref()[k - 1]
    })
}

/// Rows to be filled in.
#[inline]
pub(crate) fn no_rows<F: Formula>() -> Rows<F> {
    F::Outputs::array_of(F::Inputs::array_of(0.0))
}

/// The Jacobian of these rows.
#[inline]
pub(crate) fn jacobian_of<F: Formula>(rows: &Rows<F>) -> Jacobian<F, f64> {
    let mut k = 0;
    F::Outputs::from_components(&mut || {
        k += 1;
        from_array(&rows.as_ref()[k - 1])
    })
}
