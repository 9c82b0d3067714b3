//! The sliding constraint in the plane: one condition, and one coordinate eliminated.

use super::hard::{plane_lines, scenes};
use super::slide::Slide;
use super::span::{Span, Station};
use super::{Constraint, Increment, KeptIncrement, Nodes};
use super::{Pivots, Pivots2d};
use crate::error::Error;
use crate::fields;
use crate::formula::{Case, Convention, Element, Fields, Formula, Jacobian, Kink, Law, Source, Spec};
use crate::quantity::{
    SLIDER_DX1_PLANE, SLIDER_DXMI, SLIDER_DXMK, SLIDER_DXN_PLANE, SLIDER_G, SLIDER_X1_PLANE, SLIDER_XM_PLANE,
    SLIDER_XN_PLANE,
};
use crate::scalar::{Scalar, abs, sign};
use crate::verify::law;
use nalgebra::{Vector2, Vector3};

fields! {
    /// The line, and node m, in the plane.
    pub struct Nodes2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
    }
}
fields! {
    /// How far m is off the line in the plane.
    pub struct Distance2d<T> { g: T = SLIDER_G }
}

/// The condition that holds m on the line in the plane: g = (xm − x1)·t = 0, t = s×n = (−n2, n1).
///
/// The other condition, along the normal s of the plane, holds by itself.
#[derive(Clone, Copy, Debug)]
pub struct Constraint2d;

impl Formula for Constraint2d {
    const SPEC: Spec = Spec {
        id: "slider.constraint_2d",
        title: "Constraint in the plane",
        latex: r"g = (\mathbf{x}_m-\mathbf{x}_1)\cdot\mathbf{t},\quad \mathbf{t} = \mathbf{s}\times\mathbf{n} = (-n_2, n_1)",
        source: Source::SLIDER.section("Two-dimensional case"),
        eta: 3.0,
        eta_jacobian: 5.0,
        objective: true,
    };
    type Inputs<T: Element> = Nodes2d<T>;
    type Outputs<T: Element> = Distance2d<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &Nodes2d<D>) -> Distance2d<D> {
        let span = Span::new(&i.x1, &i.xn);
        let offset = Station::new(&span, &i.x1, &i.xn, &i.xm).offset;
        Distance2d { g: span.d.perp(&offset) / span.square.sqrt() }
    }

    /// ∂g/∂xn = −ξ t, ∂g/∂x1 = −(1 − ξ) t: as if m were a point of a rigid bar.
    #[inline]
    fn jacobian<D: Scalar>(i: &Nodes2d<D>) -> Jacobian<Self, D> {
        let span = Span::new(&i.x1, &i.xn);
        let [share, rest] = Station::new(&span, &i.x1, &i.xn, &i.xm).shares();
        let t = Vector2::new(-span.d.y, span.d.x) / span.square.sqrt();
        Distance2d { g: Nodes2d { x1: t * -rest, xn: t * -share, xm: t } }
    }

    fn validate(i: &Nodes2d<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }

    fn cases() -> Vec<Case<Nodes2d<f64>>> {
        let hand = Nodes2d { x1: Vector2::new(1.0, 1.0), xn: Vector2::new(4.0, 5.0), xm: Vector2::new(2.0, 4.0) };
        let mut cases = vec![
            Case::hand("left", "t = (-0.8, 0.6): g = -0.8 + 1.8", hand),
            Case::hand("right", "the same on the other side", Nodes2d { xm: Vector2::new(2.0, 0.0), ..hand }),
            Case::hand("at-node-n", "on the line", Nodes2d { xm: hand.xn, ..hand }),
        ];
        cases.extend(
            scenes(plane_lines())
                .into_iter()
                .map(|(id, line, xm)| Case::hard(id, line.comment, Nodes2d { x1: line.x1, xn: line.xn, xm })),
        );
        cases
    }

    fn invalid_cases() -> Vec<Case<Nodes2d<f64>>> {
        let x1 = Vector2::new(1.0, 2.0);
        vec![Case::invalid("coincident", "nodes 1 and n at one place", Nodes2d { x1, xn: x1, xm: Vector2::zeros() })]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "in the plane z = 0 of space (g1, g2) is (0, g sign n2); along i it is (−g, 0)",
            sides: |i| {
                let zero = num_traits::Zero::zero();
                let space = |v: Vector2<_>| Vector3::new(v.x, v.y, zero);
                let nodes = Nodes { x1: space(i.x1), xn: space(i.xn), xm: space(i.xm) };
                let (flat, full) = (Self::eval(i).g, Constraint::eval(&nodes));
                match sign(i.xn.y - i.x1.y) {
                    0.0 => law::equal_all([(full.g1, -flat), (full.g2, zero)]),
                    sign => law::equal_all([(full.g1, zero), (full.g2, flat * sign)]),
                }
            },
        }]
    }
}

fields! {
    /// The line and node m in the plane, increments of nodes 1 and n, and the increment of m that is kept.
    pub struct KeptIncrement2d<T> {
        x1: Vector2<T> = SLIDER_X1_PLANE, xn: Vector2<T> = SLIDER_XN_PLANE, xm: Vector2<T> = SLIDER_XM_PLANE,
        dx1: Vector2<T> = SLIDER_DX1_PLANE, dxn: Vector2<T> = SLIDER_DXN_PLANE, dxmk: T = SLIDER_DXMK,
    }
}
fields! {
    /// The increment of node m that is eliminated in the plane.
    pub struct Increment2dOutput<T> { dxmi: T = SLIDER_DXMI }
}

