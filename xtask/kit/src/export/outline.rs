//! Splits a long function into parts: consecutive statements become a separate function.

use super::repeated::Repeated;
use jointproof::toolkit::graph::{Graph, Node, Op, Statement};
use std::collections::{HashMap, HashSet};

/// How long functions are, in about as many lines as their statements have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lengths {
    /// Of the main function, at most, if possible.
    pub(super) main: usize,
    /// Of a part.
    pub(super) part: usize,
}

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
    /// The part for every slave node is called for this one.
    Repeat { part: usize, slave: usize },
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
    repeated: Option<&'a Repeated>,
    /// The approximate number of lines of a part.
    part: usize,
    /// The total number of uses of each result.
    uses: HashMap<Node, usize>,
    pub(super) main: Vec<Step>,
    pub(super) parts: Vec<Part>,
}

impl<'a> Outline<'a> {
    pub(super) fn new(
        graph: &'a Graph,
        repeated: Option<&'a Repeated>,
        results: &[Node],
        Lengths { main: limit, part }: Lengths,
    ) -> Self {
        let (main, parts) = (Vec::new(), Vec::new());
        let mut outline = Self { graph, repeated, part, uses: HashMap::new(), main, parts };
        let main = match repeated {
            None => steps(graph.statements(results)),
            Some(repeated) => outline.with_repeated(repeated, results),
        };
        outline.count(&main, results);
        outline.main = outline.shortened(main, limit);
        outline
    }

    /// The steps with the part that is called for every slave node: what it takes, the calls, and what is made of their results.
    fn with_repeated(&mut self, repeated: &Repeated, results: &[Node]) -> Vec<Step> {
        let Repeated { given, found, at } = repeated;
        let part = steps(self.graph.statements_after(given.iter().copied().collect(), found));
        self.count(&part, found);
        // Each of its results may take a line.
        let limit = self.part.saturating_sub(found.len());
        let part = Part { steps: self.shortened(part, limit), given: given.clone(), found: found.clone() };
        self.parts.push(part);
        let all = |nodes: &[Node]| at.iter().flat_map(|at| nodes.iter().map(|node| at.nodes[node])).collect::<Vec<_>>();
        let before = steps(self.graph.statements(&all(given)));
        let mut known: HashSet<_> = all(found).into_iter().collect();
        for step in &before {
            match step {
                Step::Compute(node) => _ = known.insert(*node),
                Step::Choose { results, .. } => known.extend(results.iter().map(|[select, ..]| *select)),
                Step::Call(_) | Step::Repeat { .. } => {}
            }
        }
        let calls = (0..at.len()).map(|slave| Step::Repeat { part: self.parts.len() - 1, slave });
        let after = steps(self.graph.statements_after(known, results));
        before.into_iter().chain(calls).chain(after).collect()
    }

    /// Counts the uses of every result.
    fn count(&mut self, steps: &[Step], results: &[Node]) {
        let mut uses = std::mem::take(&mut self.uses);
        for &node in results {
            *uses.entry(node).or_default() += 1;
        }
        self.walk(steps, &mut |used| *uses.entry(used).or_default() += 1, &mut |_| ());
        self.uses = uses;
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
                if self.lines(&yes) + self.lines(&no) + 3 * results.len() > self.part =>
            {
                let limit = (self.part / 2).saturating_sub(2 * results.len() + 4).max(16);
                let [yes, no] = [yes, no].map(|side| self.shortened(side, limit));
                Step::Choose { condition, results, yes, no }
            }
            step => step,
        }
    }

    /// Groups of consecutive steps, each as long as a part, as calls of parts. The calls for slave nodes remain where they are: they
    /// have so many results.
    fn grouped(&mut self, steps: Vec<Step>) -> Vec<Step> {
        let (mut calls, mut group) = (Vec::new(), Vec::new());
        for step in steps {
            if matches!(step, Step::Repeat { .. }) {
                calls.extend([self.called(std::mem::take(&mut group)), vec![step]]);
                continue;
            }
            group.push(step);
            if self.lines(&group) > self.part {
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
        let is_passed = |node: &Node| !self.graph.is_atom(*node) || self.is_given(*node);
        let given = used.keys().copied().filter(|node| !defined.contains(node) && is_passed(node)).collect();
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
                Step::Repeat { part, slave } => {
                    let Some(at) = self.repeated.and_then(|repeated| repeated.at.get(*slave)) else { continue };
                    let Part { steps, given, found } = &self.parts[*part];
                    for node in given {
                        used(at.nodes[node]);
                    }
                    let mut input = |node: Node| {
                        if self.graph.is_atom(node) && !self.is_given(node) {
                            used(at.nodes[&node]);
                        }
                    };
                    self.walk_boxed(steps, &mut input, &mut |_| ());
                    for node in found {
                        defined(at.nodes[node]);
                    }
                }
            }
        }
    }

    /// Whether the part for every slave node takes it.
    fn is_given(&self, node: Node) -> bool {
        self.repeated.is_some_and(|repeated| repeated.given.binary_search(&node).is_ok())
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
            Step::Call(part) | Step::Repeat { part, .. } => lines_of_call(&self.parts[*part]),
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

    const PART: usize = 180;

    /// Statements that take this many lines.
    fn lines(graph: &Graph, count: usize) -> Vec<Step> {
        let first = graph.value[0];
        assert!(!matches!(graph.op(first), Op::ExactSum(_) | Op::Search(..)), "it takes a line");
        vec![Step::Compute(first); count]
    }

    fn outline(graph: &Graph) -> Outline<'_> {
        Outline { graph, repeated: None, part: PART, uses: HashMap::new(), main: Vec::new(), parts: Vec::new() }
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
        let outline = Outline::new(&graph, None, &results, Lengths { main: 1, part: PART });
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
