//! Elimination: two coordinates of node m, and two of its increments, from the third.

use super::hard::{lines, scenes};
use super::place::Place;
use super::slide::Slide;
use super::{IncrementalConstraint, MovingNodes, Pivots, documented};
use crate::Octuple;
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::measure::Way;
use crate::quantity::{
    SLIDER_DX1, SLIDER_DXMI, SLIDER_DXMJ, SLIDER_DXMK, SLIDER_DXN, SLIDER_X1, SLIDER_XM, SLIDER_XMI, SLIDER_XMJ,
    SLIDER_XMK, SLIDER_XN,
};
use crate::scalar::{Scalar, abs};
use crate::verify::law;
use nalgebra::Vector3;

fields! {
    /// The line, and the coordinate of node m that is kept.
    pub struct KeptCoordinate<T> { x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xmk: T = SLIDER_XMK }
}
fields! {
    /// The coordinates of node m that are eliminated.
    pub struct Coordinates<T> { xmi: T = SLIDER_XMI, xmj: T = SLIDER_XMJ }
}

/// The place of m on the line from one coordinate: xm_i = x1_i + (n_i/n_k)(xm_k − x1_k), and the same for j.
///
/// The axes are those of [`Pivots`]. Any point of the line may stand in for x1; the nearer of nodes 1 and n does.
#[derive(Clone, Copy, Debug)]
pub struct Eliminate;

impl<D: Scalar> KeptCoordinate<D> {
    /// The axes, and where on the line m is.
    #[inline(always)]
    fn place(&self) -> (Pivots, Place<D, 3>) {
        let pivots = Pivots::new(&self.x1, &self.xn);
        (pivots, Place::new(&self.x1, &self.xn, pivots.k, self.xmk))
    }
}

impl Pivots {
    #[inline(always)]
    fn coordinates<D: Scalar>(self, place: &Place<D, 3>) -> Coordinates<D> {
        Coordinates { xmi: place.coordinate(self.i), xmj: place.coordinate(self.j) }
    }
}

