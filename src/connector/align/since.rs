//! The rotation of b since the start, relative to a: angles that are regular for every initial orientation of b, and residuals
//! without jumps.

#![expect(clippy::inline_always, reason = "a call would write the inputs to memory, and wait for them there")]

mod proof;

use super::{Misalignment, Orientations, wrapped};
use crate::contact::increments::spec;
use crate::element::cardan::{
    Angles, BetaAxes, BetaTwoArgument, CardanAngles, Oriented, Triads, accurate, accurate_jacobian, check_start,
    check_turns,
};
use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{Domain, E1B, E2B, E3B, Quantity, Shape, Unit};
use crate::formula::{Component, Document, Fields, Formula, Given, Jacobian, Spec, along};
use crate::number::scalar::Scalar;
use nalgebra::Vector3;

const fn vector(latex: &'static str, domain: Domain, meaning: &'static str) -> Quantity {
    Quantity::new(latex, Shape::Vec3, Unit::ONE, domain, meaning)
}

/// First axis of b, relative to a.
pub const R1: Quantity = vector(r"\mathbf{r}_1", Domain::Real, "first axis of b as components in a's triad");
/// Second axis of b, relative to a.
pub const R2: Quantity = vector(r"\mathbf{r}_2", Domain::Real, "second axis of b as components in a's triad");
/// Third axis of b, relative to a.
pub const R3: Quantity = vector(r"\mathbf{r}_3", Domain::Real, "third axis of b as components in a's triad");
/// First axis of b, relative to a at the start.
pub const R10: Quantity = vector(r"\mathbf{r}_{10}", Domain::Real, "first axis of b in a's triad at the start");
/// Second axis of b, relative to a at the start.
pub const R20: Quantity = vector(r"\mathbf{r}_{20}", Domain::Real, "second axis of b in a's triad at the start");
/// Third axis of b, relative to a at the start.
pub const R30: Quantity = vector(r"\mathbf{r}_{30}", Domain::Real, "third axis of b in a's triad at the start");
/// First axis of a at the start, rotated with b.
pub const Q1: Quantity =
    vector(r"\mathbf{q}_1", Domain::Vector, "where b has rotated the first axis of a since the start");
/// Second axis of a at the start, rotated with b.
pub const Q2: Quantity =
    vector(r"\mathbf{q}_2", Domain::Vector, "where b has rotated the second axis of a since the start");
/// Third axis of a at the start, rotated with b.
pub const Q3: Quantity =
    vector(r"\mathbf{q}_3", Domain::Vector, "where b has rotated the third axis of a since the start");

fields! {
    /// The axes of b, relative to a.
    pub struct Seen<T> { r1: Vector3<T> = R1, r2: Vector3<T> = R2, r3: Vector3<T> = R3 }
}

/// The axes of b as components in a's triad: r_j = (e1a·e_jb, e2a·e_jb, e3a·e_jb).
#[derive(Clone, Copy, Debug)]
pub struct Bearing;

const WHY: &str =
    "the page of ALIGN was not given; to measure angles from where b stood keeps them regular wherever that is";

