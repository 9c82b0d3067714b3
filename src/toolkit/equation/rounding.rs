//! Bounds of the rounding errors of an equation evaluated as written.

use crate::number::octuple::Octuple;
use crate::toolkit::graph::{Binary, Graph, Node, Op, Unary};
use num_traits::{Signed, Zero};

/// The error of a node in units of the rounding error: its own rounding, and the errors of its operands propagated to it.
///
/// An input has the error in `given`, or none.
pub(super) fn terms(graph: &Graph, of: Node, inputs: &[Octuple], given: &[Octuple]) -> Octuple {
    let needed = graph.needed(&[of]);
    let all = graph.results(inputs, needed.iter().copied());
    let mut sizes = vec![Octuple::zero(); all.len()];
    for node in needed {
        let size = match graph.op(node) {
            Op::Input(k) => given.get(*k).copied().unwrap_or_else(Octuple::zero),
            op => carried(op, all[node.index()], &all, &sizes),
        };
        // An infinite derivative may mean an infinite error; it is then ignored.
        sizes[node.index()] = if size.is_finite() { size } else { Octuple::zero() };
    }
    sizes[of.index()]
}

fn carried(op: &Op, result: Octuple, all: &[Octuple], sizes: &[Octuple]) -> Octuple {
    let own = if is_exact(op, all) { Octuple::zero() } else { result.abs() };
    match op {
        Op::Select(condition, a, b) => sizes[if all[condition.index()] == 1.0 { a.index() } else { b.index() }],
        // At most the sum of the errors of its components, also at 0, where it has no derivative.
        Op::Norm(parts) => parts.iter().fold(own, |sum, part| sum + sizes[part.index()]),
        op => {
            let operands = op.operands().into_iter().zip(op.derivatives(result, all));
            // An operand without error contributes 0, even over an infinite slope.
            let off = operands.filter(|(operand, _)| !sizes[operand.index()].is_zero());
            off.fold(own, |sum, (operand, by)| sum + sizes[operand.index()] * by.abs())
        }
    }
}

/// Whether the operation rounds nothing.
fn is_exact(op: &Op, all: &[Octuple]) -> bool {
    match op {
        Op::Number(_) | Op::Compare(..) | Op::Search(..) | Op::Unary(Unary::Negative | Unary::Absolute, _) => true,
        Op::Binary(Binary::Add | Binary::Subtract, a, b) => all[a.index()].is_zero() || all[b.index()].is_zero(),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toolkit::graph::Relation;

    /// a is 4 with an error of 2, b is 3 with an error of 5, and c is 0.6 with an error of 7.
    #[test]
    fn roundings_reach_what_follows() {
        let mut graph = Graph::default();
        let [a, b, c] = [0, 1, 2].map(|k| graph.enter(Op::Input(k)));
        let less = graph.enter(Op::Compare(Relation::Less, b, a));
        let zero = graph.number(0.0);
        let (sin_c, cos_c, norm) = (0.6_f64.sin(), 0.6_f64.cos(), 41.0_f64.sqrt());
        let unary = |function, x| Op::Unary(function, x);
        let binary = |operation, x, y| Op::Binary(operation, x, y);
        let expected = [
            (Op::Number(3.0_f64.to_bits()), 0.0),
            (unary(Unary::Negative, a), 2.0),
            (unary(Unary::Absolute, b), 5.0),
            (binary(Binary::Add, a, b), 7.0 + 2.0 + 5.0),
            (binary(Binary::Add, a, zero), 2.0),
            (binary(Binary::Subtract, b, a), 1.0 + 2.0 + 5.0),
            (binary(Binary::Multiply, a, b), 12.0 + 2.0 * 3.0 + 5.0 * 4.0),
            (binary(Binary::Divide, b, a), 0.75 + 5.0 / 4.0 + 2.0 * 3.0 / 16.0),
            (unary(Unary::Exponential, c), 8.0 * 0.6_f64.exp()),
            (Op::Norm([a, b, a].into()), norm + 2.0 + 5.0 + 2.0),
            (unary(Unary::Root, a), 2.0 + 2.0 / 4.0),
            (unary(Unary::Sine, c), sin_c + 7.0 * cos_c),
            (unary(Unary::Cosine, c), cos_c + 7.0 * sin_c),
            (unary(Unary::ArcSine, c), 0.6_f64.asin() + 7.0 / 0.8),
            (binary(Binary::Angle, b, a), 3.0_f64.atan2(4.0) + 5.0 * 4.0 / 25.0 + 2.0 * 3.0 / 25.0),
            (Op::Compare(Relation::Less, a, b), 0.0),
            (Op::Select(less, a, b), 2.0),
            (Op::Select(zero, a, b), 5.0),
        ];
        for (op, expected) in expected {
            let of = graph.enter(op.clone());
            let found = terms(&graph, of, &[4.0, 3.0, 0.6].map(Octuple::from), &[2.0, 5.0, 7.0].map(Octuple::from));
            let found = found.to_f64();
            assert!((found - expected).abs() <= 1e-14 * expected, "{op:?}: {found}, expected {expected}");
        }
    }
}
