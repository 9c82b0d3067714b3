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
        // What roundings change in each number: it may be a sum that cancels.
        let change = |&node: &Node| (self.result(node), self.size(node).size() * (U * ROUNDINGS));
        let numbers: Vec<_> = numbers.iter().map(change).collect();
        // Each number changed up or down, in several combinations.
        (0..TRIES).any(|trial: usize| {
            let is_up = |k: usize| (trial * (2 * k + 3) + trial / (k + 1)).is_multiple_of(2);
            let changed = numbers.iter().enumerate().map(|(k, &(x, by))| if is_up(k) { x + by } else { x - by });
            are_same(Octuple::found(search, &changed.collect::<Vec<_>>()))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::coulomb::Response;
    use crate::contact::slide_line::ClosestParabolic;
    use crate::toolkit::verify::accuracy::eta_point;
    use crate::toolkit::verify::subject::Subject;

    fn point<'a>(subject: &'a Subject, inputs: &[f64]) -> Point<'a> {
        Point::new(subject, "here".into(), false, inputs.to_vec())
    }

    /// The trial force 0.1 · 3 is rounded up to the limit, so that the contact slips in `f64` and sticks exactly.
    const ROUNDED: [f64; 5] = [3.0, 0.0, 0.1, 1.0, 0.300_000_000_000_000_04];

    #[test]
    fn nearer_to_a_kink_than_a_rounding_the_branch_of_double_is_seen() {
        let subject = Subject::of::<Response>();
        let here = point(&subject, &ROUNDED);
        let side = OtherSide::at(&here).expect("the branches differ");
        let [value, jacobian] = side.outputs();
        // In slip the force is the limit, whose derivative with respect to the normal force is 1.
        assert_eq!((side.result(value[0]), side.result(jacobian[4])), (ROUNDED[4].into(), 1.0.into()));
        assert_eq!((subject.exact_jacobian)(&here.exact)[4], 0.0);
        for claim in eta_point(&subject, ROUNDED.to_vec()) {
            assert!(claim.held(), "{claim:?}");
        }
    }

    #[test]
    fn where_both_take_one_branch_there_is_no_other() {
        let subject = Subject::of::<Response>();
        for limit in [0.3, 0.299, 0.301, 0.300_000_000_000_000_1] {
            let inputs = [3.0, 0.0, 0.1, 1.0, limit];
            assert!(OtherSide::at(&point(&subject, &inputs)).is_none(), "{limit}");
        }
    }

    /// Two sides that differ by 7 roundings of one of them may be taken for each other, and not by 100.
    #[test]
    fn a_comparison_is_not_turned_over_farther_away() {
        let subject = Subject::of::<Response>();
        let here = point(&subject, &ROUNDED);
        let side = OtherSide::at(&here).expect("the branches differ");
        let comparisons = side.graph.ops().iter().filter_map(|op| match *op {
            Op::Compare(_, x, y) => Some([x, y]),
            _ => None,
        });
        let near = |[x, y]: [Node; 2]| side.are_within_roundings(x, y);
        let (all, near) = comparisons.fold((0, 0), |(all, close), both| (all + 1, close + usize::from(near(both))));
        assert!(near > 0 && near < all, "{near} of {all}");
    }

    /// A slave point on the axis of the parabola y = x² − 1, at 0: the feet at x = ±√½ are both right, and no third one.
    #[test]
    fn two_places_that_are_equally_near_are_both_found() {
        let subject = Subject::of::<ClosestParabolic>();
        let here = point(&subject, &[0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 1.0, 0.0]);
        let graph = subject.graph().expect("it is recorded");
        let all = graph.results(&here.exact, (0..graph.ops().len()).map(Node::at));
        let side = OtherSide { graph, inputs: &here.exact, all };
        let searched = graph.ops().iter().enumerate().find_map(|(k, op)| match op {
            Op::Search(search, numbers) => Some((k, search, numbers)),
            _ => None,
        });
        let (k, search, numbers) = searched.expect("a foot is searched");
        let exact = side.all[k];
        let found = |place: f64| side.is_found_beside(search, numbers, exact, place);
        assert!((exact.to_f64().abs() - 0.5_f64.sqrt()).abs() < 1e-15, "{}", exact.to_f64());
        assert!(found(-exact.to_f64()) && !found(exact.to_f64()) && !found(0.5));
    }
}
