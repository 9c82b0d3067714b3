//! What a hinge holds, and how far its angle goes.

use crate::connector::join::{self, Joined};
use crate::connector::revolute::{self, Axes, C2, C3, G_R2, G_R3, Tilt};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    ALPHA, D0, E1A, E2A, E2B, E3A, E3B, G_JOIN, GAP1_MAX, GAP1_MIN, THETA1_MAX, THETA1_MIN, XA, XB,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Jacobian, Spec, along};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

/// The page of the connection type HINGE.
pub const DOCUMENT: Document = Document::new("HINGE");

fields! {
    /// Positions and orientations of the nodes, and their initial values.
    pub struct Hinged<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        xa: Vector3<T> = XA, xb: Vector3<T> = XB, d0: Vector3<T> = D0, c2: T = C2, c3: T = C3,
    }
}
fields! {
    /// The residuals of JOIN and of REVOLUTE.
    pub struct HingeResiduals<T> { g: Vector3<T> = G_JOIN, g2: T = G_R2, g3: T = G_R3 }
}

/// The five conditions of a hinge: JOIN's three and REVOLUTE's two.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec::new(
        "hinge.constraint",
        "Constraint",
        DOCUMENT.ours("Description", "the page names JOIN and REVOLUTE, whose pages print their conditions"),
    )
    .equation(
        r"g_i = \mathbf{e}_{ia}\cdot(\mathbf{x}_b-\mathbf{x}_a) - d_{0i}\ (i = 1, 2, 3),\quad g_{r2} = \mathbf{e}_{1a}\cdot\mathbf{e}_{2b} - c_2,\quad g_{r3} = \mathbf{e}_{1a}\cdot\mathbf{e}_{3b} - c_3",
    )
    .eta(2.0, 1.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = Hinged<T>;
    type Outputs<T: Component> = HingeResiduals<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Hinged<D>) -> HingeResiduals<D> {
        let Hinged { e1a, e2a, e3a, e2b, e3b, xa, xb, d0, c2, c3 } = *i;
        let g = join::Constraint::eval(&Joined { e1a, e2a, e3a, xa, xb, d0 }).g;
        let Tilt { g2, g3 } = revolute::Constraint::eval(&Axes { e1a, e2b, e3b, c2, c3 });
        HingeResiduals { g, g2, g3 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Hinged<D>) -> Jacobian<Self, D> {
        let (d, none) = (i.xb - i.xa, Hinged::filled(D::zero()));
        let held = |k| along(k, -D::one());
        let tilt = revolute::Constraint::jacobian(&Axes { e1a: i.e1a, e2b: i.e2b, e3b: i.e3b, c2: i.c2, c3: i.c3 });
        let row = |Axes { e1a, e2b, e3b, c2, c3 }| Hinged { e1a, e2b, e3b, c2, c3, ..none };
        HingeResiduals {
            g: Vector3::new(
                Hinged { e1a: d, xa: -i.e1a, xb: i.e1a, d0: held(0), ..none },
                Hinged { e2a: d, xa: -i.e2a, xb: i.e2a, d0: held(1), ..none },
                Hinged { e3a: d, xa: -i.e3a, xb: i.e3a, d0: held(2), ..none },
            ),
            g2: row(tilt.g2),
            g3: row(tilt.g3),
        }
    }
}

fields! {
    /// The free angle, and its stops.
    pub struct StopAngle<T> { alpha: T = ALPHA, theta1_min: T = THETA1_MIN, theta1_max: T = THETA1_MAX }
}
fields! {
    /// The angles left to both stops.
    pub struct AngleGap<T> { gap_min: T = GAP1_MIN, gap_max: T = GAP1_MAX }
}

/// The angles left to the stops: α − θ1_min and θ1_max − α.
#[derive(Clone, Copy, Debug)]
pub struct Stop;

impl Formula for Stop {
    const SPEC: Spec = Spec::new("hinge.stop", "Stops", DOCUMENT.printed("Summary"))
        .equation(
            r"\mathit{gap}_{1\min} = \alpha - \theta_1^{\min},\quad \mathit{gap}_{1\max} = \theta_1^{\max} - \alpha",
        )
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = StopAngle<T>;
    type Outputs<T: Component> = AngleGap<T>;

    #[inline]
    fn eval<D: Scalar>(i: &StopAngle<D>) -> AngleGap<D> {
        AngleGap { gap_min: i.alpha - i.theta1_min, gap_max: i.theta1_max - i.alpha }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &StopAngle<D>) -> Jacobian<Self, D> {
        let (zero, one) = (D::zero(), D::one());
        AngleGap {
            gap_min: StopAngle { alpha: one, theta1_min: -one, theta1_max: zero },
            gap_max: StopAngle { alpha: -one, theta1_min: zero, theta1_max: one },
        }
    }

    #[inline]
    fn validate<D: Scalar>(i: &StopAngle<D>) -> Result<(), Error> {
        Error::check_order(("theta1_min", i.theta1_min), ("theta1_max", i.theta1_max))
    }
}
