//! A force on b and the vector from a to b: what JOIN and SLOT exert on their nodes is made of these two.

#![expect(clippy::inline_always, reason = "the compiler sees the indices, and where the zeros are")]

use super::products::{cross_gradient, double_cross_gradient, mean, skew_gradient};
use crate::formula::Fields;
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// Inputs that the force f on b and the vector d from a to b are made of.
///
/// The functions give gradients by the inputs; `gradient` makes them from those by f and by d.
pub(super) trait Lever<D: Scalar>: Fields<D> {
    /// f.
    fn force(&self) -> Vector3<D>;
    /// d.
    fn arm(&self) -> Vector3<D>;
    /// The gradient of something by f and d, by the inputs.
    fn gradient(&self, by_force: &Vector3<D>, by_arm: &Vector3<D>) -> Self;
    /// Of the k-th component of f, times a sign.
    fn of_force(&self, k: usize, sign: D) -> Self;

    /// Of the k-th component of f.
    #[inline(always)]
    fn of_fb(&self, k: usize) -> Self {
        self.of_force(k, D::one())
    }

    /// Of the k-th component of −f.
    #[inline(always)]
    fn of_fa(&self, k: usize) -> Self {
        self.of_force(k, -D::one())
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
        self.gradient(&skew_gradient(row, column), &Vector3::from_element(D::zero()))
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
        if row == column {
            return self.of_k_ta_ta(row, row);
        }
        mean(&self.of_k_ta_ta(row, column), &self.of_k_ta_ta(column, row))
    }
}
