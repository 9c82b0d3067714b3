//! Contact pressure against overclosure, and contact damping.
//!
//! The overclosure h is the separation with the opposite sign: positive when the surfaces overlap, −h is the clearance.

use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{
    CLEARANCE, CLOSING_RATE, DAMPING_FRACTION, MU0, OVERCLOSURE, PRESSURE, PRESSURE_AT_TOUCH, STIFFNESS,
};
use crate::scalar::{Scalar, e_minus_one};
use crate::verify::law;

const SOURCE: Source =
    Source::SLIDE_LINE.section("Defining nondefault mechanical surface interactions with slide line elements");

fields! {
    /// Contact pressure.
    pub struct ContactPressure<T> { p: T = PRESSURE }
}

fields! {
    /// Overclosure and stiffness.
    pub struct LinearContact<T> { h: T = OVERCLOSURE, k: T = STIFFNESS }
}

/// Linear pressure–overclosure law: p = k h for h > 0, else 0.
#[derive(Clone, Copy, Debug)]
pub struct PressureLinear;

impl Formula for PressureLinear {
    const SPEC: Spec = Spec {
        id: "interaction.pressure_linear",
        title: "Linear pressure–overclosure law",
        latex: r"p = \begin{cases} k\,h & h > 0 \\ 0 & \text{otherwise}\end{cases}",
        source: SOURCE,
        eta: 1.0,
        eta_jacobian: 0.0,
        objective: true,
    };
    type Inputs<T: Element> = LinearContact<T>;
    type Outputs<T: Element> = ContactPressure<T>;

    fn eval<D: Scalar>(i: &LinearContact<D>) -> ContactPressure<D> {
        ContactPressure { p: if i.h > 0.0 { i.k * i.h } else { D::zero() } }
    }

    fn jacobian<D: Scalar>(i: &LinearContact<D>) -> Jacobian<Self, D> {
        ContactPressure {
            p: if i.h > 0.0 { LinearContact { h: i.k, k: i.h } } else { LinearContact::filled(D::zero()) },
        }
    }

    fn cases() -> Vec<Case<LinearContact<f64>>> {
        let hand = LinearContact { h: 0.5, k: 8.0 };
        vec![
            Case::hand("closed", "8 × 0.5", hand),
            Case::hand("open", "no tension", LinearContact { h: -0.5, ..hand }),
            Case::limit("touching", "h = 0: no pressure yet", LinearContact { h: 0.0, ..hand }),
            Case::hard("just-closed", "the least overclosure", LinearContact { h: 1e-200, ..hand }),
            Case::hard("just-open", "the least clearance", LinearContact { h: -1e-200, ..hand }),
            Case::hard("huge", "1e200 × 1e100", LinearContact { h: 1e200, k: 1e100 }),
            Case::hard("tiny", "1e-200 × 1e-100", LinearContact { h: 1e-200, k: 1e-100 }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: "h = 0",
            convention: Convention::Switch,
            holds: |i| i.h == 0.0,
            at: || LinearContact { h: 0.0, k: 8.0 },
            across: || LinearContact { h: 1.0, k: 0.0 },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "the pressure on both sides of touching adds up to k |h|",
            sides: |i| {
                let other = LinearContact { h: -i.h, ..*i };
                law::equal(Self::eval(i).p + Self::eval(&other).p, i.k * crate::scalar::abs(i.h))
            },
        }]
    }
}

fields! {
    /// Overclosure, and the two parameters of the exponential law.
    pub struct ExponentialContact<T> { h: T = OVERCLOSURE, c0: T = CLEARANCE, p0: T = PRESSURE_AT_TOUCH }
}

/// Exponential pressure–overclosure law: p = p0/(e−1) · s (eˢ − 1) with s = h/c0 + 1, for s > 0, else 0.
#[derive(Clone, Copy, Debug)]
pub struct PressureExponential;

impl PressureExponential {
    /// s = h/c0 + 1 with a single rounding that counts: near the onset h = −c0 the sum h + c0 is exact.
    #[inline]
    fn closure<D: Scalar>(i: &ExponentialContact<D>) -> D {
        if i.h * 2.0 < -i.c0 { (i.h + i.c0) / i.c0 } else { i.h / i.c0 + 1.0 }
    }
}

impl Formula for PressureExponential {
    const SPEC: Spec = Spec {
        id: "interaction.pressure_exponential",
        title: "Exponential pressure–overclosure law",
        latex: r"p = \begin{cases} \dfrac{p_0}{e-1}\,s\,(e^s - 1) & s > 0 \\ 0 & \text{otherwise}\end{cases}\qquad s = \frac{h}{c_0} + 1",
        source: SOURCE,
        eta: 8.0,
        eta_jacobian: 8.0,
        objective: true,
    };
    type Inputs<T: Element> = ExponentialContact<T>;
    type Outputs<T: Element> = ContactPressure<T>;