/// The eliminated increment of m in the plane, with the axes of [`Pivots2d`]: w = (1−ξ) dx1 + ξ dxn,
/// dxm_i = w_i + (n_i/n_k)(dxm_k − w_k).
#[derive(Clone, Copy, Debug)]
pub struct Increment2d;

impl Formula for Increment2d {
    const SPEC: Spec = Spec {
        id: "slider.increment_2d",
        title: "Eliminated increment in the plane",
        latex: r"\mathrm{d}x_{m,i} = w_i + \frac{n_i}{n_k}(\mathrm{d}x_{m,k}-w_k),\quad \mathbf{w} = (1-\xi)\,\mathrm{d}\mathbf{x}_1 + \xi\,\mathrm{d}\mathbf{x}_n",
        source: Source::SLIDER.section("Two-dimensional case"),
        eta: 3.0,
        eta_jacobian: 5.0,
        objective: false,
    };
    type Inputs<T: Element> = KeptIncrement2d<T>;
    type Outputs<T: Element> = Increment2dOutput<T>;

    #[inline(always)]
    fn eval<D: Scalar>(i: &KeptIncrement2d<D>) -> Increment2dOutput<D> {
        let pivots = Pivots2d::new(&i.x1, &i.xn);
        let slide = Slide::new(&i.x1, &i.xn, &i.xm, pivots.k);
        let [dxmi] = slide.increments([pivots.i], &i.dx1, &i.dxn, i.dxmk);
        Increment2dOutput { dxmi }
    }

    #[inline]
    fn jacobian<D: Scalar>(i: &KeptIncrement2d<D>) -> Jacobian<Self, D> {
        let pivots = Pivots2d::new(&i.x1, &i.xn);
        let row = Slide::new(&i.x1, &i.xn, &i.xm, pivots.k).gradients(&i.dx1, &i.dxn, i.dxmk).row(pivots.i);
        Increment2dOutput {
            dxmi: KeptIncrement2d { x1: row.x1, xn: row.xn, xm: row.xm, dx1: row.dx1, dxn: row.dxn, dxmk: row.dxmk },
        }
    }

    fn validate(i: &KeptIncrement2d<f64>) -> Result<(), Error> {
        Error::check_apart(("x1", i.x1), ("xn", i.xn))
    }

    fn cases() -> Vec<Case<KeptIncrement2d<f64>>> {
        let hand = KeptIncrement2d {
            x1: Vector2::zeros(),
            xn: Vector2::new(4.0, 2.0),
            xm: Vector2::new(2.0, 1.0),
            dx1: Vector2::zeros(),
            dxn: Vector2::new(0.0, 1.0),
            dxmk: 0.0,
        };
        let mut cases = vec![
            Case::hand("half-way", "m in the middle follows half of node n", hand),
            Case::hand(
                "sliding",
                "m moves along the resting line: dxm2 = 2/4 × 3",
                KeptIncrement2d { dxn: Vector2::zeros(), dxmk: 3.0, ..hand },
            ),
        ];
        cases.extend(scenes(plane_lines()).into_iter().map(|(id, line, xm)| {
            let [dx1, dxn] = line.motion();
            let dxmk = dx1.x + dxn.y;
            Case::hard(id, line.comment, KeptIncrement2d { x1: line.x1, xn: line.xn, xm, dx1, dxn, dxmk })
        }));
        cases
    }

    fn invalid_cases() -> Vec<Case<KeptIncrement2d<f64>>> {
        let (x1, zero) = (Vector2::new(1.0, 2.0), Vector2::zeros());
        let inputs = KeptIncrement2d { x1, xn: x1, xm: zero, dx1: zero, dxn: zero, dxmk: 0.0 };
        vec![Case::invalid("coincident", "nodes 1 and n at one place", inputs)]
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink {
            condition: r"\lvert d_1\rvert = \lvert d_2\rvert",
            convention: Convention::Switch,
            holds: |i| abs(i.xn.x - i.x1.x) == abs(i.xn.y - i.x1.y),
            at: || KeptIncrement2d {
                x1: Vector2::zeros(),
                xn: Vector2::new(2.0, -2.0),
                xm: Vector2::new(0.5, 1.0),
                dx1: Vector2::new(0.25, -0.5),
                dxn: Vector2::new(-0.5, 0.125),
                dxmk: 0.375,
            },
            across: || KeptIncrement2d { xn: Vector2::new(1.0, 0.0), ..KeptIncrement2d::filled(0.0) },
        }]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![Law {
            statement: "in the plane z = 0 of space it is the eliminated increment that is not along z, where no tie lets \
                        both keep different axes",
            sides: |i| {
                let zero = num_traits::Zero::zero();
                let space = |v: Vector2<_>| Vector3::new(v.x, v.y, zero);
                let [x1, xn, xm, dx1, dxn] = [i.x1, i.xn, i.xm, i.dx1, i.dxn].map(space);
                let full = Increment::eval(&KeptIncrement { x1, xn, xm, dx1, dxn, dxmk: i.dxmk });
                let (axes, flat) = (Pivots::new(&x1, &xn), Self::eval(i).dxmi);
                match axes {
                    axes if axes.k != Pivots2d::new(&i.x1, &i.xn).k => Vec::new(),
                    Pivots { i: 2, .. } => law::equal_all([(full.dxmi, zero), (full.dxmj, flat)]),
                    _ => law::equal_all([(full.dxmi, flat), (full.dxmj, zero)]),
                }
            },
        }]
    }
}
