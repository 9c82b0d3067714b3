//! Where two sides of a comparison come together.

use super::node::{Graph, Node, Op};
use std::collections::HashMap;

/// The results where the condition holds and where it does not, as one list.
///
/// Two results of the same operation become that operation on joined operands, so that what follows a choice is written
/// once and the choice itself stands where the sides part.
pub(super) fn join(graph: &mut Graph, condition: Node, yes: &[Node], no: &[Node]) -> Vec<Node> {
    let mut joined = HashMap::new();
    yes.iter().zip(no).map(|(&yes, &no)| both(graph, condition, (yes, no), &mut joined)).collect()
}

fn both(graph: &mut Graph, condition: Node, pair: (Node, Node), joined: &mut HashMap<(Node, Node), Node>) -> Node {
    let (yes, no) = pair;
    if yes == no {
        return yes;
    }
    if let Some(&known) = joined.get(&pair) {
        return known;
    }
    let (left, right) = (graph.op(yes).clone(), graph.op(no).clone());
    // A length that was there before the sides parted is there on both, and is not computed again.
    let is_known = matches!(left, Op::Norm(_)) && (yes < condition || no < condition);
    let op = if !is_known && left.is_like(&right) && !mentions(&left, condition) && !mentions(&right, condition) {
        let operands = left.operands().into_iter().zip(right.operands());
        let operands: Vec<_> = operands.map(|operands| both(graph, condition, operands, joined)).collect();
        left.with_operands(&operands)
    } else {
        Op::Select(condition, yes, no)
    };
    let node = graph.enter(op);
    joined.insert(pair, node);
    node
}

fn mentions(op: &Op, condition: Node) -> bool {
    op.operands().contains(&condition)
}
