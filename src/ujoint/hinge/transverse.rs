//! The whole transverse force on a hinge.

use super::{AxialForces, HingeAxial, HingeTwist, Twist, TwistLoads};
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{CROSS_F_BEND, F_AXIAL1, F_AXIAL3, F_TOTAL_HINGE1, F_TOTAL_HINGE3, LA, RP, TWIST_M2};
use crate::scalar::{Scalar, direction, norm};
use crate::verify::{hard, law};

fields! {
    /// All loads at the centre of the cross, and an arm.
    pub struct CentreLoads<T> {
        f_axial1: T = F_AXIAL1, f_axial3: T = F_AXIAL3, f_bend: T = CROSS_F_BEND, m2: T = TWIST_M2, la: T = LA, rp: T = RP,
    }
}
fields! {
    /// Whole transverse force on each hinge.
    pub struct TransverseForces<T> { f_total_hinge1: T = F_TOTAL_HINGE1, f_total_hinge3: T = F_TOTAL_HINGE3 }
}

/// The whole transverse force on each hinge: a quarter of the force across the cross, the force of the twisting moment
/// and that of the other axis, at right angles to one another.
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

/// The three transverse forces on a hinge, at right angles to one another.
#[inline]
pub(in crate::ujoint) fn transverse<D: Scalar>(f_bend: D, twist: &TwistLoads<D>, f_transv: D) -> [D; 3] {
    [f_bend * 0.25, twist.f_twist_hinge, f_transv]
}

