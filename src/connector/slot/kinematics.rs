//! The position of b along the slot, the constraint that holds it on the slot, and the forces.

#![expect(clippy::inline_always, reason = "compiled in place, zeros that lie side by side are stored together")]

#[cfg(feature = "verify")]
mod proof;

use crate::element::line::Positions;
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    E1A, E2A, E2A_PLANE, E3A, F1, F2, F3, FORCE, GAP_MAX, GAP_MIN, GY, GZ, KINETIC_FORCE, L1_MAX, L1_MIN, L1_REF, U1,
    U1_MAT, X, X0, XA, XA_PLANE, XB, XB_PLANE, Y, Y0, Z, Z0,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Jacobian, Spec, along};
use crate::number::scalar::Scalar;
use nalgebra::{Vector2, Vector3};

fields! {
    /// The relative position of b in the triad of a.
    pub struct Relative<T> { x: T = X, y: T = Y, z: T = Z }
}

/// Relative position of b in a's triad: x = e1a·(xb − xa), y = e2a·(xb − xa), z = e3a·(xb − xa).
#[derive(Clone, Copy, Debug)]
pub struct RelativePosition;

impl Formula for RelativePosition {
    const SPEC: Spec = Spec::new("slot.relative_position", "Relative position", Document::SLOT.printed("Description"))
        .equation(r"x = \mathbf{e}_{1a}\cdot(\mathbf{x}_b-\mathbf{x}_a),\quad y = \mathbf{e}_{2a}\cdot(\mathbf{x}_b-\mathbf{x}_a),\quad z = \mathbf{e}_{3a}\cdot(\mathbf{x}_b-\mathbf{x}_a)")
        .eta(4.0, 1.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = Positions<T>;
    type Outputs<T: Component> = Relative<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Positions<D>) -> Relative<D> {
        let d = i.xb - i.xa;
        Relative { x: i.e1a.dot(&d), y: i.e2a.dot(&d), z: i.e3a.dot(&d) }
    }

    #[inline(always)]
    fn jacobian<D: Scalar>(i: &Positions<D>) -> Jacobian<Self, D> {
        let d = i.xb - i.xa;
        let zero = Positions::filled(D::zero());
        Relative {
            x: Positions { e1a: d, xa: -i.e1a, xb: i.e1a, ..zero },
            y: Positions { e2a: d, xa: -i.e2a, xb: i.e2a, ..zero },
            z: Positions { e3a: d, xa: -i.e3a, xb: i.e3a, ..zero },
        }
    }
}

fields! {
    /// The positions of both nodes, the axes of a normal to the slot, and the position of the slot.
    pub struct SlotPositions<T> {
        e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, xa: Vector3<T> = XA, xb: Vector3<T> = XB,
        y0: T = Y0, z0: T = Z0,
    }
}
fields! {
    /// The deviations of b from the slot.
    pub struct Residuals<T> { gy: T = GY, gz: T = GZ }
}

/// The two conditions that hold b on the slot: y − y0 = 0, z − z0 = 0.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

