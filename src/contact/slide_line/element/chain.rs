//! The chain rule: numbers with their derivatives with respect to K variables, and formulas applied to them.
//!
//! The derivative of a composition of formulas is composed of their closed-form derivatives.

use crate::formula::{Component, Fields, Formula, ValueAndJacobian};
use crate::number::scalar::{Scalar, choice};
use nalgebra::SVector;
use std::ops::{Add, Mul, Neg};

/// A number, and its derivatives with respect to K variables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term<D, const K: usize> {
    pub(super) value: D,
    pub(super) slope: SVector<D, K>,
}

impl<D: Scalar, const K: usize> Term<D, K> {
    /// A number with these derivatives.
    #[inline]
    pub(super) fn new(value: D, slope: SVector<D, K>) -> Self {
        Self { value, slope }
    }

    /// A constant.
    #[inline]
    pub(super) fn constant(value: D) -> Self {
        Self::new(value, SVector::from_element(D::zero()))
    }

    /// The k-th of the variables with respect to which derivatives are taken.
    #[inline]
    pub(super) fn variable(value: D, k: usize) -> Self {
        Self::new(value, SVector::from_fn(|j, _| if j == k { D::one() } else { D::zero() }))
    }
}

impl<D: Scalar, const K: usize> Add for Term<D, K> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.slope + other.slope)
    }
}

impl<D: Scalar, const K: usize> Mul for Term<D, K> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.value * other.value, self.slope * other.value + other.slope * self.value)
    }
}

impl<D: Scalar, const K: usize> Neg for Term<D, K> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.value, -self.slope)
    }
}

/// The components of a struct as an array.
#[inline]
pub(super) fn components<T: Component, X: Fields<T>>(x: &X, filler: T) -> X::Array {
    let mut all = X::array_of(filler);
    let mut places = all.as_mut().iter_mut();
    x.for_each_component(&mut |component| {
        *places.next().expect("an array has as many components as it was made for") = component;
    });
    all
}

/// The struct of these components.
#[inline]
fn from<T: Component, X: Fields<T>>(components: impl IntoIterator<Item = T>) -> X {
    let mut all = components.into_iter();
    X::from_components(&mut || all.next().expect("there are as many components as the struct has"))
}

/// A formula applied to such numbers, from its value and its Jacobian at their values.
#[inline]
pub(super) fn through<F: Formula, D: Scalar, const K: usize>(
    i: &F::Inputs<Term<D, K>>,
    linearized: impl FnOnce(&F::Inputs<D>) -> ValueAndJacobian<F, D>,
) -> F::Outputs<Term<D, K>> {
    let terms = components(i, Term::constant(D::zero()));
    let (value, by) = linearized(&from(terms.as_ref().iter().map(|term| term.value)));
    let value = components(&value, D::zero());
    let gradients = components(&by, F::Inputs::<D>::filled(D::zero()));
    let slope = |gradient: &F::Inputs<D>| {
        let parts = components(gradient, D::zero());
        let pairs = parts.as_ref().iter().zip(terms.as_ref());
        pairs.fold(SVector::from_element(D::zero()), |slope: SVector<D, K>, (&part, term)| slope + term.slope * part)
    };
    from(value.as_ref().iter().zip(gradients.as_ref()).map(|(&value, gradient)| Term::new(value, slope(gradient))))
}

/// A formula applied to such numbers.
#[inline]
pub(super) fn chain<F: Formula, D: Scalar, const K: usize>(i: &F::Inputs<Term<D, K>>) -> F::Outputs<Term<D, K>> {
    through::<F, D, K>(i, F::linearized)
}

/// Value and Jacobian of a formula, N numbers in all, as one choice: those of all slave nodes together have too many ways to be
/// recorded.
#[inline]
pub(super) fn joined<F: Formula, D: Scalar, const N: usize>(i: &F::Inputs<D>) -> ValueAndJacobian<F, D> {
    let found = choice::<D, N>(|| {
        let (value, by) = F::linearized(i);
        let (mut all, mut k) = ([D::zero(); N], 0);
        let mut add = |x: D| {
            all[k] = x;
            k += 1;
        };
        value.for_each_component(&mut add);
        by.for_each_component(&mut |gradient: F::Inputs<D>| gradient.for_each_component(&mut add));
        all
    });
    let mut all = found.into_iter();
    let mut next = || all.next().expect("there are as many numbers as were chosen");
    let value = F::Outputs::<D>::from_components(&mut next);
    (value, F::Outputs::<F::Inputs<D>>::from_components(&mut || F::Inputs::<D>::from_components(&mut next)))
}
