//! Evidence for the formulas of the parent module: cases, laws.

use super::{Forces, GeometricStiffness, Rows, SliderForces2d, SliderLoads2d, SliderRow2d};
use crate::Octuple;
use crate::connector::slider::hard::{plane_lines, scenes};
use crate::connector::slider::rows::proof::is_oblique;
use crate::connector::slider::running::{PLANE_X1 as X1, PLANE_XM as XM, PLANE_XN as XN};
use crate::connector::slider::{Constraint2d, IncrementalConstraint2d, MovingNodes2d, Nodes2d};
use crate::element::motion::{Moving, still};
use crate::formula::proof::{Case, Equation, Law, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::{abs, norm};
use nalgebra::{Vector2, Vector6};
use num_dual::Dual;
use num_traits::{One, Zero};

type Vector = Vector2<Octuple>;

/// The positions of the nodes at points of interest.
fn places() -> Vec<Case<Nodes2d<f64>>> {
    let hand = Nodes2d { x1: Vector2::zeros(), xn: Vector2::new(4.0, 3.0), xm: Vector2::new(1.0, 0.75) };
    let mut cases = vec![
        Case::hand("quarter", "t = (-0.6, 0.8), ξ = 1/4", hand),
        Case::hand("at-node-1", "ξ = 0: node n takes nothing", Nodes2d { xm: hand.x1, ..hand }),
        Case::hand("at-node-n", "ξ = 1: node 1 takes nothing", Nodes2d { xm: hand.xn, ..hand }),
        Case::hand("outside", "ξ = 2: a lever", Nodes2d { xm: hand.xn * 2.0, ..hand }),
        Case::running("t = (-0.8, 0.6), ξ = 3/4", Nodes2d { x1: X1, xn: XN, xm: XM }),
    ];
    let scenes = scenes(plane_lines()).into_iter().filter(|(_, line, _)| is_oblique(&(line.xn - line.x1)));
    cases.extend(scenes.map(|(id, line, xm)| Case::hard(id, line.comment, Nodes2d { x1: line.x1, xn: line.xn, xm })));
    cases
}

/// The same with a multiplier; squares of these lengths do not over- or underflow.
fn loads() -> Vec<Case<SliderLoads2d<f64>>> {
    let with = |case: Case<Nodes2d<f64>>| {
        let Nodes2d { x1, xn, xm } = case.inputs;
        Case::new(case.flag, case.id, case.comment, SliderLoads2d { x1, xn, xm, lambda: 5.0 })
    };
    let has_squares = |nodes: &Nodes2d<f64>| (1e-100..1e100).contains(&(nodes.xn - nodes.x1).amax());
    let mut cases: Vec<_> = places().into_iter().filter(|case| has_squares(&case.inputs)).map(with).collect();
    let here = cases[0].inputs;
    cases.extend([
        Case::hard("unloaded", "no force", SliderLoads2d { lambda: 0.0, ..here }),
        Case::hard("large-force", "a force of 1e200", SliderLoads2d { lambda: -3e200, ..here }),
        Case::hard("small-force", "a force of 1e-200", SliderLoads2d { lambda: 3e-200, ..here }),
    ]);
    cases
}

fn coincident() -> Vec<Case<Nodes2d<f64>>> {
    let x1 = Vector2::new(1.0, 2.0);
    vec![Case::invalid("coincident", "nodes 1 and n coincide", Nodes2d { x1, xn: x1, xm: Vector2::zeros() })]
}

fn invalid_loads() -> Vec<Case<SliderLoads2d<f64>>> {
    let with = |case: Case<Nodes2d<f64>>| {
        let Nodes2d { x1, xn, xm } = case.inputs;
        Case::invalid(case.id, case.comment, SliderLoads2d { x1, xn, xm, lambda: 1.0 })
    };
    coincident().into_iter().map(with).collect()
}

/// Nodes with m on the line, at a fraction taken from its first coordinate: any fraction will do.
fn on_the_line(x1: Vector, xn: Vector, share: Octuple) -> Nodes2d<Octuple> {
    Nodes2d { x1, xn, xm: x1 + (xn - x1) * share }
}

fn length(v: Vector) -> Octuple {
    norm(v.into())
}

/// The size of the forces on the nodes for a force of size 1 on m.
fn lever(i: &Nodes2d<Octuple>) -> Octuple {
    (length(i.xm - i.x1) + length(i.xm - i.xn)) / length(i.xn - i.x1) + 1.0
}

/// The vectors are equal to within rounding errors relative to one common size.
fn equal_parts(left: [Vector; 3], right: [Vector; 3], size: Octuple) -> Vec<Equation> {
    let pairs = left.into_iter().zip(right);
    pairs.flat_map(|(l, r)| law::equal_all_with(l.iter().copied().zip(r.iter().copied()), size)).collect()
}

impl SliderRow2d<Octuple> {
    const fn parts(&self) -> [Vector; 3] {
        [self.g_u1, self.g_un, self.g_um]
    }
}

impl Proved for Rows {
    fn cases() -> Vec<Case<Nodes2d<f64>>> {
        places()
    }

    fn invalid_cases() -> Vec<Case<Nodes2d<f64>>> {
        coincident()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("on the line they are the derivatives of the residual", |i| {
                let at = on_the_line(i.x1, i.xn, i.xm.x);
                let by = Constraint2d::jacobian(&at).g;
                equal_parts(Self::eval(&at).parts(), [by.x1, by.xn, by.xm], lever(&at))
            }),
            Law::<Self>::new("they are the coefficients of the increments in the incremental constraint", |i| {
                let Nodes2d { x1, xn, xm } = *i;
                let still = MovingNodes2d { x1, xn, xm, ..MovingNodes2d::filled(Octuple::zero()) };
                let by = IncrementalConstraint2d::jacobian(&still).r;
                equal_parts(Self::eval(i).parts(), [by.dx1, by.dxn, by.dxm], lever(i))
            }),
            Law::<Self>::new("they do no work in a common motion of all nodes", |i| {
                let [on_1, on_n, on_m] = Self::eval(i).parts();
                law::vanish((on_1 + on_n + on_m).iter().copied(), lever(i))
            }),
        ]
    }
}

