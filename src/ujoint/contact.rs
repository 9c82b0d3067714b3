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

    /// The chain rule in two links: the moments by the loads at the centre, and these by the force and the vectors.
    #[inline]
    fn linearized<D: Scalar>(i: &JointLoads<D>) -> (ContactMomentPair<D>, Jacobian<Self, D>) {
        let at_centre = Decomposition::eval(&i.cross_loads());
        let f = Forces::new(i);
        let (moments, by) = i.by_centre_loads(at_centre);
        (moments, ContactMomentPair { mc1: f.row(i, &by.mc1), mc3: f.row(i, &by.mc3) })
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Slopes<D> { f_axial1: D, f_axial3: D, f_bend: D, m2: D, rp: D, la: D, ra: D, ls: D }

impl<D: Scalar> JointLoads<D> {
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
