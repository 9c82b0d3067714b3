//! The ways through the branches of a graph: on each of them a result is computed without a choice.

use crate::toolkit::graph::{Binary, Graph, Node, Op, Unary};
use std::collections::BTreeMap;

/// More ways of one result than this are not examined.
pub const MOST_WAYS: usize = 128;

/// The answers of comparisons on which a way depends; and for a maximum, whether it is its first operand.
pub type Answers = BTreeMap<Node, bool>;

/// A result on one way.
#[derive(Clone)]
pub(super) struct Way<'a> {
    pub(super) graph: &'a Graph,
    pub(super) answers: &'a Answers,
    /// The operation that computes the result.
    pub(super) result: Node,
    /// The operations that the result depends on, operands first.
    pub(super) nodes: Vec<Node>,
}

impl<'a> Way<'a> {
    /// The way that these answers describe.
    ///
    /// # Errors
    /// A comparison that is not answered, but on which the result depends.
    pub(super) fn new(graph: &'a Graph, answers: &'a Answers, result: Node) -> Result<Self, Node> {
        let mut way = Self { graph, answers, result, nodes: Vec::new() };
        way.result = way.resolved(result)?;
        way.nodes = way.needed(way.result)?;
        Ok(way)
    }

    /// The operation that computes a number on this way.
    pub(super) fn resolved(&self, mut node: Node) -> Result<Node, Node> {
        loop {
            node = match *self.graph.op(node) {
                Op::Select(condition, yes, no) => {
                    if self.holds(condition)? {
                        yes
                    } else {
                        no
                    }
                }
                Op::Binary(Binary::Maximum, x, y) => {
                    if self.answer(node)? {
                        x
                    } else {
                        y
                    }
                }
                _ => return Ok(node),
            };
        }
    }

    fn holds(&self, condition: Node) -> Result<bool, Node> {
        match *self.graph.op(condition) {
            Op::Select(condition, yes, no) => self.holds(if self.holds(condition)? { yes } else { no }),
            _ => self.answer(condition),
        }
    }

    fn answer(&self, node: Node) -> Result<bool, Node> {
        self.answers.get(&node).copied().ok_or(node)
    }

    /// The operands of an operation on this way that its derivative depends on.
    pub(super) fn operands(&self, node: Node) -> Result<Vec<Node>, Node> {
        match self.graph.op(node) {
            Op::Unary(Unary::PowerOfTwo | Unary::NearestInteger, _) => Ok(Vec::new()),
            op => op.operands().into_iter().map(|operand| self.resolved(operand)).collect(),
        }
    }

    /// A number and all that it is computed from, operands first.
    pub(super) fn needed(&self, node: Node) -> Result<Vec<Node>, Node> {
        let mut needed = vec![false; node.index() + 1];
        needed[node.index()] = true;
        for place in (0..=node.index()).rev().filter(|&place| place <= node.index()) {
            if needed[place] {
                self.operands(Node::at(place))?.into_iter().for_each(|operand| needed[operand.index()] = true);
            }
        }
        Ok((0..needed.len()).filter(|&place| needed[place]).map(Node::at).collect())
    }
}

/// The answers of every way of a result; `None` if there are too many.
pub fn ways(graph: &Graph, result: Node) -> Option<Vec<Answers>> {
    let (mut open, mut found) = (vec![Answers::new()], Vec::new());
    while let Some(answers) = open.pop() {
        match Way::new(graph, &answers, result) {
            Ok(_) => found.push(answers),
            Err(undecided) => open.extend([false, true].map(|answer| {
                let mut answers = answers.clone();
                answers.insert(undecided, answer);
                answers
            })),
        }
        if found.len() + open.len() > MOST_WAYS {
            return None;
        }
    }
    Some(found)
}

/// Whether all answers that comparisons may have belong to one of these ways.
pub(super) fn are_all(ways: &[Answers]) -> bool {
    let Some(comparison) = ways.first().and_then(|way| way.keys().next()).copied() else { return !ways.is_empty() };
    ways.iter().any(Answers::is_empty)
        || [false, true].iter().all(|&answer| {
            let consistent = ways.iter().filter(|way| way.get(&comparison).is_none_or(|&known| known == answer));
            let rest =
                |way: &Answers| way.iter().filter(|&(&node, _)| node != comparison).map(|(&n, &a)| (n, a)).collect();
            are_all(&consistent.map(rest).collect::<Vec<_>>())
        })
}
