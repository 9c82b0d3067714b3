//! The two conditions that hold node m on the line, and what they demand of increments.

use super::across::Across;
use super::hard::{lines, scenes};
use super::span::{Span, Station};
use super::{Constraint2d, Nodes2d};
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{
    SLIDER_DX1, SLIDER_DXM, SLIDER_DXN, SLIDER_G1, SLIDER_G2, SLIDER_R1, SLIDER_R2, SLIDER_X1, SLIDER_XM, SLIDER_XN,
};
use crate::scalar::{Scalar, abs};
use crate::verify::law;
use nalgebra::{Vector2, Vector3};

fields! {
    /// The line, and node m.
    pub struct Nodes<T> { x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xm: Vector3<T> = SLIDER_XM }
}
fields! {
    /// How far m is off the line.
    pub struct Distances<T> { g1: T = SLIDER_G1, g2: T = SLIDER_G2 }
}

/// The two conditions that hold m on the line: g1 = (xm − x1)·t1 = 0, g2 = (xm − x1)·t2 = 0.
///
/// Any point of the line may stand in for x1; the nearer of nodes 1 and n does.
#[derive(Clone, Copy, Debug)]
pub struct Constraint;

/// The nodes as t1 sees them, projected along its axis: a line in the plane.
#[inline]
fn projected<D: Scalar>(i: &Nodes<D>, across: &Across<D>) -> Nodes2d<D> {
    let project = |v: &Vector3<D>| Vector2::new(v[across.a], v[across.b]);
    Nodes2d { x1: project(&i.x1), xn: project(&i.xn), xm: project(&i.xm) }
}

/// How g2 varies with the component of an end of the line along a or b ("own"), in proportion:
/// c_other (c_other p_own − c_own p_other) − share c·c c_own, where p leads to m from any point of the projected line.
///
/// The share is ξ for node n, and ξ − 1 for node 1, where the sign changes too. Node 1, node n, or one of them together with the
/// part of xm − x1 across the line will do for p. The three sums are equal, but where one is what a cancellation leaves, another
/// need not be: the one of the smallest terms is taken, so that rounding does no more harm than that of the inputs.
#[inline]
fn bend<D: Scalar, const OWN: usize>(
    c: Vector2<D>,
    share: D,
    from_ends: [Vector2<D>; 2],
    aside: Vector2<D>,
    end: usize,
) -> D {
    let (own, other) = (OWN, 1 - OWN);
    // A sum with the size of its terms: numbers are selected without a branch, which would be mispredicted at every other line.
    let sum = |p: D, q: D, last: D| {
        let [p, q, last] = [c[other] * c[other] * p, -c[other] * c[own] * q, -share * last];
        (p + q + last, abs(p) + abs(q) + abs(last))
    };
    let whole = c.dot(&c) * c[own];
    let [first, second] = from_ends.map(|p| sum(p[own], p[other], whole));
    let mixed = sum(aside[own], from_ends[end][other], c[own] * c[own] * c[own]);
    let smaller = |x: (D, D), y: (D, D)| if y.1 < x.1 { y } else { x };
    smaller(smaller(first, second), mixed).0
}

impl Formula for Constraint {
    const SPEC: Spec = Spec {
        id: "slider.constraint",
        title: "Constraint",
        latex: r"g_q = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{t}_q,\quad q = 1, 2",
        source: Source::SLIDER.section("Constraint"),
        eta: 4.0,
        eta_jacobian: 10.0,
        objective: false,
    };
    type Inputs<T: Element> = Nodes<T>;
    type Outputs<T: Element> = Distances<T>;

    #[inline]
    fn eval<D: Scalar>(i: &Nodes<D>) -> Distances<D> {
        let across = Across::new(&(i.xn - i.x1));
        let station = Station::new(&Span::new(&i.x1, &i.xn), &i.x1, &i.xn, &i.xm);
        let [_, along_2] = across.along_rays(&station.offset);
        Distances { g1: -Constraint2d::eval(&projected(i, &across)).g, g2: along_2 / across.roots[1] }
    }

