//! A long function in parts: statements that follow each other become a function of their own.

use jointproof::graph::{Graph, Node, Op, Statement};
use std::collections::{HashMap, HashSet};

/// A part has about so many lines.
const PART: usize = 180;

/// A step of a function.
#[derive(Clone, Debug)]
pub(super) enum Step {
    /// A result is computed.
    Compute(Node),
    /// One of two sides is done.
    Choose {
        condition: Node,
        /// What follows: a result, what it is where the answer is yes, and what it is where it is no.
        results: Vec<[Node; 3]>,
        yes: Vec<Step>,
        no: Vec<Step>,
    },
    /// A part is done.
    Call(usize),
}

/// Statements that are a function of their own.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) steps: Vec<Step>,
    /// What it takes beside inputs.
    pub(super) given: Vec<Node>,
    /// What others need of it.
    pub(super) found: Vec<Node>,
}

/// A function, and the parts that it and they call; a part stands behind those that it calls.
#[derive(Debug)]
pub(super) struct Outline<'a> {
    graph: &'a Graph,
    /// How often each result is used in all.
    uses: HashMap<Node, usize>,
    pub(super) main: Vec<Step>,
    pub(super) parts: Vec<Part>,
}

impl<'a> Outline<'a> {
    /// With a main function of about so many lines at most.
    pub(super) fn new(graph: &'a Graph, results: &[Node], limit: usize) -> Self {
        let main = steps(graph.statements(results));
        let mut outline = Self { graph, uses: HashMap::new(), main: Vec::new(), parts: Vec::new() };
        let mut uses: HashMap<_, usize> = results.iter().map(|&node| (node, 1)).collect();
        outline.walk(&main, &mut |used| *uses.entry(used).or_default() += 1, &mut |_| ());
        outline.uses = uses;
        outline.main = outline.shortened(main, limit);
        outline
    }

    /// The same with parts called, so that about so many lines are left, if that can be.
    fn shortened(&mut self, mut steps: Vec<Step>, limit: usize) -> Vec<Step> {
        if self.lines(&steps) <= limit {
            return steps;
        }
        steps = steps.into_iter().map(|step| self.within_a_part(step)).collect();
        loop {
            let before = self.lines(&steps);
            if before <= limit {
                return steps;
            }
            steps = self.grouped(steps);
            if self.lines(&steps) >= before {
                return steps;
            }
        }
    }

    /// A step with its sides shortened, so that a part can hold it.
    fn within_a_part(&mut self, step: Step) -> Step {
        match step {
            Step::Choose { condition, results, yes, no }
                if self.lines(&yes) + self.lines(&no) + 3 * results.len() > PART =>
            {
                let limit = (PART / 2).saturating_sub(2 * results.len() + 4).max(16);
                let [yes, no] = [yes, no].map(|side| self.shortened(side, limit));
                Step::Choose { condition, results, yes, no }
            }
            step => step,
        }
    }

    /// Steps that follow each other, together as long as a part, as calls of parts.
    fn grouped(&mut self, steps: Vec<Step>) -> Vec<Step> {
        let (mut calls, mut group) = (Vec::new(), Vec::new());
        for step in steps {
            group.push(step);
            if self.lines(&group) > PART {
                let last = group.pop().expect("it was pushed");
                calls.push(self.called(std::mem::take(&mut group)));
                group.push(last);
            }
        }
        calls.push(self.called(group));
        calls.concat()
    }

    /// A call of a new part, where that is shorter.
    fn called(&mut self, steps: Vec<Step>) -> Vec<Step> {
        let (mut used, mut defined) = (HashMap::<_, usize>::new(), HashSet::new());
        self.walk(&steps, &mut |node| *used.entry(node).or_default() += 1, &mut |node| _ = defined.insert(node));
        let sorted = |mut nodes: Vec<Node>| {
            nodes.sort_unstable();
            nodes
        };
        let given = used.keys().copied().filter(|node| !defined.contains(node) && !self.graph.is_atom(*node)).collect();
        let is_found = |node: &Node| self.uses.get(node).copied().unwrap_or(0) > used.get(node).copied().unwrap_or(0);
        let found = defined.iter().copied().filter(is_found).collect();
        let part = Part { given: sorted(given), found: sorted(found), steps };
        if self.lines(&part.steps) <= lines_of_call(&part) {
            return part.steps;
        }
        self.parts.push(part);
        vec![Step::Call(self.parts.len() - 1)]
    }

    /// What is used and what is computed in steps and in the parts that they call.
    pub(super) fn walk(&self, steps: &[Step], used: &mut impl FnMut(Node), defined: &mut impl FnMut(Node)) {
        for step in steps {
            match step {
                Step::Compute(node) => {
                    self.graph.op(*node).operands().into_iter().for_each(&mut *used);
                    defined(*node);
                }
                Step::Choose { condition, results, yes, no } => {
                    used(*condition);
                    for &[select, yes, no] in results {
                        used(yes);
                        used(no);
                        defined(select);
                    }
                    self.walk_boxed(yes, used, defined);
                    self.walk_boxed(no, used, defined);
                }
                Step::Call(part) => self.walk_boxed(&self.parts[*part].steps, used, defined),
            }
        }
    }

    fn walk_boxed(&self, steps: &[Step], used: &mut dyn FnMut(Node), defined: &mut dyn FnMut(Node)) {
        self.walk(steps, &mut |node| used(node), &mut |node| defined(node));
    }

    fn lines(&self, steps: &[Step]) -> usize {
        steps.iter().map(|step| self.lines_of(step)).sum()
    }

    fn lines_of(&self, step: &Step) -> usize {
        match step {
            Step::Compute(node) => match self.graph.op(*node) {
                Op::ExactSum(products) => products.len() + 2,
                Op::Search(..) => 3,
                _ => 1,
            },
            Step::Choose { results, yes, no, .. } => 3 + 3 * results.len() + self.lines(yes) + self.lines(no),
            Step::Call(part) => lines_of_call(&self.parts[*part]),
        }
    }
}

fn lines_of_call(part: &Part) -> usize {
    3 + part.given.len() / 8
}

fn steps(statements: Vec<Statement>) -> Vec<Step> {
    let step = |statement| match statement {
        Statement::Compute(node) => Step::Compute(node),
        Statement::Choose { condition, results, yes, no } => {
            Step::Choose { condition, results, yes: steps(yes), no: steps(no) }
        }
    };
    statements.into_iter().map(step).collect()
}