impl Formula for HingeTransverse {
    const SPEC: Spec = Spec {
        id: "ujoint.hinge_transverse",
        title: "Transverse force on a hinge",
        latex: r"F_{\mathrm{total}k}^{\mathrm{hinge}} = \sqrt{\left(\tfrac14 F_{\mathrm{bend}}\right)^2 + \left(F_{\mathrm{twist}}^{\mathrm{hinge}}\right)^2 + \left(F_{\mathrm{transv}k}^{\mathrm{hinge}}\right)^2}\quad (k = 1, 3)",
        source: Source::UJOINT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = CentreLoads<T>;
    type Outputs<T: Element> = TransverseForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CentreLoads<D>) -> TransverseForces<D> {
        let (twist, axial) = (HingeTwist::eval(&i.twist()), HingeAxial::eval(&i.axial()));
        let total = |f_transv| norm(transverse(i.f_bend, &twist, f_transv));
        TransverseForces { f_total_hinge1: total(axial.f_transv_hinge1), f_total_hinge3: total(axial.f_transv_hinge3) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CentreLoads<D>) -> Jacobian<Self, D> {
        let (twist, twist_slope) = HingeTwist::linearized(&i.twist());
        let (axial, axial_slope) = HingeAxial::linearized(&i.axial());
        let by_twist = twist_slope.f_twist_hinge;
        let row = |f_transv, by_push: AxialForces<D>| {
            let [bend, twist, push] = direction(transverse(i.f_bend, &twist, f_transv));
            CentreLoads {
                f_axial1: push * by_push.f_axial1,
                f_axial3: push * by_push.f_axial3,
                f_bend: bend * 0.25,
                m2: twist * by_twist.m2,
                la: twist * by_twist.la + push * by_push.la,
                rp: twist * by_twist.rp + push * by_push.rp,
            }
        };
        TransverseForces {
            f_total_hinge1: row(axial.f_transv_hinge1, axial_slope.f_transv_hinge1),
            f_total_hinge3: row(axial.f_transv_hinge3, axial_slope.f_transv_hinge3),
        }
    }

    fn cases() -> Vec<Case<CentreLoads<f64>>> {
        let hand = CentreLoads { f_axial1: 80.0, f_axial3: -20.0, f_bend: 16.0, m2: 0.0, la: 2.0, rp: 1.0 };
        let mut cases = vec![
            Case::hand("no-twist", "β = 0.15: √(4² + 3²) = 5, √(4² + 12²)", hand),
            Case::hand(
                "bending-alone",
                "a quarter of the force on each hinge",
                CentreLoads { f_axial1: 0.0, f_axial3: 0.0, ..hand },
            ),
            Case::limit("stubby", "λ → 0: quarters of all three", CentreLoads { m2: 8e-9, la: 1e-9, ..hand }),
            Case::limit(
                "long",
                "λ → ∞: 3/8 of |m2|/La, nothing of the other axis",
                CentreLoads { m2: 8e9, la: 1e9, ..hand },
            ),
        ];
        cases.extend(hard::loads().into_iter().map(|load| {
            let [f_axial1, f_axial3, f_bend, m2] = load.value;
            Case::hard(
                format!("loads-{}", load.id),
                load.comment,
                CentreLoads { f_axial1, f_axial3, f_bend, m2, ..hand },
            )
        }));
        for (id, [f_axial1, f_axial3, f_bend, m2]) in [
            ("f_axial3-alone", [0.0, -2.5, 0.0, 0.0]),
            ("f_bend-alone", [0.0, 0.0, 2.5, 0.0]),
            ("f_axial1-missing", [0.0, 1.0, 2.0, 3.0]),
            ("f_axial3-missing", [1.0, 0.0, 2.0, 3.0]),
            ("f_bend-missing", [1.0, -1.0, 0.0, 3.0]),
        ] {
            cases.push(Case::hard(id, "loads that are 0", CentreLoads { f_axial1, f_axial3, f_bend, m2, ..hand }));
        }
        cases.extend(hard::arms().into_iter().map(|arm| {
            let [la, rp] = arm.value;
            Case::hard(arm.id, arm.comment, CentreLoads { m2: -2.5 * la, la, rp, ..hand })
        }));
        cases.extend(hard::loaded_arms().into_iter().map(|arm| {
            let [la, rp, size] = arm.value;
            let [f_axial1, f_axial3, f_bend, m2] = [-3.0, 7.0, 5.0, -11.0].map(|load| load * size);
            Case::hard(arm.id, arm.comment, CentreLoads { f_axial1, f_axial3, f_bend, m2, la, rp })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: r"F_{\mathrm{bend}} = m_2 = F_{\mathrm{axial3}} = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f_bend == 0.0 && i.m2 == 0.0 && i.f_axial3 == 0.0,
                at: || CentreLoads { f_axial1: 80.0, la: 2.0, rp: 1.0, ..CentreLoads::filled(0.0) },
                across: || CentreLoads { f_bend: 1.0, ..CentreLoads::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{bend}} = m_2 = F_{\mathrm{axial1}} = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f_bend == 0.0 && i.m2 == 0.0 && i.f_axial1 == 0.0,
                at: || CentreLoads { f_axial3: -20.0, la: 2.0, rp: 1.0, ..CentreLoads::filled(0.0) },
                across: || CentreLoads { m2: 1.0, ..CentreLoads::filled(0.0) },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "reversing any load leaves it",
                sides: |i| {
                    let out = Self::eval(i);
                    let reversed = [
                        CentreLoads { f_axial1: -i.f_axial1, f_bend: -i.f_bend, ..*i },
                        CentreLoads { f_axial3: -i.f_axial3, m2: -i.m2, ..*i },
                    ];
                    let pairs = reversed.iter().flat_map(|reversed| {
                        let reversed = Self::eval(reversed);
                        [(out.f_total_hinge1, reversed.f_total_hinge1), (out.f_total_hinge3, reversed.f_total_hinge3)]
                    });
                    law::equal_all(pairs)
                },
            },
            Law {
                statement: "exchanging the axial forces exchanges the hinges",
                sides: |i| {
                    let out = Self::eval(i);
                    let exchanged = Self::eval(&CentreLoads { f_axial1: i.f_axial3, f_axial3: i.f_axial1, ..*i });
                    law::equal_all([
                        (out.f_total_hinge1, exchanged.f_total_hinge3),
                        (out.f_total_hinge3, exchanged.f_total_hinge1),
                    ])
                },
            },
        ]
    }
}
