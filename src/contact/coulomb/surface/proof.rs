//! Evidence for the formula of the parent module: cases, kinks, laws.

use super::{ReturnMap2d, Tangential2d, Trial2d};
use crate::Octuple;
use crate::contact::coulomb::response::proof::not_positive;
use crate::contact::coulomb::{ReturnMap, Trial};
use crate::formula::Formula;
use crate::formula::proof::{Case, Kink, Law, Proved, law};
use crate::number::scalar::norm;
use nalgebra::Vector2;
use num_traits::Zero;

/// Slips: 5 > 0.25 × 8; the transmitted force is 2 in the direction (0.6, 0.8).
const SLIPPING: Trial2d<f64> = Trial2d { f_trial: Vector2::new(3.0, 4.0), mu: 0.25, r#fn: 8.0 };

fn length(v: &Vector2<Octuple>) -> Octuple {
    norm([v.x, v.y])
}

/// The size of the trial force.
fn tried(i: &Trial2d<Octuple>) -> Octuple {
    length(&i.f_trial)
}

impl Proved for ReturnMap2d {
    fn cases() -> Vec<Case<Trial2d<f64>>> {
        let with = |x, y| Trial2d { f_trial: Vector2::new(x, y), ..SLIPPING };
        vec![
            Case::hand("stick", "5 < 0.75 × 8", Trial2d { mu: 0.75, ..SLIPPING }),
            Case::hand("slip", "5 > 0.25 × 8: 2 along (0.6, 0.8)", SLIPPING),
            Case::hand("slip-back", "the force follows the trial force", with(-3.0, -4.0)),
            Case::hand("along-x", "as in one direction: 2", with(3.0, 0.0)),
            Case::hand("along-y", "as in one direction: -2", with(0.0, -3.0)),
            Case::hand("frictionless", "μ = 0 transmits nothing", Trial2d { mu: 0.0, ..SLIPPING }),
            Case::hand("open", "F_N = 0 transmits nothing", Trial2d { r#fn: 0.0, ..SLIPPING }),
            Case::hard("unloaded", "no trial force sticks", with(0.0, 0.0)),
            Case::hard(
                "tie",
                "|f_trial| = μ F_N: the value is defined, the Jacobian is not",
                Trial2d { r#fn: 20.0, ..SLIPPING },
            ),
            Case::hard("inside", "1e-9 inside the tie", Trial2d { r#fn: 20.0 + 1e-8, ..SLIPPING }),
            Case::hard("outside", "1e-9 outside the tie", Trial2d { r#fn: 20.0 - 1e-8, ..SLIPPING }),
            Case::hard("uneven", "one component 1e-17 of the other", with(3.0, 3e-17)),
            Case::hard("tiny", "squares underflow", Trial2d { r#fn: 8e-200, ..with(3e-200, -4e-200) }),
            Case::hard("huge", "squares overflow", Trial2d { r#fn: 8e200, ..with(-3e200, 4e200) }),
            Case::hard("stiff", "a trial force of 1e20", with(3e20, -4e20)),
            Case::running("6.25 > 0.5 × 4: 2 along (0.6, 0.8)", Trial2d { mu: 0.5, r#fn: 4.0, ..with(3.75, 5.0) }),
        ]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            r"\lvert\mathbf{f}^{\mathrm{trial}}\rvert = \mu F_N",
            |i| tried(i) == i.mu * i.r#fn,
            Trial2d { r#fn: 20.0, ..SLIPPING },
            Trial2d { f_trial: Vector2::new(3.0, 4.0), mu: 0.0, r#fn: 0.0 },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("what is transmitted never exceeds μ F_N", |i| {
                let limit = i.mu * i.r#fn;
                not_positive(length(&Self::eval(i).f) - limit, limit)
            }),
            Law::<Self>::new("it has the direction of the trial force", |i| {
                let f = Self::eval(i).f;
                let across = law::equal_with(f.perp(&i.f_trial), Octuple::zero(), length(&f) * tried(i));
                [across, not_positive(-f.dot(&i.f_trial), Octuple::zero())].concat()
            }),
            Law::<Self>::new("a force along an axis is mapped as in one direction", |i| {
                let f_trial = i.f_trial.x;
                let Tangential2d { f } = Self::eval(&Trial2d { f_trial: Vector2::new(f_trial, Octuple::zero()), ..*i });
                let one = ReturnMap::eval(&Trial { f_trial, mu: i.mu, r#fn: i.r#fn }).f;
                law::equal_all([(f.x, one), (f.y, Octuple::zero())])
            }),
            Law::<Self>::new("mapping twice changes nothing more", |i| {
                let Tangential2d { f } = Self::eval(i);
                let Tangential2d { f: again } = Self::eval(&Trial2d { f_trial: f, ..*i });
                law::equal_all_with([(again.x, f.x), (again.y, f.y)], length(&f))
            }),
            Law::<Self>::new("the tangent is symmetric; in slip the force does not grow with the trial force", |i| {
                let slipping = Trial2d { f_trial: i.f_trial * (i.mu * i.r#fn * 2.0 / tried(i)), ..*i };
                let Tangential2d { f: by } = Self::jacobian(&slipping);
                let growth = [by.x, by.y].map(|row| (row.f_trial.dot(&slipping.f_trial), Octuple::zero()));
                let limit = i.mu * i.r#fn;
                [law::equal(by.x.f_trial.y, by.y.f_trial.x), law::equal_all_with(growth, limit)].concat()
            }),
        ]
    }
}
