//! The places where a formula may have no derivative: its comparisons and guarded zeros, as its graph has them.

use super::words::Words;
use crate::formula::Field;
use crate::graph::{Binary, Graph, Node, Op, Relation, Unary};
use crate::quantity::Domain;
use crate::verify::Subject;
use crate::verify::point::Names;
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
#[derive(Clone)]
pub(super) struct Candidate {
    /// The operation that has none there.
    pub(super) node: Node,
    /// The place in words.
    pub(super) words: String,
    /// It is where each of these numbers is equal to the other,
    pub(super) pairs: Vec<(Node, Other)>,
    /// and this one is negative.
    pub(super) negative: Option<Node>,
}

/// All candidates of the value of a formula.
pub(super) fn candidates(subject: &Subject, graph: &Graph, names: &Names) -> Vec<Candidate> {
    let is_positive = |field: &Field| matches!(field.quantity.domain, Domain::Positive);
    let positive = subject.inputs.iter().flat_map(|field| vec![is_positive(field); field.len()]).collect();
    let seen = Seen { graph, words: Words { graph, names: &names.inputs }, positive };
    let guards = guards(graph);
    let mut known = HashSet::new();
    let mut all = Vec::new();
    for node in graph.needed(&graph.value) {
        for mut candidate in seen.places(node) {
            // What is asked only where numbers are equal is at no other place.
            for guard in guards[node.index()].iter().flat_map(|&guard| seen.places(guard)) {
                candidate.words = format!("{} and {}", candidate.words, guard.words);
                candidate.pairs.extend(guard.pairs);
            }
            if known.insert(format!("{:?} {:?}", candidate.pairs, candidate.negative)) {
                all.push(candidate);
            }
        }
    }
    all
}

/// Of every operation the equalities without which the value does not depend on it.
fn guards(graph: &Graph) -> Vec<Vec<Node>> {
    let mut guards: Vec<Option<Vec<Node>>> = vec![None; graph.ops().len()];
    graph.value.iter().for_each(|node| guards[node.index()] = Some(Vec::new()));
    for user in graph.needed(&graph.value).into_iter().rev() {
        let of_user = guards[user.index()].clone().unwrap_or_default();
        for (k, operand) in graph.op(user).operands().into_iter().enumerate() {
            let mut own = of_user.clone();
            if let (Op::Select(condition, ..), 1) = (graph.op(user), k) {
                own.extend(equalities(graph, *condition));
            }
            let known = &mut guards[operand.index()];
            *known = Some(match known.take() {
                Some(known) => known.into_iter().filter(|guard| own.contains(guard)).collect(),
                None => own,
            });
        }
    }
    guards.into_iter().map(Option::unwrap_or_default).collect()
}

/// The equalities that hold where an answer is yes.
fn equalities(graph: &Graph, answer: Node) -> Vec<Node> {
    match graph.op(answer) {
        Op::Compare(Relation::Equal, ..) => vec![answer],
        op => op.both_of().into_iter().flatten().flat_map(|answer| equalities(graph, answer)).collect(),
    }
}

/// A graph, and what is known of its inputs.
struct Seen<'a> {
    graph: &'a Graph,
    words: Words<'a>,
    positive: Vec<bool>,
}

