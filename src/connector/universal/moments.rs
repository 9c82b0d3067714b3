//! The constraint moment on the shafts, and the moments about them.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for vectors")]

#[cfg(feature = "verify")]
mod proof;

use super::kinematics::Angles;
use crate::element::cardan::check_alpha;
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{CROSS_M1, CROSS_M3, E1A, E2A, E3A, E3B, KINETIC_MOMENT, MOMENT, TWIST_M2};
use crate::formula::{Component, Document, Finite, Formula, Given, Jacobian, Spec, along};
use crate::number::scalar::{Scalar, norm_and_direction};
use nalgebra::Vector3;

fields! {
    /// The axes normal to a's shaft, b's shaft, and the constraint moment.
    pub struct Twisted<T> { e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B, m2: T = TWIST_M2 }
}
fields! {
    /// A constraint moment on node b; its opposite acts on node a.
    pub struct Moment<T> { m: Vector3<T> = MOMENT }
}

/// The moment that keeps the shafts at their angle: m = m2 (cos α e2a + sin α e3a).
///
/// cos α and sin α are the direction of (e3a·e3b, −e2a·e3b), without computing an angle. If the shafts are perpendicular this is
/// −m2 e1a × e3b.
#[derive(Clone, Copy, Debug)]
pub struct ConstraintMoment;

/// cos α e2a + sin α e3a. As a double product of e3b, it would be lost in roundings of e2a × e3a near gimbal lock.
#[inline(always)]
fn line_of_nodes<D: Scalar>(i: &Twisted<D>, [cosine, sine]: [D; 2]) -> Vector3<D> {
    i.e2a * cosine + i.e3a * sine
}

/// |(e3a·e3b, e2a·e3b)|, cos α and sin α.
#[inline]
fn turn<D: Scalar>(i: &Twisted<D>) -> (D, [D; 2]) {
    let (length, [cosine, sine]) = norm_and_direction([i.e3a.dot(&i.e3b), i.e2a.dot(&i.e3b)]);
    (length, [cosine, -sine])
}

impl Formula for ConstraintMoment {
    const SPEC: Spec = Spec::new(
        "universal.constraint_moment",
        "Constraint moment",
        Document::UJOINT
            .ours("Friction", "the page prints the axis e1a × e3b; the sign follows the second Cardan angle"),
    )
    .equation(r"\mathbf{m} = m_2\,(\cos\alpha\,\mathbf{e}_{2a} + \sin\alpha\,\mathbf{e}_{3a})")
    .given(&[Given::new(r"\alpha", &Angles::SPEC)])
    // The largest η that `audit --attack` found is 1.1 for the value, and 2.38 is possible to first order; for the Jacobian 4.26 and 9.
    .eta(6.0, 8.0)
    .normwise(3.0, 9.5)
    .scale(1e250)
    .finite(Finite::Between);
    type Inputs<T: Component> = Twisted<T>;
    type Outputs<T: Component> = Moment<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Twisted<D>) -> Moment<D> {
        let (_, direction) = turn(i);
        Moment { m: line_of_nodes(i, direction) * i.m2 }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Twisted<D>) -> Jacobian<Self, D> {
        let (length, [cosine, sine]) = turn(i);
        let across = i.e3a * cosine - i.e2a * sine; // across·e3b = length
        let line_of_nodes = line_of_nodes(i, [cosine, sine]);
        let (shaft, by_e3b) = (i.e3b / length, -line_of_nodes / length);
        // ∂α/∂e2a = −cos α e3b/length and ∂α/∂e3a = −sin α e3b/length, so both rows are those of I − across e3bᵀ/length. Its
        // diagonal is a sum over the other two axes, without the 1, which would cancel.
        let row = |k: usize| {
            let mut held = shaft * -across[k];
            held[k] = (0..3).filter(|&j| j != k).fold(D::zero(), |sum, j| sum + across[j] * shaft[j]);
            Twisted {
                e2a: held * (i.m2 * cosine),
                e3a: held * (i.m2 * sine),
                e3b: by_e3b * (i.m2 * across[k]),
                m2: line_of_nodes[k],
            }
        };
        Moment { m: Vector3::new(row(0), row(1), row(2)) }
    }

    #[inline]
    fn validate<D: Scalar>(i: &Twisted<D>) -> Result<(), Error> {
        check_alpha(&i.e2a, &i.e3a, &i.e3b)
    }
}

fields! {
    /// A kinetic moment on node a; its opposite acts on node b.
    pub struct FreeMoment<T> { m: Vector3<T> = KINETIC_MOMENT }
}
fields! {
    /// The two shafts, and the moments about them.
    pub struct Driven<T> { e1a: Vector3<T> = E1A, e3b: Vector3<T> = E3B, m1: T = CROSS_M1, m3: T = CROSS_M3 }
}

/// The moment about the free axes: m = m1 e1a + m3 e3b.
///
/// It is conjugate to (ur1, ur3) if the shafts are perpendicular, so that it acts on a and its opposite on b.
#[derive(Clone, Copy, Debug)]
pub struct KineticMoment;

impl Formula for KineticMoment {
    const SPEC: Spec = Spec::new(
        "universal.kinetic_moment",
        "Kinetic moment",
        Document::UJOINT.ours("Summary", "the page names m1, m3 and the arms e1a, e3b, and prints no vector"),
    )
    .equation(r"\mathbf{m} = m_1\,\mathbf{e}_{1a} + m_3\,\mathbf{e}_{3b}")
    .eta(1.5, 0.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = Driven<T>;
    type Outputs<T: Component> = FreeMoment<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Driven<D>) -> FreeMoment<D> {
        FreeMoment { m: i.e1a * i.m1 + i.e3b * i.m3 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Driven<D>) -> Jacobian<Self, D> {
        let row = |k: usize| Driven { e1a: along(k, i.m1), e3b: along(k, i.m3), m1: i.e1a[k], m3: i.e3b[k] };
        FreeMoment { m: Vector3::new(row(0), row(1), row(2)) }
    }
}
