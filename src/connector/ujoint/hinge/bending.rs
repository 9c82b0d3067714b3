//! The bending moments on a hinge.

#[cfg(feature = "verify")]
mod proof;

use super::{HingeTwist, Twist, TwistLoads};
use crate::fields;
use crate::formula::quantity::{CROSS_F_BEND, F_TOTAL_BEND, LA, LS, M_BEND_HINGE, M_TOTAL_HINGE, RP, TWIST_M2};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Scalar, abs, norm, norm_and_direction, sign};

fields! {
    /// The loads that bend the arms, an arm, and the length of its sleeve.
    pub struct Bending<T> { f_bend: T = CROSS_F_BEND, m2: T = TWIST_M2, la: T = LA, rp: T = RP, ls: T = LS }
}
fields! {
    /// Bending moments on each hinge, and the contact force that resists them.
    pub struct BendingLoads<T> { m_bend_hinge: T = M_BEND_HINGE, m_total_hinge: T = M_TOTAL_HINGE, f_total_bend: T = F_TOTAL_BEND }
}

/// The bending moments on each hinge, M_bend = |F_bend| La/8 and M_total = √(M_bend² + M_twist²), and the contact force at both
/// ends of the sleeve that resists them: 2 M_total/Ls, 0 if Ls = 0.
#[derive(Clone, Copy, Debug)]
pub struct HingeBending;

impl<D: Scalar> Bending<D> {
    #[inline]
    fn twist(&self) -> Twist<D> {
        Twist { m2: self.m2, la: self.la, rp: self.rp }
    }

    /// The gradient of bend · M_bend + twist · M_twist for two constant weights, from that of M_twist.
    ///
    /// The direction of (M_bend, M_twist) as weights gives the gradient of M_total.
    #[inline]
    pub(in crate::connector::ujoint) fn slope_of_moments(&self, [bend, twist]: [D; 2], by_twist: &Twist<D>) -> Self {
        let bend = bend * 0.125;
        Self {
            f_bend: bend * self.la * sign(self.f_bend),
            m2: twist * by_twist.m2,
            la: bend * abs(self.f_bend) + twist * by_twist.la,
            rp: twist * by_twist.rp,
            ls: D::zero(),
        }
    }
}

/// The bending moments on a hinge due to the force normal to the cross and to the twisting moment, perpendicular to each other.
#[inline]
pub(in crate::connector::ujoint) fn bending<D: Scalar>(f_bend: D, la: D, twist: &TwistLoads<D>) -> [D; 2] {
    [abs(f_bend) * la * 0.125, twist.m_twist_hinge]
}

/// The contact force that resists a bending moment, half of it at each end of the sleeve; 0 if Ls = 0.
#[inline]
pub(in crate::connector::ujoint) fn in_sleeve<D: Scalar>(moment: D, ls: D) -> D {
    if ls == 0.0 { D::zero() } else { moment * 2.0 / ls }
}

impl Formula for HingeBending {
    const SPEC: Spec = Spec::new(
        "ujoint.hinge_bending",
        "Bending moment on a hinge",
        Document::UJOINT.reconstructed(
            "Friction",
            "the root and the quotients 1/8 and by L_s were lost; the bars are ours",
        ),
    )
        .equation(r"M_{\mathrm{bend}}^{\mathrm{hinge}} = \tfrac18\lvert F_{\mathrm{bend}}\rvert L_a,\quad M_{\mathrm{total}}^{\mathrm{hinge}} = \sqrt{\left(M_{\mathrm{bend}}^{\mathrm{hinge}}\right)^2 + \left(M_{\mathrm{twist}}^{\mathrm{hinge}}\right)^2},\quad F_{\mathrm{total}}^{\mathrm{bend}} = \begin{cases} 2 M_{\mathrm{total}}^{\mathrm{hinge}}/L_s & L_s > 0 \\ 0 & L_s = 0 \end{cases}")
.given(&[Given::new(r"M_{\mathrm{twist}}^{\mathrm{hinge}}", &HingeTwist::SPEC)])
        // The largest η that `audit --attack` found is 1.45 for the value, and 2.75 is possible to first order; for the Jacobian 3.44
        // and 7.
        .eta(3.0, 7.0)
        .scale(1e50)
        .finite(Finite::Between);
    type Inputs<T: Component> = Bending<T>;
    type Outputs<T: Component> = BendingLoads<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Bending<D>) -> BendingLoads<D> {
        let moments = bending(i.f_bend, i.la, &HingeTwist::eval(&i.twist()));
        let m_total_hinge = norm(moments);
        BendingLoads { m_bend_hinge: moments[0], m_total_hinge, f_total_bend: in_sleeve(m_total_hinge, i.ls) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Bending<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &Bending<D>) -> ValueAndJacobian<Self, D> {
        let (twist, TwistLoads { m_twist_hinge: by_twist, .. }) = HingeTwist::linearized(&i.twist());
        let moments = bending(i.f_bend, i.la, &twist);
        let (m_total_hinge, direction) = norm_and_direction(moments);
        let press = |slope: D| in_sleeve(slope, i.ls);
        let f_total_bend = press(m_total_hinge);
        let by = BendingLoads {
            m_bend_hinge: i.slope_of_moments([D::one(), D::zero()], &by_twist),
            m_total_hinge: i.slope_of_moments(direction, &by_twist),
            f_total_bend: Bending {
                ls: if i.ls == 0.0 { D::zero() } else { -f_total_bend / i.ls },
                ..i.slope_of_moments(direction.map(press), &by_twist)
            },
        };
        (BendingLoads { m_bend_hinge: moments[0], m_total_hinge, f_total_bend }, by)
    }
}