    /// Of g1, ∂g1/∂xn = −ξ′ t1 and ∂g1/∂x1 = −(1 − ξ′) t1 with the share ξ′ of m in the projection along e. Of g2, along e,
    /// ∂g2/∂xn = −ξ t2 and ∂g2/∂x1 = −(1 − ξ) t2; along a and b see `bend`.
    #[inline]
    fn jacobian<D: Scalar>(i: &Nodes<D>) -> Jacobian<Self, D> {
        let (span, across) = (Span::new(&i.x1, &i.xn), Across::new(&(i.xn - i.x1)));
        let ([_, ray], [_, root]) = (across.rays(), across.roots);
        let station = Station::new(&span, &i.x1, &i.xn, &i.xm);
        let side = |v: Vector3<D>| Vector2::new(v[across.a], v[across.b]) * D::from(across.sideways.per_unit);
        let ends = [side(i.xm - i.x1), side(i.xm - i.xn)];
        let aside = side(station.aside(&span));
        let size = across.along / across.square;
        let row = |end: usize, share: D| {
            let c = across.c.into();
            let by_a = bend::<D, 0>(c, share, ends, aside, end) * size;
            let by_b = bend::<D, 1>(c, share, ends, aside, end) * size;
            across.vector(-ray[across.axis] * share, by_a, by_b) / root
        };
        let [share, rest] = station.shares();
        let g2 = Nodes { x1: -row(1, -rest), xn: row(0, share), xm: ray / root };

        let Nodes2d { x1, xn, xm } = Constraint2d::jacobian(&projected(i, &across)).g;
        let lift = |v: Vector2<D>| across.vector(D::zero(), -v.x, -v.y);
        Distances { g1: Nodes { x1: lift(x1), xn: lift(xn), xm: lift(xm) }, g2 }
    }

    fn validate(i: &Nodes<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }

    fn cases() -> Vec<Case<Nodes<f64>>> {
        let hand =
            Nodes { x1: Vector3::new(1.0, 1.0, 1.0), xn: Vector3::new(1.0, 4.0, 5.0), xm: Vector3::new(3.0, 5.0, 4.0) };
        let mut cases = vec![
            Case::hand("off-the-line", "t1 = (0, 0.8, -0.6), t2 = (-1, 0, 0): g1 = 3.2 - 1.8, g2 = -2", hand),
            Case::hand("at-node-1", "both residuals vanish", Nodes { xm: hand.x1, ..hand }),
            Case::hand("at-node-n", "both residuals vanish", Nodes { xm: hand.xn, ..hand }),
        ];
        cases.extend(
            scenes(lines())
                .into_iter()
                .map(|(id, line, xm)| Case::hard(id, line.comment, Nodes { x1: line.x1, xn: line.xn, xm })),
        );
        cases
    }

    fn invalid_cases() -> Vec<Case<Nodes<f64>>> {
        let x1 = Vector3::new(1.0, 2.0, 3.0);
        vec![Case::invalid("coincident", "nodes 1 and n at one place", Nodes { x1, xn: x1, xm: Vector3::zeros() })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: r"\mathbf{n} = \pm\mathbf{i}",
            convention: Convention::Switch,
            holds: |i| i.xn.y == i.x1.y && i.xn.z == i.x1.z,
            at: || Nodes { x1: Vector3::zeros(), xn: Vector3::new(2.0, 0.0, 0.0), xm: Vector3::new(1.0, 0.5, -0.25) },
            across: || Nodes { x1: Vector3::zeros(), xn: Vector3::new(0.0, 3.0, 4.0), xm: Vector3::zeros() },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "g1² + g2² is the squared distance of m from the line, whatever t1 and t2 are",
                sides: |i| {
                    let Distances { g1, g2 } = Self::eval(i);
                    let d = i.xn - i.x1;
                    let offset = i.xm - i.x1;
                    let moment = offset.cross(&d);
                    let size = d.dot(&d) * offset.dot(&offset);
                    law::equal_with((g1 * g1 + g2 * g2) * d.dot(&d), moment.dot(&moment), size)
                },
            },
            Law {
                statement: "it vanishes on the line",
                sides: |i| {
                    let xm = i.x1 + (i.xn - i.x1) * i.xm.x; // any share will do
                    let Distances { g1, g2 } = Self::eval(&Nodes { xm, ..*i });
                    law::vanish([g1, g2], law::length(i.x1) + law::length(xm))
                },
            },
        ]
    }
}

