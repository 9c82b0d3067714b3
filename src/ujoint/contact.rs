//! The contact moments of the hinges.

use super::hinge::{bending, in_sleeve, transverse};
use super::loads::{HardLoads, hard_loads};
use super::{
    Arm, AxialForces, Bending, CentreLoads, CrossForces, CrossLoads, Decomposition, HingeAxial, HingeBending, HingeTransverse,
    HingeTwist, Twist, TwistFactors,
};
use crate::fields;
use crate::Octuple;
use crate::formula::{Case, Convention, Element, Equation, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{E1A, E2A, E3A, E3B, F1, F2, F3, LA, LS, MC1, MC3, RA, RP, TWIST_M2};
use crate::scalar::{Scalar, abs, norm, norm_and_direction, sign};
use crate::verify::{hard, law};
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
}

impl Formula for ContactMoments {
    const SPEC: Spec = Spec {
        id: "ujoint.contact_moments",
        title: "Contact moments",
        latex: r"M_{Ck} = F_{\mathrm{axial}k}^{\mathrm{hinge}} R_a + \left(F_{\mathrm{total}k}^{\mathrm{hinge}} + F_{\mathrm{total}}^{\mathrm{bend}}\right) R_p\quad (k = 1, 3)",
        source: Source::UJOINT.section("Friction"),
        eta: 4.0,
        eta_jacobian: 8.0,
        objective: true,
    };
    type Inputs<T: Element> = JointLoads<T>;
    type Outputs<T: Element> = ContactMomentPair<T>;