impl Formula for Bearing {
    const SPEC: Spec = Spec::new("scene.bearing", "Axes of b, seen from a", Document::TRANSLATOR.ours("Description", WHY))
        .equation(r"\mathbf{r}_1 = (\mathbf{e}_{1a}\cdot\mathbf{e}_{1b},\ \mathbf{e}_{2a}\cdot\mathbf{e}_{1b},\ \mathbf{e}_{3a}\cdot\mathbf{e}_{1b}),\quad \mathbf{r}_2 = (\mathbf{e}_{1a}\cdot\mathbf{e}_{2b},\ \mathbf{e}_{2a}\cdot\mathbf{e}_{2b},\ \mathbf{e}_{3a}\cdot\mathbf{e}_{2b}),\quad \mathbf{r}_3 = (\mathbf{e}_{1a}\cdot\mathbf{e}_{3b},\ \mathbf{e}_{2a}\cdot\mathbf{e}_{3b},\ \mathbf{e}_{3a}\cdot\mathbf{e}_{3b})")
        .eta(2.0, 1.0);
    type Inputs<T: Component> = Triads<T>;
    type Outputs<T: Component> = Seen<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Triads<D>) -> Seen<D> {
        let seen = |e: &Vector3<D>| Vector3::new(i.e1a.dot(e), i.e2a.dot(e), i.e3a.dot(e));
        Seen { r1: seen(&i.e1b), r2: seen(&i.e2b), r3: seen(&i.e3b) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Triads<D>) -> Jacobian<Self, D> {
        let zero = Triads::filled(D::zero());
        let (a, b) = ([i.e1a, i.e2a, i.e3a], [i.e1b, i.e2b, i.e3b]);
        let row = |j: usize| {
            let of = |k: usize| {
                let mut row = zero;
                *[&mut row.e1a, &mut row.e2a, &mut row.e3a][k] = b[j];
                *[&mut row.e1b, &mut row.e2b, &mut row.e3b][j] = a[k];
                row
            };
            Vector3::new(of(0), of(1), of(2))
        };
        Seen { r1: row(0), r2: row(1), r3: row(2) }
    }
}

fields! {
    /// The triad of b, and its initial components relative to a.
    pub struct Carried<T> {
        e1b: Vector3<T> = E1B, e2b: Vector3<T> = E2B, e3b: Vector3<T> = E3B,
        r10: Vector3<T> = R10, r20: Vector3<T> = R20, r30: Vector3<T> = R30,
    }
}
fields! {
    /// The initial axes of a, rotated with b since the start.
    pub struct TurnedAxes<T> { q1: Vector3<T> = Q1, q2: Vector3<T> = Q2, q3: Vector3<T> = Q3 }
}

/// The initial axes of a, rotated with b since the start: q_j = r10_j e1b + r20_j e2b + r30_j e3b.
///
/// At the start they are a's axes, for every orientation of b; their Cardan angles relative to a are 0 there, with condition
/// number 1.
#[derive(Clone, Copy, Debug)]
pub struct TurnedBack;

impl Formula for TurnedBack {
    const SPEC: Spec =
        Spec::new("scene.turned_back", "Axes of a, turned with b since the start", Document::TRANSLATOR.ours("Description", WHY))
            .equation(r"\mathbf{q}_1 = r_{10,1}\,\mathbf{e}_{1b} + r_{20,1}\,\mathbf{e}_{2b} + r_{30,1}\,\mathbf{e}_{3b},\quad \mathbf{q}_2 = r_{10,2}\,\mathbf{e}_{1b} + r_{20,2}\,\mathbf{e}_{2b} + r_{30,2}\,\mathbf{e}_{3b},\quad \mathbf{q}_3 = r_{10,3}\,\mathbf{e}_{1b} + r_{20,3}\,\mathbf{e}_{2b} + r_{30,3}\,\mathbf{e}_{3b}")
            .eta(2.0, 1.0);
    type Inputs<T: Component> = Carried<T>;
    type Outputs<T: Component> = TurnedAxes<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Carried<D>) -> TurnedAxes<D> {
        let turned = |j: usize| i.e1b * i.r10[j] + i.e2b * i.r20[j] + i.e3b * i.r30[j];
        TurnedAxes { q1: turned(0), q2: turned(1), q3: turned(2) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Carried<D>) -> Jacobian<Self, D> {
        let row = |j: usize, c: usize| Carried {
            e1b: along(c, i.r10[j]),
            e2b: along(c, i.r20[j]),
            e3b: along(c, i.r30[j]),
            r10: along(j, i.e1b[c]),
            r20: along(j, i.e2b[c]),
            r30: along(j, i.e3b[c]),
        };
        let of = |j: usize| Vector3::new(row(j, 0), row(j, 1), row(j, 2));
        TurnedAxes { q1: of(0), q2: of(1), q3: of(2) }
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
