//! Rules that this library initially used, and that proved wrong.

use crate::statements::erratum::{Erratum, apart, at, erratum};
use jointproof::Octuple;
use jointproof::connector::slider::Pivots;
use jointproof::connector::{align, slot, ujoint, universal};
use jointproof::contact::slide_line::{self, ParabolicSlave};
use jointproof::formula::Formula;
use jointproof::formula::proof::value_and_jacobian_by_ad;
use jointproof::toolkit::verify::central_differences;
use nalgebra::{Vector2, Vector3};

pub(super) fn errata() -> Vec<Erratum> {
    vec![
        cross_direction(),
        multiplier(),
        moment_of_align(),
        axial_shares(),
        beyond_an_end(),
        nearest_root(),
        rounded_tie(),
        step_of_differences(),
    ]
}

/// b rotated by α = 0.3 and β = 0.4: its third axis and the line of nodes, in the triad of a.
fn turned() -> (Vector3<f64>, Vector3<f64>) {
    let ((sin_a, cos_a), (sin_b, cos_b)) = (0.3_f64.sin_cos(), 0.4_f64.sin_cos());
    (Vector3::new(sin_b, -sin_a * cos_b, cos_a * cos_b), Vector3::new(0.0, cos_a, sin_a))
}

const TURNED: &str = r"$\alpha = 0.3$, $\beta = 0.4$, $m_2 = 10$";

fn cross_direction() -> Erratum {
    let ((e3b, nodes), m2) = (turned(), 10.0);
    let along = ujoint::CrossDirection::eval(&ujoint::CrossAxes { e1a: Vector3::x(), e3b }).e_cross.normalize() * m2;
    let here =
        universal::ConstraintMoment::eval(&universal::Twisted { e2a: Vector3::y(), e3a: Vector3::z(), e3b, m2 }).m;
    erratum(
        "sense-of-the-cross-direction",
        vec![
            at(TURNED, r"it does the work $m_2\,\delta\beta$: its component along the line of nodes is $m_2$")
                .literal(
                    "along $\\mathbf{e}_{1a}\\times\\mathbf{e}_{3b}$",
                    r"\mathbf{m}\cdot\mathbf{n}",
                    along.dot(&nodes),
                    apart(along.dot(&nodes), m2),
                )
                .here::<universal::ConstraintMoment>(
                    r"\mathbf{m}\cdot\mathbf{n}",
                    here.dot(&nodes),
                    apart(here.dot(&nodes), m2),
                ),
        ],
    )
}

fn multiplier() -> Erratum {
    let ((e3b, nodes), m2) = (turned(), 10.0);
    let by = universal::Constraint::jacobian(&universal::Shafts { e1a: Vector3::x(), e3b, c0: 0.0 }).g;
    let of_residual = m2 * by.e3b.dot(&nodes.cross(&e3b));
    let here =
        universal::ConstraintMoment::eval(&universal::Twisted { e2a: Vector3::y(), e3a: Vector3::z(), e3b, m2 }).m;
    erratum(
        "multiplier-of-universal",
        vec![
            at(TURNED, r"its power at the rate $\dot\beta = 1$ is $m_2$")
                .literal(
                    "$m_2$ as the multiplier of the residual",
                    r"m_2\,\partial g/\partial\beta",
                    of_residual,
                    apart(of_residual, m2),
                )
                .here::<universal::ConstraintMoment>(
                    r"\mathbf{m}\cdot\mathbf{n}",
                    here.dot(&nodes),
                    apart(here.dot(&nodes), m2),
                ),
        ],
    )
}

fn moment_of_align() -> Erratum {
    let ((e3b, _), m3) = (turned(), 10.0);
    let ((sin_a, cos_a), cos_b) = (0.3_f64.sin_cos(), 0.4_f64.cos());
    let [e1a, e2a, e3a] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let by_components =
        align::ConstraintMoment::eval(&align::Moments { e1a, e2a, e3a, m1: 0.0, m2: 0.0, m3 }).m.dot(&e3b);
    let conjugate = ((e3a * cos_a - e2a * sin_a) * (m3 / cos_b)).dot(&e3b);
    erratum(
        "moment-of-align",
        vec![
            at(r"$\alpha = 0.3$, $\beta = 0.4$, $m_3 = 10$ alone", r"its power at the rate $\dot\gamma = 1$ is $m_3$")
                .kept::<align::ConstraintMoment>("by its components", r"m_3\,\mathbf{e}_{3a}\cdot\mathbf{e}_{3b}", &[by_components], apart(by_components, m3))
                .right(
                    "the moment of the Jacobian",
                    r"\frac{m_3}{\cos\beta}(\cos\alpha\,\mathbf{e}_{3a} - \sin\alpha\,\mathbf{e}_{2a})\cdot\mathbf{e}_{3b}",
                    &[conjugate],
                    apart(conjugate, m3),
                ),
        ],
    )
}

