//! The total transverse force on a hinge.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
mod proof;

use super::{AxialForces, HingeAxial, HingeTwist, Twist, TwistLoads};
use crate::fields;
use crate::formula::quantity::{CROSS_F_BEND, F_AXIAL1, F_AXIAL3, F_TOTAL_HINGE1, F_TOTAL_HINGE3, LA, RP, TWIST_M2};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, norm, norm_and_direction};

fields! {
    /// All loads at the centre of the cross, and an arm.
    pub struct CentreLoads<T> {
        f_axial1: T = F_AXIAL1, f_axial3: T = F_AXIAL3, f_bend: T = CROSS_F_BEND, m2: T = TWIST_M2, la: T = LA, rp: T = RP,
    }
}
fields! {
    /// Total transverse force on each hinge.
    pub struct TransverseForces<T> { f_total_hinge1: T = F_TOTAL_HINGE1, f_total_hinge3: T = F_TOTAL_HINGE3 }
}

/// The total transverse force on each hinge, as documented: the root of the sum of the squares of a quarter of the force normal
/// to the cross, the force due to the twisting moment and that due to the force along the other axis.
///
/// The last two are parallel, in the plane of the cross. On one of the two hinges of an axis they add, on the other they
/// subtract; the root of the sum of squares lies in between.
#[derive(Clone, Copy, Debug)]
pub struct HingeTransverse;

impl<D: Scalar> CentreLoads<D> {
    #[inline]
    fn twist(&self) -> Twist<D> {
        Twist { m2: self.m2, la: self.la, rp: self.rp }
    }
    #[inline]
    fn axial(&self) -> AxialForces<D> {
        AxialForces { f_axial1: self.f_axial1, f_axial3: self.f_axial3, la: self.la, rp: self.rp }
    }
}

/// The three transverse forces on a hinge, whose squares are added.
#[inline]
pub(in crate::connector::ujoint) fn transverse<D: Scalar>(f_bend: D, twist: &TwistLoads<D>, f_transv: D) -> [D; 3] {
    [f_bend * 0.25, twist.f_twist_hinge, f_transv]
}

impl Formula for HingeTransverse {
    const SPEC: Spec = Spec::new(
        "ujoint.hinge_transverse",
        "Transverse force on a hinge",
        Document::UJOINT.reconstructed("Friction", "the root and the quotient by 4 were lost"),
    )
        .equation(r"F_{\mathrm{total}k}^{\mathrm{hinge}} = \sqrt{\left(\tfrac14 F_{\mathrm{bend}}\right)^2 + \left(F_{\mathrm{twist}}^{\mathrm{hinge}}\right)^2 + \left(F_{\mathrm{transv}k}^{\mathrm{hinge}}\right)^2}\quad (k = 1, 3)")
.given(&[Given::new(r"F_{\mathrm{twist}}^{\mathrm{hinge}}", &HingeTwist::SPEC), Given::new(r"F_{\mathrm{transv1}}^{\mathrm{hinge}},\ F_{\mathrm{transv3}}^{\mathrm{hinge}}", &HingeAxial::SPEC)])
        // The largest η that `audit --attack` found is 1.39 for the value, and 2.75 is possible to first order; for the Jacobian 2.92
        // and 8.12.
        .eta(3.0, 8.0)
        .scale(1e50)
        .finite(Finite::Between);
    type Inputs<T: Component> = CentreLoads<T>;
    type Outputs<T: Component> = TransverseForces<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &CentreLoads<D>) -> TransverseForces<D> {
        let (twist, axial) = (HingeTwist::eval(&i.twist()), HingeAxial::eval(&i.axial()));
        let total = |f_transv| norm(transverse(i.f_bend, &twist, f_transv));
        TransverseForces { f_total_hinge1: total(axial.f_transv_hinge1), f_total_hinge3: total(axial.f_transv_hinge3) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CentreLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &CentreLoads<D>) -> ValueAndJacobian<Self, D> {
        let (twist, twist_slope) = HingeTwist::linearized(&i.twist());
        let (axial, axial_slope) = HingeAxial::linearized(&i.axial());
        let by_twist = twist_slope.f_twist_hinge;
        let total = |f_transv, by_push: AxialForces<D>| {
            let (total, [bend, twist, push]) = norm_and_direction(transverse(i.f_bend, &twist, f_transv));
            let by = CentreLoads {
                f_axial1: push * by_push.f_axial1,
                f_axial3: push * by_push.f_axial3,
                f_bend: bend * 0.25,
                m2: twist * by_twist.m2,
                la: twist * by_twist.la + push * by_push.la,
                rp: twist * by_twist.rp + push * by_push.rp,
            };
            (total, by)
        };
        let (f_total_hinge1, by_hinge1) = total(axial.f_transv_hinge1, axial_slope.f_transv_hinge1);
        let (f_total_hinge3, by_hinge3) = total(axial.f_transv_hinge3, axial_slope.f_transv_hinge3);
        let by = TransverseForces { f_total_hinge1: by_hinge1, f_total_hinge3: by_hinge3 };
        (TransverseForces { f_total_hinge1, f_total_hinge3 }, by)
    }
}
