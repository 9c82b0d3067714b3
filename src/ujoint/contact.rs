//! The contact moments of the hinges.

#[cfg(feature = "verify")]
pub(super) mod proof;

mod links;

use super::hinge::{bending, in_sleeve, transverse};
use super::{Arm, AxialForces, Bending, CrossForces, CrossLoads, Decomposition, HingeAxial, HingeTwist, Twist};
use crate::fields;
use crate::formula::{Component, Document, Formula, Jacobian, Spec};
use crate::quantity::{E1A, E2A, E3A, E3B, F1, F2, F3, LA, LS, MC1, MC3, RA, RP, TWIST_M2};
use crate::scalar::{Scalar, norm};
use nalgebra::Vector3;

fields! {
    /// How the nodes are turned, the loads that the joint transmits, and the measures of the cross.
    pub struct JointLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        f1: T = F1, f2: T = F2, f3: T = F3, m2: T = TWIST_M2, rp: T = RP, la: T = LA, ra: T = RA, ls: T = LS,
    }
}
fields! {
    /// Contact moments about both axes of the cross.
    pub struct ContactMomentPair<T> { mc1: T = MC1, mc3: T = MC3 }
}

/// The contact moment of a hinge.
#[derive(Clone, Copy, Debug)]
pub struct ContactMoments;

impl<D: Scalar> JointLoads<D> {
    #[inline]
    fn cross_loads(&self) -> CrossLoads<D> {
        let Self { e1a, e2a, e3a, e3b, f1, f2, f3, .. } = *self;
        CrossLoads { e1a, e2a, e3a, e3b, f1, f2, f3 }
    }

    #[inline]
    fn arm(&self) -> Arm<D> {
        Arm { la: self.la, rp: self.rp }
    }

    #[inline]
    fn twist(&self) -> Twist<D> {
        Twist { m2: self.m2, la: self.la, rp: self.rp }
    }

    #[inline]
    fn bending(&self, f_bend: D) -> Bending<D> {
        let Self { m2, la, rp, ls, .. } = *self;
        Bending { f_bend, m2, la, rp, ls }
    }

    /// The force along the axes of the cross and across them.
    #[inline]
    pub(super) fn at_centre(&self) -> CrossForces<D> {
        Decomposition::eval(&self.cross_loads())
    }
}

impl Formula for ContactMoments {
    const SPEC: Spec = Spec::new("ujoint.contact_moments", "Contact moments", Document::UJOINT.printed("Friction"))
.equation(r"M_{Ck} = F_{\mathrm{axial}k}^{\mathrm{hinge}} R_a + \left(F_{\mathrm{total}k}^{\mathrm{hinge}} + F_{\mathrm{total}}^{\mathrm{bend}}\right) R_p\quad (k = 1, 3)")
.eta(2.0, 6.0);
    type Inputs<T: Component> = JointLoads<T>;
    type Outputs<T: Component> = ContactMomentPair<T>;

    #[inline]
    fn eval<D: Scalar>(i: &JointLoads<D>) -> ContactMomentPair<D> {
        let JointLoads { rp, la, ra, ls, .. } = *i;
        let CrossForces { f_axial1, f_axial3, f_bend } = i.at_centre();
        let twist = HingeTwist::eval(&i.twist());
        let axial = HingeAxial::eval(&AxialForces { f_axial1, f_axial3, la, rp });
        let pressing = in_sleeve(norm(bending(f_bend, la, &twist)), ls);
        let total = |f_transv| norm(transverse(f_bend, &twist, f_transv));
        ContactMomentPair {
            mc1: moment(axial.f_axial_hinge1, total(axial.f_transv_hinge1) + pressing, ra, rp),
            mc3: moment(axial.f_axial_hinge3, total(axial.f_transv_hinge3) + pressing, ra, rp),
        }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &JointLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &JointLoads<D>) -> (ContactMomentPair<D>, Jacobian<Self, D>) {
        links::linearized(i)
    }
}

/// The moment of the axial force, left out where Ra = 0, and of the force that presses pin and sleeve together.
#[inline]
fn moment<D: Scalar>(axial: D, pressing: D, ra: D, rp: D) -> D {
    let pressing = pressing * rp;
    if ra == 0.0 { pressing } else { axial * ra + pressing }
}