    fn eval<D: Scalar>(i: &ExponentialContact<D>) -> ContactPressure<D> {
        let s = Self::closure(i);
        ContactPressure { p: if s > 0.0 { i.p0 * (s * (s.exp_m1() / e_minus_one::<D>())) } else { D::zero() } }
    }

    /// d(s(eˢ − 1))/ds = (1 + s)(eˢ − 1) + s, and ds = (dh − (s − 1) dc0)/c0.
    fn jacobian<D: Scalar>(i: &ExponentialContact<D>) -> Jacobian<Self, D> {
        let s = Self::closure(i);
        if s <= 0.0 {
            return ContactPressure { p: ExponentialContact::filled(D::zero()) };
        }
        let growth = s.exp_m1();
        let slope = i.p0 / e_minus_one::<D>() * ((s + 1.0) * growth + s) / i.c0;
        let p = ExponentialContact { h: slope, c0: -(slope * (i.h / i.c0)), p0: s * (growth / e_minus_one::<D>()) };
        ContactPressure { p }
    }

    fn validate(i: &ExponentialContact<f64>) -> Result<(), Error> {
        let slopes = Self::jacobian(i).p.components();
        if slopes.iter().all(|slope| slope.is_finite()) { Ok(()) } else { Err(Error::Overflow { name: "p" }) }
    }

    fn cases() -> Vec<Case<ExponentialContact<f64>>> {
        let hand = ExponentialContact { h: 0.0, c0: 2.0, p0: 3.5 };
        vec![
            Case::hand("touching", "h = 0: s = 1 and p = p0", hand),
            Case::hand("open", "beyond the clearance c0", ExponentialContact { h: -3.0, ..hand }),
            Case::limit("onset", "h = -c0: s = 0", ExponentialContact { h: -2.0, ..hand }),
            Case::hand("half-way", "h = -c0/2: s = 1/2", ExponentialContact { h: -1.0, ..hand }),
            Case::hand("closed", "s = 2", ExponentialContact { h: 2.0, ..hand }),
            Case::hard(
                "near-onset",
                "s = 1e-12: eˢ - 1 would cancel",
                ExponentialContact { h: -1.0 + 1e-12, c0: 1.0, ..hand },
            ),
            Case::hard(
                "ulp-above-onset",
                "h one ulp above -c0",
                ExponentialContact { h: (-2.0_f64).next_up(), ..hand },
            ),
            Case::hard(
                "ulp-below-onset",
                "h one ulp below -c0",
                ExponentialContact { h: (-2.0_f64).next_down(), ..hand },
            ),
            Case::hard("deep", "s = 101: e^101", ExponentialContact { h: 200.0, ..hand }),
            Case::hard("deepest", "s = 691: e^691, near the largest double", ExponentialContact { h: 1380.0, ..hand }),
            Case::hard(
                "hard-limit",
                "c0 = 1e-12: nearly hard contact",
                ExponentialContact { h: 3e-12, c0: 1e-12, p0: 1.0 },
            ),
            Case::hard("wide", "c0 = 1e12", ExponentialContact { h: -0.25, c0: 1e12, p0: 1.0 }),
            Case::hard("tiny", "lengths of 1e-200", ExponentialContact { h: 1e-200, c0: 3e-200, p0: 1e-50 }),
        ]
    }

    fn invalid_cases() -> Vec<Case<ExponentialContact<f64>>> {
        let too_deep = ExponentialContact { h: 1e6, c0: 1.0, p0: 1.0 };
        vec![Case::invalid("overflow", "e^1000001 is not a double", too_deep)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: "h = -c_0",
            convention: Convention::Switch,
            holds: |i| i.h == -i.c0,
            at: || ExponentialContact { h: -2.0, c0: 2.0, p0: 3.5 },
            across: || ExponentialContact { h: 1.0, c0: 0.0, p0: 0.0 },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "the pressure at touching is p0, and it begins at the clearance c0",
            sides: |i| {
                let at = |h| Self::eval(&ExponentialContact { h, ..*i }).p;
                law::equal_all([(at(0.0.into()), i.p0), (at(-i.c0), 0.0.into())])
            },
        }]
    }
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

