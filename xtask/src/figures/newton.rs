//! The examples that use Newton's method, with the full tangent and with a part of it omitted.

use kit::{Axis, Chart, Curve};
#[path = "../../../tests/examples/two_rods.rs"]
#[expect(dead_code, reason = "the example has a main function")]
mod two_rods;

#[path = "../../../tests/examples/slider_crank.rs"]
#[expect(dead_code, reason = "the example has a main function")]
mod slider_crank;

#[path = "../../../tests/examples/double_cardan.rs"]
#[expect(dead_code, reason = "the example has a main function")]
mod double_cardan;

#[path = "../../../tests/examples/thread.rs"]
#[expect(dead_code, reason = "the example has a main function")]
mod thread;

/// Two rods in UJOINTs: the size of each step, with and without the geometric stiffness.
pub(super) fn steps_of_two_rods() -> Chart<'static> {
    let counted = |with_stiffness: bool| {
        let numbered = (1..).map(f64::from).zip(two_rods::steps(with_stiffness));
        numbered.filter(|(_, size)| *size > 1e-17).collect::<Vec<_>>()
    };
    let curves = [("with geometric stiffness", true, 6), ("without", false, 10)]
        .map(|(name, with_stiffness, label_at)| Curve { name, label_at, points: counted(with_stiffness) });
    Chart {
        name: "newton-two-rods",
        title: "Steps of Newton's method for two rods in UJOINTs",
        description: "The number of the step against its size, logarithmic. With the geometric stiffness the curve bends down \
            and soon ends at rounding; without it a straight line takes three times as many steps.",
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

/// A slider-crank: the steps of each increment, with and without the consistent friction tangent.
pub(super) fn steps_of_a_slider_crank() -> Chart<'static> {
    let counted = |consistent: bool| {
        let counts = slider_crank::steps(consistent).into_iter().map(f64::from);
        (1..).map(|increment| f64::from(increment) * 15.0).zip(counts).collect::<Vec<_>>()
    };
    let curves = [("with the whole tangent", true, 5), ("without the constraint force", false, 6)]
        .map(|(name, consistent, label_at)| Curve { name, label_at, points: counted(consistent) });
    Chart {
        name: "newton-slider-crank",
        title: "Steps of Newton's method for a slider-crank with friction",
        description: "The angle of the crank against the number of steps of each increment. With the consistent tangent it stays \
            near five. Without what the constraint force does to the friction it is up to three times as large wherever the \
            rod is inclined, and as small only where the piston turns back.",
        x: Axis {
            label: "angle of the crank, in degrees",
            from: 0.0,
            to: 360.0,
            logarithmic: false,
            ticks: vec![0.0, 90.0, 180.0, 270.0, 360.0],
        },
        y: Axis {
            label: "steps of the increment",
            from: 0.0,
            to: 20.0,
            logarithmic: false,
            ticks: vec![0.0, 5.0, 10.0, 15.0, 20.0],
        },
        curves: curves.into(),
    }
}

/// A double Cardan shaft: the lead of the driven shaft, with the yokes of the intermediate shaft in phase and crossed.
pub(super) fn lead_of_a_double_cardan() -> Chart<'static> {
    use double_cardan::{Position, Yokes, revolution};
    let lead = |Position { input, output, .. }: Position| (input.to_degrees(), (output - input).to_degrees());
    let curves = [("yokes in phase", Yokes::InPhase, 2), ("yokes crossed", Yokes::Crossed, 27)].map(
        |(name, yokes, label_at)| Curve {
            name,
            label_at,
            points: revolution(yokes, 72).into_iter().map(lead).collect(),
        },
    );
    Chart {
        name: "double-cardan",
        title: "Non-uniformity of a double cardan shaft",
        description: "The angle of the driving shaft against the lead of the driven shaft. With the yokes of the intermediate shaft \
            in phase it is zero everywhere; crossed, it oscillates twice in a revolution, by 15 degrees.",
        x: Axis {
            label: "angle of the driving shaft, in degrees",
            from: 0.0,
            to: 360.0,
            logarithmic: false,
            ticks: vec![0.0, 90.0, 180.0, 270.0, 360.0],
        },
        y: Axis {
            label: "lead of the driven shaft, in degrees",
            from: -20.0,
            to: 20.0,
            logarithmic: false,
            ticks: vec![-20.0, -10.0, 0.0, 10.0, 20.0],
        },
        curves: curves.into(),
    }
}

/// A thread under load: the share carried by every turn.
pub(super) fn shares_of_the_turns() -> Chart<'static> {
    let increments = thread::loaded();
    let curve = |name, increment: usize, label_at| {
        let thread::Increment { load, shares, .. } = increments[increment];
        let points = (1..).map(f64::from).zip(shares.map(|share| 100.0 * share / load)).collect();
        Curve { name, label_at, points }
    };
    Chart {
        name: "thread-turns",
        title: "Load of the turns of a thread",
        description: "The number of the turn against its part of the load, in percent. The first turn carries three quarters of the \
            full load, the fourth three hundredths. After half of the load is taken back it is a little less uneven.",
        x: Axis { label: "turn", from: 1.0, to: 4.0, logarithmic: false, ticks: vec![1.0, 2.0, 3.0, 4.0] },
        y: Axis {
            label: "part of the load, in percent",
            from: 0.0,
            to: 100.0,
            logarithmic: false,
            ticks: vec![0.0, 25.0, 50.0, 75.0, 100.0],
        },
        curves: vec![curve("full load", 2, 0), curve("half of it taken back", 3, 1)],
    }
}
