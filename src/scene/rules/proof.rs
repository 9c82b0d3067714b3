//! Evidence for the formulas of the parent module.

use super::axes::{LineNodes, LineNodes2d};
use super::{
    Accumulated, Alignment, Bearing, Follow, Increment, Joining, KeptAxis, KeptAxis2d, KeptNodes, KeptNodes2d, Kinetic,
    PivotAxes, PivotAxis2d, Sighting, Slips, Traction, Transmitted, TurnedBack, Turns,
};
use crate::connector::align::Orientations;
use crate::connector::slider::hard::{change_of_pivot, changes_of_pivots};
use crate::element::cardan::{Oriented, Triads, turns};
use crate::formula::Fields;
use crate::formula::proof::{Case, Kink, Proved};
use nalgebra::{Vector2, Vector3};
use std::f64::consts::PI;

impl Proved for Increment {}

/// It rounds a number, which cannot be represented in its graph: jumps are therefore searched for at these cases. It jumps by a
/// full turn at half a turn, which is not a double.
impl Proved for Follow {
    fn cases() -> Vec<Case<Sighting<f64>>> {
        let sighting = |angle, start, turned| Sighting { angle, start, turned };
        vec![
            Case::hand("same-turn", "no turn is added", sighting(0.5, 0.25, 0.125)),
            Case::hand("across-the-cut", "on from 3 to −3: one turn on", sighting(-3.0, 1.0, 2.0)),
            Case::hand("back-across-the-cut", "back from −3 to 3: one turn back", sighting(3.0, -1.0, -2.0)),
            Case::hand("many-turns", "a thousand radians on", sighting(1.0, 0.5, 1000.0)),
            Case::hard("half-a-turn", "the double beside half a turn", sighting(0.0, PI, 0.0)),
            Case::hard("half-a-turn-back", "the double beside it, back", sighting(0.0, 0.0, -PI)),
        ]
    }
}

impl Proved for Accumulated {
    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::of_abs(Slips { slip: 0.0, slip_before: 0.25 }, |i| [i.slip])]
    }
}

impl Proved for Kinetic {}

impl Proved for Traction {
    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::of_abs(Transmitted { csf: 0.0 }, |i| [i.csf])]
    }
}

impl Proved for Joining {}

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

impl Proved for KeptAxis {
    fn kinks() -> Vec<Kink<Self>> {
        changes_of_pivots::<Self>(
            |i| i.xn - i.x1,
            |xn| KeptNodes {
                x1: Vector3::zeros(),
                xn,
                xm: Vector3::new(0.5, 1.0, 0.75),
                dxm: Vector3::new(0.25, -0.5, 0.125),
            },
            |dxn| KeptNodes { xn: dxn, ..KeptNodes::filled(0.0) },
        )
    }
}

impl Proved for KeptAxis2d {
    fn kinks() -> Vec<Kink<Self>> {
        change_of_pivot::<Self>(
            |i| i.xn - i.x1,
            |xn| KeptNodes2d { x1: Vector2::zeros(), xn, xm: Vector2::new(0.5, 1.0), dxm: Vector2::new(0.25, -0.5) },
            |dxn| KeptNodes2d { xn: dxn, ..KeptNodes2d::filled(0.0) },
        )
    }
}

impl Proved for PivotAxes {
    fn kinks() -> Vec<Kink<Self>> {
        changes_of_pivots::<Self>(
            |i| i.xn - i.x1,
            |xn| LineNodes { x1: Vector3::zeros(), xn },
            |dxn| LineNodes { xn: dxn, ..LineNodes::filled(0.0) },
        )
    }
}

impl Proved for PivotAxis2d {
    fn kinks() -> Vec<Kink<Self>> {
        change_of_pivot::<Self>(
            |i| i.xn - i.x1,
            |xn| LineNodes2d { x1: Vector2::zeros(), xn },
            |dxn| LineNodes2d { xn: dxn, ..LineNodes2d::filled(0.0) },
        )
    }
}

impl Proved for Bearing {}

impl Proved for TurnedBack {}
