//! The operations of a graph as statements: work that only one branch of a choice needs is done only there.

use super::node::{Graph, Node, Op, Unary};
use std::collections::{HashMap, HashSet};

/// A step of the program.
#[derive(Clone, Debug)]
pub enum Statement {
    /// A result is computed from earlier ones.
    Compute(Node),
    /// One of two branches is executed.
    Choose {
        /// The Boolean that decides.
        condition: Node,
        /// The results of the choice, each with its value in the yes-branch and in the no-branch.
        results: Vec<[Node; 3]>,
        /// The statements executed if the condition is true.
        yes: Vec<Statement>,
        /// The statements executed if the condition is false.
        no: Vec<Statement>,
    },
}

/// Up to this many cheap operations are done in both branches rather than behind a jump.
const CHEAP: usize = 4;

impl Graph {
    /// The statements that compute these results, in order.
    pub fn statements(&self, results: &[Node]) -> Vec<Statement> {
        self.statements_after(HashSet::new(), results)
    }

    /// The same where some results are known already.
    pub fn statements_after(&self, known: HashSet<Node>, results: &[Node]) -> Vec<Statement> {
        let mut layout = Layout::placed_after(self, known, results);
        layout.dissolve_cheap();
        layout.statements(0)
    }

    /// Whether it is a Boolean rather than a number.
    pub fn is_answer(&self, node: Node) -> bool {
        match self.op(node) {
            Op::Compare(..) => true,
            Op::Select(_, yes, _) => self.is_answer(*yes),
            _ => false,
        }
    }

    /// Whether it needs no statement.
    pub fn is_atom(&self, node: Node) -> bool {
        matches!(self.op(node), Op::Input(_) | Op::Number(_))
    }
}

/// A block of statements: the whole program, or a branch of a choice in another block.
#[derive(Clone, Copy, Debug)]
struct Block {
    parent: usize,
    depth: usize,
}

/// Results chosen by one condition in one block, none of which depends on another.
#[derive(Clone, Debug)]
pub(super) struct Choice {
    pub(super) block: usize,
    pub(super) condition: Node,
    pub(super) selects: Vec<Node>,
    /// The blocks of the yes-branch and the no-branch.
    pub(super) sides: [usize; 2],
    dissolved: bool,
}

pub(super) struct Layout<'a> {
    pub(super) graph: &'a Graph,
    /// Results that are not computed here.
    known: HashSet<Node>,
    blocks: Vec<Block>,
    pub(super) choices: Vec<Choice>,
    /// The block of every operation that is needed; the first block contains all others.
    pub(super) place: Vec<Option<usize>>,
    /// The choice that a select belongs to.
    pub(super) choice_of: HashMap<Node, usize>,
}

impl<'a> Layout<'a> {
    /// Places every operation that these results need.
    pub(super) fn placed(graph: &'a Graph, results: &[Node]) -> Self {
        Self::placed_after(graph, HashSet::new(), results)
    }

    fn placed_after(graph: &'a Graph, known: HashSet<Node>, results: &[Node]) -> Self {
        let (blocks, place) = (vec![Block { parent: 0, depth: 0 }], vec![None; graph.ops().len()]);
        let mut layout = Self { graph, known, blocks, choices: Vec::new(), place, choice_of: HashMap::new() };
        layout.place(results);
        layout
    }

