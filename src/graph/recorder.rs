//! The graph that is being recorded on this thread, and how the comparisons of this run come out.

use super::node::{Binary, Graph, Node, Op, Relation};
use std::cell::RefCell;
use std::collections::HashMap;
use std::panic::resume_unwind;

thread_local! {
    static RECORDER: RefCell<Option<Recorder>> = const { RefCell::new(None) };
}

/// A run that takes more operations than any formula does not end.
const MOST_OPERATIONS: usize = 200_000;

/// What is recorded in one run.
pub(super) struct Recorder {
    pub(super) graph: Graph,
    /// How the first comparisons come out; those after them hold.
    script: Vec<bool>,
    /// The comparisons that were left open by those before, and how they came out.
    pub(super) taken: Vec<(Node, bool)>,
    facts: HashMap<Node, bool>,
    operations: usize,
}

/// Why a run was given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Escape {
    /// The value of something that depends on the inputs was asked for as a double.
    Value,
    /// A function was called that the graph does not know.
    Function(&'static str),
    /// It does not end.
    Endless,
}

/// Records what `run` does, with comparisons that come out as the script says.
pub(super) fn record<T>(graph: Graph, script: Vec<bool>, run: impl FnOnce() -> T) -> (Recorder, std::thread::Result<T>) {
    let recorder = Recorder { graph, script, taken: Vec::new(), facts: HashMap::new(), operations: 0 };
    RECORDER.set(Some(recorder));
    let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run));
    (RECORDER.take().expect("it was set before the run"), result)
}

/// Gives the run up.
pub(super) fn escape(escape: Escape) -> ! {
    resume_unwind(Box::new(escape))
}

fn with<T>(f: impl FnOnce(&mut Recorder) -> T) -> T {
    RECORDER.with_borrow_mut(|recorder| f(recorder.as_mut().expect("a traced number lives while a graph is recorded")))
}

/// The place of a result.
pub(super) fn enter(op: Op) -> Node {
    let (node, operations) = with(|recorder| {
        recorder.operations += 1;
        (recorder.graph.entered(op), recorder.operations)
    });
    if operations > MOST_OPERATIONS { escape(Escape::Endless) } else { node }
}

pub(super) fn constant(node: Node) -> Option<f64> {
    with(|recorder| recorder.graph.constant(node))
}

/// How a comparison comes out in this run.
pub(super) fn decide(relation: Relation, x: Node, y: Node) -> bool {
    with(|recorder| recorder.decide(relation, x, y))
}

impl Graph {
    /// As [`Graph::enter`], where a factor 1 and a term −0 are left out, which change no bit.
    fn entered(&mut self, op: Op) -> Node {
        let is = |node, x: f64| self.constant(node).is_some_and(|c| c.to_bits() == x.to_bits());
        match op {
            Op::Binary(Binary::Multiply | Binary::Divide, x, y) if is(y, 1.0) => x,
            Op::Binary(Binary::Multiply, x, y) if is(x, 1.0) => y,
            Op::Binary(Binary::Subtract, x, y) if is(y, 0.0) => x,
            op => self.enter(op),
        }
    }
}

impl Recorder {
    fn decide(&mut self, relation: Relation, x: Node, y: Node) -> bool {
        if let (Some(x), Some(y)) = (self.graph.constant(x), self.graph.constant(y)) {
            return relation.holds(x, y);
        }
        if x == y {
            return relation != Relation::Less;
        }
        let node = self.graph.enter(Op::Compare(relation, x, y));
        if let Some(known) = self.known(relation, x, y) {
            return known;
        }
        let holds = self.script.get(self.taken.len()).copied().unwrap_or(true);
        self.taken.push((node, holds));
        self.facts.insert(node, holds);
        holds
    }

    /// What follows from the comparisons before; none of the numbers is NaN.
    fn known(&mut self, relation: Relation, x: Node, y: Node) -> Option<bool> {
        use Relation::{Equal, Less, LessOrEqual};
        let mut fact = |relation, x, y| {
            let node = self.graph.enter(Op::Compare(relation, x, y));
            self.facts.get(&node).copied()
        };
        let [less, more] = [fact(Less, x, y), fact(Less, y, x)];
        let [at_most, at_least] = [fact(LessOrEqual, x, y), fact(LessOrEqual, y, x)];
        let equal = fact(Equal, x, y).or(fact(Equal, y, x));
        let yes = |fact: Option<bool>| fact == Some(true);
        let no = |fact: Option<bool>| fact == Some(false);
        // Which of x < y, x = y and x > y is still possible?
        let can_be_less = !(no(less) || no(at_most) || yes(more) || yes(at_least) || yes(equal));
        let can_be_equal = !(yes(less) || yes(more) || no(at_most) || no(at_least) || no(equal));
        let can_be_more = !(no(more) || no(at_least) || yes(less) || yes(at_most) || yes(equal));
        let certain = |possible: bool, otherwise: bool| match (possible, otherwise) {
            (true, false) => Some(true),
            (false, true) => Some(false),
            _ => None,
        };
        match relation {
            Less => certain(can_be_less, can_be_equal | can_be_more),
            Equal => certain(can_be_equal, can_be_less | can_be_more),
            LessOrEqual => certain(can_be_less | can_be_equal, can_be_more),
        }
    }
}
