//! The error of both forms of β near 90°.

use crate::studies::near_right_angle::errors_near_right_angle;
use kit::{Axis, Chart, Curve};

/// Distances from 90°, in radians.
const DISTANCES: [f64; 15] = [1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8, 1e-8];

/// Half an ulp: an error below it is due to a lucky pose, and is drawn at this value.
const FLOOR: f64 = f64::EPSILON / 2.0;

/// Both errors as functions of the distance, on logarithmic axes.
pub(crate) fn beta_near_90() -> Chart<'static> {
    let table = errors_near_right_angle(&DISTANCES);
    let arc_sine = table.iter().map(|row| (row.distance, row.arc_sine.max(FLOOR))).collect();
    let two_argument = table.iter().map(|row| (row.distance, row.two_argument.max(FLOOR))).collect();
    Chart {
        name: "beta-near-90",
        title: "Relative error of both forms of β near 90°",
        description: "Logarithmic axes: the distance of β from 90° in radians, from 0.1 down to 1e-8, against the largest \
            relative error of 64 poses. The error of the arc sine grows in proportion to one over the distance, from 1e-15 \
            to nearly 1e-8. That of the two-argument form stays at half an ulp, 1e-16.",
        x: Axis {
            label: "90° − β, in radians",
            from: 1e-1,
            to: 1e-8,
            logarithmic: true,
            ticks: vec![1e-1, 1e-2, 1e-4, 1e-6, 1e-8],
        },
        y: Axis {
            label: "relative error",
            from: 1e-17,
            to: 1e-7,
            logarithmic: true,
            ticks: vec![1e-16, 1e-14, 1e-12, 1e-10, 1e-8],
        },
        curves: vec![
            Curve { name: "two arguments", label_at: 5, points: two_argument },
            Curve { name: "arc sine", label_at: 5, points: arc_sine },
        ],
    }
}
