//! Evidence for the formulas of the parent module: cases, kinks, laws, other methods.

use super::{
    ContactPressure, Damping, DampingContact, ExponentialContact, LinearContact, PressureExponential, PressureLinear,
};
use crate::formula::Formula;
use crate::formula::proof::{Case, Convention, Kink, Law, Method, Proved, law};
use crate::number::scalar::{Scalar, e_minus_one};

impl Proved for PressureLinear {
    fn cases() -> Vec<Case<LinearContact<f64>>> {
        let hand = LinearContact { h: 0.5, k: 8.0 };
        vec![
            Case::running("8 × 0.5", hand),
            Case::hand("open", "no tension", LinearContact { h: -0.5, ..hand }),
            Case::hand("touching", "h = 0: no pressure yet", LinearContact { h: 0.0, ..hand }),
            Case::hard("just-closed", "the least overclosure", LinearContact { h: 1e-200, ..hand }),
            Case::hard("just-open", "the least clearance", LinearContact { h: -1e-200, ..hand }),
            Case::hard("huge", "1e200 × 1e100", LinearContact { h: 1e200, k: 1e100 }),
            Case::hard("tiny", "1e-200 × 1e-100", LinearContact { h: 1e-200, k: 1e-100 }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::vanishing(Convention::Switch, LinearContact { h: 0.0, k: 8.0 }, |i| [i.h])]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("the pressure on both sides of touching adds up to k |h|", |i| {
            let other = LinearContact { h: -i.h, ..*i };
            law::equal(Self::eval(i).p + Self::eval(&other).p, i.k * crate::number::scalar::abs(i.h))
        })]
    }
}

impl Proved for PressureExponential {
    fn methods() -> Vec<Method> {
        vec![Method::new::<Self>("plain", "exponential function minus one", plain_exponential, plain_exponential)]
    }

    fn cases() -> Vec<Case<ExponentialContact<f64>>> {
        let hand = ExponentialContact { h: 0.0, c0: 2.0, p0: 3.5 };
        vec![
            Case::hand("touching", "h = 0: s = 1 and p = p0", hand),
            Case::hand("open", "beyond the clearance c0", ExponentialContact { h: -3.0, ..hand }),
            Case::hand("onset", "h = -c0: s = 0", ExponentialContact { h: -2.0, ..hand }),
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
            Case::running("s = 2: 0.5 × 2 (e² - 1)/(e - 1) = e + 1", ExponentialContact { h: 0.5, c0: 0.5, p0: 0.5 }),
        ]
    }

    fn invalid_cases() -> Vec<Case<ExponentialContact<f64>>> {
        let too_deep = ExponentialContact { h: 1e6, c0: 1.0, p0: 1.0 };
        vec![Case::invalid("overflow", "e^1000001 is not a double", too_deep)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            "h = -c_0",
            |i| i.h == -i.c0,
            ExponentialContact { h: -2.0, c0: 2.0, p0: 3.5 },
            ExponentialContact { h: 1.0, c0: 0.0, p0: 0.0 },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law::<Self>::new("the pressure at touching is p0, and it begins at the clearance c0", |i| {
            let at = |h| Self::eval(&ExponentialContact { h, ..*i }).p;
            law::equal_all([(at(0.0.into()), i.p0), (at(-i.c0), 0.0.into())])
        })]
    }
}

impl Proved for Damping {
    fn cases() -> Vec<Case<DampingContact<f64>>> {
        let hand = DampingContact { h: 1.0, v: 2.0, mu0: 3.0, c0: 4.0, eta: 0.25 };
        vec![
            Case::hand("closed", "overlapping: 3 × 2", hand),
            Case::hand("full", "clearance 0.5 < η c0 = 1: 3 × 2", DampingContact { h: -0.5, ..hand }),
            Case::hand("ramp", "clearance 2: two thirds of it", DampingContact { h: -2.0, ..hand }),
            Case::hand("open", "clearance 5 > c0", DampingContact { h: -5.0, ..hand }),
            Case::hand("separating", "damping resists opening too", DampingContact { v: -2.0, ..hand }),
            Case::hand("corner-full", "clearance η c0", DampingContact { h: -1.0, ..hand }),
            Case::hand("corner-none", "clearance c0", DampingContact { h: -4.0, ..hand }),
            Case::hand(
                "no-plateau",
                "η = 0: the ramp begins at touching",
                DampingContact { h: -2.0, eta: 0.0, ..hand },
            ),
            Case::hand("undamped", "μ0 = 0", DampingContact { mu0: 0.0, ..hand }),
            Case::hand("at-rest", "v = 0", DampingContact { v: 0.0, h: -2.0, ..hand }),
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
            Case::running(
                "clearance 0.25: (0.5 - 0.25)/(0.5 - 0.1) of 4 × 2",
                DampingContact { h: -0.25, v: 2.0, mu0: 4.0, c0: 0.5, eta: 0.2 },
            ),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        let across = || DampingContact { h: 1.0, v: 0.0, mu0: 0.0, c0: 0.0, eta: 0.0 };
        vec![
            Kink::<Self>::switch(
                r"h = -\eta c_0",
                |i| -i.h == i.eta * i.c0,
                DampingContact { h: -1.0, v: 2.0, mu0: 3.0, c0: 4.0, eta: 0.25 },
                across(),
            ),
            Kink::<Self>::switch(
                "h = -c_0",
                |i| -i.h == i.c0,
                DampingContact { h: -4.0, v: 2.0, mu0: 3.0, c0: 4.0, eta: 0.25 },
                across(),
            ),
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it resists: reversing the rate reverses the pressure", |i| {
                law::equal(Self::eval(i).p, -Self::eval(&DampingContact { v: -i.v, ..*i }).p)
            }),
            Law::<Self>::new("half-way between the corners half of it acts", |i| {
                let h = -(i.eta + 1.0) * i.c0 * 0.5;
                law::equal(Self::eval(&DampingContact { h, ..*i }).p * 2.0, i.mu0 * i.v)
            }),
        ]
    }
}

/// The textbook form: eˢ − 1 cancels if s is small.
fn plain_exponential<D: Scalar>(i: &ExponentialContact<D>) -> ContactPressure<D> {
    let s = i.h / i.c0 + 1.0;
    ContactPressure { p: if s > 0.0 { i.p0 / e_minus_one::<D>() * s * (s.exp() - 1.0) } else { D::zero() } }
}
