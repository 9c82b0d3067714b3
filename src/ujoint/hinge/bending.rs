//! The bending moments on a hinge.

use super::{HingeTwist, Twist, TwistLoads};
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{CROSS_F_BEND, F_TOTAL_BEND, LA, LS, M_BEND_HINGE, M_TOTAL_HINGE, RP, TWIST_M2};
use crate::scalar::{Scalar, abs, norm, norm_and_direction, sign};
use crate::verify::{hard, law};

fields! {
    /// What bends the arms, an arm, and the length of its sleeve.
    pub struct Bending<T> { f_bend: T = CROSS_F_BEND, m2: T = TWIST_M2, la: T = LA, rp: T = RP, ls: T = LS }
}
fields! {
    /// Bending moments on each hinge, and the contact force that resists them.
    pub struct BendingLoads<T> { m_bend_hinge: T = M_BEND_HINGE, m_total_hinge: T = M_TOTAL_HINGE, f_total_bend: T = F_TOTAL_BEND }
}

/// The bending moments on each hinge, M_bend = |F_bend| La/8 and M_total = √(M_bend² + M_twist²), and the contact force at
/// both ends of the sleeve that resists them: 2 M_total/Ls, nothing where Ls = 0.
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
    pub(in crate::ujoint) fn slope_of_moments(&self, [bend, twist]: [D; 2], by_twist: &Twist<D>) -> Self {
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

/// The bending moments on a hinge from the force across the cross and from the twisting moment, at right angles.
#[inline]
pub(in crate::ujoint) fn bending<D: Scalar>(f_bend: D, la: D, twist: &TwistLoads<D>) -> [D; 2] {
    [abs(f_bend) * la * 0.125, twist.m_twist_hinge]
}

/// The contact force that resists a bending moment, half of it at either end of the sleeve; none where Ls = 0.
#[inline]
pub(in crate::ujoint) fn in_sleeve<D: Scalar>(moment: D, ls: D) -> D {
    if ls == 0.0 { D::zero() } else { moment * 2.0 / ls }
}

impl Formula for HingeBending {
    const SPEC: Spec = Spec {
        id: "ujoint.hinge_bending",
        title: "Bending moment on a hinge",
        latex: r"M_{\mathrm{bend}}^{\mathrm{hinge}} = \tfrac18\lvert F_{\mathrm{bend}}\rvert L_a,\quad M_{\mathrm{total}}^{\mathrm{hinge}} = \sqrt{\left(M_{\mathrm{bend}}^{\mathrm{hinge}}\right)^2 + \left(M_{\mathrm{twist}}^{\mathrm{hinge}}\right)^2},\quad F_{\mathrm{total}}^{\mathrm{bend}} = \frac{2 M_{\mathrm{total}}^{\mathrm{hinge}}}{L_s}\ (0\text{ if }L_s = 0)",
        source: Source::UJOINT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = Bending<T>;
    type Outputs<T: Element> = BendingLoads<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Bending<D>) -> BendingLoads<D> {
        let moments = bending(i.f_bend, i.la, &HingeTwist::eval(&i.twist()));
        let m_total_hinge = norm(moments);
        BendingLoads { m_bend_hinge: moments[0], m_total_hinge, f_total_bend: in_sleeve(m_total_hinge, i.ls) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Bending<D>) -> Jacobian<Self, D> {
        let (twist, TwistLoads { m_twist_hinge: by_twist, .. }) = HingeTwist::linearized(&i.twist());
        let (m_total, direction) = norm_and_direction(bending(i.f_bend, i.la, &twist));
        let press = |slope: D| in_sleeve(slope, i.ls);
        BendingLoads {
            m_bend_hinge: i.slope_of_moments([D::one(), D::zero()], &by_twist),
            m_total_hinge: i.slope_of_moments(direction, &by_twist),
            f_total_bend: Bending {
                ls: if i.ls == 0.0 { D::zero() } else { -press(m_total) / i.ls },
                ..i.slope_of_moments(direction.map(press), &by_twist)
            },
        }
    }

    fn cases() -> Vec<Case<Bending<f64>>> {
        let hand = Bending { f_bend: -8.0, m2: 304.0, la: 44.0, rp: 20.0 / 3.0, ls: 11.0 };
        let mut cases = vec![
            Case::hand("pythagoras", "λ = 6.6 but for rounding: M_bend = 44, M_twist = 33, M_total = 55, F = 10", hand),
            Case::hand("force-alone", "M_bend = 44, F = 8", Bending { m2: 0.0, ..hand }),
            Case::hand(
                "moment-alone",
                "M_twist = 33: |F_bend| at 0",
                Bending { f_bend: 0.0, la: 33.0, rp: 5.0, ..hand },
            ),
            Case::limit("no-sleeve", "Ls = 0: M_total is left out", Bending { ls: 0.0, ..hand }),
            Case::limit("stubby", "λ → 0: the twisting moment does not bend", Bending { la: 1e-9, ..hand }),
            Case::limit("long", "λ → ∞: |m2|/8", Bending { la: 1e9, ..hand }),
            Case::hard("no-sleeve-unloaded", "Ls = 0 and no load", Bending { f_bend: 0.0, m2: 0.0, ls: 0.0, ..hand }),
            Case::hard("short-sleeve", "Ls of 1e-12", Bending { ls: 1e-12, ..hand }),
            Case::hard("vanishing-sleeve", "Ls of 1e-100", Bending { ls: 1e-100, ..hand }),
        ];
        cases.extend(hard::loads().into_iter().map(|load| {
            let [f_bend, m2] = load.value;
            Case::hard(format!("loads-{}", load.id), load.comment, Bending { f_bend, m2, ..hand })
        }));
        cases.extend(hard::arms().into_iter().map(|arm| {
            let [la, rp] = arm.value;
            Case::hard(arm.id, arm.comment, Bending { m2: -2.5 * la, la, rp, ls: la, ..hand })
        }));
        cases.extend(hard::loaded_arms().into_iter().map(|arm| {
            let [la, rp, size] = arm.value;
            Case::hard(arm.id, arm.comment, Bending { f_bend: 5.0 * size, m2: -11.0 * size, la, rp, ls: rp })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: "L_s = 0",
                convention: Convention::Switch,
                holds: |i| i.ls == 0.0,
                at: || Bending { f_bend: -8.0, m2: 304.0, la: 33.0, rp: 5.0, ls: 0.0 },
                across: || Bending { ls: 1.0, ..Bending::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{bend}} = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f_bend == 0.0,
                at: || Bending { f_bend: 0.0, m2: 304.0, la: 33.0, rp: 5.0, ls: 11.0 },
                across: || Bending { f_bend: 1.0, ..Bending::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{bend}} = m_2 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f_bend == 0.0 && i.m2 == 0.0,
                at: || Bending { f_bend: 0.0, m2: 0.0, la: 33.0, rp: 5.0, ls: 11.0 },
                across: || Bending { m2: 1.0, ..Bending::filled(0.0) },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "the contact force, half of it at either end of the sleeve, resists the moment: F Ls/2 = M_total",
                sides: |i| {
                    let out = Self::eval(i);
                    law::equal(out.f_total_bend * i.ls * 0.5, out.m_total_hinge)
                },
            },
            Law {
                statement: "M_bend and M_twist are at right angles",
                sides: |i| {
                    let (out, twist) = (Self::eval(i), HingeTwist::eval(&i.twist()).m_twist_hinge);
                    let squares = out.m_bend_hinge * out.m_bend_hinge + twist * twist;
                    law::equal(out.m_total_hinge * out.m_total_hinge, squares)
                },
            },
        ]
    }
}
