//! Evidence for the formulas of the parent module: cases, laws.

use super::{AlignLoads, AlignRows, GeometricStiffness, Moments, Rows};
use crate::Octuple;
use crate::element::cardan::{Angles, CardanAngles, Triads, turns};
use crate::element::motion::{Motion, Moving, Tangent, derivative, still};
use crate::element::{self, NodalForces};
use crate::formula::proof::{Case, Equation, Law, Proved, hard, law};
use crate::formula::{Fields, Formula};
use nalgebra::Vector3;
use num_dual::DualNum;
use num_traits::{One, Zero};

/// Both triads under a motion of the nodes.
pub(in crate::element) fn turned(i: &Triads<Octuple>, motion: &Motion) -> Triads<Moving> {
    let [e1a, e2a, e3a] = [i.e1a, i.e2a, i.e3a].map(|e| motion.of_a(e));
    let [e1b, e2b, e3b] = [i.e1b, i.e2b, i.e3b].map(|e| motion.of_b(e));
    Triads { e1a, e2a, e3a, e1b, e2b, e3b }
}

/// The residuals of ALIGN under a motion of the nodes, without the initial angles.
fn residuals(i: &Triads<Octuple>, motion: &Motion) -> [Moving; 3] {
    let Angles { alpha, beta, gamma } = CardanAngles::eval(&turned(i, motion));
    [alpha, beta, gamma]
}

impl AlignRows<Octuple> {
    /// The rows as motions, including the parts that are always zero.
    pub(in crate::element) fn rows(&self) -> [Motion; 3] {
        [self.ur1_tb, self.ur2_tb, self.ur3_tb].map(|tb| Motion { ta: -tb, tb, ..Motion::none() })
    }
}

/// Two derivatives with respect to spins are equal, and those with respect to translations are 0.
fn equal_turns(row: &Motion, found: &Motion) -> Vec<Equation> {
    let size = law::length(row.tb);
    [
        law::equal_vectors(row.ta, found.ta),
        law::equal_vectors(row.tb, found.tb),
        law::vanish(found.ua.iter().chain(&found.ub).copied(), size),
    ]
    .concat()
}

/// The triads of both nodes at points of interest.
pub(in crate::element) fn triads() -> Vec<Case<Triads<f64>>> {
    let [a, b] = turns::axes([1, 2, 3]);
    let mut cases = vec![
        Case::hand("aligned", "both triads are the global axes: the rows are i, j and k", Triads::new(a, b)),
        Case::running("all three angles have the sine 0.6 and the cosine 0.8", Triads::new(a, turns::PYTHAGOREAN)),
    ];
    cases.extend(turns::triads().into_iter().map(|pair| {
        let [a, b] = pair.value;
        Case::hard(pair.id, pair.comment, Triads::new(a, b))
    }));
    cases
}

/// Triads without angles, or without derivatives of the angles.
pub(in crate::element) fn invalid() -> Vec<Case<Triads<f64>>> {
    let [a, b] = turns::axes([1, 2, 3]);
    let upright = Triads { e3b: Vector3::new(1.0, -0.5, 0.5), ..Triads::new(a, b) };
    let mut cases = CardanAngles::invalid_cases();
    cases.push(Case::invalid("upright", "e1a·e3b = 1: the arc sine is upright", upright));
    cases
}

impl Proved for Rows {
    fn cases() -> Vec<Case<Triads<f64>>> {
        triads()
    }

    fn invalid_cases() -> Vec<Case<Triads<f64>>> {
        invalid()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("they are the derivatives of the residuals with respect to translations and spins", |i| {
                let rows = Self::eval(i).rows();
                let of = |k: usize| derivative(|motion| residuals(i, motion)[k]);
                (0..3).flat_map(|k| equal_turns(&rows[k], &of(k))).collect()
            }),
            Law::<Self>::new(
                "a turn of b about e1a changes α alone, about the line of nodes β, about e3b γ: their rank is three",
                |i| {
                    let (a, b) = i.orthonormal();
                    let triads = Triads::new(a, b);
                    let AlignRows { ur1_tb, ur2_tb, ur3_tb } = Self::eval(&triads);
                    let alpha = CardanAngles::eval(&triads).alpha;
                    let axes = [a[0], a[1] * alpha.cos() + a[2] * alpha.sin(), b[2]];
                    let entry = |row: usize, axis: usize| {
                        let found = [ur1_tb, ur2_tb, ur3_tb][row];
                        let expected = if row == axis { Octuple::one() } else { Octuple::zero() };
                        law::equal_with(found.dot(&axes[axis]), expected, law::length(found))
                    };
                    (0..9).flat_map(|k| entry(k / 3, k % 3)).collect()
                },
            ),
        ]
    }
}

