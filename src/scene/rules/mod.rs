//! The formulas that a scene needs in addition to the documented ones: friction over increments, angles suited to programs, and
//! the coordinate that a sliding node keeps.
//!
//! These are [`Formula`]s like any other, so the audit of this crate proves their Jacobians too; they are not in the
//! [catalog](crate::catalog), which contains the formulas of the documents.

#![expect(clippy::inline_always, reason = "a call would write the inputs to memory, and wait for them there")]

mod axes;
mod list;
#[cfg(feature = "verify")]
mod proof;
mod since;

pub use axes::{AXES, AXIS, EliminatedAxes, EliminatedAxis, LineNodes, LineNodes2d, PivotAxes, PivotAxis2d};
pub use list::RULES;
pub use since::{Bearing, Carried, Q1, Q2, Q3, R1, R2, R3, R10, R20, R30, Seen, TurnedAxes, TurnedBack};

use crate::connector::align::{self, Misalignment, Moments, Orientations, wrapped};
use crate::connector::slider::{Eliminate, Increment2d, Pivots, Pivots2d};
use crate::element::cardan::{
    Angles, BetaAxes, BetaTwoArgument, CardanAngles, Oriented, Triads, accurate, accurate_jacobian, check_start,
    check_turns, nearest,
};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    DU, Domain, E1A, E2A, E3A, F_TANGENTIAL, F2, F3, FORCE, JOIN_F1, P, Quantity, SLIDER_DXM, SLIDER_DXM_PLANE,
    SLIDER_DXMK, SLIDER_X1, SLIDER_X1_PLANE, SLIDER_XM, SLIDER_XM_PLANE, SLIDER_XMK, SLIDER_XN, SLIDER_XN_PLANE, SLIP,
    Shape, U1, Unit,
};
use crate::formula::{Component, Document, Formula, Given, Jacobian, Spec, along};
use crate::number::scalar::{Scalar, abs, sign};
use nalgebra::{Vector2, Vector3};

pub(in crate::scene) const fn scalar(
    latex: &'static str,
    unit: Unit,
    domain: Domain,
    meaning: &'static str,
) -> Quantity {
    Quantity { latex, shape: Shape::Scalar, unit, domain, meaning }
}

/// Displacement at the start of the increment.
pub const U1_BEFORE: Quantity = scalar(r"u_1^-", Unit::L, Domain::Real, "available displacement in the last state");
/// Accumulated slip.
pub const TOTAL: Quantity = scalar(r"s", Unit::L, Domain::NonNegative, "accumulated slip, never falling");
/// Accumulated slip at the start of the increment.
pub const TOTAL_BEFORE: Quantity = scalar(r"s^-", Unit::L, Domain::NonNegative, "accumulated slip in the last state");

/// The reason why all of these are ours.
const WHY: &str = "the page says when it sticks, and not how one state follows from another";

