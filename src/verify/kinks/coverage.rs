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

/// Runs a graph at points.
pub(in crate::verify) fn coverage<'a>(
    graph: &Graph,
    names: &[String],
    points: impl Iterator<Item = &'a [f64]>,
) -> Coverage {
    let words = Words { graph, names };
    let results = [graph.value.as_slice(), &graph.jacobian].concat();
    let nodes = graph.needed(&results);
    let is_comparison = |op: &Op| matches!(op, Op::Compare(..));
    let comparisons: Vec<_> = nodes.iter().copied().filter(|&node| is_comparison(graph.op(node))).collect();
    if comparisons.is_empty() {
        return Coverage::default();
    }
    let mut counts = vec![[0_usize; 2]; comparisons.len()];
    for point in points {
        let all = graph.results(point, nodes.iter().copied());
        let live = graph.live(&results, &all);
        for (count, node) in counts.iter_mut().zip(&comparisons).filter(|(_, node)| live[node.index()]) {
            count[usize::from(all[node.index()] == 1.0)] += 1;
        }
    }
    let never = comparisons.iter().zip(&counts).filter_map(|(&node, count)| match count {
        [0, 0] => Some(format!("{}: never asked", words.of(node))),
        [_, 0] => Some(format!("{}: never so", words.of(node))),
        [0, _] => Some(format!("{}: never otherwise", words.of(node))),
        _ => None,
    });
    let never = never.collect();
    Coverage { comparisons: comparisons.len(), asked: counts.iter().flatten().sum(), never }
}