impl Formula for Constraint {
    const SPEC: Spec = Spec::new("slot.constraint", "Constraint", Document::SLOT.printed("Description"))
        .equation(r"g_y = \mathbf{e}_{2a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - y_0,\quad g_z = \mathbf{e}_{3a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - z_0")
        .eta(4.0, 1.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = SlotPositions<T>;
    type Outputs<T: Component> = Residuals<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotPositions<D>) -> Residuals<D> {
        let d = i.xb - i.xa;
        Residuals { gy: i.e2a.dot(&d) - i.y0, gz: i.e3a.dot(&d) - i.z0 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SlotPositions<D>) -> Jacobian<Self, D> {
        let d = i.xb - i.xa;
        let zero = SlotPositions::filled(D::zero());
        Residuals {
            gy: SlotPositions { e2a: d, xa: -i.e2a, xb: i.e2a, y0: -D::one(), ..zero },
            gz: SlotPositions { e3a: d, xa: -i.e3a, xb: i.e3a, z0: -D::one(), ..zero },
        }
    }
}

fields! {
    /// The inputs of [`SlotPositions`], in the plane.
    pub struct SlotPositions2d<T> {
        e2a: Vector2<T> = E2A_PLANE, xa: Vector2<T> = XA_PLANE, xb: Vector2<T> = XB_PLANE, y0: T = Y0,
    }
}
fields! {
    /// The deviation of b from the slot in the plane.
    pub struct Residual2d<T> { gy: T = GY }
}

/// The condition that holds b on the slot in the plane: y − y0 = 0.
#[derive(Clone, Copy, Debug)]
pub struct Constraint2d;

impl Formula for Constraint2d {
    const SPEC: Spec =
        Spec::new("slot.constraint_2d", "Constraint in the plane", Document::SLOT.printed("Description"))
            .equation(r"g_y = \mathbf{e}_{2a}\cdot(\mathbf{x}_b-\mathbf{x}_a) - y_0")
            .eta(4.0, 1.0)
            .scale(1e250)
            .finite(Finite::Below);
    type Inputs<T: Component> = SlotPositions2d<T>;
    type Outputs<T: Component> = Residual2d<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotPositions2d<D>) -> Residual2d<D> {
        Residual2d { gy: i.e2a.dot(&(i.xb - i.xa)) - i.y0 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SlotPositions2d<D>) -> Jacobian<Self, D> {
        Residual2d { gy: SlotPositions2d { e2a: i.xb - i.xa, xa: -i.e2a, xb: i.e2a, y0: -D::one() } }
    }
}

fields! {
    /// The two directions normal to the slot, and the constraint force along them.
    pub struct CrossFrame<T> { e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, f2: T = F2, f3: T = F3 }
}
fields! {
    /// A constraint force on node b; its opposite acts on node a.
    pub struct Force<T> { f: Vector3<T> = FORCE }
}

/// The force that holds b on the slot: f = f2 e2a + f3 e3a. In the plane f3 = 0.
#[derive(Clone, Copy, Debug)]
pub struct ConstraintForce;

impl Formula for ConstraintForce {
    const SPEC: Spec = Spec::new("slot.constraint_force", "Constraint force", Document::SLOT.printed("Description"))
        .equation(r"\mathbf{f} = f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a}")
        .eta(2.0, 1.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = CrossFrame<T>;
    type Outputs<T: Component> = Force<T>;

    #[inline]
    fn eval<D: Scalar>(i: &CrossFrame<D>) -> Force<D> {
        Force { f: i.e2a * i.f2 + i.e3a * i.f3 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &CrossFrame<D>) -> Jacobian<Self, D> {
        let row = |k| CrossFrame { e2a: along(k, i.f2), e3a: along(k, i.f3), f2: i.e2a[k], f3: i.e3a[k] };
        Force { f: Vector3::new(row(0), row(1), row(2)) }
    }
}

fields! {
    /// The position of b along the slot, and the lengths from which displacements are measured.
    pub struct SlotLengths<T> { x: T = X, x0: T = X0, l1_ref: T = L1_REF }
}
fields! {
    /// Displacement along the slot.
    pub struct Displacements<T> { u1: T = U1, u1_mat: T = U1_MAT }
}

/// Displacement along the slot, from the start and from the reference length: u1 = x − x0, u1_mat = x − l1_ref.
#[derive(Clone, Copy, Debug)]
pub struct RelativeMotion;

impl Formula for RelativeMotion {
    const SPEC: Spec = Spec::new("slot.relative_motion", "Relative motion", Document::SLOT.printed("Description"))
        .equation(r"u_1 = x - x_0,\quad u_1^{\mathrm{mat}} = x - l_1^{\mathrm{ref}}")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = SlotLengths<T>;
    type Outputs<T: Component> = Displacements<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotLengths<D>) -> Displacements<D> {
        Displacements { u1: i.x - i.x0, u1_mat: i.x - i.l1_ref }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &SlotLengths<D>) -> Jacobian<Self, D> {
        const {
            Displacements {
                u1: SlotLengths { x: D::ONE, x0: D::MINUS_ONE, l1_ref: D::ZERO },
                u1_mat: SlotLengths { x: D::ONE, x0: D::ZERO, l1_ref: D::MINUS_ONE },
            }
        }
    }
}

fields! {
    /// A kinetic force on node a; its opposite acts on node b.
    pub struct AlongForce<T> { f: Vector3<T> = KINETIC_FORCE }
}
fields! {
    /// The direction of the slot, and the force along it.
    pub struct SlotForce<T> { e1a: Vector3<T> = E1A, f1: T = F1 }
}

/// The force along the slot: f = f1 e1a.
///
/// It is conjugate to u1, so that it acts on a and its opposite, −f1 e1a, on b: if b moves on against a positive f1, the
/// connector absorbs the work f1 du1.
#[derive(Clone, Copy, Debug)]
pub struct KineticForce;

impl Formula for KineticForce {
    const SPEC: Spec = Spec::new("slot.kinetic_force", "Kinetic force", Document::SLOT.printed("Description"))
        .equation(r"\mathbf{f} = f_1\,\mathbf{e}_{1a}")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = SlotForce<T>;
    type Outputs<T: Component> = AlongForce<T>;

    #[inline]
    fn eval<D: Scalar>(i: &SlotForce<D>) -> AlongForce<D> {
        AlongForce { f: i.e1a * i.f1 }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &SlotForce<D>) -> Jacobian<Self, D> {
        let row = |k| SlotForce { e1a: along(k, i.f1), f1: i.e1a[k] };
        AlongForce { f: Vector3::new(row(0), row(1), row(2)) }
    }
}

fields! {
    /// The position of b along the slot, and the stops.
    pub struct StopLengths<T> { x: T = X, l1_min: T = L1_MIN, l1_max: T = L1_MAX }
}
fields! {
    /// Distances to the stops.
    pub struct Gaps<T> { gap_min: T = GAP_MIN, gap_max: T = GAP_MAX }
}

/// Distances to the stops, both ≥ 0 if b is between them: x − l1_min, l1_max − x.
#[derive(Clone, Copy, Debug)]
pub struct Stop;

impl Formula for Stop {
    const SPEC: Spec = Spec::new(
        "slot.stop",
        "Stops",
        Document::SLOT
            .reconstructed("Summary", "both signs ≤ were lost; l, which the page does not define, is taken for x"),
    )
    .equation(r"\mathit{gap}_{\min} = x - l_1^{\min},\quad \mathit{gap}_{\max} = l_1^{\max} - x")
    .eta(1.0, 0.0)
    .scale(1e250)
    .finite(Finite::Below);
    type Inputs<T: Component> = StopLengths<T>;
    type Outputs<T: Component> = Gaps<T>;

    #[inline]
    fn eval<D: Scalar>(i: &StopLengths<D>) -> Gaps<D> {
        Gaps { gap_min: i.x - i.l1_min, gap_max: i.l1_max - i.x }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &StopLengths<D>) -> Jacobian<Self, D> {
        const {
            Gaps {
                gap_min: StopLengths { x: D::ONE, l1_min: D::MINUS_ONE, l1_max: D::ZERO },
                gap_max: StopLengths { x: D::MINUS_ONE, l1_min: D::ZERO, l1_max: D::ONE },
            }
        }
    }

    #[inline]
    fn validate<D: Scalar>(i: &StopLengths<D>) -> Result<(), Error> {
        Error::check_order(("l1_min", i.l1_min), ("l1_max", i.l1_max))
    }
}
