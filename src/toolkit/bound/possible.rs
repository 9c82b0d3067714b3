//! Ways that no inputs take, as their comparisons contradict each other.

use super::way::{Answers, Way};
use crate::toolkit::graph::{Binary, Graph, Node, Op, Relation, Unary};
use std::collections::BTreeSet;

/// Whether comparisons may come out so: no number that is said not to be 0 vanishes with one that is said to. A proof is about operations
/// that do not leave the range of doubles, so a length or a magnitude below all normal numbers is 0, and none is infinite.
pub(super) fn is_possible(graph: &Graph, answers: &Answers) -> bool {
    let Ok(way) = Way::new(graph, answers, &[]) else { return true };
    let resolved = |node: Node| way.resolved(node).unwrap_or(node);
    let is_size = |node: Node| matches!(graph.op(resolved(node)), Op::Norm(_) | Op::Unary(Unary::Absolute, _));
    let (mut zeros, mut others) = (BTreeSet::new(), BTreeSet::new());
    for (&by, &answer) in answers {
        let Op::Compare(relation, x, y) = *graph.op(by) else { continue };
        match (relation, answer, graph.constant(x), graph.constant(y)) {
            (Relation::Equal, true, None, Some(0.0)) => zeros.extend(vanishing(&way, x)),
            (Relation::Equal, false, None, Some(0.0)) => _ = others.insert(resolved(x)),
            (Relation::Less, false, None, Some(f64::INFINITY)) => return false,
            (Relation::Less | Relation::LessOrEqual, true, Some(end), None) if end > 0.0 => {
                _ = others.insert(resolved(y))
            }
            (Relation::LessOrEqual, false, Some(f64::MIN_POSITIVE), None) if is_size(y) => {
                zeros.extend(vanishing(&way, y));
            }
            _ => {}
        }
    }
    zeros.is_disjoint(&others)
}

/// The numbers that are 0 if this one is.
fn vanishing(way: &Way, node: Node) -> BTreeSet<Node> {
    let Ok(node) = way.resolved(node) else {
        let Op::Select(_, yes, no) = *way.graph.op(node) else { return BTreeSet::new() };
        return &vanishing(way, yes) & &vanishing(way, no);
    };
    let is_factor = |node: Node| way.graph.constant(node).is_some_and(|x| x != 0.0);
    let with = match *way.graph.op(node) {
        Op::Norm(ref parts) => parts.to_vec(),
        Op::Unary(Unary::Negative | Unary::Absolute, x) => vec![x],
        Op::Binary(Binary::Multiply, x, y) if is_factor(y) => vec![x],
        Op::Binary(Binary::Multiply, x, y) if is_factor(x) => vec![y],
        _ => Vec::new(),
    };
    with.into_iter().flat_map(|part| vanishing(way, part)).chain([node]).collect()
}
