//! Evidence for the formulas of the parent module: cases, kinks, laws.

use super::{Forces, GeometricStiffness, Rows, SliderForces, SliderLoads, SliderRows};
use crate::Octuple;
use crate::connector::slider::hard::{lines, scenes};
use crate::connector::slider::running::{QUARTER, X1, XN};
use crate::connector::slider::{Constraint, Distances, Ends, IncrementalConstraint, Line, MovingNodes, Nodes};
use crate::element::motion::{Moving, still};
use crate::formula::proof::{Case, Equation, Kink, Law, Proved, law};
use crate::formula::{Fields, Formula};
use crate::number::scalar::abs;
use nalgebra::{SVector, Vector3};
use num_dual::Dual;
use num_traits::{One, Zero};

type Vector = Vector3<Octuple>;

/// The positions of the nodes at points of interest.
fn places() -> Vec<Case<Nodes<f64>>> {
    let hand = Nodes { x1: Vector3::zeros(), xn: Vector3::new(12.0, 3.0, 4.0), xm: Vector3::new(3.0, 0.75, 1.0) };
    let across = Nodes { xn: Vector3::new(0.0, 3.0, 4.0), xm: Vector3::new(0.0, 0.75, 1.0), ..hand };
    let mut cases = vec![
        Case::hand("quarter", "t1 = (0, 0.8, -0.6), t2 = (-5, 7.2, 9.6)/13, ξ = 1/4", hand),
        Case::hand("across-i", "t1 = (0, 0.8, -0.6), t2 = (-1, 0, 0), ξ = 1/4", across),
        Case::hand("at-node-1", "ξ = 0: node n takes nothing", Nodes { xm: hand.x1, ..hand }),
        Case::hand("at-node-n", "ξ = 1: node 1 takes nothing", Nodes { xm: hand.xn, ..hand }),
        Case::hand("outside", "ξ = 2: a lever", Nodes { xm: hand.xn * 2.0, ..hand }),
        Case::hard(
            "along-i",
            "along i exactly: t1 and t2 jump",
            Nodes { xn: Vector3::new(2.0, 0.0, 0.0), xm: Vector3::new(0.5, 0.0, 0.0), ..hand },
        ),
        Case::running("t1 = (0, 0.8, -0.6), t2 = (-0.8, 0.36, 0.48), ξ = 1/4", Nodes { x1: X1, xn: XN, xm: QUARTER }),
    ];
    let scenes = scenes(lines()).into_iter().filter(|(_, line, _)| is_oblique(&(line.xn - line.x1)));
    cases.extend(scenes.map(|(id, line, xm)| Case::hard(id, line.comment, Nodes { x1: line.x1, xn: line.xn, xm })));
    cases
}

/// Whether a line is in general position: no component of d is 0, and none equals another in size. Otherwise some entries vanish
/// together with all their derivatives, or are remainders of terms that cancel by symmetry, so that there is no size with which
/// rounding errors could be compared.
pub(crate) fn is_oblique<const N: usize>(d: &SVector<f64, N>) -> bool {
    let is_alone = |k: usize| d[k] != 0.0 && (0..k).all(|other| d[other].abs() != d[k].abs());
    (0..N).all(is_alone)
}

/// The same with multipliers; squares of these lengths do not over- or underflow.
fn loads() -> Vec<Case<SliderLoads<f64>>> {
    let with = |case: Case<Nodes<f64>>| {
        let Nodes { x1, xn, xm } = case.inputs;
        Case::new(case.flag, case.id, case.comment, SliderLoads { x1, xn, xm, lambda_1: 5.0, lambda_2: -2.5 })
    };
    let has_squares = |nodes: &Nodes<f64>| (1e-100..1e100).contains(&(nodes.xn - nodes.x1).amax());
    let mut cases: Vec<_> = places().into_iter().filter(|case| has_squares(&case.inputs)).map(with).collect();
    let here = cases[0].inputs;
    let alone = "one force alone";
    cases.extend([
        Case::hard("first-alone", alone, SliderLoads { lambda_2: 0.0, ..here }),
        Case::hard("second-alone", alone, SliderLoads { lambda_1: 0.0, ..here }),
        Case::hard("unloaded", "no force", SliderLoads { lambda_1: 0.0, lambda_2: 0.0, ..here }),
        Case::hard("large-force", "forces of 1e200", SliderLoads { lambda_1: 3e200, lambda_2: -4e200, ..here }),
        Case::hard("small-force", "forces of 1e-200", SliderLoads { lambda_1: 3e-200, lambda_2: -4e-200, ..here }),
    ]);
    cases
}

