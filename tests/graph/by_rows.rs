//! Of which formulas several rows may be computed together: what is NaN where a number is extreme must show in a result.

use jointproof::toolkit::graph::{Binary, Graph, Node, Op, Unary};
use std::collections::{BTreeMap, BTreeSet};

/// How several rows of a formula are computed together, if they are: the value alone, and the Jacobian too.
pub fn by_rows_in_words(graph: &Graph) -> &'static str {
    let both = [&graph.value[..], &graph.jacobian].concat();
    match how_by_rows(graph, &graph.value).max(how_by_rows(graph, &both)) {
        Rows::Straight => " straight\n",
        Rows::Guarded => " guarded\n",
        Rows::Apart => "\n",
    }
}

/// How several rows are computed: from the simplest way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Rows {
    Straight,
    Guarded,
    Apart,
}

fn how_by_rows(graph: &Graph, results: &[Node]) -> Rows {
    let mut needed = graph.needed(&[results, graph.refusal.as_slice()].concat());
    needed.sort_unstable();
    if !needed.iter().all(|&node| is_simple(graph.op(node))) {
        return Rows::Apart;
    }
    let extreme = extreme(graph, &needed);
    if extreme.is_empty() {
        return Rows::Straight;
    }
    let asked = needed.iter().filter(|&&node| is_question(graph.op(node))).flat_map(|&node| graph.op(node).operands());
    let mut asked = asked.filter(|node| extreme.contains(node)).collect::<BTreeSet<_>>().into_iter();
    if asked.all(|node| is_detected(graph, results, &needed, &extreme, node)) { Rows::Guarded } else { Rows::Apart }
}

/// Whether a result is NaN if this number is, or if those are that it may be NaN by. Results that are made of a number by
/// arithmetic are NaN anyway; what is chosen by it may not be.
fn is_detected(graph: &Graph, results: &[Node], needed: &[Node], extreme: &BTreeSet<Node>, nan: Node) -> bool {
    let known = known_if_nan(graph, needed, nan);
    let is_told_by_others = || {
        let operands = graph.op(nan).operands();
        let mut operands = operands.iter().filter(|node| extreme.contains(node));
        !is_extreme_itself(graph, nan) && operands.all(|&node| is_detected(graph, results, needed, extreme, node))
    };
    results.iter().any(|result| known[result].is_some_and(f64::is_nan)) || is_told_by_others()
}

/// Whether a number may be NaN where none is that it is made of.
fn is_extreme_itself(graph: &Graph, node: Node) -> bool {
    let op = graph.op(node);
    let is_nan = |node: Node| graph.constant(node).is_some_and(f64::is_nan);
    matches!(op, Op::Norm(_) | Op::Binary(Binary::Angle, ..)) || op.operands().into_iter().any(is_nan)
}

/// Whether several rows take an operation together.
fn is_simple(op: &Op) -> bool {
    match op {
        Op::Unary(function, _) => {
            use Unary::{Absolute, ArcSine, NearestInteger, Negative, PowerOfTwo, Root};
            matches!(function, Negative | Root | Absolute | ArcSine | PowerOfTwo | NearestInteger)
        }
        op => !matches!(op, Op::ExactSum(_) | Op::Search(..)),
    }
}

/// The numbers that may be NaN where something is extreme.
fn extreme(graph: &Graph, in_order: &[Node]) -> BTreeSet<Node> {
    let mut extreme = BTreeSet::new();
    for &node in in_order {
        let may_be_nan = match graph.op(node) {
            _ if is_extreme_itself(graph, node) => true,
            Op::Select(_, yes, no) => extreme.contains(yes) || extreme.contains(no),
            op => !is_question(op) && op.operands().iter().any(|node| extreme.contains(node)),
        };
        if may_be_nan {
            extreme.insert(node);
        }
    }
    extreme
}

/// Whether a result may be a number although an operand is NaN.
fn is_question(op: &Op) -> bool {
    matches!(op, Op::Compare(..) | Op::Unary(Unary::PowerOfTwo, _) | Op::Binary(Binary::Maximum, ..))
}

/// What is known of every result, whatever the inputs, where that of one is NaN; an answer is 1 or 0.
fn known_if_nan(graph: &Graph, in_order: &[Node], nan: Node) -> BTreeMap<Node, Option<f64>> {
    let mut known = BTreeMap::from([(nan, Some(f64::NAN))]);
    for &node in in_order.iter().filter(|&&node| node != nan) {
        let op = graph.op(node);
        let is_nan = op.operands().iter().any(|operand| known[operand].is_some_and(f64::is_nan));
        let result = match *op {
            Op::Number(bits) => Some(f64::from_bits(bits)),
            Op::Compare(..) if is_nan => Some(0.0),
            Op::Compare(relation, x, y) => {
                known[&x].zip(known[&y]).map(|(x, y)| f64::from(u8::from(relation.holds(x, y))))
            }
            Op::Select(answer, yes, no) => match known[&answer] {
                Some(answer) => known[if answer == 0.0 { &no } else { &yes }],
                None => known[&yes].filter(|x| known[&no].is_some_and(|y| *x == y || x.is_nan() && y.is_nan())),
            },
            _ if is_question(op) => None,
            _ => is_nan.then_some(f64::NAN),
        };
        known.insert(node, result);
    }
    known
}
