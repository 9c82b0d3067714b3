//! The one definition of a formula, from which everything else follows.
//!
//! To add a formula: declare its inputs and outputs with [`fields!`](crate::fields), write a unit struct, implement
//! [`Formula`] for it, state its evidence in a file beside it, and name it in the catalog. The closed-form Jacobian has
//! the type `Outputs<Inputs<D>>`: the outputs, with every component replaced by its gradient, whose fields have the names
//! of the inputs. `jac.fc.f2` is ∂fc/∂f2.

mod checked;
pub mod element;
pub(crate) mod error;
mod few;
mod fields;
mod finite;
#[cfg(feature = "verify")]
pub mod proof;
pub mod quantity;
mod source;
mod spec;

#[cfg(feature = "scene")]
pub(crate) use checked::first_where;
#[cfg(feature = "batch")]
pub(crate) use checked::{are_allowed, is_plain};
pub use checked::{check, value, value_and_jacobian};
pub(crate) use few::cross_gradient;
use fields::following;
pub use fields::{Component, Field, Fields, OfField, Part, Visitor};
#[cfg(feature = "verify")]
pub(crate) use fields::{entries, typed};
pub use finite::Finite;
#[cfg(feature = "batch")]
pub(crate) use finite::bits_unless_finite;
pub use source::{Document, Provenance, Source};
#[cfg(feature = "verify")]
pub(crate) use spec::NORMWISE;
pub use spec::{Bounds, Given, Spec};

use crate::formula::error::Error;
use crate::number::scalar::Scalar;
use nalgebra::{Const, SVector, U1};
use num_dual::{Derivative, DualSVec};

/// The Jacobian of `F`: its outputs, every component replaced by its gradient.
pub type Jacobian<F, D> = <F as Formula>::Outputs<<F as Formula>::Inputs<D>>;

/// Value and Jacobian of `F`.
pub type ValueAndJacobian<F, D> = (<F as Formula>::Outputs<D>, Jacobian<F, D>);

/// A formula without its types, as far as its definition says what it is; every [`Formula`] is one.
pub trait Described: Send + Sync {
    /// What is said about it.
    fn spec(&self) -> Spec;
    /// Its inputs.
    fn inputs(&self) -> &'static [Field];
    /// Its outputs.
    fn outputs(&self) -> &'static [Field];
}

impl<F: Formula> Described for F {
    fn spec(&self) -> Spec {
        F::SPEC
    }
    fn inputs(&self) -> &'static [Field] {
        F::Inputs::<f64>::FIELDS
    }
    fn outputs(&self) -> &'static [Field] {
        F::Outputs::<f64>::FIELDS
    }
}

/// A documented equation: its value, and its Jacobian in closed form where somebody calls or reads it. What is said about it stands in its `Proved`.
pub trait Formula: Copy + Send + Sync + 'static {
    /// What is said about it.
    const SPEC: Spec;
    /// Its inputs, made by [`fields!`](crate::fields).
    type Inputs<T: Component>: Fields<T>;
    /// Its outputs, made by [`fields!`](crate::fields).
    type Outputs<T: Component>: Fields<T>;

    /// The equation.
    fn eval<D: Scalar>(i: &Self::Inputs<D>) -> Self::Outputs<D>;

    /// Its derivative: `jacobian(i).out.input` is ∂out/∂input. By default it is automatic; derived by hand, its
    /// [bound](Spec::eta) is stated, and it is proved equal to the automatic one.
    #[inline]
    fn jacobian<D: Scalar>(i: &Self::Inputs<D>) -> Jacobian<Self, D> {
        differentiate::<Self, D>(i, Self::eval).1
    }

    /// Both at once; overridden where they share work. The value has the bits of [`eval`](Self::eval).
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]
    fn linearized<D: Scalar>(i: &Self::Inputs<D>) -> ValueAndJacobian<Self, D> {
        (Self::eval(i), Self::jacobian(i))
    }

    /// What makes inputs invalid beyond the domains of the single fields.
    ///
    /// It is decided by comparisons of scalars, so that it can be written down as the formula is; only an error has doubles.
    ///
    /// # Errors
    /// What is wrong with which input.
    #[inline]
    fn validate<D: Scalar>(_: &Self::Inputs<D>) -> Result<(), Error> {
        Ok(())
    }

    /// [`eval`](Self::eval) of inputs that are valid together; overridden where telling that takes as long as the value.
    ///
    /// # Errors
    /// As [`validate`](Self::validate).
    #[inline]
    fn try_eval(i: &Self::Inputs<f64>) -> Result<Self::Outputs<f64>, Error> {
        Self::validate(i)?;
        Ok(Self::eval(i))
    }

    /// [`linearized`](Self::linearized) of inputs that are valid together; overridden where [`try_eval`](Self::try_eval) is.
    ///
    /// # Errors
    /// As [`validate`](Self::validate).
    #[inline]
    fn try_linearized(i: &Self::Inputs<f64>) -> Result<ValueAndJacobian<Self, f64>, Error> {
        Self::validate(i)?;
        Ok(Self::linearized(i))
    }
}

/// A unit vector of the i-th axis times `value`: the gradient of a product's i-th component.
#[inline]
pub fn along<D: Scalar, const N: usize>(i: usize, value: D) -> SVector<D, N> {
    SVector::from_fn(|k, _| if k == i { value } else { D::zero() })
}

// Forward automatic differentiation, as fast as dual numbers make it: no allocation, fixed arrays.

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
        let seeded = Fields::from_components(&mut || {
            k += 1;
            seed(x[k - 1], (k - 1).wrapping_sub(start))
        });
        let mut k = 0;
        Fields::for_each_component(&eval(&seeded), &mut |jet: Jet<D>| {
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
    I::from_components(&mut following(array.as_ref()))
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
    Fields::from_components(&mut || {
        k += 1;
        from_array(&rows.as_ref()[k - 1])
    })
}
