//! The triads of both nodes.

#![expect(clippy::inline_always, reason = "a call would write the vectors to memory, and wait for them there")]

use super::{check_alpha, check_gamma, difference, turn_gradients, turns};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{E1A, E1B, E2A, E2B, E3A, E3B};
use crate::formula::{Component, Fields};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The vectors of both triads.
    pub struct Triads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
    }
}

impl<T: Component> Triads<T> {
    /// Combines the triads of a and of b.
    #[inline]
    pub const fn new([e1a, e2a, e3a]: [Vector3<T>; 3], [e1b, e2b, e3b]: [Vector3<T>; 3]) -> Self {
        Self { e1a, e2a, e3a, e1b, e2b, e3b }
    }

    /// Copies the vectors component by component: whole vectors would be copied through memory.
    #[inline(always)]
    pub(crate) fn by_components(a: [&Vector3<T>; 3], b: [&Vector3<T>; 3]) -> Self {
        Self::new(a.map(Vector3::xyz), b.map(Vector3::xyz))
    }
}

impl<D: Scalar> Triads<D> {
    /// α and γ together, which is faster than one after the other.
    #[inline(always)]
    pub(crate) fn alpha_and_gamma(&self) -> [D; 2] {
        let [sines, cosines] = self.sines_and_cosines();
        turns(sines, cosines)
    }

    /// The derivatives of both.
    #[inline(always)]
    pub(crate) fn alpha_and_gamma_gradients(&self) -> [Self; 2] {
        let ([sines, cosines], zero) = (self.sines_and_cosines(), Self::filled(D::zero()));
        let of = [[&self.e3b, &self.e2a, &self.e3a], [&self.e1a, &self.e2b, &self.e1b]];
        let [[by_e3b, by_e2a, by_e3a], [by_e1a, by_e2b, by_e1b]] = turn_gradients(of, sines, cosines, difference);
        [Self { e2a: by_e2a, e3a: by_e3a, e3b: by_e3b, ..zero }, Self { e1a: by_e1a, e1b: by_e1b, e2b: by_e2b, ..zero }]
    }

    /// The scalar products whose angles are α and γ, except for the sign.
    #[inline(always)]
    fn sines_and_cosines(&self) -> [[D; 2]; 2] {
        let Self { e1a, e2a, e3a, e1b, e2b, e3b } = self;
        [[e3b.dot(e2a), e1a.dot(e2b)], [e3b.dot(e3a), e1a.dot(e1b)]]
    }

    /// The moments on a and on b of a unit multiplier whose residual has this gradient: with δe = ω × e for every vector of a
    /// node, Σ (∂g/∂e)·δe = ω·Σ e × ∂g/∂e.
    #[inline]
    pub fn moments(&self, gradient: &Self) -> [Vector3<D>; 2] {
        let moment = |e: Vector3<D>, slope: Vector3<D>| e.cross(&slope);
        let on_a = moment(self.e1a, gradient.e1a) + moment(self.e2a, gradient.e2a) + moment(self.e3a, gradient.e3a);
        let on_b = moment(self.e1b, gradient.e1b) + moment(self.e2b, gradient.e2b) + moment(self.e3b, gradient.e3b);
        [on_a, on_b]
    }
}

/// Rejects gimbal lock, at which α and γ are undefined.
///
/// # Errors
/// [`Error::GimbalLock`].
#[inline]
pub fn check_turns<D: Scalar>(i: &Triads<D>) -> Result<(), Error> {
    check_alpha(&i.e2a, &i.e3a, &i.e3b)?;
    check_gamma(&i.e1a, &i.e1b, &i.e2b)
}

/// Inputs that contain both triads.
pub(crate) trait Oriented<T> {
    /// The triads.
    fn triads(&self) -> Triads<T>;
    /// Inputs with these triads and zeros for the rest.
    fn of(triads: Triads<T>) -> Self;
}

impl<D: Scalar> Oriented<D> for Triads<D> {
    #[inline]
    fn triads(&self) -> Self {
        *self
    }
    #[inline]
    fn of(triads: Self) -> Self {
        triads
    }
}
