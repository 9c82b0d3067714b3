//! What presses the parts of a TRANSLATOR together: torque, radial force and bending, each for itself.

use crate::Octuple;
use crate::fields;
use crate::formula::{Case, Convention, Element, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{F_BEND, F_TORQ, FR, L_OVERLAP, M_BEND, M_TORQ, M1, M2, M3, RR};
use crate::scalar::{Scalar, abs, norm, norm_and_direction, sign};
use crate::slot::{self, CrossForces};
use crate::verify::{hard, law};

fields! {
    /// The torque, and its lever.
    pub struct Torque<T> { m1: T = M1, rr: T = RR }
}
fields! {
    /// Magnitude of the torque, and the contact force that it produces.
    pub struct TorqueContact<T> { m_torq: T = M_TORQ, f_torq: T = F_TORQ }
}

/// Contact force from torque: `M_torq = |m1|`, `F_torq = M_torq/R_r`; 0 if `R_r = 0`.
#[derive(Clone, Copy, Debug)]
pub struct TorqueForce;

impl Formula for TorqueForce {
    const SPEC: Spec = Spec {
        id: "translator.torque_force",
        title: "Contact force from torque",
        latex: r"M_{\mathrm{torq}} = \lvert m_1\rvert,\quad F_{\mathrm{torq}} = \frac{M_{\mathrm{torq}}}{R_r}\quad(0\text{ if }R_r = 0)",
        source: Source::TRANSLATOR.section("Friction"),
        eta: 0.5,
        eta_jacobian: 0.5,
        objective: true,
    };
    type Inputs<T: Element> = Torque<T>;
    type Outputs<T: Element> = TorqueContact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Torque<D>) -> TorqueContact<D> {
        let m_torq = abs(i.m1);
        TorqueContact { m_torq, f_torq: if i.rr == 0.0 { D::zero() } else { m_torq / i.rr } }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Torque<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &Torque<D>) -> (TorqueContact<D>, Jacobian<Self, D>) {
        let (zero, s) = (D::zero(), D::from(sign(i.m1)));
        let TorqueContact { m_torq, f_torq } = Self::eval(i);
        let by_lever =
            if i.rr == 0.0 { Torque { m1: zero, rr: zero } } else { Torque { m1: s / i.rr, rr: -f_torq / i.rr } };
        (TorqueContact { m_torq, f_torq }, TorqueContact { m_torq: Torque { m1: s, rr: zero }, f_torq: by_lever })
    }

    fn cases() -> Vec<Case<Torque<f64>>> {
        let hand = Torque { m1: -6.0, rr: 0.5 };
        vec![
            Case::hand("shaft", "|-6| / 0.5 = 12", hand),
            Case::limit("no-radius", "R_r = 0: the torque is ignored", Torque { rr: 0.0, ..hand }),
            Case::hard("no-torque", "m1 = 0: derivative 0 by convention", Torque { m1: 0.0, ..hand }),
            Case::hard("nothing", "neither torque nor radius", Torque { m1: 0.0, rr: 0.0 }),
            Case::hard("thirds", "a quotient that is not a double", Torque { m1: 1.0, rr: 3.0 }),
            Case::hard("tiny", "1e-200 on a radius of 1e-12", Torque { m1: 1e-200, rr: 1e-12 }),
            Case::hard("huge", "1e200 on a radius of 1e-12", Torque { m1: -1e200, rr: 1e-12 }),
            Case::hard("wide", "a radius of 1e12", Torque { m1: 7.0, rr: 1e12 }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: "R_r = 0",
                convention: Convention::Switch,
                holds: |i| i.rr == 0.0,
                at: || Torque { m1: -6.0, rr: 0.0 },
                across: || Torque { m1: 0.0, rr: 1.0 },
            },
            Kink {
                condition: "m_1 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.m1 == 0.0,
                at: || Torque { m1: 0.0, rr: 0.5 },
                across: || Torque { m1: 1.0, rr: 0.0 },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "reversing the torque leaves it",
                sides: |i| law::equal(Self::eval(i).f_torq, Self::eval(&Torque { m1: -i.m1, ..*i }).f_torq),
            },
            Law {
                statement: "the contact force at its lever is the torque: F_torq R_r = M_torq",
                sides: |i| law::equal(Self::eval(i).f_torq * i.rr, Self::eval(i).m_torq),
            },
        ]
    }
}

fields! {
    /// Contact force from the force across the slot.
    pub struct RadialContact<T> { fr: T = FR }
}

/// Contact force from the force across the slot, which is that of a SLOT: `F_r = √(f2² + f3²)`.
#[derive(Clone, Copy, Debug)]
pub struct RadialForce;

