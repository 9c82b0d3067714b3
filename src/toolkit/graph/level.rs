//! Finds choices with a common condition that can be made together.

use super::node::{Graph, Node, Op};
use std::collections::BTreeMap;

impl Graph {
    /// Levels of all operations, such that none depends on a choice of its own or a higher level, and choices with a
    /// common condition have the same level wherever none depends on another.
    pub(super) fn levels(&self) -> Vec<usize> {
        let choices = Choices::of(self);
        let mut set_of = vec![None; self.ops().len()];
        let mut levels = choices.levels(&set_of, 0).unwrap_or_default();
        let mut sets = 0;
        let are_level = |levels: &[usize], set: &[usize]| set.iter().all(|&select| levels[select] == levels[set[0]]);
        for selects in choices.by_condition().into_values().filter(|selects| selects.len() > 1) {
            if are_level(&levels, &selects) {
                continue;
            }
            for set in choices.independent(&selects) {
                if are_level(&levels, &set) {
                    continue;
                }
                mark(&mut set_of, &set, Some(sets));
                // Made together, these might form a cycle with other sets.
                match choices.levels(&set_of, sets + 1) {
                    Some(possible) => (levels, sets) = (possible, sets + 1),
                    None => mark(&mut set_of, &set, None),
                }
            }
        }
        levels
    }
}

fn mark(set_of: &mut [Option<usize>], selects: &[usize], set: Option<usize>) {
    for &select in selects {
        set_of[select] = set;
    }
}

/// The operations by index: the operands of each, and the condition of each choice.
struct Choices {
    operands: Vec<Vec<usize>>,
    conditions: Vec<Option<usize>>,
}

impl Choices {
    fn of(graph: &Graph) -> Self {
        let operands = |op: &Op| op.operands().into_iter().map(Node::index).collect();
        let condition = |op: &Op| match op {
            Op::Select(condition, ..) => Some(condition.index()),
            _ => None,
        };
        Self {
            operands: graph.ops().iter().map(operands).collect(),
            conditions: graph.ops().iter().map(condition).collect(),
        }
    }

    fn by_condition(&self) -> BTreeMap<usize, Vec<usize>> {
        let mut selects: BTreeMap<_, Vec<_>> = BTreeMap::new();
        for (select, condition) in self.conditions.iter().enumerate() {
            if let Some(condition) = condition {
                selects.entry(*condition).or_default().push(select);
            }
        }
        selects
    }

    /// The length of the longest chain of dependent choices up to each operation, if the choices of each set are made
    /// together; `None` if sets depend on each other cyclically.
    fn levels(&self, set_of: &[Option<usize>], sets: usize) -> Option<Vec<usize>> {
        let highest = self.conditions.iter().flatten().count();
        let mut of_sets = vec![0; sets];
        loop {
            let mut is_settled = true;
            let mut levels = vec![0; self.operands.len()];
            for (index, operands) in self.operands.iter().enumerate() {
                let mut level = usize::from(self.conditions[index].is_some());
                level += operands.iter().map(|&operand| levels[operand]).max().unwrap_or(0);
                if let Some(set) = set_of[index] {
                    is_settled &= level <= of_sets[set];
                    of_sets[set] = level.max(of_sets[set]);
                    level = of_sets[set];
                }
                levels[index] = level;
            }
            if is_settled {
                return Some(levels);
            }
            if of_sets.iter().any(|&level| level > highest) {
                return None;
            }
        }
    }

    /// Partitions choices into sets within which none depends on another.
    fn independent(&self, selects: &[usize]) -> Vec<Vec<usize>> {
        // The length of the longest chain of these choices that each operation depends on.
        let mut lengths = vec![0; self.operands.len()];
        let mut sets: Vec<Vec<usize>> = Vec::new();
        let mut open = selects.iter().copied().peekable();
        for (index, operands) in self.operands.iter().enumerate().take(selects.last().map_or(0, |last| last + 1)) {
            lengths[index] = operands.iter().map(|&operand| lengths[operand]).max().unwrap_or(0);
            if open.next_if_eq(&index).is_some() {
                sets.resize(sets.len().max(lengths[index] + 1), Vec::new());
                sets[lengths[index]].push(index);
                lengths[index] += 1;
            }
        }
        sets
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::toolkit::graph::Relation;

    #[test]
    fn choices_by_one_condition_are_made_together_where_none_follows_from_another() {
        let mut graph = Graph::default();
        let [x, y, z] = [0, 1, 2].map(|k| graph.enter(Op::Input(k)));
        let [first, second] = [(x, y), (y, z)].map(|(a, b)| graph.enter(Op::Compare(Relation::Less, a, b)));
        let early = graph.enter(Op::Select(first, x, y));
        let other = graph.enter(Op::Select(second, y, z));
        let late = graph.enter(Op::Select(first, other, z));
        let follows = graph.enter(Op::Select(first, early, late));
        let levels = graph.levels();
        assert_eq!([x, first, other].map(|node| levels[node.index()]), [0, 0, 1]);
        assert_eq!([early, late, follows].map(|node| levels[node.index()]), [2, 2, 3]);
    }
}
