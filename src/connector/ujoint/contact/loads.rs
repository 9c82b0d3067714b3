//! The inputs of the contact moments: orientation, loads and dimensions of the joint, and its loads at the centre of the cross.

use crate::connector::ujoint::{Arm, Bending, CrossForces, CrossLoads, Decomposition, Twist};
use crate::fields;
use crate::formula::Formula;
use crate::formula::quantity::{E1A, E2A, E3A, E3B, F2, F3, JOIN_F1, LA, LS, MC1, MC3, RA, RP, TWIST_M2};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The orientation of the nodes, the loads that the joint transmits, and the dimensions of the cross.
    pub struct JointLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        f1: T = JOIN_F1, f2: T = F2, f3: T = F3, m2: T = TWIST_M2, rp: T = RP, la: T = LA, ra: T = RA, ls: T = LS,
    }
}

fields! {
    /// Contact moments about both axes of the cross.
    pub struct ContactMomentPair<T> { mc1: T = MC1, mc3: T = MC3 }
}

impl<D: Scalar> JointLoads<D> {
    #[inline]
    pub(in crate::connector::ujoint) fn cross_loads(&self) -> CrossLoads<D> {
        let Self { e1a, e2a, e3a, e3b, f1, f2, f3, .. } = *self;
        CrossLoads { e1a, e2a, e3a, e3b, f1, f2, f3 }
    }

    #[inline]
    pub(in crate::connector::ujoint) fn arm(&self) -> Arm<D> {
        Arm { la: self.la, rp: self.rp }
    }

    #[inline]
    pub(in crate::connector::ujoint) fn twist(&self) -> Twist<D> {
        Twist { m2: self.m2, la: self.la, rp: self.rp }
    }

    #[inline]
    pub(in crate::connector::ujoint) fn bending(&self, f_bend: D) -> Bending<D> {
        let Self { m2, la, rp, ls, .. } = *self;
        Bending { f_bend, m2, la, rp, ls }
    }

    /// A gradient times a number.
    #[inline]
    pub(crate) fn times(&self, factor: D) -> Self {
        Self {
            e1a: self.e1a * factor,
            e2a: self.e2a * factor,
            e3a: self.e3a * factor,
            e3b: self.e3b * factor,
            f1: self.f1 * factor,
            f2: self.f2 * factor,
            f3: self.f3 * factor,
            m2: self.m2 * factor,
            rp: self.rp * factor,
            la: self.la * factor,
            ra: self.ra * factor,
            ls: self.ls * factor,
        }
    }

    /// The force along the axes of the cross and normal to them.
    #[inline]
    pub(crate) fn at_centre(&self) -> CrossForces<D> {
        Decomposition::eval(&self.cross_loads())
    }
}

/// The moment due to the axial force, 0 if Ra = 0, and due to the force that presses pin and sleeve together.
#[inline]
pub(super) fn moment<D: Scalar>(axial: D, pressing: D, ra: D, rp: D) -> D {
    axial * ra + pressing * rp
}