fields! {
    /// The line and node m, and increments of all three nodes.
    pub struct MovingNodes<T> {
        x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xm: Vector3<T> = SLIDER_XM,
        dx1: Vector3<T> = SLIDER_DX1, dxn: Vector3<T> = SLIDER_DXN, dxm: Vector3<T> = SLIDER_DXM,
    }
}
fields! {
    /// By how much increments violate the two conditions.
    pub struct IncrementalResiduals<T> { r1: T = SLIDER_R1, r2: T = SLIDER_R2 }
}

/// What the conditions demand of increments, with the variations of t1 and t2 eliminated:
/// r_q = t_q·(dxm − (1−ξ) dx1 − ξ dxn) = 0, ξ = (xm − x1)·n/l.
#[derive(Clone, Copy, Debug)]
pub struct IncrementalConstraint;

impl Formula for IncrementalConstraint {
    const SPEC: Spec = Spec {
        id: "slider.incremental_constraint",
        title: "Incremental constraint",
        latex: r"r_q = \mathbf{t}_q\cdot\bigl(\mathrm{d}\mathbf{x}_m - (1-\xi)\,\mathrm{d}\mathbf{x}_1 - \xi\,\mathrm{d}\mathbf{x}_n\bigr),\quad \xi = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{n}/l,\quad q = 1, 2",
        source: Source::SLIDER.section("Incremental constraint"),
        eta: 4.0,
        eta_jacobian: 16.0,
        objective: false,
    };
    type Inputs<T: Element> = MovingNodes<T>;
    type Outputs<T: Element> = IncrementalResiduals<T>;

    fn eval<D: Scalar>(i: &MovingNodes<D>) -> IncrementalResiduals<D> {
        let station = Station::new(&Span::new(&i.x1, &i.xn), &i.x1, &i.xn, &i.xm);
        let across = Across::new(&(i.xn - i.x1));
        let ([along_1, along_2], [root_1, root_2]) =
            (across.along_rays(&(i.dxm - station.blend(&i.dx1, &i.dxn))), across.roots);
        IncrementalResiduals { r1: along_1 / root_1, r2: along_2 / root_2 }
    }

    /// With v = dxm − (1−ξ) dx1 − ξ dxn and γ_q = t_q·(dxn − dx1), the line enters through t_q, whose variation is that in
    /// [`Constraint`] with v for xm − x1, and through ξ: ∂r_q = v·∂t_q − γ_q ∂ξ.
    fn jacobian<D: Scalar>(i: &MovingNodes<D>) -> Jacobian<Self, D> {
        let (span, across) = (Span::new(&i.x1, &i.xn), Across::new(&(i.xn - i.x1)));
        let station = Station::new(&span, &i.x1, &i.xn, &i.xm);
        let ([share, rest], [share_x1, share_xn, share_xm]) = (station.shares(), station.gradients(&span));
        let v = i.dxm - station.blend(&i.dx1, &i.dxn);
        let share_v = v.dot(&span.d) * span.binade.per_unit / span.square;
        // Everything times the length of the ray, by which the rows are divided in the end.
        let (ray, gain) = (across.rays(), across.along_rays(&(i.dxn - i.dx1)));
        let twist = across.twist(across.sideward(v[across.a], v[across.b]));
        let turning = [ray[0] * -across.share_outward(&v), twist - ray[1] * share_v];
        let row = |q: usize| {
            let root = across.roots[q];
            MovingNodes {
                x1: -(turning[q] + share_x1 * gain[q]) / root,
                xn: (turning[q] - share_xn * gain[q]) / root,
                xm: share_xm * -gain[q] / root,
                dx1: ray[q] * -rest / root,
                dxn: ray[q] * -share / root,
                dxm: ray[q] / root,
            }
        };
        IncrementalResiduals { r1: row(0), r2: row(1) }
    }

