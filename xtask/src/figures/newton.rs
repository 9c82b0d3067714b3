//! Two rods in UJOINTs: how far each step of Newton's method goes, with the geometric stiffness and without.

use super::chart::{Axis, Chart, Curve};
use two_rods::steps;

#[path = "../../../tests/examples/two_rods.rs"]
#[expect(dead_code, reason = "the example has a main function")]
mod two_rods;

pub(super) fn steps_of_two_rods() -> Chart<'static> {
    let counted = |with_stiffness: bool| {
        let numbered = (1..).map(f64::from).zip(steps(with_stiffness));
        numbered.filter(|(_, size)| *size > 1e-17).collect::<Vec<_>>()
    };
    let curves = [("with geometric stiffness", true, 4), ("without", false, 10)]
        .map(|(name, with_stiffness, label_at)| Curve { name, label_at, points: counted(with_stiffness) });
    Chart {
        name: "newton-two-rods",
        title: "Steps of Newton's method for two rods in UJOINTs",
        description: "The number of the step against its size, logarithmic. With the geometric stiffness the curve bends down \
            and ends at rounding within eight steps; without it a straight line takes twenty.",
        x: Axis { label: "step", from: 1.0, to: 21.0, logarithmic: false, ticks: vec![1.0, 5.0, 10.0, 15.0, 20.0] },
        y: Axis {
            label: "size of the step",
            from: 1e-17,
            to: 1e1,
            logarithmic: true,
            ticks: vec![1e-16, 1e-12, 1e-8, 1e-4, 1e0],
        },
        curves: curves.into(),
    }
}
