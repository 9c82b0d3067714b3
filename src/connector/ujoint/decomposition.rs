//! The decomposition of the force at the centre of the cross along its axes and normal to them.

#![expect(clippy::inline_always, reason = "value and gradients share the force where they are compiled as one piece")]

mod cancelling;
#[cfg(feature = "verify")]
pub(super) mod proof;

use super::{CrossAxes, CrossDirection};
use crate::fields;
use crate::formula::quantity::{CROSS_F_BEND, E1A, E2A, E3A, E3B, F_AXIAL1, F_AXIAL3, F2, F3, JOIN_F1};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, ValueAndJacobian};
use crate::number::scalar::{Leaf, Scalar, abs, choice, leaf, number_if};
use nalgebra::Vector3;

fields! {
    /// The orientation of the nodes, and the force that JOIN transmits.
    pub struct CrossLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        f1: T = JOIN_F1, f2: T = F2, f3: T = F3,
    }
}
fields! {
    /// The force along the axes of the cross and normal to them.
    pub struct CrossForces<T> { f_axial1: T = F_AXIAL1, f_axial3: T = F_AXIAL3, f_bend: T = CROSS_F_BEND }
}

/// The force F = f1 e1a + f2 e2a + f3 e3a along the axes of the cross and normal to them: F·e1a, F·e3b, F·(e1a × e3b).
///
/// The part f1 e1a has no component normal to the cross, whatever the vectors are; it is omitted there to avoid its rounding
/// errors. The signs of all three results are correct: if a single force acts along an axis of a's triad, F·e1a consists of
/// rounding errors of the triad, and the derivative of |F·e1a| depends on its sign.
#[derive(Clone, Copy, Debug)]
pub struct Decomposition;

impl<D: Scalar> CrossLoads<D> {
    /// f2 e2a + f3 e3a: the part of F that is not along e1a.
    #[inline]
    pub(super) fn force_beside_e1a(&self) -> Vector3<D> {
        self.e2a * self.f2 + self.e3a * self.f3
    }

    #[inline]
    pub(super) fn e_cross(&self) -> Vector3<D> {
        CrossDirection::eval(&CrossAxes { e1a: self.e1a, e3b: self.e3b }).e_cross
    }
}

/// The force, and the vectors by which it is multiplied.
struct Parts<D> {
    beside: Vector3<D>,
    force: Vector3<D>,
    e_cross: Vector3<D>,
}

impl<D: Scalar> Parts<D> {
    #[inline(always)]
    fn new(i: &CrossLoads<D>) -> Self {
        let beside = i.force_beside_e1a();
        Self { force: i.e1a * i.f1 + beside, beside, e_cross: i.e_cross() }
    }

    /// The three products, evaluated directly.
    #[inline(always)]
    fn decomposed(&self, i: &CrossLoads<D>) -> CrossForces<D> {
        CrossForces {
            f_axial1: self.force.dot(&i.e1a),
            f_axial3: self.force.dot(&i.e3b),
            f_bend: self.beside.dot(&self.e_cross),
        }
    }

    /// The products with correct signs. Small parts of the choice are inlined.
    #[inline(always)]
    fn value(&self, i: &CrossLoads<D>) -> CrossForces<D> {
        // Computed before the choice: inside it, value and Jacobian would take a third longer.
        let (rough, rounding) = (self.decomposed(i), i.most_rounding());
        let [f_axial1, f_axial3, f_bend] = choice(|| {
            let is_certain = D::takes_shortcuts() && rough.smallest() > rounding;
            let is_settled = !is_certain && D::has_extremes();
            let CrossForces { f_axial1, f_axial3, f_bend } = if is_settled { i.settled(rough) } else { rough };
            [f_axial1, f_axial3, f_bend].map(|force| number_if(is_certain || is_settled, force))
        });
        CrossForces { f_axial1, f_axial3, f_bend }
    }