impl Formula for RadialForce {
    const SPEC: Spec = Spec {
        id: "translator.radial_force",
        title: "Radial contact force",
        latex: r"F_r = \sqrt{f_2^2 + f_3^2}",
        source: Source::TRANSLATOR.section("Friction"),
        eta: 1.0,
        eta_jacobian: 3.0,
        objective: true,
    };
    type Inputs<T: Element> = CrossForces<T>;
    type Outputs<T: Element> = RadialContact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossForces<D>) -> RadialContact<D> {
        RadialContact { fr: slot::ContactForce::eval(i).fc }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossForces<D>) -> Jacobian<Self, D> {
        RadialContact { fr: slot::ContactForce::jacobian(i).fc }
    }

    #[inline]
    fn linearized<D: Scalar>(i: &CrossForces<D>) -> (RadialContact<D>, Jacobian<Self, D>) {
        let (value, jacobian) = slot::ContactForce::linearized(i);
        (RadialContact { fr: value.fc }, RadialContact { fr: jacobian.fc })
    }

    fn cases() -> Vec<Case<CrossForces<f64>>> {
        slot::ContactForce::cases()
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: "f_2 = f_3 = 0",
            convention: Convention::Subgradient,
            holds: |i| i.f2 == 0.0 && i.f3 == 0.0,
            at: || CrossForces { f2: 0.0, f3: 0.0 },
            across: || CrossForces { f2: 1.0, f3: 0.0 },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "it is the contact force of a SLOT",
                sides: |i| law::equal(Self::eval(i).fr, slot::ContactForce::eval(i).fc),
            },
            Law {
                statement: "turning the force about the slot leaves it",
                sides: |i| {
                    let [c, s] = [3.0, 4.0].map(Octuple::from);
                    let turned = CrossForces { f2: i.f2 * c - i.f3 * s, f3: i.f2 * s + i.f3 * c };
                    law::equal(Self::eval(i).fr * 5.0, Self::eval(&turned).fr)
                },
            },
        ]
    }
}

fields! {
    /// The bending moments, and the length over which they are carried.
    pub struct Bending<T> { m2: T = M2, m3: T = M3, l: T = L_OVERLAP }
}
fields! {
    /// Magnitude of the bending moment, and the contact force that it produces.
    pub struct BendingContact<T> { m_bend: T = M_BEND, f_bend: T = F_BEND }
}

/// Contact force from bending: `M_bend = √(m2² + m3²)`, `F_bend = 2 M_bend/L`; 0 if L = 0.
#[derive(Clone, Copy, Debug)]
pub struct BendingForce;

impl Formula for BendingForce {
    const SPEC: Spec = Spec {
        id: "translator.bending_force",
        title: "Contact force from bending",
        latex: r"M_{\mathrm{bend}} = \sqrt{m_2^2 + m_3^2},\quad F_{\mathrm{bend}} = \frac{2 M_{\mathrm{bend}}}{L}\quad(0\text{ if }L = 0)",
        source: Source::TRANSLATOR.section("Friction"),
        eta: 1.0,
        eta_jacobian: 3.0,
        objective: true,
    };
    type Inputs<T: Element> = Bending<T>;
    type Outputs<T: Element> = BendingContact<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Bending<D>) -> BendingContact<D> {
        let m_bend = norm([i.m2, i.m3]);
        BendingContact { m_bend, f_bend: if i.l == 0.0 { D::zero() } else { m_bend * 2.0 / i.l } }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Bending<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &Bending<D>) -> (BendingContact<D>, Jacobian<Self, D>) {
        let zero = D::zero();
        let (m_bend, [n2, n3]) = norm_and_direction([i.m2, i.m3]);
        let by_moment = Bending { m2: n2, m3: n3, l: zero };
        let (f_bend, by_length) = if i.l == 0.0 {
            (zero, Bending { m2: zero, m3: zero, l: zero })
        } else {
            let f_bend = m_bend * 2.0 / i.l;
            (f_bend, Bending { m2: n2 * 2.0 / i.l, m3: n3 * 2.0 / i.l, l: -f_bend / i.l })
        };
        (BendingContact { m_bend, f_bend }, BendingContact { m_bend: by_moment, f_bend: by_length })
    }

    fn cases() -> Vec<Case<Bending<f64>>> {
        let hand = Bending { m2: 5.0, m3: -12.0, l: 2.0 };
        let mut cases = vec![
            Case::hand("couple", "2 × 13 / 2 = 13", hand),
            Case::limit("no-length", "L = 0: bending is ignored", Bending { l: 0.0, ..hand }),
            Case::hard("nothing", "neither moment nor length", Bending { m2: 0.0, m3: 0.0, l: 0.0 }),
            Case::hard("short", "a length of 1e-12", Bending { l: 1e-12, ..hand }),
            Case::hard("long", "a length of 1e12", Bending { l: 1e12, ..hand }),
        ];
        cases.extend(hard::norms().into_iter().map(|load| {
            let [m2, m3] = load.value;
            Case::hard(load.id, load.comment, Bending { m2, m3, l: 0.375 })
        }));
        cases
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: "L = 0",
                convention: Convention::Switch,
                holds: |i| i.l == 0.0,
                at: || Bending { m2: 5.0, m3: -12.0, l: 0.0 },
                across: || Bending { m2: 0.0, m3: 0.0, l: 1.0 },
            },
            Kink {
                condition: "m_2 = m_3 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.m2 == 0.0 && i.m3 == 0.0,
                at: || Bending { m2: 0.0, m3: 0.0, l: 2.0 },
                across: || Bending { m2: 1.0, m3: 0.0, l: 0.0 },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "turning the moment about the slot leaves it",
                sides: |i| {
                    let [c, s] = [3.0, 4.0].map(Octuple::from);
                    let turned = Bending { m2: i.m2 * c - i.m3 * s, m3: i.m2 * s + i.m3 * c, ..*i };
                    law::equal(Self::eval(i).f_bend * 5.0, Self::eval(&turned).f_bend)
                },
            },
            Law {
                statement: "two opposite forces of F_bend/2 at the distance L carry the moment",
                sides: |i| law::equal(Self::eval(i).f_bend * i.l * 0.5, Self::eval(i).m_bend),
            },
        ]
    }
}