impl Formula for Eliminate {
    const SPEC: Spec = Spec {
        id: "slider.eliminate",
        title: "Elimination",
        latex: r"x_{m,i} = x_{1,i} + \frac{n_i}{n_k}(x_{m,k}-x_{1,k}),\quad x_{m,j} = x_{1,j} + \frac{n_j}{n_k}(x_{m,k}-x_{1,k})",
        source: Source::SLIDER.section("Elimination"),
        eta: 2.0,
        eta_jacobian: 2.0,
        objective: false,
    };
    type Inputs<T: Element> = KeptCoordinate<T>;
    type Outputs<T: Element> = Coordinates<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptCoordinate<D>) -> Coordinates<D> {
        let (pivots, place) = i.place();
        pivots.coordinates(&place)
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptCoordinate<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &KeptCoordinate<D>) -> (Coordinates<D>, Jacobian<Self, D>) {
        let (pivots, place) = i.place();
        let row = |axis: usize| {
            let [x1, xn] = place.gradients(axis);
            KeptCoordinate { x1, xn, xmk: place.slope(axis) }
        };
        (pivots.coordinates(&place), Coordinates { xmi: row(pivots.i), xmj: row(pivots.j) })
    }

    fn validate(i: &KeptCoordinate<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }

    fn cases() -> Vec<Case<KeptCoordinate<f64>>> {
        let hand = KeptCoordinate { x1: Vector3::zeros(), xn: Vector3::new(2.0, 1.0, 4.0), xmk: 8.0 };
        let mut cases = vec![
            Case::hand("twice", "k = 3, i = 2, j = 1: m is twice as far as n, xm2 = 2, xm1 = 4", hand),
            Case::hand("at-node-1", "m at node 1", KeptCoordinate { xmk: 0.0, ..hand }),
            Case::hand("at-node-n", "m at node n", KeptCoordinate { xmk: 4.0, ..hand }),
        ];
        cases.extend(scenes(lines()).into_iter().map(|(id, line, xm)| {
            let xmk = xm[Pivots::new(&line.x1, &line.xn).k];
            Case::hard(id, line.comment, KeptCoordinate { x1: line.x1, xn: line.xn, xmk })
        }));
        cases
    }

    fn ways() -> Vec<Way> {
        vec![Way::new::<Self>(
            "documented",
            "documented route: t1, t2 and a 2×2 system",
            documented::eliminate,
            documented::eliminate,
        )]
    }

    fn invalid_cases() -> Vec<Case<KeptCoordinate<f64>>> {
        let x1 = Vector3::new(1.0, 2.0, 3.0);
        vec![Case::invalid("coincident", "nodes 1 and n at one place", KeptCoordinate { x1, xn: x1, xmk: 1.0 })]
    }

    fn kinks() -> Vec<Kink<Self>> {
        fn line(xn: [f64; 3], xmk: f64) -> KeptCoordinate<f64> {
            KeptCoordinate { x1: Vector3::zeros(), xn: xn.into(), xmk }
        }
        vec![
            Kink {
                condition: r"\lvert d_2\rvert = \lvert d_3\rvert",
                convention: Convention::Switch,
                holds: |i| first_tie(&(i.xn - i.x1)),
                at: || line([1.0, 2.0, 2.0], 1.5),
                across: || line([0.0, 0.0, 1.0], 0.0),
            },
            Kink {
                condition: r"d_2^2 + d_3^2 = \lvert d_1\rvert\max(\lvert d_2\rvert,\lvert d_3\rvert)",
                convention: Convention::Switch,
                holds: |i| second_tie(&(i.xn - i.x1)),
                at: || line([-5.0, 2.0, 4.0], 1.5),
                across: || line([-1.0, 0.0, 0.0], 0.0),
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "the documented route, through t1, t2 and the 2×2 system, gives the same",
                sides: |i| {
                    let (here, there) = (Self::eval(i), documented::eliminate(i));
                    law::equal_all([(here.xmi, there.xmi), (here.xmj, there.xmj)])
                },
            },
            Law {
                statement: "m is on the line: (xm − x1) ∥ (xn − x1)",
                sides: |i| {
                    let Pivots { i: axis_i, j: axis_j, k } = Pivots::new(&i.x1, &i.xn);
                    let Coordinates { xmi, xmj } = Self::eval(i);
                    let mut xm = Vector3::from_element(i.xmk);
                    (xm[axis_i], xm[axis_j], xm[k]) = (xmi, xmj, i.xmk);
                    law::parallel(xm - i.x1, i.xn - i.x1)
                },
            },
            Law {
                statement: "at the coordinate of node n it is node n",
                sides: |i| {
                    let Pivots { i: axis_i, j: axis_j, k } = Pivots::new(&i.x1, &i.xn);
                    let Coordinates { xmi, xmj } = Self::eval(&KeptCoordinate { xmk: i.xn[k], ..*i });
                    law::equal_all([(xmi, i.xn[axis_i]), (xmj, i.xn[axis_j])])
                },
            },
        ]
    }
}

/// |d2| = |d3|: i may be axis 2 or 3.
fn first_tie(d: &Vector3<Octuple>) -> bool {
    abs(d.y) == abs(d.z)
}

/// p² + q² = p |d1|: j may be axis 1 or the axis of p.
fn second_tie(d: &Vector3<Octuple>) -> bool {
    let p = if abs(d.y) > abs(d.z) { abs(d.y) } else { abs(d.z) };
    d.y * d.y + d.z * d.z == p * abs(d.x)
}

fields! {
    /// The line and node m, increments of nodes 1 and n, and the increment of m that is kept.
    pub struct KeptIncrement<T> {
        x1: Vector3<T> = SLIDER_X1, xn: Vector3<T> = SLIDER_XN, xm: Vector3<T> = SLIDER_XM,
        dx1: Vector3<T> = SLIDER_DX1, dxn: Vector3<T> = SLIDER_DXN, dxmk: T = SLIDER_DXMK,
    }
}
fields! {
    /// The increments of node m that are eliminated.
    pub struct Increments<T> { dxmi: T = SLIDER_DXMI, dxmj: T = SLIDER_DXMJ }
}

/// The eliminated increments of m: with w = (1−ξ) dx1 + ξ dxn and ξ = (xm − x1)·n/l,
/// dxm_i = w_i + (n_i/n_k)(dxm_k − w_k), and the same for j.
///
/// No direction across the line is needed, and nothing grows without bound as n approaches ±i.
#[derive(Clone, Copy, Debug)]
pub struct Increment;

