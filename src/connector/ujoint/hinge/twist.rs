//! The loads on a hinge due to the twisting moment.

#[cfg(feature = "verify")]
mod proof;

use crate::connector::ujoint::{Arm, TwistFactors, TwistShares};
use crate::fields;
use crate::formula::quantity::{F_TWIST_HINGE, LA, M_TWIST_HINGE, RP, TWIST_M2};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec};
use crate::number::scalar::{Scalar, abs, sign};

fields! {
    /// The twisting moment, and an arm.
    pub struct Twist<T> { m2: T = TWIST_M2, la: T = LA, rp: T = RP }
}
fields! {
    /// Moment and force on each hinge.
    pub struct TwistLoads<T> { m_twist_hinge: T = M_TWIST_HINGE, f_twist_hinge: T = F_TWIST_HINGE }
}

/// The loads on each hinge due to the twisting moment M_twist = |m2|: the moment α_twist M_twist about the direction normal to
/// the cross, and the force β_twist M_twist/La in its plane.
#[derive(Clone, Copy, Debug)]
pub struct HingeTwist;

impl Formula for HingeTwist {
    const SPEC: Spec = Spec::new(
        "ujoint.hinge_twist",
        "Hinge loads of the twisting moment",
        Document::UJOINT.reconstructed("Friction", "the quotient by L_a was lost"),
    )
        .equation(r"M_{\mathrm{twist}}^{\mathrm{hinge}} = \alpha_{\mathrm{twist}}\lvert m_2\rvert,\quad F_{\mathrm{twist}}^{\mathrm{hinge}} = \beta_{\mathrm{twist}}\frac{\lvert m_2\rvert}{L_a}")
.given(&[Given::new(r"\alpha_{\mathrm{twist}},\ \beta_{\mathrm{twist}}", &TwistFactors::SPEC)])
        // The largest η that `audit --attack` found is 1.13 for the value, and 2.25 is possible to first order; for the Jacobian 2.96
        // and 5.33.
        .eta(2.5, 5.5)
        .scale(1e50)
        .finite(Finite::Between);
    type Inputs<T: Component> = Twist<T>;
    type Outputs<T: Component> = TwistLoads<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Twist<D>) -> TwistLoads<D> {
        i.loads(&TwistFactors::eval(&i.arm()))
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Twist<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &Twist<D>) -> (TwistLoads<D>, Jacobian<Self, D>) {
        let (shares, slope) = TwistFactors::linearized(&i.arm());
        let (m_twist, s) = (abs(i.m2), sign(i.m2));
        let (f_twist, beta_per_la) = (m_twist / i.la, shares.beta_twist / i.la);
        let jacobian = TwistLoads {
            m_twist_hinge: Twist {
                m2: shares.alpha_twist * s,
                la: slope.alpha_twist.la * m_twist,
                rp: slope.alpha_twist.rp * m_twist,
            },
            f_twist_hinge: Twist {
                m2: beta_per_la * s,
                la: (slope.beta_twist.la - beta_per_la) * f_twist,
                rp: slope.beta_twist.rp * f_twist,
            },
        };
        (i.loads(&shares), jacobian)
    }
}

impl<D: Scalar> Twist<D> {
    #[inline]
    fn arm(&self) -> Arm<D> {
        Arm { la: self.la, rp: self.rp }
    }
    #[inline]
    fn loads(&self, shares: &TwistShares<D>) -> TwistLoads<D> {
        let m_twist = abs(self.m2);
        TwistLoads {
            m_twist_hinge: shares.alpha_twist * m_twist,
            f_twist_hinge: shares.beta_twist * (m_twist / self.la),
        }
    }
}
