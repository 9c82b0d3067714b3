//! The places where a formula may have no derivative: its comparisons and guarded zeros, as its graph has them.

use super::words::Words;
use crate::graph::{Binary, Graph, Node, Op, Unary};
use std::collections::HashSet;

/// What a number is equal to at such a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Other {
    /// Another result.
    Node(Node),
    /// A number.
    Number(f64),
    /// The power of two above it: where it passes that, the one below it jumps.
    PowerOfTwo,
}

/// A place where a formula may have no derivative.
pub(super) struct Candidate {
    /// The operation that has none there.
    pub(super) node: Node,
    /// The place in words.
    pub(super) words: String,
    /// It is where each of these numbers is equal to the other.
    pub(super) pairs: Vec<(Node, Other)>,
}

/// All candidates of the value of a formula, whose inputs have these names.
pub(super) fn candidates(graph: &Graph, names: &[String]) -> Vec<Candidate> {
    let words = Words { graph, names };
    let mut known = HashSet::new();
    let mut all = Vec::new();
    for node in graph.needed(&graph.value) {
        for (words, pairs) in places(graph, node, &words) {
            if known.insert(format!("{pairs:?}")) {
                all.push(Candidate { node, words, pairs });
            }
        }
    }
    all
}

/// Where an operation may have no derivative, in words and in pairs of equal numbers.
fn places(graph: &Graph, node: Node, words: &Words<'_>) -> Vec<(String, Vec<(Node, Other)>)> {
    let of = |node| words.of(node);
    let zero = |node: Node| {
        let pairs = vanish(graph, node).into_iter().map(|node| (node, Other::Number(0.0))).collect();
        vec![(format!("{} = 0", of(node)), pairs)]
    };
    match graph.op(node) {
        Op::Compare(_, x, y) | Op::Binary(Binary::Maximum, x, y) => match [graph.constant(*x), graph.constant(*y)] {
            [Some(0.0), _] => zero(*y),
            [_, Some(0.0)] => zero(*x),
            [Some(c), _] => vec![(format!("{} = {}", of(*y), of(*x)), vec![(*y, Other::Number(c))])],
            [_, Some(c)] => vec![(format!("{} = {}", of(*x), of(*y)), vec![(*x, Other::Number(c))])],
            _ => vec![(format!("{} = {}", of(*x), of(*y)), vec![(*x, Other::Node(*y))])],
        },
        Op::Unary(Unary::Absolute | Unary::Root, x) => zero(*x),
        Op::Norm(_) => zero(node),
        Op::Unary(Unary::ArcSine, x) => {
            [1.0, -1.0].map(|c| (format!("{} = {c}", of(*x)), vec![(*x, Other::Number(c))])).into()
        }
        Op::Unary(Unary::PowerOfTwo, x) => {
            vec![(format!("{} = a power of two", of(*x)), vec![(*x, Other::PowerOfTwo)])]
        }
        Op::Binary(Binary::Angle, y, x) => {
            let [on_y, on_x] = [*y, *x].map(|node| (node, Other::Number(0.0)));
            let (y, x) = (of(*y), of(*x));
            vec![(format!("{y} = {x} = 0"), vec![on_y, on_x]), (format!("{y} = 0, {x} < 0"), vec![on_y])]
        }
        _ => Vec::new(),
    }
}

/// The results that are all 0 where this one is; a sum of squares is 0 only where every term is.
fn vanish(graph: &Graph, node: Node) -> Vec<Node> {
    match graph.op(node) {
        Op::Norm(parts) => parts.iter().flat_map(|&part| vanish(graph, part)).collect(),
        Op::Unary(Unary::Absolute | Unary::Root | Unary::Negative, x) => vanish(graph, *x),
        Op::Binary(Binary::Multiply, x, y) if x == y => vanish(graph, *x),
        Op::Binary(Binary::Add | Binary::Maximum, x, y) if [*x, *y].iter().all(|&term| is_at_least_zero(graph, term)) => {
            [*x, *y].iter().flat_map(|&term| vanish(graph, term)).collect()
        }
        _ => vec![node],
    }
}

/// Whether the operation gives no negative number.
fn is_at_least_zero(graph: &Graph, node: Node) -> bool {
    match graph.op(node) {
        Op::Norm(_) | Op::Unary(Unary::Absolute | Unary::Root, _) => true,
        Op::Number(bits) => f64::from_bits(*bits) == 0.0,
        Op::Binary(Binary::Multiply, x, y) => x == y,
        Op::Binary(Binary::Add | Binary::Maximum, x, y) => [*x, *y].iter().all(|&term| is_at_least_zero(graph, term)),
        _ => false,
    }
}
