//! The graph that is being recorded on this thread, and how the comparisons of this run come out.

use super::join::join;
use super::node::{Binary, Graph, Node, Op, Relation};
use rustc_hash::FxHashMap;
use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

thread_local! {
    static RECORDER: RefCell<Option<Recorder>> = const { RefCell::new(None) };
}

/// More runs than any formula needs that can be printed.
pub(super) const MOST_RUNS: usize = 65_536;
/// A run that takes more operations than any formula does not end.
const MOST_OPERATIONS: usize = 200_000;

/// The graph, and the run that is being recorded.
#[derive(Default)]
struct Recorder {
    graph: Graph,
    run: Run,
    operations: usize,
    runs: usize,
    /// Whether this run has asked for the value of something that depends on the inputs.
    asked: bool,
    extremes: Extremes,
}

/// What becomes of numbers that would over- or underflow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Extremes {
    /// They are computed in another way, as a single point is.
    #[default]
    Computed,
    /// They are NaN, as where several rows of a batch are computed at once.
    Nan,
}

/// How comparisons come out in a run.
#[derive(Clone, Default)]
struct Run {
    /// How the first comparisons after the start come out; those after them hold.
    script: Vec<bool>,
    /// So many comparisons were decided before the start.
    start: usize,
    /// The comparisons that were left open by those before, and how they came out.
    taken: Vec<(Node, bool)>,
    facts: FxHashMap<Node, bool>,
}

/// Why recording was given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Escape {
    /// The value of something that depends on the inputs was asked for as a double.
    Value,
    /// A function was called that the graph does not know.
    Function(&'static str),
    /// Comparisons come out in too many ways.
    Ways,
    /// A run does not end.
    Endless,
}

/// Why there is no graph.
pub(super) enum Failure {
    Escape(Escape),
    Panic,
}

/// Records runs, each with its comparisons in every possible way, into a new graph; and what they result in.
pub(super) fn record<const N: usize>(
    extremes: Extremes,
    runs: [&dyn Fn() -> Vec<Node>; N],
) -> Result<(Graph, [Vec<Node>; N]), Failure> {
    RECORDER.set(Some(Recorder { extremes, ..Recorder::default() }));
    let results = catch_unwind(AssertUnwindSafe(|| runs.map(sides)));
    let recorder = RECORDER.take().expect("it was set before the run");
    match results {
        Ok(results) if results.iter().any(Option::is_none) => Err(Failure::Panic),
        Ok(results) => Ok((recorder.graph, results.map(Option::unwrap_or_default))),
        Err(payload) => Err(payload.downcast_ref().map_or(Failure::Panic, |escape| Failure::Escape(*escape))),
    }
}

/// What `run` results in, its operations written behind those of a graph.
pub(super) fn extended<T>(graph: &mut Graph, run: impl FnOnce() -> T) -> T {
    RECORDER.set(Some(Recorder { graph: std::mem::take(graph), ..Recorder::default() }));
    let results = run();
    *graph = RECORDER.take().expect("it was set before the run").graph;
    results
}

/// The results of a side; `None` of one that nothing can reach, since the formula does not get through it.
type Side = Option<Vec<Node>>;

/// What `run` results in, with its comparisons in every way that those before leave open.
pub(super) fn sides(run: &dyn Fn() -> Vec<Node>) -> Side {
    let before = with(|recorder| recorder.run.clone());
    let side = sides_from(run, &before, Vec::new());
    with(|recorder| recorder.run = before);
    side
}

/// The same where the first comparisons come out as the script says.
fn sides_from(run: &dyn Fn() -> Vec<Node>, before: &Run, script: Vec<bool>) -> Side {
    let decided = script.len();
    let runs = with(|recorder| {
        recorder.run = Run { script, start: before.taken.len(), ..before.clone() };
        recorder.operations = 0;
        recorder.runs += 1;
        recorder.runs
    });
    if runs > MOST_RUNS {
        escape(Escape::Ways);
    }
    let mut side = match catch_unwind(AssertUnwindSafe(run)) {
        Ok(results) => Some(results),
        Err(payload) if payload.is::<Escape>() => resume_unwind(payload),
        Err(_) if has_asked() => escape(Escape::Value),
        Err(_) => None,
    };
    let taken = with(|recorder| recorder.run.taken.split_off(before.taken.len()));
    for k in (decided..taken.len()).rev() {
        let (condition, answer) = taken[k];
        let script = taken[..k].iter().map(|&(_, answer)| answer).chain([!answer]).collect();
        let other = sides_from(run, before, script);
        let (yes, no) = if answer { (side, other) } else { (other, side) };
        side = match (yes, no) {
            (Some(yes), Some(no)) => Some(with(|recorder| join(&mut recorder.graph, condition, &yes, &no))),
            (one, None) | (None, one) => one,
        };
    }
    side
}

