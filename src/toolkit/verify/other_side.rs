//! The results on the other side of a kink, where `f64` is on it by its roundings alone.
//!
//! Nearer to a kink than a rounding, a comparison in `f64` may come out otherwise than the exact one. The results are then those
//! of the branch that `f64` takes, continued across the kink, and no program that rounds can do better.

use super::Sensitivity;
use super::eta::U;
use super::point::Point;
use crate::Octuple;
use crate::formula::Field;
use crate::toolkit::graph::{Graph, Node, Number, Op, Search};
use num_traits::Signed;

/// A comparison may come out otherwise if its sides differ by at most this many roundings of them and of the inputs.
const ROUNDINGS: f64 = 8.0;
/// Results of a search that differ by less are the same place, found with other roundings.
const SAME_PLACE: f64 = 1e-6;
/// The combinations of changes that are tried.
const TRIES: usize = 64;

/// The exact results of the branch that `f64` takes.
pub(super) struct OtherSide<'a> {
    graph: &'a Graph,
    inputs: &'a [Octuple],
    all: Vec<Octuple>,
}

impl<'a> OtherSide<'a> {
    /// At a point; `None` if `f64` takes the branch that the exact numbers take, or if no graph shows it.
    pub(super) fn at(point: &'a Point) -> Option<Self> {
        let graph = point.subject.graph().ok()?;
        let in_double = graph.results(&point.inputs, (0..graph.ops().len()).map(Node::at));
        let all = vec![Octuple::from(f64::NAN); graph.ops().len()];
        let mut side = Self { graph, inputs: &point.exact, all };
        let mut differs = false;
        for (k, op) in graph.ops().iter().enumerate() {
            side.all[k] = op.result(side.inputs, &side.all);
            let is_other = match op {
                Op::Compare(_, x, y) => side.all[k].to_f64() != in_double[k] && side.are_within_roundings(*x, *y),
                Op::Search(search, numbers) => side.is_found_beside(search, numbers, side.all[k], in_double[k]),
                _ => false,
            };
            if is_other {
                side.all[k] = in_double[k].into();
                differs = true;
            }
        }
        differs.then_some(side)
    }

    fn are_within_roundings(&self, x: Node, y: Node) -> bool {
        let difference = (self.result(x) - self.result(y)).abs();
        difference <= self.size(x).and(self.size(y)).size() * (U * ROUNDINGS)
    }

    /// Whether a search finds another result if its numbers change by roundings: two places are equally good.
    fn is_found_beside(&self, search: &Search, numbers: &[Node], exact: Octuple, found: f64) -> bool {
        let are_same = |x: Octuple| (x - found).abs() <= (x.abs() + 1.0) * SAME_PLACE;
        if are_same(exact) {
            return false;
        }
        let numbers: Vec<_> = numbers.iter().map(|&node| self.result(node)).collect();
        // Each number changed up or down, as the bits of an index say.
        (0..TRIES).any(|trial: usize| {
            let sign = |k: usize| if (trial * (2 * k + 3) + trial / (k + 1)) % 2 == 0 { ROUNDINGS } else { -ROUNDINGS };
            let changed: Vec<_> = numbers.iter().enumerate().map(|(k, &x)| x + x * (sign(k) * U)).collect();
            are_same(Octuple::found(search, &changed))
        })
    }

    /// The result of an operation.
    pub(super) fn result(&self, node: Node) -> Octuple {
        self.all[node.index()]
    }

    /// Its size, with its sensitivity to the inputs.
    pub(super) fn size(&self, node: Node) -> Sensitivity {
        Sensitivity::new(&self.gradient(node), self.inputs).plus(self.result(node))
    }

    /// The same by whole vectors.
    pub(super) fn size_by_fields(&self, fields: &[Field], node: Node) -> Sensitivity {
        Sensitivity::by_fields(fields, &self.gradient(node), self.inputs).plus(self.result(node))
    }

    fn gradient(&self, node: Node) -> Vec<Octuple> {
        self.graph.gradient(node, &self.graph.needed(&[node]), &self.all, self.inputs.len())
    }

    /// The operations that compute the value, and the Jacobian.
    pub(super) fn outputs(&self) -> [&'a [Node]; 2] {
        [&self.graph.value, &self.graph.jacobian]
    }
}