    #[inline(always)]
    fn gradients(&self, i: &CrossLoads<D>) -> CrossForces<CrossLoads<D>> {
        let Self { beside, force, e_cross } = self;
        let CrossLoads { e1a, e2a, e3a, e3b, .. } = i;
        let zero = D::zero();
        CrossForces {
            f_axial1: CrossLoads {
                e1a: force + e1a * i.f1,
                e2a: e1a * i.f2,
                e3a: e1a * i.f3,
                e3b: Vector3::new(zero, zero, zero),
                f1: e1a.dot(e1a),
                f2: e2a.dot(e1a),
                f3: e3a.dot(e1a),
            },
            f_axial3: CrossLoads {
                e1a: e3b * i.f1,
                e2a: e3b * i.f2,
                e3a: e3b * i.f3,
                e3b: *force,
                f1: e1a.dot(e3b),
                f2: e2a.dot(e3b),
                f3: e3a.dot(e3b),
            },
            f_bend: CrossLoads {
                e1a: e3b.cross(beside),
                e2a: e_cross * i.f2,
                e3a: e_cross * i.f3,
                e3b: beside.cross(e1a),
                f1: zero,
                f2: e2a.dot(e_cross),
                f3: e3a.dot(e_cross),
            },
        }
    }
}

impl<D: Scalar> CrossForces<D> {
    /// The size of the smallest result. NaN is skipped, unless it is the first, since nothing compares smaller than NaN.
    #[inline(always)]
    fn smallest(&self) -> D::Leaf {
        let smaller = |x: D::Leaf, y: D::Leaf| if y < x { y } else { x };
        smaller(smaller(abs(leaf(self.f_axial1)), abs(leaf(self.f_axial3))), abs(leaf(self.f_bend)))
    }
}

impl<D: Scalar> CrossLoads<D> {
    /// A bound of all three numbers of [`Self::rounding`] that is cheaper to compute: 32 ε Σ |f e| (e1a² + 1) (e3b² + 1).
    ///
    /// The sizes of a vector's components add up to at most √3 times its length, which is at most (e² + 1) / 2: the largest of
    /// the three is below 3.5 ε times that sum. If terms underflow, their sum is at least a seventh of the exact one, or all
    /// terms are zero.
    #[inline(always)]
    fn most_rounding(&self) -> D::Leaf {
        let Self { e1a, e2a, e3a, e3b, f1, f2, f3 } = self;
        let size = |f: &D, e: &Vector3<D>| {
            let [x, y, z] = [e.x, e.y, e.z].map(|component| abs(leaf(component) * leaf(*f)));
            x + y + z
        };
        let square = |e: &Vector3<D>| leaf(e.x) * leaf(e.x) + leaf(e.y) * leaf(e.y) + leaf(e.z) * leaf(e.z);
        let sizes = size(f2, e2a) + size(f3, e3a) + size(f1, e1a);
        sizes * ((square(e1a) + 1.0) * (square(e3b) + 1.0) * (32.0 * D::Leaf::EPSILON))
    }
}

impl Formula for Decomposition {
    const SPEC: Spec = Spec::new(
        "ujoint.decomposition",
        "Force in the axes of the cross",
        Document::UJOINT.printed("Friction"),
    )
        .equation(r"F_{\mathrm{axial1}} = \mathbf{F}\cdot\mathbf{e}_{1a},\quad F_{\mathrm{axial3}} = \mathbf{F}\cdot\mathbf{e}_{3b},\quad F_{\mathrm{bend}} = \mathbf{F}\cdot\mathbf{e}_{\mathrm{cross}},\quad \mathbf{F} = f_1\mathbf{e}_{1a} + f_2\mathbf{e}_{2a} + f_3\mathbf{e}_{3a}")
.given(&[Given::new(r"\mathbf{e}_{\mathrm{cross}}", &CrossDirection::SPEC)])
        // The largest η that `audit --attack` found is 1.18 for the value, and 3.18 is possible to first order; for the Jacobian 1.32
        // and 2.06.
        .eta(3.5, 2.5)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = CrossLoads<T>;
    type Outputs<T: Component> = CrossForces<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossLoads<D>) -> CrossForces<D> {
        Parts::new(i).value(i)
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossLoads<D>) -> Jacobian<Self, D> {
        Parts::new(i).gradients(i)
    }

    #[inline(always)]
    fn linearized<D: Scalar>(i: &CrossLoads<D>) -> ValueAndJacobian<Self, D> {
        let parts = Parts::new(i);
        (parts.value(i), parts.gradients(i))
    }
}