impl Seen<'_> {
    /// Where an operation may have no derivative.
    fn places(&self, node: Node) -> Vec<Candidate> {
        let of = |node| self.words.of(node);
        let place = |words: String, pairs| Candidate { node, words, pairs, negative: None };
        let equal = |x: Node, other: Other, to: &str| vec![place(format!("{} = {to}", of(x)), vec![(x, other)])];
        let zero = |node: Node| {
            let pairs = self.vanish(node).into_iter().map(|node| (node, Other::Number(0.0))).collect();
            vec![place(format!("{} = 0", of(node)), pairs)]
        };
        match self.graph.op(node) {
            Op::Compare(_, x, y) | Op::Binary(Binary::Maximum, x, y) => {
                match [self.graph.constant(*x), self.graph.constant(*y)] {
                    // Of finite numbers none is on it.
                    [Some(c), _] | [_, Some(c)] if c.is_infinite() => Vec::new(),
                    [Some(0.0), _] => zero(*y),
                    [_, Some(0.0)] => zero(*x),
                    [Some(c), _] => equal(*y, Other::Number(c), &of(*x)),
                    [_, Some(c)] => equal(*x, Other::Number(c), &of(*y)),
                    _ => equal(*x, Other::Node(*y), &of(*y)),
                }
            }
            Op::Unary(Unary::Absolute | Unary::Root, x) => zero(*x),
            Op::Norm(_) => zero(node),
            Op::Unary(Unary::ArcSine, x) => {
                [1.0, -1.0].into_iter().flat_map(|c| equal(*x, Other::Number(c), &c.to_string())).collect()
            }
            Op::Unary(Unary::PowerOfTwo, x) => equal(*x, Other::PowerOfTwo, "a power of two"),
            Op::Binary(Binary::Angle, y, x) => {
                let [on_y, on_x] = [*y, *x].map(|node| (node, Other::Number(0.0)));
                let origin = place(format!("{} = {} = 0", of(*y), of(*x)), vec![on_y, on_x]);
                let cut = place(format!("{} = 0, {} < 0", of(*y), of(*x)), vec![on_y]);
                vec![origin, Candidate { negative: Some(*x), ..cut }]
            }
            _ => Vec::new(),
        }
    }

    /// The results that are all 0 where this one is; a sum of squares is 0 only where every term is.
    fn vanish(&self, node: Node) -> Vec<Node> {
        match self.graph.op(node) {
            Op::Number(bits) if f64::from_bits(*bits) == 0.0 => Vec::new(),
            Op::Norm(parts) => parts.iter().flat_map(|&part| self.vanish(part)).collect(),
            Op::Unary(Unary::Absolute | Unary::Root | Unary::Negative, x) | Op::Binary(Binary::Divide, x, _) => {
                self.vanish(*x)
            }
            Op::Binary(Binary::Multiply, x, y) if x == y => self.vanish(*x),
            Op::Binary(Binary::Multiply, x, y) if self.is_factor(*y) => self.vanish(*x),
            Op::Binary(Binary::Multiply, x, y) if self.is_factor(*x) => self.vanish(*y),
            Op::Binary(Binary::Add | Binary::Maximum, x, y) if [*x, *y].iter().all(|&term| self.is_size(term)) => {
                [*x, *y].iter().flat_map(|&term| self.vanish(term)).collect()
            }
            _ => vec![node],
        }
    }

    /// Whether it is a factor that is never 0: a number, a power of two, an input above 0, or made of these.
    fn is_factor(&self, node: Node) -> bool {
        match self.graph.op(node) {
            Op::Number(bits) => f64::from_bits(*bits) != 0.0,
            Op::Input(k) => self.positive[*k],
            Op::Unary(Unary::PowerOfTwo, _) => true,
            Op::Binary(Binary::Divide | Binary::Multiply, x, y) => self.is_factor(*x) && self.is_factor(*y),
            _ => false,
        }
    }

    /// Whether the operation gives no negative number.
    fn is_size(&self, node: Node) -> bool {
        match self.graph.op(node) {
            Op::Norm(_) | Op::Unary(Unary::Absolute | Unary::Root, _) => true,
            Op::Number(bits) => f64::from_bits(*bits) >= 0.0,
            Op::Binary(Binary::Multiply, x, y) => x == y || self.is_size(*x) && self.is_size(*y),
            Op::Binary(Binary::Add | Binary::Maximum, x, y) => self.is_size(*x) && self.is_size(*y),
            Op::Input(k) => self.positive[*k],
            _ => false,
        }
    }
}
