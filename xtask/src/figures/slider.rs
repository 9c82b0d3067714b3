//! SLIDER by both routes: errors for difficult lines, and the jump of t1 and t2.

use crate::studies::routes::Setting;
use jointproof::connector::slider::{Nodes, Slider};
use kit::{Axis, Chart, Curve};
use nalgebra::Vector3;
use std::fmt::Write;

/// Powers of ten, as decimal literals, so that they are the same doubles everywhere.
const SMALL: [f64; 17] =
    [1e0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16];
const LARGE: [f64; 13] = [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12];

const ORDINARY: Setting = Setting { tilt: 1.0, length: 1.0, share: 0.5, offset: 1.0 };

/// The errors of the increments, with one chart for each kind of difficulty.
pub(super) fn charts() -> Vec<Chart<'static>> {
    let down = |label, to| Axis { label, from: 1e0, to, logarithmic: true, ticks: vec![1e0, 1e-4, 1e-8, 1e-12] };
    let up = |label| Axis { label, from: 1e0, to: 1e12, logarithmic: true, ticks: vec![1e0, 1e3, 1e6, 1e9, 1e12] };
    let mut tilt = down("angle between the line and the x axis", 1e-16);
    tilt.ticks.push(1e-16);
    let tall = |to| (to, vec![1e-16, 1e-12, 1e-8, 1e-4, 1e0]);
    vec![
        chart(
            "slider-near-x",
            "Error of the increments of m as the line approaches the x axis",
            "Logarithmic axes: the tangent of the angle, from 1 down to 1e-16, against the largest relative error. By the \
                documented route it grows in proportion to one over the angle, from 1e-15 to 1. By the direct route it \
                stays below 1e-15.",
            tilt,
            tall(1e1),
            &SMALL,
            |tilt| Setting { tilt, ..ORDINARY },
        ),
        chart(
            "slider-short",
            "Error of the increments of m as the line gets short",
            "Logarithmic axes: the length of the line, from 1 down to 1e-14, against the largest relative error. By the \
                documented route it grows in proportion to one over the length, from 1e-15 to 1e-2. By the direct route \
                it stays below 1e-15.",
            down("length of the line", 1e-14),
            tall(1e1),
            &SMALL[..15],
            |length| Setting { length, ..ORDINARY },
        ),
        chart(
            "slider-offset",
            "Error of the increments of m as the nodes are far from the origin",
            "Logarithmic axes: the size of the coordinates, from 1 to 1e12, against the largest relative error. By the \
                documented route it grows in proportion to the coordinates, from 1e-15 to 1e-4. By the direct route it \
                stays below 1e-15.",
            up("size of the coordinates, for a line of length 1"),
            tall(1e1),
            &LARGE,
            |offset| Setting { offset, ..ORDINARY },
        ),
        chart(
            "slider-far-out",
            "Error of the increments of m as m is far out on the line",
            "Logarithmic axes: the share of m in the way from node 1 to node n, from 1 to 1e12, against the largest relative \
                error. By both routes it stays near 1e-15.",
            up("share ξ of m in the way from node 1 to node n"),
            (1e-13, vec![1e-17, 1e-16, 1e-15, 1e-14, 1e-13]),
            &LARGE,
            |share| Setting { share, ..ORDINARY },
        ),
    ]
}

fn chart(
    name: &'static str,
    title: &'static str,
    description: &'static str,
    x: Axis<'static>,
    (to, ticks): (f64, Vec<f64>),
    values: &[f64],
    setting: impl Fn(f64) -> Setting,
) -> Chart<'static> {
    let errors: Vec<_> = values.iter().map(|&value| (value, setting(value).increment_errors())).collect();
    // Where both errors stay low, the name of the lower curve goes below it, at a point from which it rises.
    let rises = |&k: &usize| to > 1.0 || errors[k + 1].1.direct > 1.2 * errors[k].1.direct;
    let direct_at = (values.len() * 2 / 3..values.len() - 3).find(rises).unwrap_or_default();
    Chart {
        name,
        title,
        description,
        x,
        y: Axis { label: "relative error of the increments", from: 1e-17, to, logarithmic: true, ticks },
        curves: vec![
            Curve {
                name: "direct",
                label_at: direct_at,
                points: errors.iter().map(|(x, errors)| (*x, errors.direct)).collect(),
            },
            Curve {
                name: "documented",
                label_at: values.len() / 3,
                points: errors.iter().map(|(x, errors)| (*x, errors.documented)).collect(),
            },
        ],
    }
}

