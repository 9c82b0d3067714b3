//! All ways of results but those that no inputs take, as their comparisons contradict each other.

use super::way::{Answers, Way};
use crate::toolkit::graph::{Binary, Graph, Node, Op, Relation, Unary};
use std::collections::{BTreeMap, BTreeSet};

/// More ways of one result than this are not examined.
pub const MOST_WAYS: usize = 128;

/// The answers of every possible way of results; `None` if there are too many.
pub(super) fn ways(graph: &Graph, results: &[Node]) -> Option<Vec<Answers>> {
    let (mut open, mut found) = (vec![Answers::new()], Vec::new());
    while let Some(answers) = open.pop() {
        match Way::new(graph, &answers, results) {
            Ok(_) => found.push(answers),
            Err(undecided) => open.extend([false, true].into_iter().filter_map(|answer| {
                let mut answers = answers.clone();
                answers.insert(undecided, answer);
                is_possible(graph, &answers).then_some(answers)
            })),
        }
        if found.len() + open.len() > MOST_WAYS {
            return None;
        }
    }
    Some(found)
}

/// Whether all answers that comparisons may have, together with those given, belong to one of these ways.
pub(super) fn are_all(graph: &Graph, ways: &[Answers], given: &Answers) -> bool {
    if ways.iter().any(Answers::is_empty) {
        return true;
    }
    let Some(comparison) = ways.first().and_then(|way| way.keys().next()).copied() else {
        return !is_possible(graph, given);
    };
    [false, true].into_iter().all(|answer| {
        let consistent = ways.iter().filter(|way| way.get(&comparison).is_none_or(|&known| known == answer));
        let rest = |way: &Answers| way.iter().filter(|&(&node, _)| node != comparison).map(|(&n, &a)| (n, a)).collect();
        let given = given.iter().map(|(&n, &a)| (n, a)).chain([(comparison, answer)]).collect();
        are_all(graph, &consistent.map(rest).collect::<Vec<_>>(), &given)
    })
}

/// Whether comparisons may come out so: no number that is said not to be 0 vanishes with those that are said to. A proof is about
/// operations that do not leave the range of doubles, so a length or a magnitude below all normal numbers is 0, and none is infinite.
fn is_possible(graph: &Graph, answers: &Answers) -> bool {
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
                others.insert(resolved(y));
            }
            (Relation::LessOrEqual, false, Some(f64::MIN_POSITIVE), None) if is_size(y) => {
                zeros.extend(vanishing(&way, y));
            }
            _ => {}
        }
    }
    let mut known = zeros.into_iter().map(|node| (node, true)).collect();
    !others.into_iter().any(|node| vanishes(&way, node, &mut known))
}

/// Whether a number is 0 since these are; what is found is noted.
fn vanishes(way: &Way, node: Node, known: &mut BTreeMap<Node, bool>) -> bool {
    let node = way.resolved(node).unwrap_or(node);
    if let Some(&known) = known.get(&node) {
        return known;
    }
    let is_zero = match *way.graph.op(node) {
        Op::Number(_) => way.graph.constant(node) == Some(0.0),
        Op::Unary(Unary::Negative | Unary::Absolute, x) | Op::Binary(Binary::Divide, x, _) => vanishes(way, x, known),
        Op::Binary(Binary::Multiply, x, y) => vanishes(way, x, known) || vanishes(way, y, known),
        // Of a choice that is not known, both sides are 0.
        Op::Binary(Binary::Add | Binary::Subtract | Binary::Maximum, x, y) | Op::Select(_, x, y) => {
            vanishes(way, x, known) && vanishes(way, y, known)
        }
        Op::Norm(ref parts) => parts.iter().all(|&part| vanishes(way, part, known)),
        _ => false,
    };
    known.insert(node, is_zero);
    is_zero
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