impl SliderForces2d<Octuple> {
    const fn parts(&self) -> [Vector; 3] {
        [self.force_1, self.force_n, self.force_m]
    }
}

impl SliderLoads2d<Octuple> {
    const fn nodes(&self) -> Nodes2d<Octuple> {
        let Self { x1, xn, xm, .. } = *self;
        Nodes2d { x1, xn, xm }
    }

    /// The same with m on the line.
    fn aligned(&self) -> Self {
        Self { xm: on_the_line(self.x1, self.xn, self.xm.x).xm, ..*self }
    }
}

impl Proved for Forces {
    fn cases() -> Vec<Case<SliderLoads2d<f64>>> {
        loads()
    }

    fn invalid_cases() -> Vec<Case<SliderLoads2d<f64>>> {
        invalid_loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("they are the multiplier times the row", |i| {
                let row = Rows::eval(&i.nodes()).parts().map(|part| part * i.lambda);
                equal_parts(Self::eval(i).parts(), row, i.lambda * lever(&i.nodes()))
            }),
            Law::<Self>::new("on the line forces and moments balance", |i| {
                let at = i.aligned();
                let (parts, places) = (Self::eval(&at).parts(), [at.x1, at.xn, at.xm]);
                let force: Vector = parts.iter().sum();
                let moment = places.iter().zip(&parts).map(|(x, f)| x.perp(f)).sum::<Octuple>();
                let size = i.lambda * lever(&at.nodes());
                let reach = places.into_iter().map(length).sum::<Octuple>();
                [law::vanish(force.iter().copied(), size), law::vanish([moment], size * reach)].concat()
            }),
        ]
    }
}

/// The size of the entries of the stiffness.
fn entry_size(i: &SliderLoads2d<Octuple>) -> Octuple {
    abs(i.lambda) * lever(&i.nodes()) / length(i.xn - i.x1)
}

impl Proved for GeometricStiffness {
    fn cases() -> Vec<Case<SliderLoads2d<f64>>> {
        loads()
    }

    fn invalid_cases() -> Vec<Case<SliderLoads2d<f64>>> {
        invalid_loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "on the line it is λ ∂²g, the derivative of what the residual's gradient gives",
                |i| {
                    let at = i.aligned();
                    let matrix = Self::eval(&at).matrix();
                    let column = |moved: usize| {
                        let speed = |k: usize| if k == moved { Octuple::one() } else { Octuple::zero() };
                        let place =
                            |x: &Vector, first: usize| Vector2::from_fn(|k, _| Dual::new(x[k], speed(first + k)));
                        let nodes: Nodes2d<Moving> =
                            Nodes2d { x1: place(&at.x1, 0), xn: place(&at.xn, 2), xm: place(&at.xm, 4) };
                        let by = Constraint2d::jacobian(&nodes).g;
                        let parts = [by.x1, by.xn, by.xm].map(|part| part * still(at.lambda));
                        Vector6::from_fn(|k, _| parts[k / 2][k % 2].eps)
                    };
                    let pairs = (0..6).flat_map(|k| {
                        let found: Vec<_> = matrix.column(k).iter().copied().zip(column(k).iter().copied()).collect();
                        found
                    });
                    law::equal_all_with(pairs, entry_size(&at))
                },
            ),
            Law::<Self>::new("it is symmetric, and a common motion of all nodes changes nothing", |i| {
                let matrix = Self::eval(i).matrix();
                let pairs = (0..36).map(|k| (matrix[(k / 6, k % 6)], matrix[(k % 6, k / 6)]));
                let sums = (0..12).map(|k| {
                    let (row, axis) = (k / 2, k % 2);
                    matrix[(row, axis)] + matrix[(row, 2 + axis)] + matrix[(row, 4 + axis)]
                });
                [law::equal_all_with(pairs, entry_size(i)), law::vanish(sums, entry_size(i))].concat()
            }),
            Law::<Self>::new("where all nodes on the line turn as one body, the forces turn with them", |i| {
                let at = i.aligned();
                let left = |v: Vector| Vector2::new(-v.y, v.x);
                let moved = [at.x1, at.xn, at.xm].map(|x| left(x - at.x1));
                let change = Self::eval(&at).matrix() * Vector6::from_fn(|k, _| moved[k / 2][k % 2]);
                let forces = Forces::eval(&at).parts().map(left);
                let found = [0, 2, 4].map(|first| change.fixed_rows::<2>(first).into_owned());
                let reach = length(at.xn - at.x1) + length(at.xm - at.x1);
                equal_parts(found, forces, entry_size(&at) * reach)
            }),
        ]
    }
}