/// How far the damping coefficient has risen.
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
    const SPEC: Spec = Spec {
        id: "interaction.damping",
        title: "Viscous contact damping",
        latex: r"p = v \begin{cases} \mu_0 & -h \le \eta c_0 \\ \mu_0\,\dfrac{c_0 + h}{(1-\eta)\,c_0} & \eta c_0 < -h < c_0 \\ 0 & \text{otherwise}\end{cases}",
        source: SOURCE,
        eta: 4.0,
        eta_jacobian: 6.0,
        objective: true,
    };
    type Inputs<T: Element> = DampingContact<T>;
    type Outputs<T: Element> = ContactPressure<T>;

    fn eval<D: Scalar>(i: &DampingContact<D>) -> ContactPressure<D> {
        let p = match Zone::of(i) {
            Zone::Full => i.mu0 * i.v,
            Zone::Ramp => i.mu0 * i.v * ((i.h + i.c0) / ((-i.eta + 1.0) * i.c0)),
            Zone::None => D::zero(),
        };
        ContactPressure { p }
    }

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

    fn cases() -> Vec<Case<DampingContact<f64>>> {
        let hand = DampingContact { h: 1.0, v: 2.0, mu0: 3.0, c0: 4.0, eta: 0.25 };
        vec![
            Case::hand("closed", "overlapping: 3 × 2", hand),
            Case::hand("full", "clearance 0.5 < η c0 = 1: 3 × 2", DampingContact { h: -0.5, ..hand }),
            Case::hand("ramp", "clearance 2: two thirds of it", DampingContact { h: -2.0, ..hand }),
            Case::hand("open", "clearance 5 > c0", DampingContact { h: -5.0, ..hand }),
            Case::hand("separating", "damping resists opening too", DampingContact { v: -2.0, ..hand }),
            Case::limit("corner-full", "clearance η c0", DampingContact { h: -1.0, ..hand }),
            Case::limit("corner-none", "clearance c0", DampingContact { h: -4.0, ..hand }),
            Case::limit(
                "no-plateau",
                "η = 0: the ramp begins at touching",
                DampingContact { h: -2.0, eta: 0.0, ..hand },
            ),
            Case::limit("undamped", "μ0 = 0", DampingContact { mu0: 0.0, ..hand }),
            Case::limit("at-rest", "v = 0", DampingContact { v: 0.0, h: -2.0, ..hand }),
            Case::hard("touching", "η = 0 and h = 0: on the corner", DampingContact { h: 0.0, eta: 0.0, ..hand }),
            Case::hard(
                "ulp-inside",
                "one ulp inside the clearance",
                DampingContact { h: (-4.0_f64).next_up(), ..hand },
            ),
            Case::hard("ulp-beyond", "one ulp beyond it", DampingContact { h: (-4.0_f64).next_down(), ..hand }),
            Case::hard(
                "steep",
                "η one ulp below 1: the ramp is one ulp wide",
                DampingContact { h: -0.5, eta: 1.0_f64.next_down(), ..hand },
            ),
            Case::hard(
                "steep-ramp",
                "η = 1 - 1e-8",
                DampingContact { h: -(1.0 - 2.0_f64.powi(-28)), c0: 1.0, eta: 1.0 - 2.0_f64.powi(-27), ..hand },
            ),
            Case::hard("tiny", "lengths of 1e-200", DampingContact { h: -2e-200, c0: 4e-200, ..hand }),
            Case::hard("huge", "lengths of 1e200", DampingContact { h: -2e200, c0: 4e200, ..hand }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        let across = || DampingContact { h: 1.0, v: 0.0, mu0: 0.0, c0: 0.0, eta: 0.0 };
        vec![
            Kink {
                condition: r"h = -\eta c_0",
                convention: Convention::Switch,
                holds: |i| -i.h == i.eta * i.c0,
                at: || DampingContact { h: -1.0, v: 2.0, mu0: 3.0, c0: 4.0, eta: 0.25 },
                across,
            },
            Kink {
                condition: "h = -c_0",
                convention: Convention::Switch,
                holds: |i| -i.h == i.c0,
                at: || DampingContact { h: -4.0, v: 2.0, mu0: 3.0, c0: 4.0, eta: 0.25 },
                across,
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "it resists: reversing the rate reverses the pressure",
                sides: |i| law::equal(Self::eval(i).p, -Self::eval(&DampingContact { v: -i.v, ..*i }).p),
            },
            Law {
                statement: "half-way between the corners half of it acts",
                sides: |i| {
                    let h = -(i.eta + 1.0) * i.c0 * 0.5;
                    law::equal(Self::eval(&DampingContact { h, ..*i }).p * 2.0, i.mu0 * i.v)
                },
            },
        ]
    }
}
