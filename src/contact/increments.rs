//! Friction and angles over increments: what happens from one state of a scene to the next.
//!
//! These are [`Formula`]s like any other, and the audit proves their Jacobians too; they are not in the
//! [catalog](crate::catalog), which contains the formulas of the documents.

#![expect(clippy::inline_always, reason = "a call would write the inputs to memory, and wait for them there")]

mod proof;

use crate::element::cardan::nearest;
use crate::fields;
use crate::formula::quantity::{DU, Domain, F_TANGENTIAL, P, Quantity, SLIP, U1, Unit};
use crate::formula::{Component, Document, Formula, Jacobian, Spec};
use crate::number::scalar::{Scalar, abs, sign};

/// Displacement at the start of the increment.
pub const U1_BEFORE: Quantity =
    Quantity::scalar(r"u_1^-", Unit::L, Domain::Real, "available displacement in the last state");
/// Accumulated slip.
pub const TOTAL: Quantity = Quantity::scalar(r"s", Unit::L, Domain::NonNegative, "accumulated slip, never falling");
/// Accumulated slip at the start of the increment.
pub const TOTAL_BEFORE: Quantity =
    Quantity::scalar(r"s^-", Unit::L, Domain::NonNegative, "accumulated slip in the last state");

/// The reason why all of these are ours.
const WHY: &str = "the page says when it sticks, and not how one state follows from another";

pub(crate) const fn spec(id: &'static str, title: &'static str, latex: &'static str) -> Spec {
    Spec::new(id, title, Document::SLOT.ours("Friction", WHY)).equation(latex).eta(4.0, 4.0)
}

fields! {
    /// Displacement now and in the last state.
    pub struct Displaced<T> { u1: T = U1, u1_before: T = U1_BEFORE }
}
fields! {
    /// Displacement since the last state.
    pub struct Moved<T> { du: T = DU }
}

/// The motion along a free direction since the last state: Δu = u1 − u1⁻.
#[derive(Clone, Copy, Debug)]
pub struct Increment;

impl Formula for Increment {
    const SPEC: Spec = spec("scene.increment", "Motion of an increment", r"\Delta u = u_1 - u_1^-");
    type Inputs<T: Component> = Displaced<T>;
    type Outputs<T: Component> = Moved<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Displaced<D>) -> Moved<D> {
        Moved { du: i.u1 - i.u1_before }
    }
}

/// Stick stiffness of a joint that rotates.
pub const TURN_STICK: Quantity =
    Quantity::scalar(r"k", Unit::FL, Domain::Positive, "rotational stiffness in stick, moment per radian");
/// An angle computed from the triads.
pub const ANGLE: Quantity = Quantity::scalar(r"\alpha", Unit::ONE, Domain::Angle, "angle, from −π to below π");
/// The angle at the start.
pub const ANGLE_START: Quantity = Quantity::scalar(r"\alpha_0", Unit::ONE, Domain::Angle, "angle at the start");
/// The rotation in the last state.
pub const TURNED: Quantity =
    Quantity::scalar(r"u_r^-", Unit::ONE, Domain::Angle, "available rotation in the last state");
/// The angle, including full turns.
pub const FOLLOWED: Quantity = Quantity::scalar(
    r"\alpha^{\mathrm{full}}",
    Unit::ONE,
    Domain::Angle,
    "angle, followed from state to state over full turns",
);

fields! {
    /// The computed angle, its initial value, and the rotation in the last state.
    pub struct Sighting<T> { angle: T = ANGLE, start: T = ANGLE_START, turned: T = TURNED }
}
fields! {
    /// The angle including full turns.
    pub struct Followed<T> { followed: T = FOLLOWED }
}

/// The angle plus the number of full turns that brings it nearest to the one in the last state.
#[derive(Clone, Copy, Debug)]
pub struct Follow;

