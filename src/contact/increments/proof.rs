//! Evidence for the formulas of the parent module.

use super::{Accumulated, Follow, Increment, Kinetic, Sighting, Slips, Traction, Transmitted};
use crate::formula::proof::{Case, Kink, Proved};
use std::f64::consts::PI;

impl Proved for Increment {}

/// It jumps by a full turn at half a turn, which is not a double.
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