/// The tables shown in the chapter, with their names.
pub(super) fn outputs() -> Vec<(String, String)> {
    [("slider-errors", errors()), ("slider-jump", jump())].map(|(name, text)| (name.to_owned(), text)).into()
}

fn errors() -> String {
    let at_origin = Setting { offset: 0.0, ..ORDINARY };
    let rows = [
        ("an ordinary line", ORDINARY),
        ("angle to the x axis 1e-8", Setting { tilt: 1e-8, ..ORDINARY }),
        ("angle to the x axis 1e-16", Setting { tilt: 1e-16, ..ORDINARY }),
        ("along the x axis exactly", Setting { tilt: 0.0, ..ORDINARY }),
        ("angle 1e-8, node 1 at the origin", Setting { tilt: 1e-8, ..at_origin }),
        ("angle 1e-16, node 1 at the origin", Setting { tilt: 1e-16, ..at_origin }),
        ("length 1e-12", Setting { length: 1e-12, ..ORDINARY }),
        ("m at ξ = 1e12", Setting { share: 1e12, ..ORDINARY }),
        ("coordinates of 1e12", Setting { offset: 1e12, ..ORDINARY }),
    ];
    let mut text = format!(
        "{:34}{:>24}{:>24}\n{:34}{:>12}{:>12}{:>12}{:>12}\n",
        "largest relative error", "increments", "elimination", "", "documented", "direct", "documented", "direct"
    );
    for (name, setting) in rows {
        let (increment, eliminate) = (setting.increment_errors(), setting.eliminate_errors());
        let _ = writeln!(
            text,
            "{name:34}{:>12.0e}{:>12.0e}{:>12.0e}{:>12.0e}",
            increment.documented, increment.direct, eliminate.documented, eliminate.direct
        );
    }
    text
}

/// The vectors that jump and those that do not where the line passes through the x axis.
fn jump() -> String {
    let zero = Vector3::zeros();
    let m = Vector3::new(0.5, 0.25, 0.0);
    let motion = Nodes { x1: Vector3::new(0.0, 0.0, 0.5), xn: Vector3::new(0.0, 0.5, 0.0), xm: zero };
    let mut text =
        format!("{:24}{:^16}{:^18}{:>14}   {:22}\n", "line to", "t1", "(g1, g2)", "|(g1, g2)|", "increment of m");
    for (shown, y, z) in [("1e-16", 1e-16, 0.0), ("0", 0.0, 0.0), ("-1e-16", -1e-16, 0.0), ("", 0.0, 1e-16)] {
        let name = if shown.is_empty() { "(1, 0, 1e-16)".to_owned() } else { format!("(1, {shown}, 0)") };
        let Ok(slider) = Slider::new(zero, Vector3::new(1.0, y, z)) else { continue };
        let (t1, Ok(g)) = (slider.basis().t1, slider.constraint(m)) else { continue };
        let Ok(dxm) = slider.increment(m, motion.x1, motion.xn, 0.125) else { continue };
        let vector = |v: Vector3<f64>| v.map(plain).iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let (t1, pair) = (format!("({})", vector(t1)), format!("({}, {})", plain(g.g1), plain(g.g2)));
        let (distance, dxm) = (plain(g.g1.hypot(g.g2)), vector(dxm));
        let _ = writeln!(text, "{name:24}{t1:^16}{pair:^18}{distance:>14}   ({dxm})");
    }
    text.replace('-', "−").replace("e−", "e-")
}

/// Rounds to 12 decimals, without a negative zero.
fn plain(x: f64) -> f64 {
    (x * 1e12).round() / 1e12 + 0.0
}