impl Formula for Increment {
    const SPEC: Spec = Spec {
        id: "slider.increment",
        title: "Eliminated increments",
        latex: r"\mathrm{d}x_{m,i} = w_i + \frac{n_i}{n_k}(\mathrm{d}x_{m,k}-w_k),\quad \mathrm{d}x_{m,j} = w_j + \frac{n_j}{n_k}(\mathrm{d}x_{m,k}-w_k),\quad \mathbf{w} = (1-\xi)\,\mathrm{d}\mathbf{x}_1 + \xi\,\mathrm{d}\mathbf{x}_n",
        source: Source::SLIDER.section("Elimination of the increments"),
        eta: 3.0,
        eta_jacobian: 5.0,
        objective: false,
    };
    type Inputs<T: Element> = KeptIncrement<T>;
    type Outputs<T: Element> = Increments<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptIncrement<D>) -> Increments<D> {
        let Pivots { i: axis_i, j: axis_j, k } = Pivots::new(&i.x1, &i.xn);
        let slide = Slide::new(&i.x1, &i.xn, &i.xm, k);
        let [dxmi, dxmj] = slide.increments([axis_i, axis_j], &i.dx1, &i.dxn, i.dxmk);
        Increments { dxmi, dxmj }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptIncrement<D>) -> Jacobian<Self, D> {
        Self::linearized(i).1
    }

    #[inline]
    fn linearized<D: Scalar>(i: &KeptIncrement<D>) -> (Increments<D>, Jacobian<Self, D>) {
        // The axes as constants, so that no index is looked up: half as long in f64.
        match Pivots::new(&i.x1, &i.xn) {
            Pivots { i: 1, j: 0, .. } => along_axes::<D, 1, 0, 2>(i),
            Pivots { i: 1, .. } => along_axes::<D, 1, 2, 0>(i),
            Pivots { j: 0, .. } => along_axes::<D, 2, 0, 1>(i),
            Pivots { .. } => along_axes::<D, 2, 1, 0>(i),
        }
    }

    fn validate(i: &KeptIncrement<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }

    fn cases() -> Vec<Case<KeptIncrement<f64>>> {
        let hand = KeptIncrement {
            x1: Vector3::zeros(),
            xn: Vector3::new(2.0, 1.0, 4.0),
            xm: Vector3::new(1.0, 0.5, 2.0),
            dx1: Vector3::zeros(),
            dxn: Vector3::new(0.5, 1.0, 0.0),
            dxmk: 0.0,
        };
        let same = Vector3::new(1.0, -2.0, 3.0);
        let mut cases = vec![
            Case::hand("half-way", "m in the middle follows half of node n: dxm2 = 0.5, dxm1 = 0.25", hand),
            Case::hand(
                "sliding",
                "m moves along the resting line: dxm2 = 1/4 × 8, dxm1 = 2/4 × 8",
                KeptIncrement { dxn: Vector3::zeros(), dxmk: 8.0, ..hand },
            ),
            Case::hand(
                "translation",
                "all nodes move alike",
                KeptIncrement { dx1: same, dxn: same, dxmk: 3.0, ..hand },
            ),
        ];
        cases.extend(scenes(lines()).into_iter().map(|(id, line, xm)| {
            let [dx1, dxn] = line.motion();
            let dxmk = dx1.x + dxn.z;
            Case::hard(id, line.comment, KeptIncrement { x1: line.x1, xn: line.xn, xm, dx1, dxn, dxmk })
        }));
        cases
    }

    fn ways() -> Vec<Way> {
        vec![Way::new::<Self>(
            "documented",
            "documented route, m put on the line",
            documented::increment_on_line,
            documented::increment_on_line,
        )]
    }

    fn invalid_cases() -> Vec<Case<KeptIncrement<f64>>> {
        let (x1, zero) = (Vector3::new(1.0, 2.0, 3.0), Vector3::zeros());
        let inputs = KeptIncrement { x1, xn: x1, xm: zero, dx1: zero, dxn: zero, dxmk: 0.0 };
        vec![Case::invalid("coincident", "nodes 1 and n at one place", inputs)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        fn scene(xn: [f64; 3]) -> KeptIncrement<f64> {
            KeptIncrement {
                x1: Vector3::zeros(),
                xn: xn.into(),
                xm: Vector3::new(0.5, 1.0, 0.75),
                dx1: Vector3::new(0.25, -0.5, 0.75),
                dxn: Vector3::new(-0.5, 0.125, 0.25),
                dxmk: 0.375,
            }
        }
        fn turn(xn: [f64; 3]) -> KeptIncrement<f64> {
            KeptIncrement { xn: xn.into(), ..KeptIncrement::filled(0.0) }
        }
        vec![
            Kink {
                condition: r"\lvert d_2\rvert = \lvert d_3\rvert",
                convention: Convention::Switch,
                holds: |i| first_tie(&(i.xn - i.x1)),
                at: || scene([1.0, 2.0, 2.0]),
                across: || turn([0.0, 0.0, 1.0]),
            },
            Kink {
                condition: r"d_2^2 + d_3^2 = \lvert d_1\rvert\max(\lvert d_2\rvert,\lvert d_3\rvert)",
                convention: Convention::Switch,
                holds: |i| second_tie(&(i.xn - i.x1)),
                at: || scene([-5.0, 2.0, 4.0]),
                across: || turn([-1.0, 0.0, 0.0]),
            },
        ]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law {
                statement: "on the line, the documented route, through t1, t2, dt1, dt2 and the 2×2 system, gives the same",
                sides: |i| {
                    let xm = on_the_line(i);
                    let at = KeptIncrement { xm, ..*i };
                    let (here, there) = (Self::eval(&at), documented::increment(&at));
                    law::equal_all([(here.dxmi, there.dxmi), (here.dxmj, there.dxmj)])
                },
            },
            Law {
                statement: "the increments satisfy the incremental constraint, on the line and off it",
                sides: |i| {
                    let KeptIncrement { x1, xn, xm, dx1, dxn, dxmk } = *i;
                    let Pivots { i: axis_i, j: axis_j, k } = Pivots::new(&x1, &xn);
                    let Increments { dxmi, dxmj } = Self::eval(i);
                    let mut dxm = Vector3::from_element(dxmk);
                    (dxm[axis_i], dxm[axis_j], dxm[k]) = (dxmi, dxmj, dxmk);
                    let r = IncrementalConstraint::eval(&MovingNodes { x1, xn, xm, dx1, dxn, dxm });
                    let size = law::length(dxm) + law::length(dx1) + law::length(dxn);
                    law::vanish([r.r1, r.r2], size)
                },
            },
            Law {
                statement: "on the line it is the derivative of the elimination",
                sides: |i| {
                    let at = KeptIncrement { xm: on_the_line(i), ..*i };
                    let k = Pivots::new(&at.x1, &at.xn).k;
                    let jac = Eliminate::jacobian(&KeptCoordinate { x1: at.x1, xn: at.xn, xmk: at.xm[k] });
                    let along = |row: KeptCoordinate<_>| row.x1.dot(&at.dx1) + row.xn.dot(&at.dxn) + row.xmk * at.dxmk;
                    let Increments { dxmi, dxmj } = Self::eval(&at);
                    law::equal_all([(dxmi, along(jac.xmi)), (dxmj, along(jac.xmj))])
                },
            },
        ]
    }
}

/// Value and Jacobian of [`Increment`] for these axes.
#[inline]
fn along_axes<D: Scalar, const I: usize, const J: usize, const K: usize>(
    i: &KeptIncrement<D>,
) -> (Increments<D>, Increments<KeptIncrement<D>>) {
    let slide = Slide::new(&i.x1, &i.xn, &i.xm, K);
    let [dxmi, dxmj] = slide.increments([I, J], &i.dx1, &i.dxn, i.dxmk);
    let rows = slide.gradients(&i.dx1, &i.dxn, i.dxmk);
    let row = |axis: usize| {
        let row = rows.row(axis);
        KeptIncrement { x1: row.x1, xn: row.xn, xm: row.xm, dx1: row.dx1, dxn: row.dxn, dxmk: row.dxmk }
    };
    (Increments { dxmi, dxmj }, Increments { dxmi: row(I), dxmj: row(J) })
}

/// A point of the line with the k-th coordinate of xm.
fn on_the_line(i: &KeptIncrement<Octuple>) -> Vector3<Octuple> {
    let k = Pivots::new(&i.x1, &i.xn).k;
    i.x1 + (i.xn - i.x1) * ((i.xm[k] - i.x1[k]) / (i.xn[k] - i.x1[k]))
}