    #[inline]
    fn eval<D: Scalar>(i: &JointLoads<D>) -> ContactMomentPair<D> {
        let JointLoads { m2, rp, la, ra, ls, .. } = *i;
        let CrossForces { f_axial1, f_axial3, f_bend } = Decomposition::eval(&i.cross_loads());
        let twist = HingeTwist::eval(&Twist { m2, la, rp });
        let axial = HingeAxial::eval(&AxialForces { f_axial1, f_axial3, la, rp });
        let [transverse1, transverse3] = transverse(f_bend, &twist, &axial).map(norm);
        let bending = in_sleeve(norm(bending(f_bend, la, &twist)), ls);
        ContactMomentPair {
            mc1: moment(axial.f_axial_hinge1, transverse1 + bending, ra, rp),
            mc3: moment(axial.f_axial_hinge3, transverse3 + bending, ra, rp),
        }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &JointLoads<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    /// The chain rule in two links: the moments by the loads at the centre, and these by the force and the vectors.
    #[inline]
    fn linearized<D: Scalar>(i: &JointLoads<D>) -> (ContactMomentPair<D>, Jacobian<Self, D>) {
        let at_centre = Decomposition::eval(&i.cross_loads());
        let f = Forces::new(i);
        let (moments, by) = i.by_centre_loads(at_centre);
        (moments, ContactMomentPair { mc1: f.row(i, &by.mc1), mc3: f.row(i, &by.mc3) })
    }

    fn cases() -> Vec<Case<JointLoads<f64>>> {
        hard_cases(|_| true).into_iter().collect()
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![
            Kink {
                condition: "R_a = 0",
                convention: Convention::Switch,
                holds: |i| i.ra == 0.0,
                at: || JointLoads { ra: 0.0, ..hand() },
                across: || JointLoads { ra: 1.0, ..JointLoads::filled(0.0) },
            },
            Kink {
                condition: "L_s = 0",
                convention: Convention::Switch,
                holds: |i| i.ls == 0.0,
                at: || JointLoads { ls: 0.0, ..hand() },
                across: || JointLoads { ls: 1.0, ..JointLoads::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{axial1}} = 0",
                convention: Convention::Subgradient,
                holds: |i| i.at_centre().f_axial1 == 0.0,
                at: || JointLoads { f1: 0.0, ..hand() },
                across: || JointLoads { f1: 1.0, ..JointLoads::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{axial3}} = 0",
                convention: Convention::Subgradient,
                holds: |i| i.at_centre().f_axial3 == 0.0,
                at: || JointLoads { f2: 0.0, f3: 0.0, ..hand() },
                across: || JointLoads { f3: 1.0, ..JointLoads::filled(0.0) },
            },
            Kink {
                condition: r"F_{\mathrm{bend}} = m_2 = 0",
                convention: Convention::Subgradient,
                holds: |i| i.m2 == 0.0 && i.at_centre().f_bend == 0.0,
                at: || JointLoads { f2: 0.0, f3: 0.0, m2: 0.0, ..hand() },
                across: || JointLoads { m2: 1.0, ..JointLoads::filled(0.0) },
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "reversing all loads leaves them",
                sides: |i| {
                    let reversed = JointLoads { f1: -i.f1, f2: -i.f2, f3: -i.f3, m2: -i.m2, ..*i };
                    equal_pairs(Self::eval(i), Self::eval(&reversed))
                },
            },
            Law {
                statement: "they are of first degree in the loads: f·∂M/∂f + m2 ∂M/∂m2 = M",
                sides: |i| {
                    let (m, by) = Self::linearized(i);
                    let along = |by: JointLoads<_>| by.f1 * i.f1 + by.f2 * i.f2 + by.f3 * i.f3 + by.m2 * i.m2;
                    law::equal_all([(along(by.mc1), m.mc1), (along(by.mc3), m.mc3)])
                },
            },
            Law {
                statement: "exchanging the axes of the cross under the same force exchanges them",
                sides: |i| {
                    let force = i.e1a * i.f1 + i.cross_loads().force_beside_e1a();
                    let (one, zero) = (Octuple::from(1.0), Octuple::from(0.0));
                    let exchanged = JointLoads { e1a: i.e3b, e2a: force, e3b: i.e1a, f1: zero, f2: one, f3: zero, ..*i };
                    let ContactMomentPair { mc1, mc3 } = Self::eval(&exchanged);
                    equal_pairs(Self::eval(i), ContactMomentPair { mc1: mc3, mc3: mc1 })
                },
            },
            Law {
                statement: "the twisting moment alone makes both |m2| (β Rp/La + 2α Rp/Ls)",
                sides: |i| {
                    let zero = Octuple::from(0.0);
                    let ContactMomentPair { mc1, mc3 } = Self::eval(&JointLoads { f1: zero, f2: zero, f3: zero, ..*i });
                    let shares = TwistFactors::eval(&Arm { la: i.la, rp: i.rp });
                    let m = abs(i.m2) * i.rp * (shares.beta_twist / i.la + shares.alpha_twist * 2.0 / i.ls);
                    law::equal_all([(mc1, m), (mc3, m)])
                },
            },
            Law {
                statement: "the links of the chain, each its own formula, give the same",
                sides: |i| {
                    let JointLoads { m2, la, rp, ra, ls, .. } = *i;
                    let CrossForces { f_axial1, f_axial3, f_bend } = i.at_centre();
                    let axial = HingeAxial::eval(&AxialForces { f_axial1, f_axial3, la, rp });
                    let total = HingeTransverse::eval(&CentreLoads { f_axial1, f_axial3, f_bend, m2, la, rp });
                    let bend = HingeBending::eval(&Bending { f_bend, m2, la, rp, ls }).f_total_bend;
                    let mc1 = axial.f_axial_hinge1 * ra + (total.f_total_hinge1 + bend) * rp;
                    let mc3 = axial.f_axial_hinge3 * ra + (total.f_total_hinge3 + bend) * rp;
                    equal_pairs(Self::eval(i), ContactMomentPair { mc1, mc3 })
                },
            },
        ]
    }
}

fn equal_pairs(left: ContactMomentPair<Octuple>, right: ContactMomentPair<Octuple>) -> Vec<Equation> {
    law::equal_all([(left.mc1, right.mc1), (left.mc3, right.mc3)])
}

/// The global axes and α = 0: F_axial1 = 20, F_axial3 = 80, F_bend = 16.
fn hand() -> JointLoads<f64> {
    JointLoads {
        e1a: Vector3::x(),
        e2a: Vector3::y(),
        e3a: Vector3::z(),
        e3b: Vector3::z(),
        f1: 20.0,
        f2: -16.0,
        f3: 80.0,
        m2: 152.0,
        rp: 1.0,
        la: 2.0,
        ra: 0.5,
        ls: 4.0,
    }
}

/// The cases of the contact moments, and of what is made of them.
pub(super) fn hard_cases(keep: impl Fn(&str) -> bool) -> Vec<Case<JointLoads<f64>>> {
    let hand = hand();
    let mut cases = vec![
        Case::hand("straight", "α_axial = 0.35, β_axial = 0.15, F_bend = 16, M_bend = 4", hand),
        Case::hand("no-twist", "√(4² + 12²) and 5, 2 × 4/4 each", JointLoads { m2: 0.0, ..hand }),
        Case::hand("bend-alone", "16/4 and 2 × 4/4: 6 each", JointLoads { f1: 0.0, f3: 0.0, m2: 0.0, ..hand }),
        Case::limit("no-axial-arm", "Ra = 0: the axial forces do not rub", JointLoads { ra: 0.0, ..hand }),
        Case::limit("no-sleeve", "Ls = 0: the bending moments do not press", JointLoads { ls: 0.0, ..hand }),
        Case::limit("neither", "Ra = Ls = 0", JointLoads { ra: 0.0, ls: 0.0, ..hand }),
    ];
    let [e1a, e2a, e3a] = hard::triad();
    let off_axis = JointLoads { e1a, e2a, e3a, e3b: e3a * 0.8 - e2a * 0.6, ..hand };
    cases.extend(hard_loads().into_iter().map(|HardLoads { id, comment, inputs }| {
        let CrossLoads { e1a, e2a, e3a, e3b, f1, f2, f3 } = inputs;
        Case::hard(id, comment, JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2: 0.0, ..hand })
    }));
    for size in [1e-150, 1e-100, 1e100, 1e150] {
        let [f1, f2, f3, m2] = [3.0, -4.0, 12.0, -5.0].map(|load| load * size);
        cases.push(Case::hard(format!("loads-{size:e}"), "loads of extreme size", JointLoads { f1, f2, f3, m2, ..off_axis }));
    }
    cases.push(Case::hard(
        "m2-alone",
        "the twisting moment alone",
        JointLoads { f1: 0.0, f2: 0.0, f3: 0.0, m2: -2.5, ..off_axis },
    ));
    cases.extend(hard::arms().into_iter().map(|arm| {
        let [la, rp] = arm.value;
        let larger = if la > rp { la } else { rp };
        Case::hard(arm.id, arm.comment, JointLoads { la, rp, m2: -2.5 * la, ra: rp, ls: larger, ..off_axis })
    }));
    cases.retain(|case| keep(&case.id));
    cases
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Slopes<D> { f_axial1: D, f_axial3: D, f_bend: D, m2: D, rp: D, la: D, ra: D, ls: D }

impl<D: Scalar> JointLoads<D> {
    /// The force along the axes of the cross and across them.
    #[inline]
    pub(super) fn at_centre(&self) -> CrossForces<D> {
        Decomposition::eval(&self.cross_loads())
    }