    /// Places every operation in the innermost block that contains all its uses. Uses come after what they use.
    fn place(&mut self, results: &[Node]) {
        let levels = self.graph.levels();
        let mut keys = HashMap::new();
        for &node in results {
            self.used_in(node, 0);
        }
        for index in (0..self.graph.ops().len()).rev() {
            let node = Node::at(index);
            let Some(block) = self.place[index] else { continue };
            match *self.graph.op(node) {
                Op::Select(condition, yes, no) => {
                    let choice = *keys.entry((block, condition, levels[index])).or_insert_with(|| {
                        self.choices.push(Choice {
                            block,
                            condition,
                            selects: Vec::new(),
                            sides: [0, 1].map(|side| self.blocks.len() + side),
                            dissolved: false,
                        });
                        let depth = self.blocks[block].depth + 1;
                        self.blocks.extend([Block { parent: block, depth }; 2]);
                        self.choices.len() - 1
                    });
                    self.choices[choice].selects.push(node);
                    self.choice_of.insert(node, choice);
                    let [on_yes, on_no] = self.choices[choice].sides;
                    self.used_in(condition, block);
                    self.used_in(yes, on_yes);
                    self.used_in(no, on_no);
                }
                ref op => op.operands().into_iter().for_each(|operand| self.used_in(operand, block)),
            }
        }
    }

    fn used_in(&mut self, node: Node, block: usize) {
        if self.known.contains(&node) {
            return;
        }
        let place = &mut self.place[node.index()];
        *place = Some(place.map_or(block, |known| common(&self.blocks, known, block)));
    }

    /// Does both branches of a choice where that is cheaper than a jump.
    fn dissolve_cheap(&mut self) {
        // Inner choices have larger indices than those around them.
        for choice in (0..self.choices.len()).rev() {
            let Choice { block, sides, .. } = self.choices[choice];
            let within = |place: Option<usize>| place.is_some_and(|place| sides.contains(&place));
            let inside = (0..self.place.len()).filter(|&k| within(self.place[k]));
            let inside: Vec<_> = inside.filter(|&k| !self.graph.is_atom(Node::at(k))).collect();
            let holds_choice = self.choices.iter().any(|inner| !inner.dissolved && sides.contains(&inner.block));
            let is_cheap = |&k: &usize| is_cheap(self.graph.op(Node::at(k)));
            if holds_choice || inside.len() > CHEAP || !inside.iter().all(is_cheap) {
                continue;
            }
            self.choices[choice].dissolved = true;
            for place in self.place.iter_mut().flatten().filter(|place| sides.contains(place)) {
                *place = block;
            }
            for inner in self.choices.iter_mut().filter(|inner| sides.contains(&inner.block)) {
                inner.block = block;
            }
        }
    }

    fn statements(&self, block: usize) -> Vec<Statement> {
        let mut schedule = Schedule { layout: self, block, done: HashSet::new(), statements: Vec::new() };
        for index in 0..self.place.len() {
            if self.place[index] == Some(block) {
                schedule.require(Node::at(index));
            }
        }
        schedule.statements
    }

    fn kept_choice(&self, node: Node) -> Option<usize> {
        self.choice_of.get(&node).copied().filter(|&choice| !self.choices[choice].dissolved)
    }

    /// The branch of an outermost choice that contains a block, or the block itself if it is outside all choices.
    pub(super) fn outermost(&self, mut block: usize) -> usize {
        while self.blocks[block].depth > 1 {
            block = self.blocks[block].parent;
        }
        block
    }

    /// Whether a block is the other one or nested in it.
    fn is_within(&self, mut block: usize, outer: usize) -> bool {
        while self.blocks[block].depth > self.blocks[outer].depth {
            block = self.blocks[block].parent;
        }
        block == outer
    }
}

/// The innermost block that contains both.
fn common(blocks: &[Block], mut a: usize, mut b: usize) -> usize {
    while a != b {
        if blocks[a].depth >= blocks[b].depth {
            a = blocks[a].parent;
        } else {
            b = blocks[b].parent;
        }
    }
    a
}

/// The statements of a block, in an order in which nothing is used before it is computed.
struct Schedule<'a> {
    layout: &'a Layout<'a>,
    block: usize,
    done: HashSet<Node>,
    statements: Vec<Statement>,
}