const fn spec(id: &'static str, title: &'static str, latex: &'static str) -> Spec {
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
    scalar(r"k", Unit::FL, Domain::Positive, "rotational stiffness in stick, moment per radian");
/// An angle computed from the triads.
pub const ANGLE: Quantity = scalar(r"\alpha", Unit::ONE, Domain::Angle, "angle, from −π to below π");
/// The angle at the start.
pub const ANGLE_START: Quantity = scalar(r"\alpha_0", Unit::ONE, Domain::Angle, "angle at the start");
/// The rotation in the last state.
pub const TURNED: Quantity = scalar(r"u_r^-", Unit::ONE, Domain::Angle, "available rotation in the last state");
/// The angle, including full turns.
pub const FOLLOWED: Quantity =
    scalar(r"\alpha^{\mathrm{full}}", Unit::ONE, Domain::Angle, "angle, followed from state to state over full turns");

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
    scalar(r"f_1^{\mathrm{load}}", Unit::F, Domain::Real, "kinetic force that the connector is loaded with");
/// The total force along a free direction.
pub const F_KINETIC: Quantity = scalar(r"f_1", Unit::F, Domain::Real, "kinetic force, friction included");

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

fields! {
    /// The triad of a, and the forces along its axes.
    pub struct JoinLoads<T> {
        e1a: Vector3<T> = E1A, e2a: Vector3<T> = E2A, e3a: Vector3<T> = E3A, f1: T = JOIN_F1, f2: T = F2, f3: T = F3,
    }
}
fields! {
    /// The force on b.
    pub struct JoinForce<T> { f: Vector3<T> = FORCE }
}

impl<D: Scalar> JoinLoads<D> {
    /// The sum along a's axes is the same as that of ALIGN's moments.
    #[inline(always)]
    fn moments(&self) -> Moments<D> {
        let Self { e1a, e2a, e3a, f1, f2, f3 } = *self;
        Moments { e1a, e2a, e3a, m1: f1, m2: f2, m3: f3 }
    }
}

/// The force on b that JOIN transmits: f = f1 e1a + f2 e2a + f3 e3a.
#[derive(Clone, Copy, Debug)]
pub struct Joining;

impl Formula for Joining {
    const SPEC: Spec = Spec::new("scene.join_force", "Constraint force of JOIN", Document::UJOINT.printed("Friction"))
        .equation(r"\mathbf{f} = f_1\,\mathbf{e}_{1a} + f_2\,\mathbf{e}_{2a} + f_3\,\mathbf{e}_{3a}")
        .eta(1.5, 0.0);
    type Inputs<T: Component> = JoinLoads<T>;
    type Outputs<T: Component> = JoinForce<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &JoinLoads<D>) -> JoinForce<D> {
        JoinForce { f: align::ConstraintMoment::eval(&i.moments()).m }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &JoinLoads<D>) -> Jacobian<Self, D> {
        let row = |Moments { e1a, e2a, e3a, m1, m2, m3 }| JoinLoads { e1a, e2a, e3a, f1: m1, f2: m2, f3: m3 };
        JoinForce { f: align::ConstraintMoment::jacobian(&i.moments()).m.map(row) }
    }
}

/// The Cardan angles with which a joint starts, with β from two arguments; rejected so close to ±90° that residuals are useless.
#[derive(Clone, Copy, Debug)]
pub struct Turns;

impl Formula for Turns {
    const SPEC: Spec = spec(
        "scene.angles",
        "Cardan angles, β from two arguments",
        r"\beta = \operatorname{atan2}\bigl(\mathbf{e}_{1a}\cdot\mathbf{e}_{3b},\ \sqrt{(\mathbf{e}_{1a}\cdot\mathbf{e}_{1b})^2 + (\mathbf{e}_{1a}\cdot\mathbf{e}_{2b})^2}\bigr)",
    )
    .given(&[Given::new(r"\alpha,\ \gamma", &CardanAngles::SPEC)]);
    type Inputs<T: Component> = Triads<T>;
    type Outputs<T: Component> = Angles<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Triads<D>) -> Angles<D> {
        accurate(i)
    }
    #[inline]
    fn jacobian<D: Scalar>(i: &Triads<D>) -> Jacobian<Self, D> {
        accurate_jacobian(i)
    }
    #[inline]
    fn validate<D: Scalar>(i: &Triads<D>) -> Result<(), Error> {
        check_turns(i)?;
        check_start(BetaTwoArgument::eval(&BetaAxes::from(i)).beta)
    }
}

/// ALIGN's residuals with β from two arguments, and with differences of α and γ reduced to angles from −π to π.
#[derive(Clone, Copy, Debug)]
pub struct Alignment;

impl Formula for Alignment {
    const SPEC: Spec = spec(
        "scene.alignment",
        "Residuals of ALIGN, without jumps",
        r"u_{r1} = w(\alpha - \alpha_0),\quad u_{r2} = \beta - \beta_0,\quad u_{r3} = w(\gamma - \gamma_0),\quad w(\delta) = \begin{cases} \delta & \lvert\delta\rvert \le \pi \\ \delta - 2\pi\operatorname{sign}\delta & \text{otherwise} \end{cases}",
    )
    .given(&[Given::new(r"\alpha,\ \gamma", &CardanAngles::SPEC), Given::new(r"\beta", &BetaTwoArgument::SPEC)]);
    type Inputs<T: Component> = Orientations<T>;
    type Outputs<T: Component> = Misalignment<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Orientations<D>) -> Misalignment<D> {
        let Angles { alpha, beta, gamma } = accurate(&i.triads());
        Misalignment { ur1: wrapped(alpha - i.alpha0), ur2: beta - i.beta0, ur3: wrapped(gamma - i.gamma0) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Orientations<D>) -> Jacobian<Self, D> {
        Misalignment::since_start(accurate_jacobian(&i.triads()))
    }

    #[inline]
    fn validate<D: Scalar>(i: &Orientations<D>) -> Result<(), Error> {
        check_turns(&i.triads())
    }
}