fn coincident() -> Vec<Case<Nodes<f64>>> {
    let x1 = Vector3::new(1.0, 2.0, 3.0);
    vec![Case::invalid("coincident", "nodes 1 and n coincide", Nodes { x1, xn: x1, xm: Vector3::zeros() })]
}

fn invalid_loads() -> Vec<Case<SliderLoads<f64>>> {
    let with = |case: Case<Nodes<f64>>| {
        let Nodes { x1, xn, xm } = case.inputs;
        Case::invalid(case.id, case.comment, SliderLoads { x1, xn, xm, lambda_1: 1.0, lambda_2: 1.0 })
    };
    coincident().into_iter().map(with).collect()
}

/// Exactly along i, t1 and t2 are defined differently: the condition for this, a point, and a direction away from it.
const ALONG_I: &str = r"\mathbf{n}\times\mathbf{i} = \mathbf{0}";

fn is_along_i<T: PartialEq>(x1: &Vector3<T>, xn: &Vector3<T>) -> bool {
    [1, 2].iter().all(|&k| xn[k] == x1[k])
}

fn across_i() -> [SliderLoads<f64>; 2] {
    let zero = SliderLoads::filled(0.0);
    let (xn, xm) = (Vector3::new(2.0, 0.0, 0.0), Vector3::new(0.5, 0.0, 0.0));
    let at = SliderLoads { xn, xm, lambda_1: 5.0, lambda_2: -2.5, ..zero };
    [at, SliderLoads { xn: Vector3::new(0.0, 3.0, 4.0), ..zero }]
}

/// Nodes with m on the line, at a fraction taken from its first coordinate: any fraction will do.
fn on_the_line(x1: Vector, xn: Vector, share: Octuple) -> Nodes<Octuple> {
    Nodes { x1, xn, xm: x1 + (xn - x1) * share }
}

/// All nine derivatives of a vector with respect to the positions of the nodes.
fn derivatives<const N: usize>(
    at: &Nodes<Octuple>,
    of: impl Fn(&Nodes<Moving>) -> [Moving; N],
) -> [SVector<Octuple, N>; 9] {
    std::array::from_fn(|moved| {
        let speed = |k: usize| if k == moved { Octuple::one() } else { Octuple::zero() };
        let place = |x: &Vector, first: usize| Vector3::from_fn(|k, _| Dual::new(x[k], speed(first + k)));
        let moving = Nodes { x1: place(&at.x1, 0), xn: place(&at.xn, 3), xm: place(&at.xm, 6) };
        SVector::from(of(&moving).map(|number| number.eps))
    })
}

impl SliderRows<Octuple> {
    fn rows(&self) -> [[Vector; 3]; 2] {
        [[self.g1_u1, self.g1_un, self.g1_um], [self.g2_u1, self.g2_un, self.g2_um]]
    }
}

/// The vectors are equal to within rounding errors relative to one common size.
fn equal_parts(left: &[Vector; 3], right: &[Vector; 3], size: Octuple) -> Vec<Equation> {
    let pairs = left.iter().zip(right);
    pairs.flat_map(|(l, r)| law::equal_all_with(l.iter().copied().zip(r.iter().copied()), size)).collect()
}

/// The size of the forces on the nodes for a force of size 1 on m.
fn lever(i: &Nodes<Octuple>) -> Octuple {
    (law::length(i.xm - i.x1) + law::length(i.xm - i.xn)) / law::length(i.xn - i.x1) + 1.0
}

impl Proved for Rows {
    fn cases() -> Vec<Case<Nodes<f64>>> {
        places()
    }

    fn invalid_cases() -> Vec<Case<Nodes<f64>>> {
        coincident()
    }

