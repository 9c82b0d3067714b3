//! What the loads at the centre of the cross make of forces and moments on its four hinges.

use super::{Arm, AxialFactors, AxialShares, TwistFactors, TwistShares};
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{
    F_AXIAL_HINGE1, F_AXIAL_HINGE3, F_AXIAL1, F_AXIAL3, CROSS_F_BEND, F_TOTAL_BEND, F_TOTAL_HINGE1, F_TOTAL_HINGE3,
    F_TRANSV_HINGE1, F_TRANSV_HINGE3, F_TWIST_HINGE, LA, LS, M_BEND_HINGE, M_TOTAL_HINGE, M_TWIST_HINGE, RP, TWIST_M2,
};
use crate::scalar::{Scalar, abs, direction, norm, norm_and_direction, sign};
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
        TwistLoads { m_twist_hinge: shares.alpha_twist * m_twist, f_twist_hinge: shares.beta_twist * (m_twist / self.la) }
    }
}

fields! {
    /// The force along the axes of the cross, and an arm.
    pub struct AxialForces<T> { f_axial1: T = F_AXIAL1, f_axial3: T = F_AXIAL3, la: T = LA, rp: T = RP }
}
fields! {
    /// Axial and transverse force on each hinge.
    pub struct AxialLoads<T> {
        f_axial_hinge1: T = F_AXIAL_HINGE1, f_axial_hinge3: T = F_AXIAL_HINGE3,
        f_transv_hinge1: T = F_TRANSV_HINGE1, f_transv_hinge3: T = F_TRANSV_HINGE3,
    }
}

/// What the axial forces make on each hinge: a force along an axis pulls on the two hinges of that axis with α_axial of its
/// size, and pushes the two of the other axis sideways with β_axial of it.
#[derive(Clone, Copy, Debug)]
pub struct HingeAxial;

impl Formula for HingeAxial {
    const SPEC: Spec = Spec {
        id: "ujoint.hinge_axial",
        title: "Hinge loads of the axial forces",
        latex: r"F_{\mathrm{axial}k}^{\mathrm{hinge}} = \alpha_{\mathrm{axial}}\lvert F_{\mathrm{axial}k}\rvert\ (k = 1, 3),\quad F_{\mathrm{transv1}}^{\mathrm{hinge}} = \beta_{\mathrm{axial}}\lvert F_{\mathrm{axial3}}\rvert,\quad F_{\mathrm{transv3}}^{\mathrm{hinge}} = \beta_{\mathrm{axial}}\lvert F_{\mathrm{axial1}}\rvert",
        source: Source::UJOINT.section("Friction"),
        eta: 2.0,
        eta_jacobian: 4.0,
        objective: true,
    };
    type Inputs<T: Element> = AxialForces<T>;
    type Outputs<T: Element> = AxialLoads<T>;

    #[inline]
    fn eval<D: Scalar>(i: &AxialForces<D>) -> AxialLoads<D> {
        i.loads(&AxialFactors::eval(&i.arm()))
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &AxialForces<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &AxialForces<D>) -> (AxialLoads<D>, Jacobian<Self, D>) {
        let (shares, slopes) = AxialFactors::linearized(&i.arm());
        let zero = D::zero();
        let by_1 = |share: D, slope: Arm<D>| {
            let (f, s) = (abs(i.f_axial1), sign(i.f_axial1));
            AxialForces { f_axial1: share * s, f_axial3: zero, la: slope.la * f, rp: slope.rp * f }
        };
        let by_3 = |share: D, slope: Arm<D>| {
            let (f, s) = (abs(i.f_axial3), sign(i.f_axial3));
            AxialForces { f_axial1: zero, f_axial3: share * s, la: slope.la * f, rp: slope.rp * f }
        };
        let jacobian = AxialLoads {
            f_axial_hinge1: by_1(shares.alpha_axial, slopes.alpha_axial),
            f_axial_hinge3: by_3(shares.alpha_axial, slopes.alpha_axial),
            f_transv_hinge1: by_3(shares.beta_axial, slopes.beta_axial),
            f_transv_hinge3: by_1(shares.beta_axial, slopes.beta_axial),
        };
        (i.loads(&shares), jacobian)
    }

    fn cases() -> Vec<Case<AxialForces<f64>>> {
        let hand = AxialForces { f_axial1: -20.0, f_axial3: 10.0, la: 2.0, rp: 1.0 };
        let mut cases = vec![
            Case::hand("lambda-2", "α = 0.35, β = 0.15: 7, 3.5 along, 1.5, 3 across", hand),
            Case::limit("stubby", "λ → 0: a quarter everywhere", AxialForces { la: 1e-9, ..hand }),
            Case::limit("long", "λ → ∞: half along, nothing across", AxialForces { la: 1e9, ..hand }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [f_axial1, f_axial3] = load.value;
            Case::hard(format!("forces-{}", load.id), load.comment, AxialForces { f_axial1, f_axial3, ..hand })
        }));
        cases.extend(hard::arms().into_iter().map(|arm| {
            let [la, rp] = arm.value;
            Case::hard(arm.id, arm.comment, AxialForces { la, rp, ..hand })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: r"F_{\mathrm{axial1}} = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f_axial1 == 0.0,
                at: || AxialForces { f_axial1: 0.0, f_axial3: 10.0, la: 2.0, rp: 1.0 },
                across: || AxialForces { f_axial1: 1.0, ..AxialForces::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{axial3}} = 0",
                convention: Convention::Subgradient,
                holds: |i| i.f_axial3 == 0.0,
                at: || AxialForces { f_axial1: -20.0, f_axial3: 0.0, la: 2.0, rp: 1.0 },
                across: || AxialForces { f_axial3: 1.0, ..AxialForces::filled(0.0) },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "two hinges along the force and two across it carry the whole of it",
            sides: |i| {
                let out = Self::eval(i);
                law::equal_all([
                    ((out.f_axial_hinge1 + out.f_transv_hinge3) * 2.0, abs(i.f_axial1)),
                    ((out.f_axial_hinge3 + out.f_transv_hinge1) * 2.0, abs(i.f_axial3)),
                ])
            },
        }]
    }
}

