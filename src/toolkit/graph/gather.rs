//! Work that is shared by several choices, and by nothing else, is done only if one of them needs it.

use super::node::{Graph, Node, Op};
use super::program::Layout;
use std::collections::{BTreeSet, HashMap, HashSet};

/// The number of shared operations that justifies a common condition.
const WORTH: usize = 16;

impl Graph {
    /// Puts choices whose yes-branches share much work behind a common condition, the disjunction of theirs.
    ///
    /// `c ? a : b` becomes `(c or d) ? (c ? a : b) : b`, and so does the choice by `d`; work that only `a` and its
    /// counterpart need then belongs to one branch.
    #[must_use]
    pub(super) fn gathered(&self) -> Self {
        let results = [self.value.as_slice(), &self.jacobian].concat();
        let layout = Layout::placed(self, &results);
        let groups = groups(&layout, &results);
        let group_of: HashMap<_, _> =
            groups.iter().flat_map(|group| group.selects().map(move |s| (s, group))).collect();
        if group_of.is_empty() {
            return self.clone();
        }
        let mut gathered = Self::default();
        let mut places: Vec<Node> = Vec::with_capacity(self.ops().len());
        for (index, op) in self.ops().iter().enumerate() {
            let operands: Vec<_> = op.operands().iter().map(|node| places[node.index()]).collect();
            let mut node = gathered.enter(op.with_operands(&operands));
            if let (Some(group), Op::Select(_, _, no)) = (group_of.get(&Node::at(index)), op) {
                let conditions = group.conditions.iter().map(|condition| places[condition.index()]);
                let any = conditions.reduce(|any, condition| gathered.enter(Op::either(any, condition)));
                let any = any.expect("a group has conditions");
                node = gathered.enter(Op::Select(any, node, places[no.index()]));
            }
            places.push(node);
        }
        gathered.with_results_of(self, |node| places[node.index()])
    }
}

/// Choices that share work.
struct Group<'a> {
    conditions: BTreeSet<Node>,
    selects: Vec<&'a [Node]>,
}

impl Group<'_> {
    fn selects(&self) -> impl Iterator<Item = Node> {
        self.selects.iter().flat_map(|selects| selects.iter().copied())
    }
}

fn groups<'a>(layout: &'a Layout, results: &[Node]) -> Vec<Group<'a>> {
    let group = |set: BTreeSet<usize>| {
        let choices: Vec<_> = set.into_iter().map(|choice| &layout.choices[choice]).collect();
        let conditions: BTreeSet<_> = choices.iter().map(|choice| choice.condition).collect();
        let selects: Vec<_> = choices.iter().map(|choice| choice.selects.as_slice()).collect();
        // All conditions must be computed before any of these results.
        let first = selects.iter().copied().flatten().min()?;
        conditions.iter().all(|condition| condition < first).then_some(Group { conditions, selects })
    };
    sharing(layout, results).into_iter().filter_map(group).collect()
}

/// Sets of outermost choices whose yes-branches share much work and whose no-branches are empty.
fn sharing(layout: &Layout, results: &[Node]) -> Vec<BTreeSet<usize>> {
    let outer: Vec<_> = (0..layout.choices.len()).filter(|&choice| layout.choices[choice].block == 0).collect();
    // A choice may itself be part of the work that others share.
    let uses = Uses::of(layout, results, &outer);
    let is_shared = |select: &Node| uses.at[select.index()].as_ref().is_some_and(|use_| !use_.is_empty());
    let (shared, outer): (Vec<_>, Vec<_>) =
        outer.into_iter().partition(|&choice| layout.choices[choice].selects.iter().all(is_shared));
    let busy: HashSet<_> = layout.place.iter().flatten().map(|&block| layout.outermost(block)).collect();
    let outer: BTreeSet<_> =
        outer.into_iter().filter(|&choice| !busy.contains(&layout.choices[choice].sides[1])).collect();
    let uses = Uses::of(layout, results, &shared.into_iter().chain(outer.iter().copied()).collect::<Vec<_>>());
    let mut sets: Vec<(BTreeSet<usize>, usize)> = Vec::new();
    for choices in uses.shared() {
        let (meeting, mut rest): (Vec<_>, _) = sets.into_iter().partition(|(set, _)| !set.is_disjoint(choices));
        let count = meeting.iter().map(|(_, count)| count).sum::<usize>() + 1;
        rest.push((meeting.into_iter().flat_map(|(set, _)| set).chain(choices.iter().copied()).collect(), count));
        sets = rest;
    }
    let sets = sets.into_iter().filter(|(_, count)| *count >= WORTH);
    sets.map(|(set, _)| set.intersection(&outer).copied().collect()).filter(|set: &BTreeSet<_>| set.len() > 1).collect()
}

/// For every operation, the choices within whose branches alone it is used; empty if it is used elsewhere too.
struct Uses<'a> {
    layout: &'a Layout<'a>,
    at: Vec<Option<BTreeSet<usize>>>,
}

impl<'a> Uses<'a> {
    /// Branches of other choices count as elsewhere.
    fn of(layout: &'a Layout, results: &[Node], choices: &[usize]) -> Self {
        let sides = choices.iter().flat_map(|&choice| layout.choices[choice].sides.map(|side| (side, choice)));
        let sides: HashMap<_, _> = sides.collect();
        let within = |block: usize| sides.get(&layout.outermost(block)).into_iter().copied().collect::<BTreeSet<_>>();
        let mut at: Vec<Option<BTreeSet<usize>>> = vec![None; layout.graph.ops().len()];
        for node in results {
            at[node.index()] = Some(BTreeSet::new());
        }
        for index in (0..at.len()).rev() {
            let (node, Some(block)) = (Node::at(index), layout.place[index]) else { continue };
            let own = if block == 0 { at[index].clone().unwrap_or_default() } else { within(block) };
            for (k, operand) in layout.graph.op(node).operands().into_iter().enumerate() {
                let here = match layout.choice_of.get(&node) {
                    Some(&choice) if k > 0 && own.is_empty() => within(layout.choices[choice].sides[k - 1]),
                    _ => own.clone(),
                };
                let known = &mut at[operand.index()];
                *known = Some(match known.take() {
                    None => here,
                    Some(known) if known.is_empty() || here.is_empty() => BTreeSet::new(),
                    Some(known) => known.union(&here).copied().collect(),
                });
            }
        }
        Self { layout, at }
    }

    /// For each operation outside all choices that only several choices need, the set of those choices.
    fn shared(&self) -> impl Iterator<Item = &BTreeSet<usize>> {
        let is_before =
            |index: usize| self.layout.place[index] == Some(0) && !self.layout.graph.is_atom(Node::at(index));
        let uses = self.at.iter().enumerate().filter(move |(index, _)| is_before(*index));
        uses.filter_map(|(_, choices)| choices.as_ref()).filter(|choices| choices.len() > 1)
    }
}
