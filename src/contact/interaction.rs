//! Contact pressure against overclosure, and contact damping.
//!
//! The overclosure h is the separation with the opposite sign: positive when the surfaces overlap, −h is the clearance, and h = 0
//! where they touch. Its rate v is positive while the surfaces approach. A pressure is positive when it pushes them apart.

#[cfg(feature = "verify")]
mod proof;

use crate::fields;
use crate::formula::error::Error;
use crate::formula::quantity::{
    CLEARANCE, CLOSING_RATE, DAMPING_FRACTION, MU0, OVERCLOSURE, PRESSURE, PRESSURE_AT_TOUCH, STIFFNESS,
};
use crate::formula::{Component, Document, Fields, Finite, Formula, Jacobian, Source, Spec, ValueAndJacobian};
use crate::number::scalar::{Leaf, Scalar, abs, choice, constant, exp_m1};

const SOURCE: Source = Document::SLIDE_LINE.ours(
    "Defining nondefault mechanical surface interactions with slide line elements",
    "the section names the laws; those that it refers to were not given",
);

fields! {
    /// Contact pressure.
    pub struct ContactPressure<T> { p: T = PRESSURE }
}

fields! {
    /// Overclosure and stiffness.
    pub struct LinearContact<T> { h: T = OVERCLOSURE, k: T = STIFFNESS }
}

/// Linear pressure–overclosure law: p = k h for h > 0, else 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressureLinear;

impl Formula for PressureLinear {
    const SPEC: Spec = Spec::new("interaction.pressure_linear", "Linear pressure–overclosure law", SOURCE)
        .equation(r"p = \begin{cases} k\,h & h > 0 \\ 0 & \text{otherwise}\end{cases}")
        .eta(1.0, 0.0)
        .scale(1e250)
        .finite(Finite::Below);
    type Inputs<T: Component> = LinearContact<T>;
    type Outputs<T: Component> = ContactPressure<T>;

    #[inline]
    fn eval<D: Scalar>(i: &LinearContact<D>) -> ContactPressure<D> {
        ContactPressure { p: if i.h > 0.0 { i.k * i.h } else { D::zero() } }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &LinearContact<D>) -> Jacobian<Self, D> {
        ContactPressure {
            p: if i.h > 0.0 { LinearContact { h: i.k, k: i.h } } else { LinearContact::filled(D::zero()) },
        }
    }
}

fields! {
    /// Overclosure, and the two parameters of the exponential law.
    pub struct ExponentialContact<T> { h: T = OVERCLOSURE, c0: T = CLEARANCE, p0: T = PRESSURE_AT_TOUCH }
}

/// Exponential pressure–overclosure law: p = p0/(e−1) · s (eˢ − 1) with s = h/c0 + 1, for s > 0, else 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressureExponential;

impl PressureExponential {
    /// p/p0, and its derivative with respect to s; `None` without contact.
    ///
    /// With q = h/c0, p/p0 is (1 + q)(1 + κ (e^q − 1)), κ = e/(e − 1), which is insensitive to the rounding of 1 + q. Near the
    /// onset, where the second factor vanishes, it is computed as s (eˢ − 1)/(e − 1): there the sum h + c0 is exact. Hence the
    /// form is s (1 + m) or s m, with m = κ (e^q − 1) or (eˢ − 1)/(e − 1).
    #[inline(always)]
    #[expect(clippy::inline_always, reason = "a call would write the results to memory, and wait for them there")]
    fn rise<D: Scalar>(i: &ExponentialContact<D>) -> Option<[D; 2]> {
        let [kappa, per] = growth::<D>();
        let [s, exponent, factor, beside] = choice(|| {
            if i.h * 2.0 >= -i.c0 {
                let q = i.h / i.c0;
                [q + 1.0, q, kappa, D::one()]
            } else {
                let s = (i.h + i.c0) / i.c0;
                [s, s, per, D::zero()]
            }
        });
        if s <= 0.0 {
            return None;
        }
        let m = exp_m1(exponent) * factor;
        Some([s * (m + beside), s * (m + factor) + (m + beside)])
    }

    #[cold]
    fn check_slopes<D: Scalar>(i: &ExponentialContact<D>) -> Result<(), Error> {
        let slopes = Self::jacobian(i).p.components();
        if slopes.iter().all(|&slope| abs(slope) <= f64::MAX) { Ok(()) } else { Err(Error::Overflow { name: "p" }) }
    }
}

impl Formula for PressureExponential {
    const SPEC: Spec = Spec::new("interaction.pressure_exponential", "Exponential pressure–overclosure law", SOURCE)
        .equation(r"p = \begin{cases} \dfrac{p_0}{e-1}\,s\,(e^s - 1) & s > 0 \\ 0 & \text{otherwise}\end{cases}\qquad s = \frac{h}{c_0} + 1")
        .eta(5.0, 8.0)
        .scale(1e120);
    type Inputs<T: Component> = ExponentialContact<T>;
    type Outputs<T: Component> = ContactPressure<T>;

