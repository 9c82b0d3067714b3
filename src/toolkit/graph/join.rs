//! Joins the two branches of a comparison.

use super::node::{Graph, Node, Op};
use rustc_hash::{FxHashMap, FxHashSet};

/// Merges the results of both branches of a condition into one list.
///
/// Two results of the same operation become that operation on joined operands, so that common work is written once after the
/// choice, and the choice itself selects where the branches diverge. A result that a branch also needs internally is not
/// recomputed after the choice. If a second condition decides within one branch only, and one of its results is that of the other
/// branch, both conditions are combined: that result then belongs to a single branch, and is computed only there.
pub(super) fn join(graph: &mut Graph, condition: Node, yes: &[Node], no: &[Node]) -> Vec<Node> {
    let pairs: Vec<_> = yes.iter().copied().zip(no.iter().copied()).collect();
    let own = own(graph, condition, &pairs);
    let mut join = Join { graph, condition, own, joined: FxHashMap::default() };
    pairs.into_iter().map(|pair| join.both(pair)).collect()
}

/// For all operations, whether each branch needs them for results that cannot be joined.
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

/// A second condition within one branch, which selects between another result and that of the other branch, provided
/// that the latter did not exist before the branches diverged.
enum Second {
    None,
    Both(Node),
    Either(Node),
}

/// Two results that are not joined, combined with a second condition if there is one: the result if the conditions
/// hold, and the result if they do not.
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
    // A length known before the branches diverged is available in both, and is not recomputed.
    let is_known = matches!(left, Op::Norm(_)) && (yes < condition || no < condition);
    !is_known && !is_own(own, pair) && left.is_like(right) && !left.mentions(condition) && !right.mentions(condition)
}

fn operands(graph: &Graph, (yes, no): (Node, Node)) -> impl Iterator<Item = (Node, Node)> + use<> {
    graph.op(yes).operands().into_iter().zip(graph.op(no).operands())
}

/// The operations each branch needs internally. The more there are, the fewer are joined, and the reverse, so this
/// iterates until nothing joined is among them.
fn own(graph: &Graph, condition: Node, pairs: &[(Node, Node)]) -> Own {
    let mut own = [(); 2].map(|()| vec![false; graph.ops().len()]);
    while joined(graph, condition, &mut own, pairs).into_iter().any(|pair| is_own(&own, pair)) {}
    own
}

/// The pairs that are joined given what each branch is known to need internally; what the other pairs need is added to that.
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

/// Adds an operation and everything it is computed from.
fn add_needed(graph: &Graph, needed: &mut [bool], node: Node) {
    let mut open = vec![node];
    while let Some(node) = open.pop() {
        if !needed[node.index()] && !graph.is_atom(node) {
            needed[node.index()] = true;
            graph.op(node).each_operand(|operand| open.push(operand));
        }
    }
}
