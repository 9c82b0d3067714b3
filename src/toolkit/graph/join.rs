//! Where two sides of a comparison come together.

use super::node::{Graph, Node, Op};
use rustc_hash::{FxHashMap, FxHashSet};

/// The results where the condition holds and where it does not, as one list.
///
/// Two results of the same operation become that operation on joined operands, so that what follows a choice is written
/// once and the choice itself stands where the sides part. A result that a side needs for itself as well is not computed
/// again behind it. Where a second condition decides on one side alone, and one of its results is that of the other side,
/// both conditions become one: that result then belongs to a single side, and is computed there only.
pub(super) fn join(graph: &mut Graph, condition: Node, yes: &[Node], no: &[Node]) -> Vec<Node> {
    let pairs: Vec<_> = yes.iter().copied().zip(no.iter().copied()).collect();
    let own = own(graph, condition, &pairs);
    let mut join = Join { graph, condition, own, joined: FxHashMap::default() };
    pairs.into_iter().map(|pair| join.both(pair)).collect()
}

/// Of all operations, whether each side needs them for results that cannot be joined.
type Own = [Vec<bool>; 2];

struct Join<'a> {
    graph: &'a mut Graph,
    condition: Node,
    own: Own,
    joined: FxHashMap<(Node, Node), Node>,
}

impl Join<'_> {
    fn both(&mut self, pair: (Node, Node)) -> Node {
        let (yes, no) = pair;
        if yes == no {
            return yes;
        }
        if let Some(&known) = self.joined.get(&pair) {
            return known;
        }
        let op = if are_joined(self.graph, self.condition, &self.own, pair) {
            let operands: Vec<_> = operands(self.graph, pair).map(|operands| self.both(operands)).collect();
            self.graph.op(yes).with_operands(&operands)
        } else {
            self.select(pair)
        };
        let node = self.graph.enter(op);
        self.joined.insert(pair, node);
        node
    }

    fn select(&mut self, pair: (Node, Node)) -> Op {
        let (second, yes, no) = parted(self.graph, self.condition, pair);
        let condition = match second {
            Second::None => self.condition,
            Second::Both(second) => self.graph.enter(Op::both(self.condition, second)),
            Second::Either(second) => self.graph.enter(Op::either(self.condition, second)),
        };
        Op::Select(condition, yes, no)
    }
}

/// A condition that decides on one side alone, between another result and that of the other side, which was not there before
/// the sides parted.
enum Second {
    None,
    Both(Node),
    Either(Node),
}

/// Two results that are not joined, by both conditions where there is a second: where they hold, and where they do not.
fn parted(graph: &Graph, condition: Node, (yes, no): (Node, Node)) -> (Second, Node, Node) {
    match (graph.op(yes), graph.op(no)) {
        (&Op::Select(second, both, other), _) if other == no && no > condition => (Second::Both(second), both, no),
        (_, &Op::Select(second, other, neither)) if other == yes && yes > condition => {
            (Second::Either(second), yes, neither)
        }
        _ => (Second::None, yes, no),
    }
}

/// Whether two results become one operation on joined operands.
fn are_joined(graph: &Graph, condition: Node, own: &Own, pair: (Node, Node)) -> bool {
    let (yes, no) = pair;
    let (left, right) = (graph.op(yes), graph.op(no));
    // A length that was there before the sides parted is there on both, and is not computed again.
    let is_known = matches!(left, Op::Norm(_)) && (yes < condition || no < condition);
    !is_known && !is_own(own, pair) && left.is_like(right) && !left.mentions(condition) && !right.mentions(condition)
}

fn operands(graph: &Graph, (yes, no): (Node, Node)) -> impl Iterator<Item = (Node, Node)> + use<> {
    graph.op(yes).operands().into_iter().zip(graph.op(no).operands())
}

/// What each side needs for itself: the more is not joined, the more that is, until nothing that was joined is among it.
fn own(graph: &Graph, condition: Node, pairs: &[(Node, Node)]) -> Own {
    let mut own = [(); 2].map(|()| vec![false; graph.ops().len()]);
    while joined(graph, condition, &mut own, pairs).into_iter().any(|pair| is_own(&own, pair)) {}
    own
}

/// The pairs that are joined as far as is known what each side needs for itself, to which all others are added.
fn joined(graph: &Graph, condition: Node, own: &mut Own, pairs: &[(Node, Node)]) -> Vec<(Node, Node)> {
    let (mut open, mut seen, mut joined) = (pairs.to_vec(), FxHashSet::default(), Vec::new());
    while let Some(pair) = open.pop() {
        if pair.0 == pair.1 || !seen.insert(pair) {
            continue;
        }
        if are_joined(graph, condition, own, pair) {
            joined.push(pair);
            open.extend(operands(graph, pair));
        } else {
            let (_, yes, no) = parted(graph, condition, pair);
            own.iter_mut().zip([yes, no]).for_each(|(own, node)| add_needed(graph, own, node));
        }
    }
    joined
}

fn is_own(own: &Own, (yes, no): (Node, Node)) -> bool {
    own[0][yes.index()] || own[1][no.index()]
}

/// Adds an operation and all that it is computed from.
fn add_needed(graph: &Graph, needed: &mut [bool], node: Node) {
    let mut open = vec![node];
    while let Some(node) = open.pop() {
        if !needed[node.index()] && !graph.is_atom(node) {
            needed[node.index()] = true;
            graph.op(node).each_operand(|operand| open.push(operand));
        }
    }
}
