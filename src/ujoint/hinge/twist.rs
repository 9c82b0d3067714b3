//! What the twisting moment makes on a hinge.

use crate::fields;
use crate::formula::{Case, Convention, Element, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{F_TWIST_HINGE, LA, M_TWIST_HINGE, RP, TWIST_M2};
use crate::scalar::{Scalar, abs, sign};
use crate::ujoint::{Arm, TwistFactors, TwistShares};
use crate::verify::{hard, law};

fields! {
    /// The twisting moment, and an arm.
    pub struct Twist<T> { m2: T = TWIST_M2, la: T = LA, rp: T = RP }
}
fields! {
    /// Moment and force on each hinge.
    pub struct TwistLoads<T> { m_twist_hinge: T = M_TWIST_HINGE, f_twist_hinge: T = F_TWIST_HINGE }
}

/// What the twisting moment M_twist = |m2| makes on each hinge: the moment α_twist M_twist about the direction across
/// the cross, and the force β_twist M_twist/La in its plane.
#[derive(Clone, Copy, Debug)]
pub struct HingeTwist;

impl Formula for HingeTwist {
    const SPEC: Spec = Spec {
        id: "ujoint.hinge_twist",
        title: "Hinge loads of the twisting moment",
        latex: r"M_{\mathrm{twist}}^{\mathrm{hinge}} = \alpha_{\mathrm{twist}}\lvert m_2\rvert,\quad F_{\mathrm{twist}}^{\mathrm{hinge}} = \beta_{\mathrm{twist}}\frac{\lvert m_2\rvert}{L_a}",
        source: Source::UJOINT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = Twist<T>;
    type Outputs<T: Element> = TwistLoads<T>;

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

    fn cases() -> Vec<Case<Twist<f64>>> {
        let hand = Twist { m2: -304.0, la: 33.0, rp: 5.0 };
        let mut cases = vec![
            Case::hand("lambda-6.6", "α = 33/304, β = 109/304: M = 33, F = 109/33", hand),
            Case::limit("stubby", "λ → 0: no moment, a quarter of |m2|/La", Twist { m2: 8.0, la: 1e-9, rp: 1.0 }),
            Case::limit("long", "λ → ∞: |m2|/8, 3/8 of |m2|/La", Twist { m2: 8.0, la: 1e9, rp: 1.0 }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m2] = load.value;
            Case::hard(format!("moment-{}", load.id), load.comment, Twist { m2, ..hand })
        }));
        cases.extend(hard::arms().into_iter().map(|arm| {
            let [la, rp] = arm.value;
            Case::hard(arm.id, arm.comment, Twist { m2: -2.5 * la, la, rp })
        }));
        cases.extend(hard::loaded_arms().into_iter().map(|arm| {
            let [la, rp, m2] = arm.value;
            Case::hard(arm.id, arm.comment, Twist { m2, la, rp })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: "m_2 = 0",
            convention: Convention::Subgradient,
            holds: |i| i.m2 == 0.0,
            at: || Twist { m2: 0.0, la: 33.0, rp: 5.0 },
            across: || Twist { m2: 1.0, la: 0.0, rp: 0.0 },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "moments about the centre: four hinges bear F La − M each, together |m2|",
            sides: |i| {
                let TwistLoads { m_twist_hinge, f_twist_hinge } = Self::eval(i);
                law::equal((f_twist_hinge * i.la - m_twist_hinge) * 4.0, abs(i.m2))
            },
        }]
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
