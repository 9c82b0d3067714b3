//! The ways through the branches of a graph: on each of them a result is computed without a choice.

use crate::toolkit::graph::{Binary, Graph, Node, Op, Unary};
use std::collections::BTreeMap;

/// The answers of comparisons on which a way depends; and for a maximum, whether it is its first operand.
pub type Answers = BTreeMap<Node, bool>;

/// Results on one way.
#[derive(Clone)]
pub(super) struct Way<'a> {
    pub(super) graph: &'a Graph,
    pub(super) answers: &'a Answers,
    /// The operations that compute the results.
    pub(super) results: Vec<Node>,
    /// The operations that the results depend on, operands first.
    pub(super) nodes: Vec<Node>,
}

impl<'a> Way<'a> {
    /// The way that these answers describe.
    ///
    /// # Errors
    /// A comparison that is not answered, but on which a result depends.
    pub(super) fn new(graph: &'a Graph, answers: &'a Answers, results: &[Node]) -> Result<Self, Node> {
        let mut way = Self { graph, answers, results: Vec::new(), nodes: Vec::new() };
        way.results = results.iter().map(|&result| way.resolved(result)).collect::<Result<_, _>>()?;
        way.nodes = way.needed(&way.results)?;
        Ok(way)
    }

    /// The way with all inputs among its operations.
    pub(super) fn with_inputs(mut self) -> Self {
        let inputs = self.graph.ops().iter().enumerate().filter(|(_, op)| matches!(op, Op::Input(_)));
        self.nodes.extend(inputs.map(|(place, _)| Node::at(place)));
        self.nodes.sort_unstable();
        self.nodes.dedup();
        self
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

    /// Numbers and all that they are computed from, operands first.
    pub(super) fn needed(&self, nodes: &[Node]) -> Result<Vec<Node>, Node> {
        let mut needed = vec![false; nodes.iter().map(|node| node.index() + 1).max().unwrap_or_default()];
        for node in nodes {
            needed[node.index()] = true;
        }
        for place in (0..needed.len()).rev() {
            if needed[place] {
                self.operands(Node::at(place))?.into_iter().for_each(|operand| needed[operand.index()] = true);
            }
        }
        Ok((0..needed.len()).filter(|&place| needed[place]).map(Node::at).collect())
    }
}