impl<D: Scalar> AxialForces<D> {
    #[inline]
    fn arm(&self) -> Arm<D> {
        Arm { la: self.la, rp: self.rp }
    }
    #[inline]
    fn loads(&self, shares: &AxialShares<D>) -> AxialLoads<D> {
        let (f1, f3) = (abs(self.f_axial1), abs(self.f_axial3));
        AxialLoads {
            f_axial_hinge1: shares.alpha_axial * f1,
            f_axial_hinge3: shares.alpha_axial * f3,
            f_transv_hinge1: shares.beta_axial * f3,
            f_transv_hinge3: shares.beta_axial * f1,
        }
    }
}

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

/// The three transverse forces on a hinge of either axis, at right angles to one another.
#[inline]
pub(super) fn transverse<D: Scalar>(f_bend: D, twist: &TwistLoads<D>, axial: &AxialLoads<D>) -> [[D; 3]; 2] {
    [axial.f_transv_hinge1, axial.f_transv_hinge3].map(|f_transv| [f_bend * 0.25, twist.f_twist_hinge, f_transv])
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
        let [f_total_hinge1, f_total_hinge3] = transverse(i.f_bend, &twist, &axial).map(norm);
        TransverseForces { f_total_hinge1, f_total_hinge3 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CentreLoads<D>) -> Jacobian<Self, D> {
        let (twist, twist_slope) = HingeTwist::linearized(&i.twist());
        let (axial, axial_slope) = HingeAxial::linearized(&i.axial());
        let row = |[bend, twist, transv]: [D; 3], by_twist: Twist<D>, by_transv: AxialForces<D>| CentreLoads {
            f_axial1: transv * by_transv.f_axial1,
            f_axial3: transv * by_transv.f_axial3,
            f_bend: bend * 0.25,
            m2: twist * by_twist.m2,
            la: twist * by_twist.la + transv * by_transv.la,
            rp: twist * by_twist.rp + transv * by_transv.rp,
        };
        let [hinge1, hinge3] = transverse(i.f_bend, &twist, &axial).map(direction);
        TransverseForces {
            f_total_hinge1: row(hinge1, twist_slope.f_twist_hinge, axial_slope.f_transv_hinge1),
            f_total_hinge3: row(hinge3, twist_slope.f_twist_hinge, axial_slope.f_transv_hinge3),
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
            Case::limit("long", "λ → ∞: 3/8 of |m2|/La, nothing of the other axis", CentreLoads { m2: 8e9, la: 1e9, ..hand }),
        ];
        cases.extend(hard::loads().into_iter().map(|load| {
            let [f_axial1, f_axial3, f_bend, m2] = load.value;
            Case::hard(format!("loads-{}", load.id), load.comment, CentreLoads { f_axial1, f_axial3, f_bend, m2, ..hand })
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
}

/// The bending moments on a hinge from the force across the cross and from the twisting moment, at right angles.
#[inline]
pub(super) fn bending<D: Scalar>(f_bend: D, la: D, twist: &TwistLoads<D>) -> [D; 2] {
    [abs(f_bend) * la * 0.125, twist.m_twist_hinge]
}

/// The contact force that resists a bending moment, half of it at either end of the sleeve; none where Ls = 0.
#[inline]
pub(super) fn in_sleeve<D: Scalar>(moment: D, ls: D) -> D {
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
        let (twist, twist_slope) = HingeTwist::linearized(&i.twist());
        let by_twist = twist_slope.m_twist_hinge;
        let (m_total, [bend, twist]) = norm_and_direction(bending(i.f_bend, i.la, &twist));
        let zero = Bending::filled(D::zero());
        let m_bend_hinge = Bending { f_bend: i.la * (0.125 * sign(i.f_bend)), la: abs(i.f_bend) * 0.125, ..zero };
        let m_total_hinge = Bending {
            f_bend: bend * m_bend_hinge.f_bend,
            m2: twist * by_twist.m2,
            la: bend * m_bend_hinge.la + twist * by_twist.la,
            rp: twist * by_twist.rp,
            ls: zero.ls,
        };
        let f_total_bend = Bending {
            f_bend: in_sleeve(m_total_hinge.f_bend, i.ls),
            m2: in_sleeve(m_total_hinge.m2, i.ls),
            la: in_sleeve(m_total_hinge.la, i.ls),
            rp: in_sleeve(m_total_hinge.rp, i.ls),
            ls: if i.ls == 0.0 { D::zero() } else { -in_sleeve(m_total, i.ls) / i.ls },
        };
        BendingLoads { m_bend_hinge, m_total_hinge, f_total_bend }
    }

    fn cases() -> Vec<Case<Bending<f64>>> {
        let hand = Bending { f_bend: -8.0, m2: 304.0, la: 44.0, rp: 20.0 / 3.0, ls: 11.0 };
        let mut cases = vec![
            Case::hand("pythagoras", "λ = 6.6 but for rounding: M_bend = 44, M_twist = 33, M_total = 55, F = 10", hand),
            Case::hand("force-alone", "M_bend = 44, F = 8", Bending { m2: 0.0, ..hand }),
            Case::hand("moment-alone", "M_twist = 33: |F_bend| at 0", Bending { f_bend: 0.0, la: 33.0, rp: 5.0, ..hand }),
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
