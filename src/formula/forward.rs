//! Forward automatic differentiation, as fast as dual numbers make it: no allocation, fixed arrays.

use crate::Scalar;
use crate::formula::{Component, Fields, Formula, Jacobian, ValueAndJacobian};
use nalgebra::{Const, SVector, U1};
use num_dual::{Derivative, DualSVec};

/// Directions carried at once. Chunks of a fixed width keep the number of inputs out of the types.
pub(crate) const WIDTH: usize = 4;

/// A number that carries derivatives in a few directions at once.
pub type Jet<D = f64> = DualSVec<D, WIDTH>;

/// The components of `I`.
pub(crate) type Array<I, T = f64> = <I as Fields<T>>::Array;

/// The rows of the Jacobian of `F`, one an output.
pub(crate) type Rows<F, D = f64> = Array<<F as Formula>::Outputs<Row<F, D>>, Row<F, D>>;
type Row<F, D> = Array<<F as Formula>::Inputs<D>, D>;

/// Value and Jacobian of `F` by differentiating `F::eval`, in chunks of a few directions.
///
/// ```
/// use jointproof::connector::slot::{ContactForce, CrossForces};
/// let forces = CrossForces { f2: 3.0, f3: 4.0 };
/// let (value, jac) = jointproof::formula::proof::value_and_jacobian_by_ad::<ContactForce, f64>(&forces);
/// assert_eq!((value.fc, jac.fc.f2, jac.fc.f3), (5.0, 0.6, 0.8));
/// ```
#[inline]
pub fn value_and_jacobian_by_ad<F: Formula, D: Scalar>(i: &F::Inputs<D>) -> ValueAndJacobian<F, D> {
    differentiate::<F, D>(i, F::eval)
}

/// As [`value_and_jacobian_by_ad`], of any way to compute `F`.
#[inline]
pub(crate) fn differentiate<F: Formula, D: Scalar>(
    i: &F::Inputs<D>,
    eval: impl Fn(&F::Inputs<Jet<D>>) -> F::Outputs<Jet<D>>,
) -> ValueAndJacobian<F, D> {
    let x = to_array(i);
    let x = x.as_ref();
    let mut value = F::Outputs::array_of(D::zero());
    let mut rows = no_rows::<F, D>();
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
    (from_array(&value), jacobian_of::<F, D>(&rows))
}

/// Written without a store to a place known at run time only, for which the processor would wait.
#[inline]
fn seed<D: Scalar>(x: D, direction: usize) -> Jet<D> {
    let unit = SVector::from_fn(|d, _| if d == direction { D::one() } else { D::zero() });
    Jet::new(x, Derivative::some(unit))
}

/// The components in order.
#[inline]
pub(crate) fn to_array<D: Scalar, I: Fields<D>>(i: &I) -> I::Array {
    let mut array = I::array_of(D::zero());
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
pub(crate) fn no_rows<F: Formula, D: Scalar>() -> Rows<F, D> {
    F::Outputs::array_of(F::Inputs::array_of(D::zero()))
}

/// The Jacobian of these rows.
#[inline]
pub(crate) fn jacobian_of<F: Formula, D: Scalar>(rows: &Rows<F, D>) -> Jacobian<F, D> {
    let mut k = 0;
    F::Outputs::from_components(&mut || {
        k += 1;
        from_array(&rows.as_ref()[k - 1])
    })
}
