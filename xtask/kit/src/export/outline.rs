//! Splits a long function into parts: consecutive statements become a separate function.

use jointproof::toolkit::graph::{Graph, Node, Op, Statement};
use std::collections::{HashMap, HashSet};

/// The approximate number of lines of a part.
const PART: usize = 180;

/// A step of a function.
#[derive(Clone, Debug)]
pub(super) enum Step {
    /// A result is computed.
    Compute(Node),
    /// One of two branches is executed.
    Choose {
        condition: Node,
        /// The results of the choice, each with its value in the yes-branch and in the no-branch.
        results: Vec<[Node; 3]>,
        yes: Vec<Step>,
        no: Vec<Step>,
    },
    /// A part is called.
    Call(usize),
}

/// Statements that form a separate function.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) steps: Vec<Step>,
    /// The results it takes in addition to inputs.
    pub(super) given: Vec<Node>,
    /// Its results that others need.
    pub(super) found: Vec<Node>,
}

/// A function, and all parts called directly or indirectly; a part comes after those that it calls.
#[derive(Debug)]
pub(super) struct Outline<'a> {
    graph: &'a Graph,
    /// The total number of uses of each result.
    uses: HashMap<Node, usize>,
    pub(super) main: Vec<Step>,
    pub(super) parts: Vec<Part>,
}

impl<'a> Outline<'a> {
    /// With a main function of about `limit` lines at most.
    pub(super) fn new(graph: &'a Graph, results: &[Node], limit: usize) -> Self {
        let main = steps(graph.statements(results));
        let mut outline = Self { graph, uses: HashMap::new(), main: Vec::new(), parts: Vec::new() };
        let mut uses: HashMap<_, usize> = results.iter().map(|&node| (node, 1)).collect();
        outline.walk(&main, &mut |used| *uses.entry(used).or_default() += 1, &mut |_| ());
        outline.uses = uses;
        outline.main = outline.shortened(main, limit);
        outline
    }

    /// The steps with parts called, so that about `limit` lines are left, if possible.
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

    /// A step with its branches shortened, so that it fits into a part.
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

    /// Groups of consecutive steps, each as long as a part, as calls of parts.
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

    /// A call of a new part, if that is shorter.
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

    /// Visits the results used and computed in steps and in the parts that they call.
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

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::find;

    /// Statements that take this many lines.
    fn lines(graph: &Graph, count: usize) -> Vec<Step> {
        let first = graph.value[0];
        assert!(!matches!(graph.op(first), Op::ExactSum(_) | Op::Search(..)), "it takes a line");
        vec![Step::Compute(first); count]
    }

    fn outline(graph: &Graph) -> Outline<'_> {
        Outline { graph, uses: HashMap::new(), main: Vec::new(), parts: Vec::new() }
    }

    fn choice(graph: &Graph, results: usize, [yes, no]: [usize; 2]) -> Step {
        let node = graph.value[0];
        let [yes, no] = [yes, no].map(|count| lines(graph, count));
        Step::Choose { condition: node, results: vec![[node; 3]; results], yes, no }
    }

    /// Except for the three lines of every choice.
    #[test]
    fn a_choice_that_no_part_could_hold_is_shortened_until_one_can() {
        let graph = find("slot.contact_force").unwrap().graph().unwrap();
        for results in [1, 5, 30] {
            for count in 60..=PART + 10 {
                for sides in [[count, count], [count, 1], [1, count]] {
                    let mut outline = outline(&graph);
                    let choice = choice(&graph, results, sides);
                    let before = outline.lines_of(&choice);
                    let held = outline.within_a_part(choice);
                    let after = outline.lines_of(&held);
                    assert!(after <= PART + 3, "{results} results, sides of {sides:?} lines: {after}");
                    assert!(before > PART || after == before, "{results} results, sides of {sides:?} lines: {after}");
                    assert!(outline.parts.iter().all(|part| outline.lines(&part.steps) <= PART));
                }
            }
        }
    }

    #[test]
    fn what_is_short_enough_is_left_and_the_rest_in_parts() {
        let graph = find("slot.contact_force").unwrap().graph().unwrap();
        let parts = |count: usize, limit: usize| {
            let mut outline = outline(&graph);
            let steps = outline.shortened(lines(&graph, count), limit);
            let parts: Vec<_> = outline.parts.iter().map(|part| outline.lines(&part.steps)).collect();
            (outline.lines(&steps), parts)
        };
        assert_eq!(parts(100, 100), (100, vec![]));
        // A call takes three lines.
        assert_eq!(parts(101, 100), (3, vec![101]));
        assert_eq!(parts(PART, 100), (3, vec![PART]));
        assert_eq!(parts(2 * PART + 9, 100), (9, vec![PART, PART, 9]));
        // No call if it is no shorter.
        assert_eq!(parts(PART + 3, 100), (6, vec![PART]));
        assert_eq!([parts(3, 1), parts(4, 1)], [(3, vec![]), (3, vec![4])]);
    }

    #[test]
    fn a_part_takes_what_it_needs_and_gives_what_others_need() {
        let formula = find("slot.friction").unwrap();
        let graph = formula.graph().unwrap();
        let results: Vec<_> = graph.value.iter().chain(&graph.jacobian).copied().collect();
        let outline = Outline::new(&graph, &results, 1);
        assert!(!outline.parts.is_empty());
        for part in &outline.parts {
            let (mut used, mut defined) = (HashSet::new(), HashSet::new());
            outline.walk(&part.steps, &mut |node| _ = used.insert(node), &mut |node| _ = defined.insert(node));
            let mut given: Vec<_> =
                used.into_iter().filter(|node| !defined.contains(node) && !graph.is_atom(*node)).collect();
            given.sort_unstable();
            assert_eq!(part.given, given);
            assert!(part.found.is_sorted() && part.found.iter().all(|node| defined.contains(node)));
        }
        // As there are no other uses, every result is either returned by one part or computed outside the parts.
        let (mut there, mut beside) = (HashSet::new(), HashSet::new());
        outline.parts.iter().for_each(|part| there.extend(part.found.iter().copied()));
        for step in &outline.main {
            if !matches!(step, Step::Call(_)) {
                outline.walk(std::slice::from_ref(step), &mut |_| (), &mut |node| _ = beside.insert(node));
            }
        }
        assert!(results.iter().all(|node| graph.is_atom(*node) || there.contains(node) || beside.contains(node)));
    }
}