fn axial_shares() -> Erratum {
    let stubby = ujoint::Arm { la: 1e-9_f64, rp: 1.0 };
    // Minus the part of the order of the square of la/rp.
    let ratio = 44.0 / 15.0;
    let timoshenko = 0.5 * ratio / (1.0 + ratio);
    let here = ujoint::AxialFactors::eval(&stubby).alpha_axial;
    erratum(
        "shares-of-a-stubby-cross",
        vec![
            at("$L_a/R_p = 10^{-9}$", "rigid arms share a force equally: each takes a quarter")
                .literal("Timoshenko beams", r"\alpha_{\mathrm{axial}}", timoshenko, apart(timoshenko, 0.25))
                .here::<ujoint::AxialFactors>(r"\alpha_{\mathrm{axial}}", here, apart(here, 0.25)),
        ],
    )
}

/// An arch of three nodes, and a slave point.
fn arch(xs: [f64; 2]) -> ParabolicSlave<f64> {
    let node = |x, y| Vector2::new(x, y);
    ParabolicSlave { xs: xs.into(), x1: node(-1.0, 0.0), x2: node(0.0, 1.0), x3: node(1.0, 0.0) }
}

fn beyond_an_end() -> Erratum {
    let i = arch([-3.0, 0.5]);
    let here = slide_line::ClosestParabolic::jacobian(&i).separation.x2.y;
    let by_ad = value_and_jacobian_by_ad::<slide_line::ClosestParabolic, f64>(&i).1.separation.x2.y;
    // At the first node the weight of the midside node is 0.
    let literal = 0.0;
    erratum(
        "gap-beyond-an-end",
        vec![
            at(
                r"nodes $(-1, 0)$, $(0, 1)$, $(1, 0)$, slave $(-3, 0.5)$ beyond the first; $\partial E_{11}/\partial x_{2,z}$",
                "automatic differentiation gives the same",
            )
            .literal("as for a foot inside", r"-N_2\,n_z", literal, apart(literal, by_ad))
            .here::<slide_line::ClosestParabolic>(r"-(N_2 + \tau N_2')\,n_z", here, apart(here, by_ad)),
        ],
    )
}

fn nearest_root() -> Erratum {
    let i = arch([0.0, -3.0]);
    let point =
        |g: f64| slide_line::ParabolicPoint::eval(&slide_line::ParabolicPlace { x1: i.x1, x2: i.x2, x3: i.x3, g }).x;
    let distance = |g: f64| (i.xs - point(g)).norm();
    let least = (-1000..=1000).map(|k| distance(f64::from(k) / 1000.0)).fold(f64::INFINITY, f64::min);
    let foot = slide_line::ClosestParabolic::eval(&i).g;
    erratum(
        "nearest-root",
        vec![
            at("nodes $(-1, 0)$, $(0, 1)$, $(1, 0)$, slave $(0, -3)$ below", "no point of the curve is nearer")
                .literal(
                    "the nearest root, $g = 0$",
                    r"\lvert\mathbf{x}_s-\mathbf{X}\rvert",
                    distance(0.0),
                    apart(distance(0.0), least),
                )
                .here::<slide_line::ClosestParabolic>(
                    r"\lvert\mathbf{x}_s-\mathbf{X}\rvert",
                    distance(foot),
                    apart(distance(foot), least),
                ),
        ],
    )
}

fn rounded_tie() -> Erratum {
    let [d1, p, q] = [26.0, 25.0, 5.0].map(Octuple::from);
    let literal = (p * ((q / p) * (q / p) + 1.0) - d1).to_f64();
    let misses = |axis_is_1: bool| if axis_is_1 { 0.0 } else { 1.0 };
    let here = Pivots::new(&Vector3::zeros(), &Vector3::new(d1, p, q));
    erratum(
        "tie-in-rounded-numbers",
        vec![
            at(
                r"$\mathbf{d} = (26, 25, 5)$ in 237 bits, where $p^2 + q^2 = p\,\lvert d_1\rvert$ exactly",
                "at a tie $j$ is axis 1; the error is 1 if it is not",
            )
            .literal("as first written", r"p\,(1 + (q/p)^2) - \lvert d_1\rvert", literal, misses(literal >= 0.0))
            .right(
                "here, without rounding",
                r"p^2 + q^2 - p\,\lvert d_1\rvert",
                &[(p * p + q * q - p * d1).to_f64()],
                misses(here.j == 0),
            ),
        ],
    )
}

fn step_of_differences() -> Erratum {
    let forces = [1.0, 2.0].map(Octuple::from);
    let value = |f2: Octuple| slot::ContactForce::eval(&slot::CrossForces { f2, f3: forces[1] }).fc;
    let exact = slot::ContactForce::jacobian(&slot::CrossForces { f2: forces[0], f3: forces[1] }).fc.f2;
    let step = Octuple::from(1e-30);
    let short = (value(forces[0] + step) - value(forces[0] - step)) / (step * 2.0);
    let fourth = central_differences::<slot::ContactForce>(&forces, 0, 1e-18)[0];
    let off = |found: Octuple| ((found - exact) / exact).to_f64().abs();
    erratum(
        "step-of-differences",
        vec![
            at(r"$F_C$ at $f_2 = 1$, $f_3 = 2$ in 237 bits", r"it is $f_2/F_C$, to $10^{-50}$")
                .within(1e-50)
                .literal("a step of $10^{-30}$", r"\frac{F_C(f_2+h)-F_C(f_2-h)}{2h}", short.to_f64(), off(short))
                .right(
                    "fourth order, a step of $10^{-18}$",
                    r"\partial F_C/\partial f_2",
                    &[fourth.to_f64()],
                    off(fourth),
                ),
        ],
    )
}
