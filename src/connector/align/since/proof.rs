//! Evidence for the formulas of the parent module.

use super::{Alignment, Bearing, TurnedBack, Turns};
use crate::connector::align::Orientations;
use crate::element::cardan::{Oriented, Triads, turns};
use crate::formula::proof::{Case, Kink, Proved};

impl Proved for Turns {
    fn kinks() -> Vec<Kink<Self>> {
        turns::cuts().into()
    }
}

/// Half a turn from the start is a double only if the initial value is 0.
impl Proved for Alignment {
    fn invalid_cases() -> Vec<Case<Orientations<f64>>> {
        let locked = turns::gimbal_locked().into_iter();
        let inputs = |[a, b]: turns::TriadPair| Orientations::of(Triads::new(a, b));
        locked.map(|pair| Case::invalid(pair.id, pair.comment, inputs(pair.value))).collect()
    }

    fn kinks() -> Vec<Kink<Self>> {
        let [alpha, gamma] = turns::cuts::<Self>();
        let (at_alpha, at_gamma) = (alpha.holds, gamma.holds);
        vec![
            Kink {
                condition: r"\lvert\alpha - \alpha_0\rvert = \pi".into(),
                holds: Box::new(move |i| i.alpha0 == 0.0 && at_alpha(i)),
                ..alpha
            },
            Kink {
                condition: r"\lvert\gamma - \gamma_0\rvert = \pi".into(),
                holds: Box::new(move |i| i.gamma0 == 0.0 && at_gamma(i)),
                ..gamma
            },
        ]
    }
}

impl Proved for Bearing {}

impl Proved for TurnedBack {}
