//! A force on b and the vector from a to b: what JOIN and SLOT exert on their nodes is made of these two.

#![expect(clippy::inline_always, reason = "zeros are left out where the compiler sees the indices")]

use super::products::{Sparse, cross_gradient, double_cross_gradient, skew_gradient, symmetric_gradient};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// Inputs that the force f on b and the vector d from a to b are made of.
///
/// The functions give gradients by the inputs; `gradient` makes them from those by f and by d.
pub(super) trait Lever<D: Scalar>: Sized {
    /// f.
    fn force(&self) -> Vector3<D>;
    /// d.
    fn arm(&self) -> Vector3<D>;
    /// The gradient of something by f and d, by the inputs.
    fn gradient(&self, by_force: &Sparse<D>, by_arm: &Sparse<D>) -> Self;

    /// Of the k-th component of f.
    #[inline(always)]
    fn of_fb(&self, k: usize) -> Self {
        self.gradient(&Sparse::none().with(k, D::one()), &Sparse::none())
    }

    /// Of the k-th component of −f.
    #[inline(always)]
    fn of_fa(&self, k: usize) -> Self {
        self.gradient(&Sparse::none().with(k, -D::one()), &Sparse::none())
    }

    /// Of the k-th component of f × d.
    #[inline(always)]
    fn of_ma(&self, k: usize) -> Self {
        let [by_force, by_arm] = cross_gradient(&self.force(), &self.arm(), k);
        self.gradient(&by_force, &by_arm)
    }

    /// Of an entry of f × I.
    #[inline(always)]
    fn of_k_ua_ta(&self, row: usize, column: usize) -> Self {
        self.gradient(&skew_gradient(row, column), &Sparse::none())
    }

    /// Of an entry of f ⊗ d − (f·d) I.
    #[inline(always)]
    fn of_k_ta_ta(&self, row: usize, column: usize) -> Self {
        let [by_force, by_arm] = double_cross_gradient(&self.force(), &self.arm(), row, column);
        self.gradient(&by_force, &by_arm)
    }

    /// Of an entry of the symmetric part of that.
    #[inline(always)]
    fn of_s_ta_ta(&self, row: usize, column: usize) -> Self {
        let [by_force, by_arm] = symmetric_gradient(&self.force(), &self.arm(), row, column);
        self.gradient(&by_force, &by_arm)
    }
}
