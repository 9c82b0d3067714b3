//! The sliding constraint.

use crate::statements::erratum::{Erratum, apart, at, erratum};
use jointproof::connector::slider::{self, MovingNodes, Nodes, Nodes2d, Pivots};
use jointproof::formula::Formula;
use nalgebra::{Vector2, Vector3};

pub(super) fn errata() -> Vec<Erratum> {
    vec![held_by_itself(), ties(), on_the_line()]
}

/// The same three nodes in the plane and in space.
struct Flat {
    xn: Vector2<f64>,
    xm: Vector2<f64>,
}

impl Flat {
    fn distance(&self) -> f64 {
        let n = self.xn.normalize();
        n.perp(&self.xm)
    }

    fn conditions(&self) -> [f64; 2] {
        let space = |v: Vector2<f64>| Vector3::new(v.x, v.y, 0.0);
        let nodes = Nodes { x1: Vector3::zeros(), xn: space(self.xn), xm: space(self.xm) };
        let slider::Distances { g1, g2 } = slider::Constraint::eval(&nodes);
        [g1, g2]
    }

    fn here(&self) -> f64 {
        slider::Constraint2d::eval(&Nodes2d { x1: Vector2::zeros(), xn: self.xn, xm: self.xm }).g
    }
}

fn held_by_itself() -> Erratum {
    const LAW: &str = "the condition that is left measures how far m is off the line";
    let inclined = Flat { xn: Vector2::new(3.0, 4.0), xm: Vector2::new(1.0, 3.0) };
    let along = Flat { xn: Vector2::new(5.0, 0.0), xm: Vector2::new(1.0, 3.0) };
    let [first, second] = inclined.conditions();
    let [along_first, along_second] = along.conditions();
    let off = |flat: &Flat, g: f64| apart(g.abs(), flat.distance().abs());
    erratum(
        "condition-that-holds-by-itself",
        vec![
            at("$\\mathbf{x}_1 = (0, 0)$, $\\mathbf{x}_n = (3, 4)$, $\\mathbf{x}_m = (1, 3)$", LAW)
                .printed(r"g_1 = 0\text{ is left}", first, off(&inclined, first))
                .right("the second condition", r"g_2 = 0\text{ is left}", &[second], off(&inclined, second))
                .here::<slider::Constraint2d>(
                    r"g = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{t}",
                    inclined.here(),
                    off(&inclined, inclined.here()),
                ),
            at("$\\mathbf{x}_1 = (0, 0)$, $\\mathbf{x}_n = (5, 0)$, along the 1-axis, $\\mathbf{x}_m = (1, 3)$", LAW)
                .right("as printed", r"g_1 = 0\text{ is left}", &[along_first], off(&along, along_first))
                .literal("the second condition", r"g_2 = 0\text{ is left}", along_second, off(&along, along_second))
                .here::<slider::Constraint2d>(
                    r"g = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{t}",
                    along.here(),
                    off(&along, along.here()),
                ),
        ],
    )
}

fn ties() -> Erratum {
    let d = Vector3::new(2.0, 1.0, 1.0);
    let t1 = slider::Basis::eval(&slider::LineDirection { n: d.normalize() }).t1;
    let larger_than_all = |i: &usize| (0..3).all(|other| other == *i || t1[*i].abs() > t1[other].abs());
    let strict = (0..3).filter(larger_than_all).map(|_| 1.0).sum::<f64>();
    let chosen = Pivots::new(&Vector3::zeros(), &d);
    let here = (0..3).filter(|axis| *axis == chosen.i).map(|_| 1.0).sum::<f64>();
    erratum(
        "ties-of-the-pivot-rule",
        vec![
            at(r"$\mathbf{d} = (2, 1, 1)$", "one axis is $i$")
                .literal(
                    "“largest” as larger than all others",
                    r"\text{axes with }\lvert t_{1i}\rvert > \lvert t_{1j}\rvert",
                    strict,
                    apart(strict, 1.0),
                )
                .right(
                    "here: axis 2 on a tie",
                    r"\lvert t_{1i}\rvert \ge \lvert t_{1j}\rvert",
                    &[here],
                    apart(here, 1.0),
                ),
        ],
    )
}

fn on_the_line() -> Erratum {
    let i = MovingNodes {
        x1: Vector3::zeros(),
        xn: Vector3::new(2.0, 2.0, 1.0),
        xm: Vector3::new(1.0, 2.0, 0.0),
        dx1: Vector3::zeros(),
        dxn: Vector3::new(0.1, 0.0, 0.2),
        dxm: Vector3::new(0.05, 0.1, 0.0),
    };
    let by = slider::Constraint::jacobian(&Nodes { x1: i.x1, xn: i.xn, xm: i.xm }).g1;
    let variation = by.x1.dot(&i.dx1) + by.xn.dot(&i.dxn) + by.xm.dot(&i.dxm);
    let reduced = slider::IncrementalConstraint::eval(&i).r1;
    erratum(
        "on-the-line-only",
        vec![
            at(
                r"$\mathbf{x}_n = (2, 2, 1)$, $\mathbf{x}_m = (1, 2, 0)$ off the line, $\mathrm{d}\mathbf{x}_n = (0.1, 0, 0.2)$, $\mathrm{d}\mathbf{x}_m = (0.05, 0.1, 0)$, node 1 at rest at the origin",
                "it is the variation of the condition $g_1$",
            )
            .kept::<slider::IncrementalConstraint>("by the words", 
                r"r_1 = \mathbf{t}_1\cdot(\mathrm{d}\mathbf{x}_m - \mathbf{w})",
                &[reduced],
                apart(reduced, variation),
            )
            .right(
                "unreduced",
                r"\mathbf{t}_1\cdot(\mathrm{d}\mathbf{x}_m-\mathrm{d}\mathbf{x}_1) + (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathrm{d}\mathbf{t}_1",
                &[unreduced(&i)],
                apart(unreduced(&i), variation),
            ),
        ],
    )
}

/// The derivative of the condition before dt1 is eliminated.
fn unreduced(i: &MovingNodes<f64>) -> f64 {
    let n = slider::Line::eval(&slider::Ends { x1: i.x1, xn: i.xn }).n;
    let dn = slider::DirectionVariation::eval(&slider::MovingEnds { x1: i.x1, xn: i.xn, dx1: i.dx1, dxn: i.dxn }).dn;
    let t1 = slider::Basis::eval(&slider::LineDirection { n }).t1;
    let dt1 = slider::BasisVariation::eval(&slider::TurningDirection { n, dn }).dt1;
    t1.dot(&(i.dxm - i.dx1)) + (i.xm - i.x1).dot(&dt1)
}
