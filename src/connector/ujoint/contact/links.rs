//! The derivatives of the contact moments with respect to all 20 inputs, in two links.
//!
//! The vectors e1a, e2a, e3a, e3b and the forces f1, f2, f3 affect M_C only through three loads at the centre of the cross: the
//! forces along its two axes and the force normal to them. So the chain rule has two links:
//!
//! 1. [`ByLoads`]: M_C with respect to these three loads, to m2 and to the dimensions of the cross. A hinge on axis 3 is one on
//!    axis 1 with the two axial forces exchanged, so that one function, [`Common::hinge`], serves both.
//! 2. [`Force::chain`]: the three loads with respect to forces and vectors.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

use super::loads::{ContactMomentPair, JointLoads, moment};
use crate::connector::ujoint::hinge::{Shared, bending, in_sleeve, share_of, transverse};
use crate::connector::ujoint::{AxialFactors, Bending, CrossForces, HingeTwist, Twist};
use crate::formula::Formula;
use crate::number::scalar::{Scalar, choice, is_between, norm_and_direction, number_if};
use nalgebra::Vector3;

/// M_C of both axes, and their gradients.
#[inline(always)]
pub(super) fn linearized<D: Scalar>(i: &JointLoads<D>) -> (ContactMomentPair<D>, ContactMomentPair<JointLoads<D>>) {
    let loads = i.at_centre();
    let [(mc1, by1), (mc3, by3)] = first_link(i, &loads);
    let force = Force::new(i);
    let gradients = ContactMomentPair {
        mc1: force.chain(i, by1.own, by1.other, &by1),
        mc3: force.chain(i, by3.other, by3.own, &by3),
    };
    (ContactMomentPair { mc1, mc3 }, gradients)
}

/// The first link: the derivatives of M_C of a hinge with respect to the loads at the centre and the dimensions of the cross.
#[derive(Clone, Copy, Debug)]
struct ByLoads<D> {
    /// With respect to the force along the hinge's own axis.
    own: D,
    /// With respect to the force along the other axis.
    other: D,
    f_bend: D,
    m2: D,
    rp: D,
    la: D,
    ra: D,
    ls: D,
}

/// M_C = F_axial^hinge Ra + (F_total^hinge + F_total^bend) Rp for a hinge on axis 1 and one on axis 3.
#[inline(always)]
fn first_link<D: Scalar>(i: &JointLoads<D>, loads: &CrossForces<D>) -> [(D, ByLoads<D>); 2] {
    let CrossForces { f_axial1, f_axial3, f_bend } = *loads;
    let JointLoads { rp, la, ls, .. } = *i;

    // The terms: the effects of twist, bending and the axial forces, each with its derivatives. A hinge carries α of the force
    // along its own axis as pull and β of the force along the other axis as push.
    let (twist, by_twist) = HingeTwist::linearized(&i.twist());
    let (shares, slopes) = AxialFactors::linearized(&i.arm());
    let [pull1, pull3] = [f_axial1, f_axial3].map(|f| share_of(f, shares.alpha_axial, slopes.alpha_axial));
    let [push3, push1] = [f_axial1, f_axial3].map(|f| share_of(f, shares.beta_axial, slopes.beta_axial));

    // The three root-sum-squares: F_total of both hinges, and M_total. The derivative of such a sum with respect to its terms is
    // its direction.
    let [m_bend, m_twist] = bending(f_bend, la, &twist);
    let [sum1, sum3, (m_total, [bend, twist, _])] = sizes_and_directions([
        transverse(f_bend, &twist, push1.value),
        transverse(f_bend, &twist, push3.value),
        [m_bend, m_twist, D::zero()],
    ]);

    // F_total^bend = 2 M_total/Ls presses equally on every hinge, with the lever Rp; 2 Rp/Ls is its moment per M_total.
    let (pressing, per_moment) = (in_sleeve(m_total, ls), in_sleeve(rp, ls));
    let weights = [bend * per_moment, twist * per_moment];
    let by_pressing = i.bending(f_bend).slope_of_moments(weights, &by_twist.m_twist_hinge);
    let by_pressing = Bending { rp: by_pressing.rp + pressing, ls: -pressing * per_moment * 0.5, ..by_pressing };

    let common = Common { by_twist: by_twist.f_twist_hinge, pressing, by_pressing };
    [common.hinge(i, &pull1, &push1, sum1), common.hinge(i, &pull3, &push3, sum3)]
}

/// What both axes have in common.
struct Common<D> {
    /// The derivative of F_twist^hinge.
    by_twist: Twist<D>,
    /// F_total^bend.
    pressing: D,
    /// The derivative of F_total^bend Rp.
    by_pressing: Bending<D>,
}