    fn kinks() -> Vec<Kink<Self>> {
        vec![Kink::<Self>::switch(
            ALONG_I,
            |i| is_along_i(&i.x1, &i.xn),
            Nodes { x1: Vector3::zeros(), xn: Vector3::new(2.0, 0.0, 0.0), xm: Vector3::new(1.0, 0.5, -0.25) },
            Nodes { x1: Vector3::zeros(), xn: Vector3::new(0.0, 3.0, 4.0), xm: Vector3::zeros() },
        )]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("on the line they are the derivatives of the residuals", |i| {
                let at = on_the_line(i.x1, i.xn, i.xm.x);
                let jac = Constraint::jacobian(&at);
                let [first, second] = Self::eval(&at).rows();
                let of = |row: Nodes<Octuple>| [row.x1, row.xn, row.xm];
                let size = lever(&at);
                [equal_parts(&first, &of(jac.g1), size), equal_parts(&second, &of(jac.g2), size)].concat()
            }),
            Law::<Self>::new("they are the coefficients of the increments in the incremental constraint", |i| {
                let Nodes { x1, xn, xm } = *i;
                let jac =
                    IncrementalConstraint::jacobian(&MovingNodes { x1, xn, xm, ..MovingNodes::filled(x1.x * 0.0) });
                let [first, second] = Self::eval(i).rows();
                let of = |row: MovingNodes<Octuple>| [row.dx1, row.dxn, row.dxm];
                let size = lever(i);
                [equal_parts(&first, &of(jac.r1), size), equal_parts(&second, &of(jac.r2), size)].concat()
            }),
            Law::<Self>::new("they do no work in a common motion of all nodes, or when m moves along the line", |i| {
                let n = Line::eval(&Ends { x1: i.x1, xn: i.xn }).n;
                let of_row = |row: [Vector; 3]| {
                    let sum = row[0] + row[1] + row[2];
                    [law::vanish(sum.iter().copied(), lever(i)), law::no_work(row[2], n)].concat()
                };
                Self::eval(i).rows().into_iter().flat_map(of_row).collect()
            }),
            Law::<Self>::new("their rank is two: those of m are unit vectors at right angles", |i| {
                let SliderRows { g1_um, g2_um, .. } = Self::eval(i);
                let one = Octuple::one();
                [law::equal_all([(g1_um.dot(&g1_um), one), (g2_um.dot(&g2_um), one)]), law::no_work(g1_um, g2_um)]
                    .concat()
            }),
        ]
    }
}

impl SliderForces<Octuple> {
    fn parts(&self) -> [Vector; 3] {
        [self.force_1, self.force_n, self.force_m]
    }
}

impl SliderLoads<Octuple> {
    const fn nodes(&self) -> Nodes<Octuple> {
        let Self { x1, xn, xm, .. } = *self;
        Nodes { x1, xn, xm }
    }

    /// The same with m on the line.
    fn aligned(&self) -> Self {
        Self { xm: on_the_line(self.x1, self.xn, self.xm.x).xm, ..*self }
    }

    /// The size of the force on m.
    fn size(&self) -> Octuple {
        abs(self.lambda_1) + abs(self.lambda_2)
    }
}

impl Proved for Forces {
    fn cases() -> Vec<Case<SliderLoads<f64>>> {
        loads()
    }

    fn invalid_cases() -> Vec<Case<SliderLoads<f64>>> {
        invalid_loads()
    }

    fn kinks() -> Vec<Kink<Self>> {
        let [at, across] = across_i();
        vec![Kink::<Self>::switch(ALONG_I, |i| is_along_i(&i.x1, &i.xn), at, across)]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "they are Rowsᵀ λ: their work in any motion is that of the multipliers on the residuals",
                |i| {
                    let [first, second] = Rows::eval(&i.nodes()).rows();
                    let sum = [0, 1, 2].map(|node| first[node] * i.lambda_1 + second[node] * i.lambda_2);
                    equal_parts(&Self::eval(i).parts(), &sum, i.size() * lever(&i.nodes()))
                },
            ),
            Law::<Self>::new("on the line forces and moments balance", |i| {
                let at = i.aligned();
                let forces = Self::eval(&at);
                let [f1, fn_, fm] = forces.parts();
                let moment = at.x1.cross(&f1) + at.xn.cross(&fn_) + at.xm.cross(&fm);
                let reach = law::length(at.x1) + law::length(at.xn) + law::length(at.xm);
                let force = i.size() * lever(&at.nodes());
                [
                    law::vanish((f1 + fn_ + fm).iter().copied(), force),
                    law::vanish(moment.iter().copied(), force * reach),
                ]
                .concat()
            }),
            Law::<Self>::new("the line is smooth: no force acts along it", |i| {
                let n = Line::eval(&Ends { x1: i.x1, xn: i.xn }).n;
                Self::eval(i).parts().into_iter().flat_map(|force| law::no_work(force, n)).collect()
            }),
        ]
    }
}

