//! The contact moments of the hinges.

use super::hinge::{bending, in_sleeve, transverse};
use super::{AxialForces, Bending, CrossForces, CrossLoads, Decomposition, HingeAxial, HingeTwist, Twist};
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{E1A, E2A, E3A, E3B, F1, F2, F3, LA, LS, MC1, MC3, RA, RP, TWIST_M2};
use crate::scalar::{Scalar, abs, norm, norm_and_direction, sign};
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

    /// The chain rule, link by link.
    #[inline]
    fn linearized<D: Scalar>(i: &JointLoads<D>) -> (ContactMomentPair<D>, Jacobian<Self, D>) {
        let JointLoads { e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls } = *i;
        let cross_loads = i.cross_loads();

        // 1. The loads at the centre, and each hinge's share of them.
        let CrossForces { f_axial1, f_axial3, f_bend } = Decomposition::eval(&cross_loads);
        let (twist, by_twist) = HingeTwist::linearized(&Twist { m2, la, rp });
        let (axial, by_axial) = HingeAxial::linearized(&AxialForces { f_axial1, f_axial3, la, rp });

        // 2. The sums at right angles; their derivatives by their terms are the directions.
        let [hinge1, hinge3] = transverse(f_bend, &twist, &axial);
        let [bend, twist] = bending(f_bend, la, &twist);
        let [hinge1, hinge3, (m_total, [bend, twist, _])] = sizes_and_directions([hinge1, hinge3, [bend, twist, D::zero()]]);

        // 3. The contact force of the bending moment, by the loads at the centre and the lengths: alike for all hinges.
        let pressed = in_sleeve(m_total, ls);
        let (bend, twist) = (in_sleeve(bend, ls), in_sleeve(twist, ls));
        let pressed_by = Bending {
            f_bend: bend * la * (0.125 * sign(f_bend)),
            m2: twist * by_twist.m_twist_hinge.m2,
            la: bend * abs(f_bend) * 0.125 + twist * by_twist.m_twist_hinge.la,
            rp: twist * by_twist.m_twist_hinge.rp,
            ls: if ls == 0.0 { ls } else { -pressed / ls },
        };
        let by_twist = by_twist.f_twist_hinge;

        // 4. What all rows need of the force and the cross: F·e_cross by e1a and by e3b.
        let beside = cross_loads.force_beside_e1a();
        let force = e1a * f1 + beside;
        let e_cross = cross_loads.e_cross();
        let (bend_by_e1a, bend_by_e3b) = (e3b.cross(&beside), beside.cross(&e1a));

        // 5. A contact moment, by the loads at the centre, then by what these are made of.
        macro_rules! slopes { ($axial:expr, $by_axial:expr, $hinge:expr, $by_transv:expr, $own:ident, $other:ident) => {{
            let (axial, by_axial, (total, [bend, twist, transv]), by_transv) = ($axial, $by_axial, $hinge, $by_transv);
            let by_bend = (bend * 0.25 + pressed_by.f_bend) * rp;
            let by_own = by_axial.$own * ra;
            let by_other = transv * by_transv.$other * rp;
            (by_own, by_other, by_bend, [
                (twist * by_twist.m2 + pressed_by.m2) * rp,
                (twist * by_twist.rp + transv * by_transv.rp + pressed_by.rp) * rp + by_axial.rp * ra + total + pressed,
                (twist * by_twist.la + transv * by_transv.la + pressed_by.la) * rp + by_axial.la * ra,
                if ra == 0.0 { ra } else { axial },
                pressed_by.ls * rp,
            ], moment(axial, total + pressed, ra, rp))
        }} }
        macro_rules! row { ($by_1:expr, $by_3:expr, $by_bend:expr, $rest:expr) => {{
            let (by_1, by_3, by_bend, [m2, rp, la, ra, ls]) = ($by_1, $by_3, $by_bend, $rest);
            let in_plane = e1a * by_1 + e3b * by_3;
            let by_force = in_plane + e_cross * by_bend;
            JointLoads {
                e1a: in_plane * f1 + force * by_1 + bend_by_e1a * by_bend,
                e2a: by_force * f2,
                e3a: by_force * f3,
                e3b: force * by_3 + bend_by_e3b * by_bend,
                f1: e1a.dot(&in_plane),
                f2: e2a.dot(&by_force),
                f3: e3a.dot(&by_force),
                m2, rp, la, ra, ls
            }
        }} }
        let (own1, other1, bend1, rest1, mc1) = slopes!(axial.f_axial_hinge1, by_axial.f_axial_hinge1, hinge1, by_axial.f_transv_hinge1, f_axial1, f_axial3);
        let (own3, other3, bend3, rest3, mc3) = slopes!(axial.f_axial_hinge3, by_axial.f_axial_hinge3, hinge3, by_axial.f_transv_hinge3, f_axial3, f_axial1);
        let by_1 = row!(own1, other1, bend1, rest1);
        let by_3 = row!(other3, own3, bend3, rest3);
        (ContactMomentPair { mc1, mc3 }, ContactMomentPair { mc1: by_1, mc3: by_3 })
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