    #[inline]
    fn eval<D: Scalar>(i: &ExponentialContact<D>) -> ContactPressure<D> {
        ContactPressure { p: Self::rise(i).map_or(D::zero(), |[share, _]| i.p0 * share) }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &ExponentialContact<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    /// ds = (dh − q dc0)/c0.
    #[inline]
    fn linearized<D: Scalar>(i: &ExponentialContact<D>) -> ValueAndJacobian<Self, D> {
        let Some([share, by_s]) = Self::rise(i) else {
            return (ContactPressure { p: D::zero() }, ContactPressure { p: ExponentialContact::filled(D::zero()) });
        };
        let slope = i.p0 / i.c0 * by_s;
        let p = ExponentialContact { h: slope, c0: -(slope * (i.h / i.c0)), p0: share };
        (ContactPressure { p: i.p0 * share }, ContactPressure { p })
    }

    #[inline]
    fn validate<D: Scalar>(i: &ExponentialContact<D>) -> Result<(), Error> {
        // eˢ < 3e43 while s < 100, so that no slope overflows.
        if i.h < i.c0 * 99.0 && i.c0 > 1e-100 && i.p0 < 1e100 {
            return Ok(());
        }
        Self::check_slopes(i)
    }
}

/// e/(e − 1) and 1/(e − 1).
#[inline]
fn growth<D: Scalar>() -> [D; 2] {
    let of = |minus_one: D::Leaf| [(minus_one + 1.0) / minus_one, D::Leaf::from(1.0) / minus_one];
    D::Leaf::constants([1.581_976_706_869_326_5, 0.581_976_706_869_326_5], || of(D::Leaf::e_minus_one())).map(constant)
}

fields! {
    /// Overclosure and its rate, and the parameters of damping.
    pub struct DampingContact<T> {
        h: T = OVERCLOSURE, v: T = CLOSING_RATE, mu0: T = MU0, c0: T = CLEARANCE, eta: T = DAMPING_FRACTION,
    }
}

/// Viscous contact damping: μ0 v up to the clearance η c0, falling linearly to 0 at c0.
#[derive(Clone, Copy, Debug)]
pub struct Damping;

/// The zones of the damping coefficient.
enum Zone {
    None,
    Ramp,
    Full,
}

impl Zone {
    #[inline]
    fn of<D: Scalar>(i: &DampingContact<D>) -> Self {
        let clearance = -i.h;
        if clearance <= i.eta * i.c0 {
            Self::Full
        } else if clearance < i.c0 {
            Self::Ramp
        } else {
            Self::None
        }
    }
}

impl Formula for Damping {
    const SPEC: Spec = Spec::new("interaction.damping", "Viscous contact damping", SOURCE)
        .equation(r"p = v \begin{cases} \mu_0 & -h \le \eta c_0 \\ \mu_0\,\dfrac{c_0 + h}{(1-\eta)\,c_0} & \eta c_0 < -h < c_0 \\ 0 & \text{otherwise}\end{cases}")
        // The largest η that `audit --attack` found is 1.54 for the value, and 2 is possible to first order; for the Jacobian 1.96
        // and 2.67.
        .eta(2.0, 2.67)
        // Beyond this scale 237 bits cannot represent c0 + h, which the check needs.
        .scale(1e40)
        .finite(Finite::Between);
    type Inputs<T: Component> = DampingContact<T>;
    type Outputs<T: Component> = ContactPressure<T>;

    #[inline]
    fn eval<D: Scalar>(i: &DampingContact<D>) -> ContactPressure<D> {
        let p = match Zone::of(i) {
            Zone::Full => i.mu0 * i.v,
            Zone::Ramp => i.mu0 * i.v * ((i.h + i.c0) / ((-i.eta + 1.0) * i.c0)),
            Zone::None => D::zero(),
        };
        ContactPressure { p }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &DampingContact<D>) -> Jacobian<Self, D> {
        let zero = DampingContact::filled(D::zero());
        let p = match Zone::of(i) {
            Zone::Full => DampingContact { v: i.mu0, mu0: i.v, ..zero },
            Zone::Ramp => {
                let rest = -i.eta + 1.0;
                let part = (i.h + i.c0) / (rest * i.c0);
                let full = i.mu0 * i.v;
                let h = full / (rest * i.c0);
                DampingContact { h, v: i.mu0 * part, mu0: i.v * part, c0: -(h * (i.h / i.c0)), eta: full * part / rest }
            }
            Zone::None => zero,
        };
        ContactPressure { p }
    }
}
