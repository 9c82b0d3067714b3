//! The two conditions that hold node m on the line, and what they demand of increments.

use super::across::Across;
use super::hard::{lines, scenes};
use super::span::{Span, Station};
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{
    SLIDER_DX1, SLIDER_DXM, SLIDER_DXN, SLIDER_G1, SLIDER_G2, SLIDER_R1, SLIDER_R2, SLIDER_X1, SLIDER_XM, SLIDER_XN,
};
use crate::scalar::{Scalar, abs};
use crate::verify::law;
use nalgebra::Vector3;

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

/// Node m as both directions across the line see it.
struct View<D> {
    across: Across<D>,
    /// Along the line.
    station: Station<D, 3>,
    /// Along the projection of the line that t1 sees.
    projected: Station<D, 2>,
}

impl<D: Scalar> View<D> {
    #[inline(always)]
    fn new(i: &Nodes<D>) -> Self {
        let across = Across::new(&(i.xn - i.x1));
        let project = |v: &Vector3<D>| across.split(v).1;
        let projected = Station::new(&across.projected, &project(&i.x1), &project(&i.xn), &project(&i.xm));
        Self { across, station: Station::new(&Span::new(&i.x1, &i.xn), &i.x1, &i.xn, &i.xm), projected }
    }

    /// g1 times the length of its ray.
    #[inline]
    fn sideward(&self) -> D {
        self.projected.offset.perp(&self.across.projected.d)
    }

    #[inline]
    fn distances(&self) -> Distances<D> {
        let ([_, along_2], [root_1, root_2]) = (self.across.along_rays(&self.station.offset), self.across.roots);
        Distances { g1: self.sideward() / root_1, g2: along_2 / root_2 }
    }

    /// With d = xn − x1, ∂g1/∂d = −ξ′ t1, where ξ′ is the share of m in the projection that t1 sees, and ∂g2/∂d = −ξ t2 +
    /// (n·i) g1/|i × d| t1: t2 turns with the line, and with t1 about i.
    #[inline]
    fn gradients(&self) -> Distances<Nodes<D>> {
        let ([ray_1, ray_2], [root_1, root_2]) = (self.across.rays(), self.across.roots);
        let (per_1, per_2) = (root_1.recip(), root_2.recip());
        let (t1, t2, turn) = (ray_1 * per_1, ray_2 * per_2, self.across.twist(self.sideward()) * per_2);
        let ([share, rest], [share_1, rest_1]) = (self.station.shares(), self.projected.shares());
        Distances {
            g1: Nodes { x1: t1 * -rest_1, xn: t1 * -share_1, xm: t1 },
            g2: Nodes { x1: -turn - t2 * rest, xn: turn - t2 * share, xm: t2 },
        }
    }
}

impl Formula for Constraint {
    const SPEC: Spec = Spec {
        id: "slider.constraint",
        title: "Constraint",
        latex: r"g_q = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{t}_q,\quad q = 1, 2",
        source: Source::SLIDER.section("Constraint"),
        eta: 4.0,
        // An entry of ∂g2 is a sum of a turn about i and one across it; where they cancel, the sum keeps their roundings.
        eta_jacobian: 24.0,
        objective: false,
    };
    type Inputs<T: Element> = Nodes<T>;
    type Outputs<T: Element> = Distances<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Nodes<D>) -> Distances<D> {
        View::new(i).distances()
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &Nodes<D>) -> Jacobian<Self, D> {
        View::new(i).gradients()
    }

    #[inline]
    fn linearized<D: Scalar>(i: &Nodes<D>) -> (Distances<D>, Jacobian<Self, D>) {
        let view = View::new(i);
        (view.distances(), view.gradients())
    }

    #[inline]
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

    #[inline(always)]
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
        let twist = across.twist(across.split(&v).1.perp(&across.projected.d));
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