impl Formula for Follow {
    const SPEC: Spec = Spec::new(
        "scene.follow",
        "Angle followed over full turns",
        Document::UJOINT.ours("Summary", "the page names the rotations, and not what they are beyond half a turn"),
    )
    .equation(r"\alpha^{\mathrm{full}} = \alpha + 2\pi\operatorname{round}\frac{\alpha_0 + u_r^- - \alpha}{2\pi}")
    .eta(4.0, 4.0);
    type Inputs<T: Component> = Sighting<T>;
    type Outputs<T: Component> = Followed<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Sighting<D>) -> Followed<D> {
        Followed { followed: nearest(i.angle, i.start + i.turned) }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &Sighting<D>) -> Jacobian<Self, D> {
        Followed { followed: Sighting { angle: D::one(), start: D::zero(), turned: D::zero() } }
    }
}

fields! {
    /// The slip of the increment, and the slip before it.
    pub struct Slips<T> { slip: T = SLIP, slip_before: T = TOTAL_BEFORE }
}
fields! {
    /// The slip so far.
    pub struct SlipTotal<T> { slip_total: T = TOTAL }
}

/// The slip accumulates, whatever its direction: s = s⁻ + |Δs|.
#[derive(Clone, Copy, Debug)]
pub struct Accumulated;

impl Formula for Accumulated {
    const SPEC: Spec = spec("scene.slip_total", "Accumulated slip", r"s = s^- + \lvert\Delta s\rvert");
    type Inputs<T: Component> = Slips<T>;
    type Outputs<T: Component> = SlipTotal<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Slips<D>) -> SlipTotal<D> {
        SlipTotal { slip_total: i.slip_before + abs(i.slip) }
    }
}

/// The load along a free direction, without friction.
pub const F_LOAD: Quantity =
    Quantity::scalar(r"f_1^{\mathrm{load}}", Unit::F, Domain::Real, "kinetic force that the connector is loaded with");
/// The total force along a free direction.
pub const F_KINETIC: Quantity = Quantity::scalar(r"f_1", Unit::F, Domain::Real, "kinetic force, friction included");

fields! {
    /// The load along a free direction, and the friction there.
    pub struct KineticLoads<T> { f_load: T = F_LOAD, csf: T = F_TANGENTIAL }
}
fields! {
    /// Their sum.
    pub struct KineticSum<T> { f_kinetic: T = F_KINETIC }
}

/// The total force along a free direction: the load and the computed friction force, f1 = f_load + f.
#[derive(Clone, Copy, Debug)]
pub struct Kinetic;

impl Formula for Kinetic {
    const SPEC: Spec = spec("scene.kinetic", "Load and friction", r"f_1 = f_1^{\mathrm{load}} + f");
    type Inputs<T: Component> = KineticLoads<T>;
    type Outputs<T: Component> = KineticSum<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KineticLoads<D>) -> KineticSum<D> {
        KineticSum { f_kinetic: i.f_load + i.csf }
    }

    #[inline]
    fn jacobian<D: Scalar>(_: &KineticLoads<D>) -> Jacobian<Self, D> {
        KineticSum { f_kinetic: KineticLoads { f_load: D::one(), csf: D::one() } }
    }
}

fields! {
    /// A friction force.
    pub struct Transmitted<T> { csf: T = F_TANGENTIAL }
}
fields! {
    /// Its magnitude.
    pub struct TractionSize<T> { p: T = P }
}

/// The tangential traction of the computed friction force: P = |f|.
#[derive(Clone, Copy, Debug)]
pub struct Traction;

impl Formula for Traction {
    const SPEC: Spec = spec("scene.traction", "Tangential traction", r"P = \lvert f\rvert");
    type Inputs<T: Component> = Transmitted<T>;
    type Outputs<T: Component> = TractionSize<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Transmitted<D>) -> TractionSize<D> {
        TractionSize { p: abs(i.csf) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Transmitted<D>) -> Jacobian<Self, D> {
        TractionSize { p: Transmitted { csf: sign(i.csf) } }
    }
}