/// The value of a number that depends on the inputs was asked for: NaN, which may only be told in an error.
pub(super) fn ask() -> f64 {
    with(|recorder| recorder.asked = true);
    f64::NAN
}

/// Whether that has happened since the last time.
pub(super) fn has_asked() -> bool {
    with(|recorder| std::mem::take(&mut recorder.asked))
}

pub(super) fn extremes() -> Extremes {
    with(|recorder| recorder.extremes)
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
        let run = &mut self.run;
        let holds = run.script.get(run.taken.len() - run.start).copied().unwrap_or(true);
        run.taken.push((node, holds));
        run.facts.insert(node, holds);
        holds
    }

    /// What follows from the comparisons before; none of the numbers is NaN.
    fn known(&mut self, relation: Relation, x: Node, y: Node) -> Option<bool> {
        use Relation::{Equal, Less, LessOrEqual};
        let mut fact = |relation, x, y| {
            let node = self.graph.enter(Op::Compare(relation, x, y));
            self.run.facts.get(&node).copied()
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::cmp::Ordering::{self, Equal, Greater, Less};

    const ORDERS: [Ordering; 3] = [Less, Equal, Greater];

    /// A comparison of x with y, or of y with x where it is swapped.
    #[derive(Clone, Copy)]
    struct Asked {
        relation: Relation,
        swapped: bool,
    }

    impl Asked {
        fn all() -> impl Iterator<Item = Self> {
            let relations = [Relation::Less, Relation::LessOrEqual, Relation::Equal];
            relations.into_iter().flat_map(|relation| [false, true].map(|swapped| Self { relation, swapped }))
        }

        /// Whether it holds where x and y are in this order.
        fn holds(self, order: Ordering) -> bool {
            let order = if self.swapped { order.reverse() } else { order };
            match self.relation {
                Relation::Less => order == Less,
                Relation::LessOrEqual => order != Greater,
                Relation::Equal => order == Equal,
            }
        }

        fn nodes(self, [x, y]: [Node; 2]) -> (Relation, Node, Node) {
            if self.swapped { (self.relation, y, x) } else { (self.relation, x, y) }
        }
    }

    /// What is known of a comparison after others that came out as they do in one of these orders: whatever holds in all orders
    /// that are left, and nothing else.
    #[test]
    fn what_follows_from_two_comparisons_is_known_and_nothing_else() {
        for (first, second) in Asked::all().flat_map(|first| Asked::all().map(move |second| (first, second))) {
            for truth in ORDERS {
                let answers = [first, second].map(|asked| asked.holds(truth));
                let mut recorder = Recorder::default();
                let nodes = [0, 1].map(|k| recorder.graph.enter(Op::Input(k)));
                for (asked, answer) in [first, second].into_iter().zip(answers) {
                    let (relation, x, y) = asked.nodes(nodes);
                    let node = recorder.graph.enter(Op::Compare(relation, x, y));
                    recorder.run.facts.insert(node, answer);
                }
                let is_left = |order: &Ordering| [first, second].map(|asked| asked.holds(*order)) == answers;
                let left: Vec<_> = ORDERS.into_iter().filter(is_left).collect();
                for third in Asked::all() {
                    let (relation, x, y) = third.nodes(nodes);
                    let in_all = |answer: bool| left.iter().all(|&order| third.holds(order) == answer);
                    let expected = if in_all(true) { Some(true) } else { in_all(false).then_some(false) };
                    assert_eq!(recorder.known(relation, x, y), expected, "{relation:?} of {left:?}");
                }
            }
        }
    }

    #[test]
    fn a_comparison_comes_out_as_the_script_says_and_what_is_certain_is_not_in_it() {
        let mut recorder = Recorder::default();
        let [x, y, z] = [0, 1, 2].map(|k| recorder.graph.enter(Op::Input(k)));
        let [one, two] = [1.0_f64, 2.0].map(|number| recorder.graph.enter(Op::Number(number.to_bits())));
        recorder.run.script = vec![false, true];
        let mut decide = |relation, x, y| recorder.decide(relation, x, y);
        assert_eq!([decide(Relation::Less, one, two), decide(Relation::Less, two, one)], [true, false]);
        let same = [Relation::Less, Relation::LessOrEqual, Relation::Equal].map(|relation| decide(relation, x, x));
        assert_eq!(same, [false, true, true]);
        assert!(!decide(Relation::Less, x, y) && decide(Relation::LessOrEqual, y, x));
        assert!(decide(Relation::Less, y, z) && !decide(Relation::LessOrEqual, z, y));
        // Behind the script what is asked holds.
        assert!(decide(Relation::Less, x, z));
        let answers: Vec<_> = recorder.run.taken.iter().map(|(_, answer)| *answer).collect();
        assert_eq!(answers, [false, true, true]);
    }
}