    fn validate(i: &MovingNodes<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }

    fn cases() -> Vec<Case<MovingNodes<f64>>> {
        let hand = MovingNodes {
            x1: Vector3::zeros(),
            xn: Vector3::new(0.0, 3.0, 4.0),
            xm: Vector3::new(0.0, 1.5, 2.0),
            dx1: Vector3::zeros(),
            dxn: Vector3::new(0.5, 1.0, 0.0),
            dxm: Vector3::new(0.25, 0.5, 0.0),
        };
        let same = Vector3::new(1.0, -2.0, 3.0);
        let mut cases = vec![
            Case::hand("half-way", "m in the middle follows half of node n", hand),
            Case::hand(
                "lagging",
                "t1 = (0, 0.8, -0.6), t2 = (-1, 0, 0): r1 = -0.4, r2 = 0.25",
                MovingNodes { dxm: Vector3::zeros(), ..hand },
            ),
            Case::hand("translation", "all nodes move alike", MovingNodes { dx1: same, dxn: same, dxm: same, ..hand }),
            Case::hand(
                "sliding",
                "m moves along the line",
                MovingNodes { dxn: Vector3::zeros(), dxm: Vector3::new(0.0, 3.0, 4.0), ..hand },
            ),
        ];
        cases.extend(scenes(lines()).into_iter().map(|(id, line, xm)| {
            let [dx1, dxn] = line.motion();
            let dxm = (dx1 + dxn) * 0.5;
            Case::hard(id, line.comment, MovingNodes { x1: line.x1, xn: line.xn, xm, dx1, dxn, dxm })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<MovingNodes<f64>>> {
        let (x1, zero) = (Vector3::new(1.0, 2.0, 3.0), Vector3::zeros());
        let inputs = MovingNodes { x1, xn: x1, xm: zero, dx1: zero, dxn: zero, dxm: zero };
        vec![Case::invalid("coincident", "nodes 1 and n at one place", inputs)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: r"\mathbf{n} = \pm\mathbf{i}",
            convention: Convention::Switch,
            holds: |i| i.xn.y == i.x1.y && i.xn.z == i.x1.z,
            at: || MovingNodes {
                x1: Vector3::zeros(),
                xn: Vector3::new(2.0, 0.0, 0.0),
                xm: Vector3::new(1.0, 0.0, 0.0),
                dx1: Vector3::new(0.25, -0.5, 0.75),
                dxn: Vector3::new(-0.5, 0.125, 0.25),
                dxm: Vector3::new(0.5, 0.5, -0.25),
            },
            across: || {
                let zero = Vector3::zeros();
                MovingNodes { x1: zero, xn: Vector3::new(0.0, 3.0, 4.0), xm: zero, dx1: zero, dxn: zero, dxm: zero }
            },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "on the line it is the variation of the constraint: t1, t2 and their variations drop out",
                sides: |i| {
                    let xm = i.x1 + (i.xn - i.x1) * i.xm.x; // any share will do
                    let at = MovingNodes { xm, ..*i };
                    let jac = Constraint::jacobian(&Nodes { x1: at.x1, xn: at.xn, xm });
                    let along = |row: Nodes<_>| row.x1.dot(&at.dx1) + row.xn.dot(&at.dxn) + row.xm.dot(&at.dxm);
                    let IncrementalResiduals { r1, r2 } = Self::eval(&at);
                    let motion = law::length(at.dx1) + law::length(at.dxn);
                    let size = motion * (abs(i.xm.x) + 1.0) + law::length(at.dxm);
                    law::equal_all_with([(r1, along(jac.g1)), (r2, along(jac.g2))], size)
                },
            },
            Law {
                statement: "a translation of all three nodes is free",
                sides: |i| {
                    let IncrementalResiduals { r1, r2 } = Self::eval(&MovingNodes { dx1: i.dxm, dxn: i.dxm, ..*i });
                    law::vanish([r1, r2], law::length(i.dxm))
                },
            },
        ]
    }
}
