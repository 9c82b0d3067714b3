//! Which sides of the comparisons of a formula its points take.

use super::subject::Subject;
use crate::graph::{Graph, Node, Op};

/// The comparisons that value and Jacobian depend on.
pub(super) struct Branches<'a> {
    pub(super) graph: &'a Graph,
    results: Vec<Node>,
    /// All that the results are computed from.
    nodes: Vec<Node>,
    pub(super) comparisons: Vec<Node>,
}

/// What comes out of each comparison at a point; `None` where nothing depends on it there.
pub(super) type Answers = Vec<Option<bool>>;

/// How often each comparison came out as no and as yes.
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

    /// No point yet.
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

    /// How often the side was taken that was taken least of these.
    pub(super) fn rarest(&self, answers: &Answers) -> usize {
        let taken = |(counts, answer): (&[usize; 2], &Option<bool>)| answer.map(|answer| counts[usize::from(answer)]);
        self.0.iter().zip(answers).filter_map(taken).min().unwrap_or(usize::MAX)
    }

    /// Whether a side of the k-th comparison was taken.
    pub(super) fn has(&self, k: usize, answer: bool) -> bool {
        self.0[k][usize::from(answer)] > 0
    }

    /// Whether every side was.
    pub(super) fn is_full(&self) -> bool {
        self.0.iter().flatten().all(|&count| count > 0)
    }
}

/// So many points at least take each side, if there are so many.
const LEAST: usize = 2;

/// So many of these points, spread over the sides of the comparisons: one after another the first one that takes a side which
/// few have taken; where there is none, the first one.
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
