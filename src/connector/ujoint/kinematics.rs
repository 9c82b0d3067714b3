//! The constraint of a universal joint, and the range of its free angles.

#![expect(clippy::inline_always, reason = "compiled in place, zeros that lie side by side are stored together")]

#[cfg(feature = "verify")]
mod proof;

use crate::connector::join::{self, Joined};
use crate::connector::universal::{self, Shafts};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    ALPHA, C0, D0, E1A, E2A, E3A, E3B, G_JOIN, G_ROT, GAMMA, GAP1_MAX, GAP1_MIN, GAP3_MAX, GAP3_MIN, THETA1_MAX,
    THETA1_MIN, THETA3_MAX, THETA3_MIN, XA, XB,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Jacobian, Spec, along};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

fields! {
    /// The positions and axes of the nodes, and their initial configuration.
    pub struct Jointed<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB, d0: Vector3<T> = D0, c0: T = C0,
    }
}
fields! {
    /// The deviations of the joint from its initial configuration.
    pub struct JointResiduals<T> { g: Vector3<T> = G_JOIN, g_rot: T = G_ROT }
}

/// The four conditions of a universal joint: JOIN's three and UNIVERSAL's one.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec::new(
        "ujoint.constraint",
        "Constraint",
        Document::UJOINT.ours("Description", "the pages of JOIN and UNIVERSAL were not given"),
    )
        .equation(r"g_i = \mathbf{e}_{ia}\cdot(\mathbf{x}_b-\mathbf{x}_a) - d_{0i}\ (i = 1, 2, 3),\quad g_{\mathrm{rot}} = \mathbf{e}_{1a}\cdot\mathbf{e}_{3b} - c_0")
        .eta(2.0, 1.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = Jointed<T>;
    type Outputs<T: Component> = JointResiduals<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Jointed<D>) -> JointResiduals<D> {
        let Jointed { e1a, e2a, e3a, e3b, xa, xb, d0, c0 } = *i;
        let g = join::Constraint::eval(&Joined { e1a, e2a, e3a, xa, xb, d0 }).g;
        JointResiduals { g, g_rot: universal::Constraint::eval(&Shafts { e1a, e3b, c0 }).g }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Jointed<D>) -> Jacobian<Self, D> {
        let d = i.xb - i.xa;
        let none = Jointed::filled(D::zero());
        let held = |k| along(k, -D::one());
        // Written out although JOIN has these rows: assembled from those, the results would be stored in a slower order.
        JointResiduals {
            g: Vector3::new(
                Jointed { e1a: d, xa: -i.e1a, xb: i.e1a, d0: held(0), ..none },
                Jointed { e2a: d, xa: -i.e2a, xb: i.e2a, d0: held(1), ..none },
                Jointed { e3a: d, xa: -i.e3a, xb: i.e3a, d0: held(2), ..none },
            ),
            g_rot: Jointed { e1a: i.e3b.xyz(), e3b: i.e1a.xyz(), c0: -D::one(), ..none },
        }
    }
}

fields! {
    /// The free angles, and the stops.
    pub struct StopAngles<T> {
        alpha: T = ALPHA, gamma: T = GAMMA, theta1_min: T = THETA1_MIN, theta1_max: T = THETA1_MAX,
        theta3_min: T = THETA3_MIN, theta3_max: T = THETA3_MAX,
    }
}
fields! {
    /// The remaining angles to the stops.
    pub struct AngleGaps<T> { gap1_min: T = GAP1_MIN, gap1_max: T = GAP1_MAX, gap3_min: T = GAP3_MIN, gap3_max: T = GAP3_MAX }
}

/// The remaining angles to the stops, all ≥ 0 between them: α − θ1min, θ1max − α, γ − θ3min, θ3max − γ.
#[derive(Clone, Copy, Debug)]
pub struct Stop;

impl Formula for Stop {
    const SPEC: Spec = Spec::new(
        "ujoint.stop",
        "Stops",
        Document::UJOINT.reconstructed(
            "Summary",
            "the signs ≤ were lost; the first row is printed with γ, where α is meant",
        ),
    )
        .equation(r"\mathit{gap}_{1\min} = \alpha - \theta_1^{\min},\quad \mathit{gap}_{1\max} = \theta_1^{\max} - \alpha,\quad \mathit{gap}_{3\min} = \gamma - \theta_3^{\min},\quad \mathit{gap}_{3\max} = \theta_3^{\max} - \gamma")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = StopAngles<T>;
    type Outputs<T: Component> = AngleGaps<T>;

    #[inline]
    fn eval<D: Scalar>(i: &StopAngles<D>) -> AngleGaps<D> {
        AngleGaps {
            gap1_min: i.alpha - i.theta1_min,
            gap1_max: i.theta1_max - i.alpha,
            gap3_min: i.gamma - i.theta3_min,
            gap3_max: i.theta3_max - i.gamma,
        }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &StopAngles<D>) -> Jacobian<Self, D> {
        const {
            let (zero, one, minus_one) = (D::ZERO, D::ONE, D::MINUS_ONE);
            let none = StopAngles {
                alpha: zero,
                gamma: zero,
                theta1_min: zero,
                theta1_max: zero,
                theta3_min: zero,
                theta3_max: zero,
            };
            AngleGaps {
                gap1_min: StopAngles { alpha: one, theta1_min: minus_one, ..none },
                gap1_max: StopAngles { alpha: minus_one, theta1_max: one, ..none },
                gap3_min: StopAngles { gamma: one, theta3_min: minus_one, ..none },
                gap3_max: StopAngles { gamma: minus_one, theta3_max: one, ..none },
            }
        }
    }

    #[inline]
    fn validate<D: Scalar>(i: &StopAngles<D>) -> Result<(), Error> {
        Error::check_order(("theta1_min", i.theta1_min), ("theta1_max", i.theta1_max))?;
        Error::check_order(("theta3_min", i.theta3_min), ("theta3_max", i.theta3_max))
    }
}