/// The size of the entries of the stiffness, for m on the line.
fn entry_size(at: &SliderLoads<Octuple>) -> Octuple {
    let d = at.xn - at.x1;
    // The distance of node n from the axis i, or from the axis k if that is 0.
    let outward = law::length(Vector3::new(Octuple::zero(), d.y, d.z));
    let outward = if outward.is_zero() { law::length(d) } else { outward };
    at.size() * lever(&at.nodes()) / outward
}

impl Proved for GeometricStiffness {
    fn cases() -> Vec<Case<SliderLoads<f64>>> {
        let stays = |SliderLoads { x1, xn, .. }: &SliderLoads<f64>| is_oblique(&(xn - x1)) || is_along_i(x1, xn);
        loads().into_iter().filter(|case| stays(&case.inputs)).collect()
    }

    fn invalid_cases() -> Vec<Case<SliderLoads<f64>>> {
        invalid_loads()
    }

    fn kinks() -> Vec<Kink<Self>> {
        let [at, across] = across_i();
        vec![Kink::<Self>::switch(ALONG_I, |i| is_along_i(&i.x1, &i.xn), at, across)]
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "on the line it is Σ λ ∂²g, the derivative of what the residuals' gradients give",
                |i| {
                    let at = i.aligned();
                    let columns = derivatives(&at.nodes(), |nodes| {
                        let Distances { g1, g2 } = Constraint::jacobian(nodes);
                        let (first, second) = (still(at.lambda_1), still(at.lambda_2));
                        let parts = [
                            g1.x1 * first + g2.x1 * second,
                            g1.xn * first + g2.xn * second,
                            g1.xm * first + g2.xm * second,
                        ];
                        std::array::from_fn::<_, 9, _>(|k| parts[k / 3][k % 3])
                    });
                    let matrix = Self::eval(&at).matrix();
                    let entries = (0..81).map(|k| (matrix[(k % 9, k / 9)], columns[k / 9][k % 9]));
                    law::equal_all_with(entries, entry_size(&at))
                },
            ),
            Law::<Self>::new("it is symmetric, and a common motion of all nodes changes nothing", |i| {
                let matrix = Self::eval(i).matrix();
                let size = entry_size(i);
                let pairs = (0..81).map(|k| (matrix[(k % 9, k / 9)], matrix[(k / 9, k % 9)]));
                let sums = (0..27).map(|k| {
                    let (row, axis) = (k / 3, k % 3);
                    matrix[(row, axis)] + matrix[(row, 3 + axis)] + matrix[(row, 6 + axis)]
                });
                [law::equal_all_with(pairs, size), law::vanish(sums, size)].concat()
            }),
            Law::<Self>::new("where all nodes turn about the axis i on the line, the forces turn with them", |i| {
                let at = i.aligned();
                let spin: Vector = Vector3::x();
                if is_along_i(&at.x1, &at.xn) {
                    return Vec::new(); // t1 and t2 are constant there
                }
                let moved = [at.x1, at.xn, at.xm].map(|x| spin.cross(&(x - at.x1)));
                let change = Self::eval(&at).matrix() * SVector::<Octuple, 9>::from_fn(|k, _| moved[k / 3][k % 3]);
                let forces = Forces::eval(&at).parts().map(|force| spin.cross(&force));
                let found = [0, 3, 6].map(|first| change.fixed_rows::<3>(first).into_owned());
                let reach = law::length(at.xn - at.x1) + law::length(at.xm - at.x1);
                equal_parts(&found, &forces, entry_size(&at) * reach)
            }),
        ]
    }
}
