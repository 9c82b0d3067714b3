//! The graph being recorded on this thread, and the outcomes of comparisons in the current run.

use super::join::join;
use super::node::{Binary, Graph, Node, Op, Relation};
use rustc_hash::FxHashMap;
use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

thread_local! {
    static RECORDER: RefCell<Option<Recorder>> = const { RefCell::new(None) };
}

/// More runs than any formula needs whose graph can be printed.
pub(super) const MOST_RUNS: usize = 65_536;
/// A run with more operations than any formula counts as endless.
const MOST_OPERATIONS: usize = 200_000;

/// The graph, and the run that is being recorded.
#[derive(Default)]
struct Recorder {
    graph: Graph,
    run: Run,
    operations: usize,
    runs: usize,
    /// Whether this run has requested the value of something that depends on the inputs.
    asked: bool,
    extremes: Extremes,
    /// The number of choices so far in every run that has not ended, the innermost last.
    choices: Vec<usize>,
    known: FxHashMap<Place, Side>,
}

/// The place of a choice: what was decided before, and its number, with those that it is within. What is chosen follows from it.
type Place = (Vec<(Node, bool)>, Vec<usize>);

/// The treatment of numbers that would over- or underflow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Extremes {
    /// They are computed by a separate branch, as for a single point.
    #[default]
    Computed,
    /// The same, but the branches of a direction are joined at once: an element has too many combinations of them.
    Joined,
    /// They are NaN, as for several rows of a batch computed together.
    Nan,
    /// Nothing is done about them, except that the zero vector has the direction 0: the graph is what one would write by hand.
    Ignored,
}

/// The outcomes of comparisons in a run.
#[derive(Clone, Default)]
struct Run {
    /// The outcomes of the first comparisons after the start; later ones are true.
    script: Vec<bool>,
    /// The number of comparisons decided before the start.
    start: usize,
    /// The comparisons that earlier ones left open, and their outcomes.
    taken: Vec<(Node, bool)>,
    facts: FxHashMap<Node, bool>,
}

/// Why recording was aborted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Escape {
    /// The value of something that depends on the inputs was requested as a double.
    Value,
    /// A function was called that the graph does not know.
    Function(&'static str),
    /// There are too many combinations of outcomes.
    Combinations,
    /// A run does not terminate.
    Endless,
}

/// Why there is no graph.
pub(super) enum Failure {
    Escape(Escape),
    Panic,
}

/// Records a run for every combination of outcomes into a new graph, and returns the graph with the results.
pub(super) fn record<const N: usize>(
    extremes: Extremes,
    runs: [&dyn Fn() -> Vec<Node>; N],
) -> Result<(Graph, [Vec<Node>; N]), Failure> {
    RECORDER.set(Some(Recorder::new(Graph::default(), extremes)));
    let results = catch_unwind(AssertUnwindSafe(|| runs.map(sides)));
    let recorder = RECORDER.take().expect("it was set before the run");
    match results {
        Ok(results) if results.iter().any(Option::is_none) => Err(Failure::Panic),
        Ok(results) => Ok((recorder.graph, results.map(Option::unwrap_or_default))),
        Err(payload) => Err(payload.downcast_ref().map_or(Failure::Panic, |escape| Failure::Escape(*escape))),
    }
}

/// Appends the operations of `run` to a graph and returns its result.
pub(super) fn extended<T>(graph: &mut Graph, run: impl FnOnce() -> T) -> T {
    RECORDER.set(Some(Recorder::new(std::mem::take(graph), Extremes::Computed)));
    let results = run();
    *graph = RECORDER.take().expect("it was set before the run").graph;
    results
}

/// The results of a branch; `None` if it is unreachable, since the formula panics or does not terminate there.
type Side = Option<Vec<Node>>;