impl<D: Scalar> Common<D> {
    /// M_C of a hinge, from the pull along its axis, the push across it, and F_total with its direction.
    #[inline]
    fn hinge(
        &self,
        i: &JointLoads<D>,
        pull: &Shared<D>,
        push: &Shared<D>,
        (total, direction): (D, [D; 3]),
    ) -> (D, ByLoads<D>) {
        let JointLoads { rp, ra, .. } = *i;
        let Self { by_twist, pressing, by_pressing } = self;
        // The derivatives of F_total Rp with respect to its three terms.
        let [by_bend, by_twisting, by_push] = direction.map(|n| n * rp);
        let slopes = ByLoads {
            own: pull.by_force * ra,
            other: by_push * push.by_force,
            f_bend: by_bend * 0.25 + by_pressing.f_bend,
            m2: by_twisting * by_twist.m2 + by_pressing.m2,
            rp: by_twisting * by_twist.rp + by_push * push.by_arm.rp + pull.by_arm.rp * ra + total + by_pressing.rp,
            la: by_twisting * by_twist.la + by_push * push.by_arm.la + pull.by_arm.la * ra + by_pressing.la,
            ra: pull.value,
            ls: by_pressing.ls,
        };
        (moment(pull.value, total + *pressing, ra, rp), slopes)
    }
}

/// Magnitude and direction of three vectors of perpendicular components.
///
/// Computed as by [`norm_and_direction`], but with one range test for all three, and with the reciprocal of the square in
/// parallel with its root instead of a quotient after it.
#[inline]
fn sizes_and_directions<D: Scalar>(sums: [[D; 3]; 3]) -> [(D, [D; 3]); 3] {
    let [a, b, c] = sums;
    let square = |x: [D; 3]| x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    let (aa, bb, cc) = (square(a), square(b), square(c));
    let regular = |square: D| is_between(square, 1e-270, 1e300);
    let divided = |x: [D; 3], square: D| {
        let size = square.sqrt();
        let per_size = size * square.recip();
        [size, x[0] * per_size, x[1] * per_size, x[2] * per_size]
    };
    let numbers = choice(|| {
        let are_regular = regular(aa) & regular(bb) & regular(cc);
        if !D::ignores_extremes() && (are_regular || !D::has_extremes()) {
            flat([divided(a, aa), divided(b, bb), divided(c, cc)]).map(|x| number_if(are_regular, x))
        } else {
            irregular(sums)
        }
    });
    [0, 4, 8].map(|k| (numbers[k], [numbers[k + 1], numbers[k + 2], numbers[k + 3]]))
}

#[cold]
fn irregular<D: Scalar>(sums: [[D; 3]; 3]) -> [D; 12] {
    flat(sums.map(|sum| {
        let (size, [x, y, z]) = norm_and_direction(sum);
        [size, x, y, z]
    }))
}

/// The three as one list.
#[inline]
fn flat<D: Scalar>([[a, b, c, d], [e, f, g, h], [i, j, k, l]]: [[D; 4]; 3]) -> [D; 12] {
    [a, b, c, d, e, f, g, h, i, j, k, l]
}

/// The second link: F = f1 e1a + W with W = f2 e2a + f3 e3a, and
///
/// ```text
/// F_axial1 = F·e1a,   F_axial3 = F·e3b,   F_bend = W·(e1a × e3b)
/// ```
///
/// with W instead of F, since e1a has no component normal to the cross.
struct Force<D> {
    whole: Vector3<D>,
    e_cross: Vector3<D>,
    /// F_bend = e1a·(e3b × W) …
    bend_by_e1a: Vector3<D>,
    /// … = e3b·(W × e1a).
    bend_by_e3b: Vector3<D>,
}

impl<D: Scalar> Force<D> {
    #[inline]
    fn new(i: &JointLoads<D>) -> Self {
        let loads = i.cross_loads();
        let beside = loads.force_beside_e1a();
        Self {
            whole: i.e1a * i.f1 + beside,
            e_cross: loads.e_cross(),
            bend_by_e1a: i.e3b.cross(&beside),
            bend_by_e3b: beside.cross(&i.e1a),
        }
    }

    /// The gradient of a number with these derivatives with respect to F_axial1, F_axial3 and the other loads and dimensions.
    ///
    /// For a variation of F the moment changes by p·dF + (∂M/∂F_bend) e_cross·dW, where p is its derivative in the plane of the
    /// two axes.
    #[inline]
    fn chain(&self, i: &JointLoads<D>, by_axial1: D, by_axial3: D, by: &ByLoads<D>) -> JointLoads<D> {
        let in_plane = i.e1a * by_axial1 + i.e3b * by_axial3;
        let by_force = in_plane + self.e_cross * by.f_bend;
        JointLoads {
            e1a: in_plane * i.f1 + self.whole * by_axial1 + self.bend_by_e1a * by.f_bend,
            e2a: by_force * i.f2,
            e3a: by_force * i.f3,
            e3b: self.whole * by_axial3 + self.bend_by_e3b * by.f_bend,
            f1: i.e1a.dot(&in_plane),
            f2: i.e2a.dot(&by_force),
            f3: i.e3a.dot(&by_force),
            m2: by.m2,
            rp: by.rp,
            la: by.la,
            ra: by.ra,
            ls: by.ls,
        }
    }
}