fn loads() -> Vec<Case<AlignLoads<f64>>> {
    let with = |case: Case<Triads<f64>>| {
        Case::new(case.flag, case.id, case.comment, AlignLoads::new(&case.inputs, [2.0, -3.0, 6.0]))
    };
    let mut cases: Vec<_> = triads().into_iter().map(with).collect();
    let [a, b] = turns::at_angles([0.3, 0.4, -0.7].map(Octuple::from));
    cases.extend(hard::norms().into_iter().map(|load| {
        Case::hard(format!("moments-{}", load.id), load.comment, AlignLoads::new(&Triads::new(a, b), load.value))
    }));
    cases
}

fn invalid_loads() -> Vec<Case<AlignLoads<f64>>> {
    let with =
        |case: Case<Triads<f64>>| Case::invalid(case.id, case.comment, AlignLoads::new(&case.inputs, [2.0, -3.0, 6.0]));
    invalid().into_iter().map(with).collect()
}

/// The size of the terms of the moment.
pub(in crate::element) fn size(i: &AlignLoads<Octuple>) -> Octuple {
    let rows = Rows::eval(&i.triads()).rows();
    rows.iter().zip(i.multipliers()).map(|(row, m)| law::length(row.tb * m)).sum()
}

impl Proved for Moments {
    fn cases() -> Vec<Case<AlignLoads<f64>>> {
        loads()
    }

    fn invalid_cases() -> Vec<Case<AlignLoads<f64>>> {
        invalid_loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new(
                "they are Rowsᵀ λ: their work in any motion is that of the multipliers on the residuals",
                |i| {
                    let rows = Rows::eval(&i.triads()).rows();
                    let sum = |of: fn(&Motion) -> Vector3<Octuple>| {
                        rows.iter().zip(i.multipliers()).map(|(row, m)| of(row) * m).sum::<Vector3<Octuple>>()
                    };
                    let moments = Self::eval(i);
                    let size = size(i);
                    let pairs = [(moments.ma, sum(|row| row.ta)), (moments.mb, sum(|row| row.tb))];
                    pairs
                        .into_iter()
                        .flat_map(|(m, sum)| law::equal_all_with(m.iter().copied().zip(sum.iter().copied()), size))
                        .collect()
                },
            ),
            Law::<Self>::new(
                "the multipliers are the moments about e1a, the line of nodes and e3b, and both nodes balance",
                |i| {
                    let (a, b) = i.triads().orthonormal();
                    let triads = Triads::new(a, b);
                    let moments = Self::eval(&AlignLoads::new(&triads, i.multipliers()));
                    let alpha = CardanAngles::eval(&triads).alpha;
                    let axes = [a[0], a[1] * alpha.cos() + a[2] * alpha.sin(), b[2]];
                    let size = law::length(moments.mb);
                    let about = axes.iter().zip(i.multipliers());
                    let mut sides = law::equal_vectors(moments.ma, -moments.mb);
                    sides.extend(about.flat_map(|(axis, m)| law::equal_with(moments.mb.dot(axis), m, size)));
                    sides
                },
            ),
        ]
    }
}

/// The nodal forces under a motion of the nodes.
fn moving(i: &AlignLoads<Octuple>, motion: &Motion) -> element::Forces<Moving> {
    let moments = Moments::eval(&AlignLoads::new(&turned(&i.triads(), motion), i.multipliers().map(still)));
    NodalForces { ma: moments.ma, mb: moments.mb, ..NodalForces::filled(still(Octuple::zero())) }.vector()
}

/// The size of the terms of the stiffness: each row times its multiplier, times the length of an axis or of the row.
pub(in crate::element) fn stiffness_size(i: &AlignLoads<Octuple>) -> Octuple {
    let rows = Rows::eval(&i.triads()).rows();
    rows.iter()
        .zip(i.multipliers())
        .map(|(row, m)| law::length(row.tb * m) * (Octuple::one() + law::length(row.tb)))
        .sum()
}

fn tangent(i: &AlignLoads<Octuple>) -> Tangent {
    let forces = moving(i, &Motion::none()).map(|moving| moving.re);
    let sizes = [stiffness_size(i); 2];
    Tangent { matrix: GeometricStiffness::eval(i).matrix(), forces, sizes }
}

impl Proved for GeometricStiffness {
    fn cases() -> Vec<Case<AlignLoads<f64>>> {
        loads()
    }

    fn invalid_cases() -> Vec<Case<AlignLoads<f64>>> {
        invalid_loads()
    }

    fn laws() -> Vec<Law<Self>> {
        vec![
            Law::<Self>::new("it is the derivative of the nodal moments with respect to spins", |i| {
                tangent(i).derives(|motion| moving(i, motion))
            }),
            Law::<Self>::new("it is symmetric but for each node's own spin, where K − Kᵀ = −[m×]", |i| {
                tangent(i).is_symmetric_but_for_own_spins()
            }),
            Law::<Self>::new("where both nodes turn as one body, the moments turn with them", |i| {
                tangent(i).turns_with_the_body([Vector3::from_element(Octuple::zero()); 2], i.e1a + i.e3b)
            }),
        ]
    }
}
