//! The contact moments of the hinges.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
pub(crate) mod proof;

mod links;
mod loads;

use loads::moment;
pub use loads::{ContactMomentPair, JointLoads};

use super::hinge::{bending, in_sleeve, transverse};
use super::{AxialForces, CrossForces, Decomposition, HingeAxial, HingeBending, HingeTransverse, HingeTwist};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec};
use crate::number::scalar::{Scalar, norm};

/// The contact moment of a hinge.
#[derive(Clone, Copy, Debug)]
pub struct ContactMoments;

impl Formula for ContactMoments {
    const SPEC: Spec = Spec::new("ujoint.contact_moments", "Contact moments", Document::UJOINT.printed("Friction"))
        .equation(r"M_{Ck} = F_{\mathrm{axial}k}^{\mathrm{hinge}} R_a + \left(F_{\mathrm{total}k}^{\mathrm{hinge}} + F_{\mathrm{total}}^{\mathrm{bend}}\right) R_p\quad (k = 1, 3)")
.given(&[Given::new(r"F_{\mathrm{axial1}}^{\mathrm{hinge}},\ F_{\mathrm{axial3}}^{\mathrm{hinge}}", &HingeAxial::SPEC), Given::new(r"F_{\mathrm{total1}}^{\mathrm{hinge}},\ F_{\mathrm{total3}}^{\mathrm{hinge}}", &HingeTransverse::SPEC), Given::new(r"F_{\mathrm{total}}^{\mathrm{bend}}", &HingeBending::SPEC), Given::new(r"F_{\mathrm{axial1}},\ F_{\mathrm{axial3}},\ F_{\mathrm{bend}}", &Decomposition::SPEC)])
        // The largest η that `audit --attack` found is 1.3 for the value, and 3.63 is possible to first order; for the Jacobian 5.82
        // and 17.4.
        .eta(4.0, 6.0)
        .normwise(4.0, 18.0)
        .scale(1e50)
        .finite(Finite::Between);
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

    #[inline(always)]
    fn linearized<D: Scalar>(i: &JointLoads<D>) -> (ContactMomentPair<D>, Jacobian<Self, D>) {
        links::linearized(i)
    }
}
