//! Two nodes in space, with their positions and triads.

#[cfg(feature = "verify")]
pub(crate) mod proof;

use super::cardan::Triads;
use super::cross::UniversalMoments;
use super::line::{JoinLoads, Positions};
use super::offset::Arms;
use super::{Contribution, Forces, NodalForces};
use crate::fields;
use crate::formula::quantity::{E1A, E1B, E2A, E2B, E3A, E3B, SPIN_A, SPIN_B, TRANSLATION_A, TRANSLATION_B, XA, XB};
use crate::formula::{Component, Field, Fields};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The positions and triads of both nodes.
    pub struct Nodes<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A,
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB,
    }
}

/// The degrees of freedom of two nodes in space.
pub(crate) const UNKNOWNS: &[Field] = &[
    Field::new("ua", &TRANSLATION_A),
    Field::new("ta", &SPIN_A),
    Field::new("ub", &TRANSLATION_B),
    Field::new("tb", &SPIN_B),
];
/// The forces and moments on them.
pub(crate) const FORCES: &[Field] = <NodalForces<f64> as Fields<f64>>::FIELDS;

impl<T: Component> Nodes<T> {
    /// Combines the triads of a and of b with the positions of a and of b.
    #[inline]
    pub const fn new(triads: [[Vector3<T>; 3]; 2], places: [Vector3<T>; 2]) -> Self {
        let ([[e1a, e2a, e3a], [e1b, e2b, e3b]], [xa, xb]) = (triads, places);
        Self { e1a, e2a, e3a, e1b, e2b, e3b, xa, xb }
    }

    /// The triad of a.
    #[inline]
    pub const fn a(&self) -> [Vector3<T>; 3] {
        [self.e1a, self.e2a, self.e3a]
    }

    /// The triad of b.
    #[inline]
    pub const fn b(&self) -> [Vector3<T>; 3] {
        [self.e1b, self.e2b, self.e3b]
    }

    pub(crate) fn positions(&self) -> Positions<T> {
        let Self { e1a, e2a, e3a, xa, xb, .. } = *self;
        Positions { e1a, e2a, e3a, xa, xb }
    }

    /// The loads of JOIN at these nodes.
    pub(crate) fn join_loads(&self, [f1, f2, f3]: [T; 3]) -> JoinLoads<T> {
        let Self { e1a, e2a, e3a, xa, xb, .. } = *self;
        JoinLoads { e1a, e2a, e3a, xa, xb, f1, f2, f3 }
    }

    pub(crate) fn triads(&self) -> Triads<T> {
        Triads::new(self.a(), self.b())
    }
}

impl<D: Scalar> Nodes<D> {
    /// The nodes after small motions u_a, θ_a, u_b, θ_b.
    pub(crate) fn moved(&self, motions: &Forces<D>) -> Self {
        let [ua, ta, ub, tb] = [0, 3, 6, 9].map(|k| motions.fixed_rows::<3>(k).into_owned());
        let turned = |triad: [Vector3<D>; 3], spin: Vector3<D>| triad.map(|e| e + spin.cross(&e));
        Self::new([turned(self.a(), ta), turned(self.b(), tb)], [self.xa + ua, self.xb + ub])
    }
}

impl<D: Scalar, const M: usize> Contribution<D, M> {
    /// Converts this contribution at the connector's points to the nodes that carry rigid arms to these points.
    #[must_use]
    pub fn on_arms(&self, arms: &Arms<D>) -> Self {
        Self {
            residuals: self.residuals,
            rows: arms.rows(&self.rows),
            forces: arms.forces(&self.forces),
            stiffness: arms.stiffness(&self.stiffness, &self.forces),
            by_multipliers: arms.rows(&self.by_multipliers.transpose()).transpose(),
        }
    }
}

/// A vector over all degrees of freedom that has only the parts of the spins.
pub(crate) fn by_spins<D: Scalar>(ma: Vector3<D>, mb: Vector3<D>) -> Forces<D> {
    UniversalMoments { ma, mb }.vector()
}

/// The part of an [`Element`](super::Element) that two nodes in space have in common.
macro_rules! two_nodes {
    () => {
        const UNKNOWNS: &'static [Field] = $crate::element::nodes::UNKNOWNS;
        const FORCES: &'static [Field] = $crate::element::nodes::FORCES;
        type Nodes<T: Component> = Nodes<T>;

        fn moved<D: Scalar>(nodes: &Nodes<D>, motions: &nalgebra::SVector<D, 12>) -> Nodes<D> {
            nodes.moved(motions)
        }
    };
}
pub(crate) use two_nodes;
