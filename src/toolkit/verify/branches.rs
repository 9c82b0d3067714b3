//! The branches that a formula takes at its points.

use super::subject::Subject;
use crate::toolkit::graph::{Graph, Node, Op};

/// The comparisons on which value and Jacobian depend.
pub(super) struct Branches<'a> {
    pub(super) graph: &'a Graph,
    results: Vec<Node>,
    /// All operations that the results are computed from.
    nodes: Vec<Node>,
    pub(super) comparisons: Vec<Node>,
}

/// The outcome of each comparison at a point; `None` if nothing depends on it there.
pub(super) type Answers = Vec<Option<bool>>;

/// How often each comparison was false and true.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Tally(pub(super) Vec<[usize; 2]>);

impl<'a> Branches<'a> {
    pub(super) fn of(graph: &'a Graph) -> Self {
        let results = [graph.value.as_slice(), &graph.jacobian].concat();
        let nodes = graph.needed(&results);
        let is_comparison = |node: &Node| matches!(graph.op(*node), Op::Compare(..));
        let comparisons = nodes.iter().copied().filter(is_comparison).collect();
        Self { graph, results, nodes, comparisons }
    }

    pub(super) fn answers(&self, point: &[f64]) -> Answers {
        let all = self.graph.results(point, self.nodes.iter().copied());
        let live = self.graph.live(&self.results, &all);
        let answer = |node: &Node| live[node.index()].then(|| all[node.index()] == 1.0);
        self.comparisons.iter().map(answer).collect()
    }

    /// A tally without points.
    pub(super) fn tally(&self) -> Tally {
        Tally(vec![[0; 2]; self.comparisons.len()])
    }
}

impl Tally {
    pub(super) fn add(&mut self, answers: &Answers) {
        for (counts, answer) in self.0.iter_mut().zip(answers) {
            if let Some(answer) = answer {
                counts[usize::from(*answer)] += 1;
            }
        }
    }

    /// The count of the rarest of these outcomes.
    pub(super) fn rarest(&self, answers: &Answers) -> usize {
        let taken = |(counts, answer): (&[usize; 2], &Option<bool>)| answer.map(|answer| counts[usize::from(answer)]);
        self.0.iter().zip(answers).filter_map(taken).min().unwrap_or(usize::MAX)
    }

    /// Whether an outcome of the k-th comparison has occurred.
    pub(super) fn has(&self, k: usize, answer: bool) -> bool {
        self.0[k][usize::from(answer)] > 0
    }

    /// Whether every outcome has occurred.
    pub(super) fn is_full(&self) -> bool {
        self.0.iter().flatten().all(|&count| count > 0)
    }
}

/// The number of points that should take each branch, if there are that many.
const LEAST: usize = 2;

/// Selects `count` of these points, spread over the branches: in turn, the first one that takes a branch which few
/// have taken, or else the first one left.
pub(super) fn spread(subject: &Subject, drawn: Vec<Vec<f64>>, count: usize) -> Vec<Vec<f64>> {
    let nothing = Graph::default();
    let branches = Branches::of(subject.graph().unwrap_or(&nothing));
    let mut tally = branches.tally();
    let mut left: Vec<_> = drawn.into_iter().map(|point| (branches.answers(&point), point)).collect();
    let next = |_| {
        let rarest = left.iter().enumerate().min_by_key(|(_, (answers, _))| tally.rarest(answers).min(LEAST));
        let (answers, point) = left.remove(rarest?.0);
        tally.add(&answers);
        Some(point)
    };
    (0..count).map_while(next).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::coulomb::ReturnMap;

    fn tally() -> Tally {
        Tally(vec![[0, 2], [3, 1], [5, 0]])
    }

    #[test]
    fn sides_are_counted_where_they_were_taken() {
        let mut tally = tally();
        tally.add(&vec![Some(false), None, Some(true)]);
        assert_eq!(tally, Tally(vec![[1, 2], [3, 1], [5, 1]]));
        assert!(tally.is_full() && tally.has(0, false));
        tally.0[1][0] = 0;
        assert!(!tally.is_full() && !tally.has(1, false) && tally.has(1, true));
    }

    #[test]
    fn the_rarest_side_is_among_those_that_are_taken() {
        assert_eq!(tally().rarest(&vec![Some(true), Some(false), Some(false)]), 2);
        assert_eq!(tally().rarest(&vec![None, Some(true), Some(false)]), 1);
        assert_eq!(tally().rarest(&vec![Some(false), Some(true), None]), 0);
        assert_eq!(tally().rarest(&vec![None; 3]), usize::MAX);
    }

    /// Whether a force is below a limit matters everywhere; the rounding error of the product matters only where both are equal.
    #[test]
    fn what_nothing_depends_on_has_no_answer() {
        let subject = Subject::of::<ReturnMap>();
        let graph = subject.graph().expect("it is recorded");
        let branches = Branches::of(graph);
        let answers = |f_trial| branches.answers(&[f_trial, 0.5, 4.0]);
        let live = |answers: &Answers| answers.iter().filter(|answer| answer.is_some()).count();
        let [sticks, ties, slips] = [1.0, 2.0, 3.0].map(answers);
        assert!(live(&sticks) < live(&ties), "{sticks:?}, {ties:?}");
        assert!(sticks.iter().zip(&slips).any(|both| matches!(both, (Some(one), Some(other)) if one != other)));
        assert_eq!(branches.tally(), Tally(vec![[0; 2]; sticks.len()]));
        assert!(branches.comparisons.iter().all(|node| matches!(graph.op(*node), Op::Compare(..))));
    }

    #[test]
    fn points_are_spread_over_sides_until_each_was_taken_twice() {
        let subject = Subject::of::<ReturnMap>();
        let at = |f_trial: f64| vec![f_trial, 0.5, 4.0];
        // Below 2 it sticks, above it slips.
        let drawn: Vec<_> = [1.0, 1.1, 1.2, 1.3, 3.0, 3.1, 3.2].map(at).into();
        let forces = |count| spread(&subject, drawn.clone(), count).iter().map(|point| point[0]).collect::<Vec<_>>();
        assert_eq!(forces(6), [1.0, 3.0, 1.1, 3.1, 1.2, 1.3]);
        assert_eq!(forces(9), [1.0, 3.0, 1.1, 3.1, 1.2, 1.3, 3.2]);
    }
}
