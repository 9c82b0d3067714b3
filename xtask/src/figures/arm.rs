//! The models of a cross arm as functions of its slenderness.

use crate::studies::arm_models::{Models, curves};
use kit::{Axis, Chart, Curve};

fn slenderness() -> Axis<'static> {
    Axis {
        label: "λ = La/Rp",
        from: 0.1,
        to: 1000.0,
        logarithmic: true,
        ticks: vec![0.1, 1.0, 10.0, 20.0, 100.0, 1000.0],
    }
}

fn curve(name: &'static str, label_at: usize, share: impl Fn(&Models) -> f64) -> Curve<'static> {
    Curve { name, label_at, points: curves(-1, 3, 161).iter().map(|at| (at.lambda, share(at))).collect() }
}

/// α_twist of all models, and the printed limits as grid lines.
pub(crate) fn twist() -> Chart<'static> {
    Chart {
        name: "arm-twist",
        title: "The share of the twisting moment, by model",
        description: "α_twist over the slenderness λ from 0.1 to 1000. The model used rises from the printed limit 0 to the \
            printed limit 1/8. The Timoshenko arm agrees with it beyond λ = 20 and turns negative below λ = 2.1. The \
            Euler–Bernoulli arm is 1/8 throughout, the rigid arm 0.",
        x: slenderness(),
        y: Axis {
            label: "α twist",
            from: -0.05,
            to: 0.15,
            logarithmic: false,
            ticks: vec![-0.05, 0.0, 0.05, 0.1, 0.125],
        },
        curves: vec![
            curve("used", 20, |at| at.used.alpha_twist),
            // The em space keeps the name away from the steep curve.
            curve("\u{2003}Timoshenko", 50, |at| at.timoshenko.alpha_twist),
            curve("Euler–Bernoulli", 4, |at| at.euler_bernoulli.alpha_twist),
            curve("rigid", 130, |at| at.rigid.alpha_twist),
        ],
    }
}

/// The axial shares of the model used, and α_axial of beams.
pub(crate) fn axial() -> Chart<'static> {
    Chart {
        name: "arm-axial",
        title: "The shares of a force along an arm",
        description: "α_axial and β_axial over the slenderness λ from 0.1 to 1000. By the model used both are 1/4 for a rigid \
            cross; for a slender one the hinges on the arm carry 1/2 each and those on the other arm nothing. The α_axial of \
            Timoshenko arms ends at 22/59 for stubby arms, that of Euler–Bernoulli arms at 0.",
        x: slenderness(),
        y: Axis { label: "share", from: 0.0, to: 0.6, logarithmic: false, ticks: vec![0.0, 0.25, 0.5] },
        curves: vec![
            curve("α, used", 130, |at| at.used.alpha_axial),
            curve("β, used", 100, |at| at.used.beta_axial),
            curve("α, Timoshenko", 2, |at| at.timoshenko.alpha_axial),
            curve("α, Euler–Bernoulli", 52, |at| at.euler_bernoulli.alpha_axial),
        ],
    }
}

/// The distance of α_twist in every other model from the one used.
pub(crate) fn apart() -> Chart<'static> {
    let apart = |other: f64, used: f64| (other - used).abs();
    Chart {
        name: "arm-apart",
        title: "The distance of the models of an arm",
        description: "Logarithmic axes: |α_twist − α_twist of the model used| over the slenderness λ from 0.1 to 1000. The \
            Timoshenko arm is 0.25 away at the left, is below 0.001 beyond λ = 7.5 and falls with the fourth power of λ. The \
            Euler–Bernoulli arm is 0.125 away at the left, 0.002 at λ = 20, and falls with the square. The rigid arm rises \
            with the square and ends 0.125 away.",
        x: slenderness(),
        y: Axis {
            label: "distance in α twist",
            from: 1e-7,
            to: 1.0,
            logarithmic: true,
            ticks: vec![1e-6, 1e-4, 1e-2, 1.0],
        },
        curves: vec![
            curve("Timoshenko", 92, |at| apart(at.timoshenko.alpha_twist, at.used.alpha_twist)),
            curve("Euler–Bernoulli", 118, |at| apart(at.euler_bernoulli.alpha_twist, at.used.alpha_twist)),
            curve("rigid", 130, |at| apart(at.rigid.alpha_twist, at.used.alpha_twist)),
        ],
    }
}
