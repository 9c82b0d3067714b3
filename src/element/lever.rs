//! A force on b and the vector from a to b: what JOIN and SLOT exert on their nodes is made of these two.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

use super::products::{double_cross_gradient, skew_gradient, symmetric_gradient};
use crate::formula::{Few, Fields, Sign, cross_gradient};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// Inputs that the force f on b and the vector d from a to b are made of.
///
/// The functions give gradients by the inputs; `gradient` makes them from those by f and by d.
pub(super) trait Lever<D: Scalar>: Fields<D> {
    /// f.
    fn force(&self) -> Vector3<D>;
    /// d.
    fn arm(&self) -> Vector3<D>;
    /// The gradient of something by the inputs, of which this is that by f and d, and its sign.
    fn gradient(&self, by: ([Few<D>; 2], Sign)) -> Self;

    /// Of the k-th component of f.
    #[inline(always)]
    fn of_fb(&self, k: usize) -> Self {
        self.gradient(([Few::one(k, D::one()), Few::none()], Sign::Plus))
    }

    /// Of the k-th component of −f.
    #[inline(always)]
    fn of_fa(&self, k: usize) -> Self {
        self.gradient(([Few::one(k, D::one()), Few::none()], Sign::Minus))
    }

    /// Of the k-th component of f × d.
    #[inline(always)]
    fn of_ma(&self, k: usize) -> Self {
        self.gradient((cross_gradient(&self.force(), &self.arm(), k), Sign::Plus))
    }

    /// Of an entry of f × I.
    #[inline(always)]
    fn of_k_ua_ta(&self, row: usize, column: usize) -> Self {
        self.gradient(([skew_gradient(row, column), Few::none()], Sign::Plus))
    }

    /// Of an entry of f ⊗ d − (f·d) I.
    #[inline(always)]
    fn of_k_ta_ta(&self, row: usize, column: usize) -> Self {
        self.gradient(double_cross_gradient(&self.force(), &self.arm(), row, column))
    }

    /// Of an entry of the symmetric part of that.
    #[inline(always)]
    fn of_s_ta_ta(&self, row: usize, column: usize) -> Self {
        self.gradient(symmetric_gradient(&self.force(), &self.arm(), row, column))
    }
}
