//! How often each outcome of each comparison of a formula occurred at the points of an audit.

use super::words::Words;
use crate::toolkit::graph::Graph;
use crate::toolkit::verify::branches::Branches;
use serde::{Deserialize, Serialize};

/// The comparisons of value and Jacobian, and the outcomes that occurred at no point.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Coverage {
    /// The number of comparisons.
    pub comparisons: usize,
    /// The total number of evaluations of comparisons.
    pub asked: usize,
    /// The number of points with the rarest outcome, among outcomes that occurred at all.
    pub least: usize,
    /// The outcomes that never occurred, in words.
    pub never: Vec<String>,
}

/// A comparison of value and Jacobian, and how often it was false and true.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Comparison {
    /// The comparison in words.
    pub words: String,
    /// How often it was false, and how often true.
    pub counts: [usize; 2],
}

impl Coverage {
    /// A summary of the counts.
    pub(in crate::toolkit::verify) fn of(comparisons: &[Comparison]) -> Self {
        let never = comparisons.iter().filter_map(|Comparison { words, counts }| match counts {
            [0, 0] => Some(format!("{words}: never asked")),
            [_, 0] => Some(format!("{words}: never so")),
            [0, _] => Some(format!("{words}: never otherwise")),
            _ => None,
        });
        let counts = comparisons.iter().flat_map(|comparison| comparison.counts);
        let least = counts.clone().filter(|&count| count > 0).min().unwrap_or(0);
        Self { comparisons: comparisons.len(), asked: counts.sum(), least, never: never.collect() }
    }
}

/// Evaluates the comparisons of a graph at points.
pub(in crate::toolkit::verify) fn comparisons<'a>(
    graph: &Graph,
    names: &[String],
    points: impl Iterator<Item = &'a [f64]>,
) -> Vec<Comparison> {
    let words = Words { graph, names };
    let branches = Branches::of(graph);
    let mut tally = branches.tally();
    if !branches.comparisons.is_empty() {
        points.for_each(|point| tally.add(&branches.answers(point)));
    }
    let comparison = |(&node, counts)| Comparison { words: words.of(node), counts };
    branches.comparisons.iter().zip(tally.0).map(comparison).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toolkit::graph::Relation;

    #[test]
    fn the_least_count_is_of_a_side_that_is_taken() {
        let taken = |words: &str, counts| Comparison { words: words.to_owned(), counts };
        let coverage = Coverage::of(&[taken("x < y", [3, 7]), taken("x = 0", [5, 0]), taken("y = 0", [0, 9])]);
        assert_eq!((coverage.comparisons, coverage.asked, coverage.least), (3, 24, 3));
        assert_eq!(coverage.never, ["x = 0: never so", "y = 0: never otherwise"]);
        assert_eq!(Coverage::of(&[]), Coverage::default());
        let alone = Coverage::of(&[taken("x < y", [0, 0])]);
        assert_eq!((alone.asked, alone.least, alone.never), (0, 0, vec!["x < y: never asked".to_owned()]));
    }

    /// x < y, and otherwise y < 0.
    #[test]
    fn a_comparison_is_counted_at_points_that_come_to_it() {
        let mut graph = Graph::default();
        let [x, y] = graph.inputs();
        let zero = graph.number(0.0);
        let [first, second] = [(x, y), (y, zero)].map(|(a, b)| graph.compare(Relation::Less, a, b));
        let inner = graph.select(second, x, zero);
        graph.value = vec![graph.select(first, y, inner)];
        let names = ["x", "y"].map(str::to_owned);
        let points: [&[f64]; 4] = [&[1.0, 2.0], &[3.0, 2.0], &[3.0, -2.0], &[4.0, 2.0]];
        let counted = comparisons(&graph, &names, points.into_iter());
        let shown: Vec<_> = counted.iter().map(|counted| (counted.words.as_str(), counted.counts)).collect();
        assert_eq!(shown, [("x < y", [3, 1]), ("y < 0", [2, 1])]);
        assert_eq!(comparisons(&Graph::default(), &names, points.into_iter()), []);
    }
}