    #[inline]
    fn by_centre_loads(&self, CrossForces { f_axial1, f_axial3, f_bend }: CrossForces<D>) -> (ContactMomentPair<D>, ContactMomentPair<Slopes<D>>) {
        let Self { m2, rp, la, ra, ls, .. } = *self;
        let (twist, by_twist) = HingeTwist::linearized(&Twist { m2, la, rp });
        let (axial, by_axial) = HingeAxial::linearized(&AxialForces { f_axial1, f_axial3, la, rp });

        // The sums at right angles; their derivatives by their terms are the directions.
        let [hinge1, hinge3] = transverse(f_bend, &twist, &axial);
        let [bend, twist] = bending(f_bend, la, &twist);
        let [hinge1, hinge3, (m_total, [bend, twist, _])] = sizes_and_directions([hinge1, hinge3, [bend, twist, D::zero()]]);

        // The contact force of the bending moment is alike for all hinges.
        let pressed = in_sleeve(m_total, ls);
        let (bend, twist) = (in_sleeve(bend * rp, ls), in_sleeve(twist * rp, ls));
        let pressed_by = Bending {
            f_bend: bend * la * (0.125 * sign(f_bend)),
            m2: twist * by_twist.m_twist_hinge.m2,
            la: bend * abs(f_bend) * 0.125 + twist * by_twist.m_twist_hinge.la,
            rp: twist * by_twist.m_twist_hinge.rp + pressed,
            ls: if ls == 0.0 { ls } else { -pressed * rp / ls },
        };
        let by_twist = by_twist.f_twist_hinge;

        macro_rules! slopes { ($axial:expr, $by_axial:expr, $hinge:expr, $by_transv:expr, $own:ident, $other:ident) => {{
            let (axial, by_axial, (total, [bend, twist, transv]), by_transv) = ($axial, $by_axial, $hinge, $by_transv);
            let (bend, twist, transv) = (bend * rp, twist * rp, transv * rp);
            (moment(axial, total + pressed, ra, rp), Slopes {
                f_bend: bend * 0.25 + pressed_by.f_bend,
                $own: by_axial.$own * ra,
                $other: transv * by_transv.$other,
                m2: twist * by_twist.m2 + pressed_by.m2,
                rp: twist * by_twist.rp + transv * by_transv.rp + by_axial.rp * ra + total + pressed_by.rp,
                la: twist * by_twist.la + transv * by_transv.la + by_axial.la * ra + pressed_by.la,
                ra: if ra == 0.0 { ra } else { axial },
                ls: pressed_by.ls,
            })
        }} }
        let (mc1, by_1) = slopes!(axial.f_axial_hinge1, by_axial.f_axial_hinge1, hinge1, by_axial.f_transv_hinge1, f_axial1, f_axial3);
        let (mc3, by_3) = slopes!(axial.f_axial_hinge3, by_axial.f_axial_hinge3, hinge3, by_axial.f_transv_hinge3, f_axial3, f_axial1);
        (ContactMomentPair { mc1, mc3 }, ContactMomentPair { mc1: by_1, mc3: by_3 })
    }
}

struct Forces<D> { force: Vector3<D>, e_cross: Vector3<D>, bend_by_e1a: Vector3<D>, bend_by_e3b: Vector3<D> }
impl<D: Scalar> Forces<D> {
    #[inline]
    fn new(i: &JointLoads<D>) -> Self {
        let cross_loads = i.cross_loads();
        let beside = cross_loads.force_beside_e1a();
        Self { force: i.e1a * i.f1 + beside, e_cross: cross_loads.e_cross(), bend_by_e1a: i.e3b.cross(&beside), bend_by_e3b: beside.cross(&i.e1a) }
    }
    #[inline]
    fn row(&self, i: &JointLoads<D>, by: &Slopes<D>) -> JointLoads<D> {
        let in_plane = i.e1a * by.f_axial1 + i.e3b * by.f_axial3;
        let by_force = in_plane + self.e_cross * by.f_bend;
        JointLoads {
            e1a: in_plane * i.f1 + self.force * by.f_axial1 + self.bend_by_e1a * by.f_bend,
            e2a: by_force * i.f2,
            e3a: by_force * i.f3,
            e3b: self.force * by.f_axial3 + self.bend_by_e3b * by.f_bend,
            f1: i.e1a.dot(&in_plane),
            f2: i.e2a.dot(&by_force),
            f3: i.e3a.dot(&by_force),
            m2: by.m2, rp: by.rp, la: by.la, ra: by.ra, ls: by.ls,
        }
    }
}

/// The moment of the axial force, left out where Ra = 0, and of the force that presses pin and sleeve together.
#[inline]
fn moment<D: Scalar>(axial: D, pressing: D, ra: D, rp: D) -> D {
    let pressing = pressing * rp;
    if ra == 0.0 { pressing } else { axial * ra + pressing }
}

#[inline]
fn sizes_and_directions<D: Scalar>([a, b, c]: [[D; 3]; 3]) -> [(D, [D; 3]); 3] {
    let square = |x: [D; 3]| x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    let (a2, b2, c2) = (square(a), square(b), square(c));
    let ok = |s: D| (s > 1e-270) & (s < 1e300);
    if ok(a2) & ok(b2) & ok(c2) {
        let (la, lb, lc) = (a2.sqrt(), b2.sqrt(), c2.sqrt());
        let (ra, rb, rc) = (la * a2.recip(), lb * b2.recip(), lc * c2.recip());
        [
            (la, [a[0] * ra, a[1] * ra, a[2] * ra]),
            (lb, [b[0] * rb, b[1] * rb, b[2] * rb]),
            (lc, [c[0] * rc, c[1] * rc, c[2] * rc]),
        ]
    } else {
        guarded(a, b, c)
    }
}
#[cold]
fn guarded<D: Scalar>(a: [D; 3], b: [D; 3], c: [D; 3]) -> [(D, [D; 3]); 3] { [norm_and_direction(a), norm_and_direction(b), norm_and_direction(c)] }