/// The results of `run` over all outcomes of its comparisons that earlier ones leave open.
pub(super) fn sides(run: &dyn Fn() -> Vec<Node>) -> Side {
    let (before, place) = with(|recorder| {
        *recorder.choices.last_mut().expect("a choice is within a run") += 1;
        (recorder.run.clone(), (recorder.run.taken.clone(), recorder.choices.clone()))
    });
    if let Some(known) = with(|recorder| recorder.known.get(&place).cloned()) {
        return known;
    }
    with(|recorder| recorder.choices.push(0));
    let side = sides_from(run, &before, Vec::new());
    with(|recorder| {
        recorder.run = before;
        recorder.choices.pop();
        recorder.known.insert(place, side.clone());
    });
    side
}

/// The same with the outcomes of the first comparisons given by the script.
fn sides_from(run: &dyn Fn() -> Vec<Node>, before: &Run, script: Vec<bool>) -> Side {
    let decided = script.len();
    let runs = with(|recorder| {
        recorder.run = Run { script, start: before.taken.len(), ..before.clone() };
        recorder.operations = 0;
        *recorder.choices.last_mut().expect("a choice is within a run") = 0;
        recorder.runs += 1;
        recorder.runs
    });
    if runs > MOST_RUNS {
        escape(Escape::Combinations);
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

/// Records that the value of a number that depends on the inputs was requested; returns NaN, which may only appear in an error.
pub(super) fn ask() -> f64 {
    with(|recorder| recorder.asked = true);
    f64::NAN
}

/// Whether this has happened since the last call.
pub(super) fn has_asked() -> bool {
    with(|recorder| std::mem::take(&mut recorder.asked))
}

pub(super) fn extremes() -> Extremes {
    with(|recorder| recorder.extremes)
}

/// Aborts the run.
pub(super) fn escape(escape: Escape) -> ! {
    resume_unwind(Box::new(escape))
}

fn with<T>(f: impl FnOnce(&mut Recorder) -> T) -> T {
    RECORDER.with_borrow_mut(|recorder| f(recorder.as_mut().expect("a traced number lives while a graph is recorded")))
}

/// The index of a result.
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

/// The outcome of a comparison in this run.
pub(super) fn decide(relation: Relation, x: Node, y: Node) -> bool {
    with(|recorder| recorder.decide(relation, x, y))
}

impl Graph {
    /// Like [`Graph::enter`], but omits factors of 1 and terms of −0, which change no bit.
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
    fn new(graph: Graph, extremes: Extremes) -> Self {
        Self { graph, extremes, choices: vec![0], ..Self::default() }
    }

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

    /// The outcome implied by earlier comparisons, if any; none of the numbers is NaN.
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

    /// A comparison of x with y, or of y with x if swapped.
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

        /// Whether it holds if x and y are in this order.
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

    /// What is known of a comparison after two others: exactly what holds in all orders of x and y that are consistent
    /// with their outcomes.
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

    /// Each outcome before it has its own choice, and none after it.
    #[test]
    fn a_choice_is_made_once_whatever_is_decided_after_it() {
        let runs = std::cell::Cell::new(0);
        let run = || {
            let [x, y, z] = [0, 1, 2].map(|k| enter(Op::Input(k)));
            let chosen = |a, b| {
                runs.set(runs.get() + 1);
                vec![if decide(Relation::Less, a, b) { a } else { b }]
            };
            let first = sides(&|| chosen(x, y)).unwrap();
            let is_less = decide(Relation::Less, y, z);
            let second = sides(&|| chosen(x, z)).unwrap();
            let third = sides(&|| chosen(z, x)).unwrap();
            decide(Relation::Less, first[0], third[0]);
            vec![if is_less { first[0] } else { second[0] }]
        };
        let Ok((graph, [results])) = record(Extremes::Computed, [&run]) else { panic!("it is recorded") };
        assert_eq!(runs.get(), 2 + 2 * 2 + 2 * 2);
        let all = |inputs: &[f64]| graph.results(inputs, (0..graph.ops().len()).map(Node::at))[results[0].index()];
        assert_eq!([all(&[2.0, 1.0, 3.0]), all(&[2.0, 5.0, 0.5])], [1.0, 0.5]);
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
        // After the script, comparisons are true.
        assert!(decide(Relation::Less, x, z));
        let answers: Vec<_> = recorder.run.taken.iter().map(|(_, answer)| *answer).collect();
        assert_eq!(answers, [false, true, true]);
    }
}