fields! {
    /// The coordinate that is kept, and its increment.
    pub struct Kept<T> { xmk: T = SLIDER_XMK, dxmk: T = SLIDER_DXMK }
}
fields! {
    /// The line, node m and its increment.
    pub struct KeptNodes<T> {
        x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xm: Vector3<T> = SLIDER_XM, dxm: Vector3<T> = SLIDER_DXM,
    }
}

/// The coordinate of node m along the axis that the documented pivots keep, and its increment.
#[derive(Clone, Copy, Debug)]
pub struct KeptAxis;

impl Formula for KeptAxis {
    const SPEC: Spec = Spec {
        objective: false,
        ..spec(
            "scene.kept_axis",
            "The coordinate that is kept",
            r"x_{m,k} = \mathbf{x}_m\cdot\mathbf{e}_k,\quad \mathrm{d}x_{m,k} = \mathrm{d}\mathbf{x}_m\cdot\mathbf{e}_k,\quad \mathbf{e}_k = \begin{cases} \mathbf{i} & k = 1 \\ \mathbf{j} & k = 2 \\ \mathbf{k} & k = 3 \end{cases}",
        )
        .given(&[Given::new("k", &Eliminate::SPEC)])
    };
    type Inputs<T: Component> = KeptNodes<T>;
    type Outputs<T: Component> = Kept<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptNodes<D>) -> Kept<D> {
        let k = Pivots::new(&i.x1, &i.xn).k;
        Kept { xmk: i.xm[k], dxmk: i.dxm[k] }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptNodes<D>) -> Jacobian<Self, D> {
        let k = Pivots::new(&i.x1, &i.xn).k;
        let zero = Vector3::from_element(D::zero());
        let axis = along(k, D::one());
        let none = KeptNodes { x1: zero, xn: zero, xm: zero, dxm: zero };
        Kept { xmk: KeptNodes { xm: axis, ..none }, dxmk: KeptNodes { dxm: axis, ..none } }
    }

    #[inline]
    fn validate<D: Scalar>(i: &KeptNodes<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}

fields! {
    /// The line, node m and its increment, in the plane.
    pub struct KeptNodes2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
        dxm: Vector2<T> = SLIDER_DXM_PLANE,
    }
}

/// As [`KeptAxis`], in the plane.
#[derive(Clone, Copy, Debug)]
pub struct KeptAxis2d;

impl Formula for KeptAxis2d {
    const SPEC: Spec = Spec {
        id: "scene.kept_axis_2d",
        given: &[Given::new("k", &Increment2d::SPEC)],
        latex: r"x_{m,k} = \mathbf{x}_m\cdot\mathbf{e}_k,\quad \mathrm{d}x_{m,k} = \mathrm{d}\mathbf{x}_m\cdot\mathbf{e}_k,\quad \mathbf{e}_k = \begin{cases} (1, 0) & k = 1 \\ (0, 1) & k = 2 \end{cases}",
        ..KeptAxis::SPEC
    };
    type Inputs<T: Component> = KeptNodes2d<T>;
    type Outputs<T: Component> = Kept<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptNodes2d<D>) -> Kept<D> {
        let k = Pivots2d::new(&i.x1, &i.xn).k;
        Kept { xmk: i.xm[k], dxmk: i.dxm[k] }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptNodes2d<D>) -> Jacobian<Self, D> {
        let k = Pivots2d::new(&i.x1, &i.xn).k;
        let (zero, axis) = (Vector2::from_element(D::zero()), along(k, D::one()));
        let none = KeptNodes2d { x1: zero, xn: zero, xm: zero, dxm: zero };
        Kept { xmk: KeptNodes2d { xm: axis, ..none }, dxmk: KeptNodes2d { dxm: axis, ..none } }
    }

    #[inline]
    fn validate<D: Scalar>(i: &KeptNodes2d<D>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }
}
