//! How often each side of each comparison of a formula was taken at the points of an audit.

use super::words::Words;
use crate::graph::{Graph, Op};
use serde::{Deserialize, Serialize};

/// The comparisons of value and Jacobian, and the sides of them that no point reached.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Coverage {
    /// How many comparisons there are.
    pub comparisons: usize,
    /// How often each was asked, all together.
    pub asked: usize,
    /// What never came out so, in words.
    pub never: Vec<String>,
}

/// A comparison of value and Jacobian, and how often it came out false and true.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Comparison {
    /// It, in words.
    pub words: String,
    /// How often it was false, and how often true.
    pub counts: [usize; 2],
}

impl Coverage {
    /// What the counts say.
    pub(in crate::verify) fn of(comparisons: &[Comparison]) -> Self {
        let never = comparisons.iter().filter_map(|Comparison { words, counts }| match counts {
            [0, 0] => Some(format!("{words}: never asked")),
            [_, 0] => Some(format!("{words}: never so")),
            [0, _] => Some(format!("{words}: never otherwise")),
            _ => None,
        });
        let asked = comparisons.iter().flat_map(|comparison| comparison.counts).sum();
        Self { comparisons: comparisons.len(), asked, never: never.collect() }
    }
}

/// Runs a graph at points.
pub(in crate::verify) fn comparisons<'a>(
    graph: &Graph,
    names: &[String],
    points: impl Iterator<Item = &'a [f64]>,
) -> Vec<Comparison> {
    let words = Words { graph, names };
    let results = [graph.value.as_slice(), &graph.jacobian].concat();
    let nodes = graph.needed(&results);
    let is_comparison = |op: &Op| matches!(op, Op::Compare(..));
    let comparisons: Vec<_> = nodes.iter().copied().filter(|&node| is_comparison(graph.op(node))).collect();
    if comparisons.is_empty() {
        return Vec::new();
    }
    let mut counts = vec![[0_usize; 2]; comparisons.len()];
    for point in points {
        let all = graph.results(point, nodes.iter().copied());
        let live = graph.live(&results, &all);
        for (count, node) in counts.iter_mut().zip(&comparisons).filter(|(_, node)| live[node.index()]) {
            count[usize::from(all[node.index()] == 1.0)] += 1;
        }
    }
    comparisons.iter().zip(counts).map(|(&node, counts)| Comparison { words: words.of(node), counts }).collect()
}