impl Schedule<'_> {
    /// Ensures that a result is computed, if this is the block to do so.
    fn require(&mut self, node: Node) {
        let layout = self.layout;
        let is_here = layout.place[node.index()] == Some(self.block);
        if !is_here || layout.graph.is_atom(node) || self.done.contains(&node) {
            return;
        }
        let Some(choice) = layout.kept_choice(node) else {
            layout.graph.op(node).operands().into_iter().for_each(|operand| self.require(operand));
            self.done.insert(node);
            self.statements.push(Statement::Compute(node));
            return;
        };
        let Choice { condition, ref selects, sides, .. } = layout.choices[choice];
        self.require(condition);
        for index in 0..layout.place.len() {
            let is_inside = |block| sides.iter().any(|&side| layout.is_within(block, side));
            if layout.place[index].is_some_and(is_inside) {
                layout.graph.op(Node::at(index)).operands().into_iter().for_each(|operand| self.require(operand));
            }
        }
        let results: Vec<_> = selects
            .iter()
            .rev()
            .map(|&select| match *layout.graph.op(select) {
                Op::Select(_, yes, no) => [select, yes, no],
                _ => unreachable!("a choice is of selects"),
            })
            .collect();
        for [select, yes, no] in &results {
            self.require(*yes);
            self.require(*no);
            self.done.insert(*select);
        }
        let [yes, no] = sides.map(|side| layout.statements(side));
        self.statements.push(Statement::Choose { condition, results, yes, no });
    }
}

/// Whether an operation takes about a cycle.
fn is_cheap(op: &Op) -> bool {
    use super::node::Binary::{Add, Maximum, Multiply, Subtract};
    match op {
        Op::Binary(operation, ..) => matches!(operation, Add | Subtract | Multiply | Maximum),
        Op::Unary(function, _) => matches!(function, Unary::Negative | Unary::Absolute),
        Op::Compare(..) | Op::Select(..) => true,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toolkit::graph::node::Relation;

    /// The results that statements use before they are computed.
    fn early(graph: &Graph, statements: &[Statement], there: &mut HashSet<Node>) -> Vec<Node> {
        let missing = |there: &HashSet<Node>, node: &Node| !graph.is_atom(*node) && !there.contains(node);
        let mut early = Vec::new();
        for statement in statements {
            match statement {
                Statement::Compute(node) => {
                    early.extend(graph.op(*node).operands().into_iter().filter(|operand| missing(there, operand)));
                    there.insert(*node);
                }
                Statement::Choose { condition, results, yes, no } => {
                    early.extend([*condition].into_iter().filter(|node| missing(there, node)));
                    for (side, k) in [(yes, 1), (no, 2)] {
                        let mut within = there.clone();
                        early.extend(self::early(graph, side, &mut within));
                        early.extend(results.iter().map(|result| result[k]).filter(|node| missing(&within, node)));
                    }
                    there.extend(results.iter().map(|result| result[0]));
                }
            }
        }
        early
    }

    /// A choice is made for all of its results where the first of them is needed; an operation that only the last of
    /// them uses was added after the first.
    #[test]
    fn what_a_choice_takes_is_there_before_it() {
        for is_yes in [true, false] {
            let mut graph = Graph::default();
            let [x, y] = [0, 1].map(|k| graph.enter(Op::Input(k)));
            let condition = graph.enter(Op::Compare(Relation::Less, x, y));
            let mut roots = |node| (0..8).fold(node, |node, _| graph.enter(Op::Unary(Unary::Root, node)));
            let (heavy, deep) = (roots(x), roots(y));
            let first = graph.enter(Op::Select(condition, heavy, y));
            let late = graph.enter(Op::Unary(Unary::Sine, y));
            let [yes, no] = if is_yes { [late, deep] } else { [deep, late] };
            let last = graph.enter(Op::Select(condition, yes, no));
            let statements = graph.statements(&[first, late, last]);
            assert!(statements.iter().any(|it| matches!(it, Statement::Choose { results, .. } if results.len() == 2)));
            assert_eq!(early(&graph, &statements, &mut HashSet::new()), [], "{statements:?}");
        }
    }
}
