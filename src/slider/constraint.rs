//! The two conditions that hold node m on the line, and what they demand of increments.

use super::azimuth::Azimuth;
use super::hard::{lines, scenes};
use super::station::Station;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{
    SLIDER_DX1, SLIDER_DXM, SLIDER_DXN, SLIDER_G1, SLIDER_G2, SLIDER_R1, SLIDER_R2, SLIDER_X1, SLIDER_XM, SLIDER_XN,
};
use crate::scalar::{Scalar, abs, norm_and_direction};
use crate::verify::law;
use nalgebra::{Vector2, Vector3};

/// The line as seen from its directions across: around axis e, n = cos e + sin (c_a e_a + c_b e_b).
#[derive(Clone, Copy, Debug)]
struct Polar<D> {
    around: Azimuth<D>,
    l: D,
    sin: D,
    cos: D,
}

impl<D: Scalar> Polar<D> {
    #[inline]
    fn new(d: &Vector3<D>) -> Self {
        let around = Azimuth::new(d);
        let (l, [sin, cos]) = norm_and_direction([around.h, d[around.axis]]);
        Self { around, l, sin, cos }
    }

    #[inline]
    fn n(&self) -> Vector3<D> {
        let Azimuth { a, b, c: [ca, cb], .. } = self.around;
        let mut n = Vector3::from_element(self.cos);
        (n[a], n[b]) = (self.sin * ca, self.sin * cb);
        n
    }

    /// (v·t1, v·t2).
    #[inline]
    fn across(&self, v: &Vector3<D>) -> [D; 2] {
        let [along_t1, outward] = self.around.components(v);
        [along_t1, self.cos * outward - self.sin * v[self.around.axis]]
    }

    /// v·n.
    #[inline]
    fn along(&self, v: &Vector3<D>) -> D {
        let [_, outward] = self.around.components(v);
        self.sin * outward + self.cos * v[self.around.axis]
    }
}

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

impl Constraint {
    /// Where m is along the line as t1 sees it: in the projection along the axis of the azimuth.
    #[inline]
    fn projected<D: Scalar>(i: &Nodes<D>, around: &Azimuth<D>) -> Station<D, 2> {
        let project = |v: &Vector3<D>| Vector2::new(v[around.a], v[around.b]);
        Station::new([&project(&i.x1), &project(&i.xn), &project(&i.xm)], &around.c.into(), around.h)
    }
}

impl Formula for Constraint {
    const SPEC: Spec = Spec {
        id: "slider.constraint",
        title: "Constraint",
        latex: r"g_q = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{t}_q,\quad q = 1, 2",
        source: Source::SLIDER.section("Constraint"),
        eta: 6.0,
        eta_jacobian: 8.0,
        objective: false,
    };
    type Inputs<T: Element> = Nodes<T>;
    type Outputs<T: Element> = Distances<T>;

    fn eval<D: Scalar>(i: &Nodes<D>) -> Distances<D> {
        let polar = Polar::new(&(i.xn - i.x1));
        let [ca, cb] = polar.around.c;
        let projected = Self::projected(i, &polar.around).offset;
        let [_, g2] = polar.across(&Station::new([&i.x1, &i.xn, &i.xm], &polar.n(), polar.l).offset);
        Distances { g1: cb * projected.x - ca * projected.y, g2 }
    }

    /// With the projected share ξ′ of m, and κ = n·e/h: ∂g1/∂xn = −ξ′ t1, ∂g1/∂x1 = −(1 − ξ′) t1, ∂g2/∂xn = −ξ t2 + κ g1 t1,
    /// ∂g2/∂x1 = −(1 − ξ) t2 − κ g1 t1.
    fn jacobian<D: Scalar>(i: &Nodes<D>) -> Jacobian<Self, D> {
        let polar = Polar::new(&(i.xn - i.x1));
        let around = &polar.around;
        let (t1, t2) = (around.t1(), around.t2(polar.sin, polar.cos));
        let projected = Self::projected(i, around);
        let [share_1, rest_1] = projected.shares();
        let [share_2, rest_2] = Station::new([&i.x1, &i.xn, &i.xm], &polar.n(), polar.l).shares();
        let [ca, cb] = around.c;
        let g1 = cb * projected.offset.x - ca * projected.offset.y;
        let twist = t1 * (polar.cos * (g1 / around.h));
        Distances {
            g1: Nodes { x1: t1 * -rest_1, xn: t1 * -share_1, xm: t1 },
            g2: Nodes { x1: t2 * -rest_2 - twist, xn: t2 * -share_2 + twist, xm: t2 },
        }
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
        eta: 8.0,
        eta_jacobian: 16.0,
        objective: false,
    };
    type Inputs<T: Element> = MovingNodes<T>;
    type Outputs<T: Element> = IncrementalResiduals<T>;

    fn eval<D: Scalar>(i: &MovingNodes<D>) -> IncrementalResiduals<D> {
        let polar = Polar::new(&(i.xn - i.x1));
        let station = Station::new([&i.x1, &i.xn, &i.xm], &polar.n(), polar.l);
        let [r1, r2] = polar.across(&(i.dxm - station.blend(&i.dx1, &i.dxn)));
        IncrementalResiduals { r1, r2 }
    }

    /// With v = dxm − (1−ξ) dx1 − ξ dxn and γ_q = t_q·(dxn − dx1), the line enters through t_q, whose variation is that in
    /// [`Constraint`] with v for xm − x1, and through ξ: ∂r_q = v·∂t_q − γ_q ∂ξ.
    fn jacobian<D: Scalar>(i: &MovingNodes<D>) -> Jacobian<Self, D> {
        let d = i.xn - i.x1;
        let polar = Polar::new(&d);
        let (around, l, n) = (&polar.around, polar.l, polar.n());
        let t = [around.t1(), around.t2(polar.sin, polar.cos)];
        let station = Station::new([&i.x1, &i.xn, &i.xm], &n, l);
        let [share, rest] = station.shares();
        let v = i.dxm - station.blend(&i.dx1, &i.dxn);
        let [r1, outward] = around.components(&v);
        let turning =
            [t[0] * -(outward / around.h), t[0] * (polar.cos * (r1 / around.h)) - t[1] * (polar.along(&v) / l)];
        let gain = polar.across(&(i.dxn - i.dx1));
        let aside = station.aside(&d) / l;
        let (share_xn, share_x1) = ((aside - n * share) / l, -(aside + n * rest) / l);
        let row = |q: usize| MovingNodes {
            x1: -turning[q] - share_x1 * gain[q],
            xn: turning[q] - share_xn * gain[q],
            xm: n * -(gain[q] / l),
            dx1: t[q] * -rest,
            dxn: t[q] * -share,
            dxm: t[q],
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
                    let size = (law::length(at.dx1) + law::length(at.dxn)) * (abs(i.xm.x) + 1.0);
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
