//! What an element does alike at each of its slave nodes: operations that are written once, and called for each of them.
//!
//! They are found in the recorded operations: those for the first slave node and those for another one are followed from the
//! results back to the inputs, side by side, as long as they are the same and belong to that slave node alone. No bit changes.

use jointproof::formula::Field;
use jointproof::toolkit::graph::{Binary, Graph, Node, Op};
use jointproof::toolkit::verify::Layout;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::ops::Range;

/// The operations at the first slave node, and what stands for them at each.
#[derive(Clone, Debug)]
pub(super) struct Repeated {
    /// What they take in addition to inputs, in order.
    pub(super) given: Vec<Node>,
    /// Their results that others need, in order.
    pub(super) found: Vec<Node>,
    /// The slave nodes; the first one stands for itself.
    pub(super) at: Vec<Place>,
}

/// A slave node.
#[derive(Clone, Debug)]
pub(super) struct Place {
    /// What stands here for an operation at the first slave node, and for an input there.
    pub(super) nodes: HashMap<Node, Node>,
    /// The component of the inputs that stands for each one.
    pub(super) inputs: Vec<usize>,
}

impl Repeated {
    /// None if the element has one slave node, or if not all of them do the same.
    pub(super) fn of(graph: &Graph, layout: &Layout, inputs: &[Field]) -> Option<Self> {
        if layout.slaves < 2 {
            return None;
        }
        let slaves: Vec<_> = (0..layout.slaves).map(|slave| Slave::new(layout, inputs, slave)).collect();
        let first = &slaves[0];
        let mut pairs = Pairs::new(graph, &slaves);
        for (k, is_own) in first.own_results.iter().enumerate() {
            if *is_own {
                pairs.follow(slaves.iter().map(|slave| graph.value[slave.results[k]]).collect())?;
            }
        }
        pairs.follow_terms()?;
        pairs.finished(&slaves)
    }
}

/// A slave node in the lists of inputs and results.
struct Slave {
    /// Where inputs and results are that take the place of those of the first slave node; that one takes their place.
    inputs: Vec<usize>,
    results: Vec<usize>,
    /// The inputs that concern no other slave node: those of its segment, and its state.
    own_inputs: HashSet<usize>,
    /// The inputs that are fields of their own; others are components of one that is of all slave nodes.
    whole: Range<usize>,
    /// The results that concern no other slave node: forces, their derivatives, and its state.
    own_results: Vec<bool>,
}

impl Slave {
    fn new(layout: &Layout, inputs: &[Field], slave: usize) -> Self {
        let count = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
        let all: usize = count(inputs);
        let (nodes, slaves) = (count(layout.nodes), layout.slaves);
        let (width, segment) = (nodes / layout.nodes.len(), layout.nodes.len() / slaves - 1);
        let exchanged = |one: usize| match one {
            0 => slave,
            one if one == slave => 0,
            one => one,
        };
        // The slave node to which a node belongs, and the other node.
        let owner = |node: usize| if node < slaves { node } else { (node - slaves) / segment };
        let other = |node: usize| {
            if node < slaves {
                exchanged(node)
            } else {
                slaves + exchanged(owner(node)) * segment + (node - slaves) % segment
            }
        };
        let degree = |k: usize| if k < nodes { other(k / width) * width + k % width } else { k };
        let state = |k: usize| k - k % slaves + exchanged(k % slaves);
        let first_state = all - if all > nodes + count(layout.start) { count(layout.state) } else { 0 };
        let input = |k: usize| if k < first_state { degree(k) } else { first_state + state(k - first_state) };
        let own_inputs = |k: &usize| {
            (slaves * width..nodes).contains(k) && owner(k / width) == slave
                || *k >= first_state && (k - first_state) % slaves == slave
        };
        let (reported, mut results, mut own_results) = (count(layout.residuals), Vec::new(), Vec::new());
        let mut add = |place: usize, is_own: bool| {
            results.push(place);
            own_results.push(is_own);
        };
        let is_own = |k: usize| owner(k / width) == slave;
        (0..reported).for_each(|k| add(k, false));
        let mut first = reported;
        (0..reported * nodes).for_each(|k| add(first + k - k % nodes + degree(k % nodes), false));
        first += reported * nodes;
        (0..nodes).for_each(|k| add(first + degree(k), is_own(k)));
        first += nodes;
        (0..nodes * nodes).for_each(|k| add(first + degree(k / nodes) * nodes + degree(k % nodes), is_own(k / nodes)));
        first += nodes * nodes;
        (0..all - first_state).for_each(|k| add(first + state(k), k % slaves == slave));
        Self {
            inputs: (0..all).map(input).collect(),
            results,
            own_inputs: (0..all).filter(own_inputs).collect(),
            whole: 0..first_state,
            own_results,
        }
    }
}

/// The operations at all slave nodes, followed side by side.
struct Pairs<'a> {
    graph: &'a Graph,
    slaves: &'a [Slave],
    /// For every slave node, whether an operation depends on what is its own.
    own: Vec<Vec<bool>>,
    /// What stands for an operation at the first slave node.
    there: HashMap<Node, Vec<Node>>,
    repeated: BTreeSet<Node>,
    given: BTreeSet<Node>,
    /// Sums that have a term less at some slave nodes.
    sums: Vec<Vec<Node>>,
}

impl<'a> Pairs<'a> {
    fn new(graph: &'a Graph, slaves: &'a [Slave]) -> Self {
        let own = slaves.iter().map(|slave| {
            let mut own: Vec<bool> = Vec::with_capacity(graph.ops().len());
            for op in graph.ops() {
                own.push(match op {
                    Op::Input(k) => slave.own_inputs.contains(k),
                    op => op.operands().iter().any(|node| own[node.index()]),
                });
            }
            own
        });
        let own = own.collect();
        Self {
            graph,
            slaves,
            own,
            there: HashMap::new(),
            repeated: BTreeSet::new(),
            given: BTreeSet::new(),
            sums: Vec::new(),
        }
    }

    /// Follows operations, one at each slave node, back to the inputs; none if one of them would stand for two others.
    fn follow(&mut self, nodes: Vec<Node>) -> Option<()> {
        let mut open = vec![nodes];
        while let Some(nodes) = open.pop() {
            let first = nodes[0];
            if let Some(known) = self.there.get(&first) {
                if *known == nodes {
                    continue;
                }
                return None;
            }
            let is_same = nodes.iter().all(|&node| node == first);
            match self.graph.op(first) {
                Op::Number(_) if is_same => {}
                Op::Number(_) => return None,
                Op::Input(k) if self.is_passed(*k, &nodes) => {}
                _ if self.is_repeated(&nodes) => {
                    self.repeated.insert(first);
                    let operands: Vec<_> = nodes.iter().map(|&node| self.graph.op(node).operands()).collect();
                    open.extend((0..operands[0].len()).map(|k| operands.iter().map(|of| of[k]).collect()));
                }
                _ if self.lacks_a_term(&nodes) => {
                    let rest = nodes.iter().map(|&node| self.sum(node).map_or(node, |[rest, _]| rest));
                    open.push(rest.collect());
                    self.repeated.insert(first);
                    self.sums.push(nodes.clone());
                }
                _ => _ = self.given.insert(first),
            }
            self.there.insert(first, nodes);
        }
        Some(())
    }

    /// Whether inputs are those that stand for the one of the first slave node.
    fn is_passed(&self, k: usize, nodes: &[Node]) -> bool {
        let mut all = self.slaves.iter().zip(nodes);
        all.all(|(slave, node)| slave.whole.contains(&k) && *self.graph.op(*node) == Op::Input(slave.inputs[k]))
    }

    /// Whether each is the same operation and concerns what is the slave node's own.
    fn is_repeated(&self, nodes: &[Node]) -> bool {
        let first = self.graph.op(nodes[0]);
        nodes.iter().zip(&self.own).all(|(node, own)| {
            let (op, operands) = (self.graph.op(*node), self.graph.op(*node).operands());
            own[node.index()] && operands.len() == first.operands().len() && first.on(&operands) == *op
        })
    }

    /// The terms of a sum.
    fn sum(&self, node: Node) -> Option<[Node; 2]> {
        match *self.graph.op(node) {
            Op::Binary(Binary::Add, x, y) => Some([x, y]),
            _ => None,
        }
    }

    /// Whether they are sums whose last term is a multiple of something given, or, where that is always 0, the sum without it.
    fn lacks_a_term(&self, nodes: &[Node]) -> bool {
        let has_term =
            |slave: usize, node: Node| self.sum(node).is_some_and(|[_, term]| self.multiple(slave, term).is_some());
        let is_own = nodes.iter().zip(&self.own).all(|(node, own)| own[node.index()]);
        is_own && has_term(0, nodes[0]) && nodes.iter().enumerate().any(|(slave, node)| !has_term(slave, *node))
    }

    /// A product of something given and something of this slave node's own.
    fn multiple(&self, slave: usize, node: Node) -> Option<[Node; 2]> {
        let is_own = |node: Node| self.own[slave][node.index()];
        match *self.graph.op(node) {
            Op::Binary(Binary::Multiply, x, y) if !is_own(x) && is_own(y) => Some([x, y]),
            _ => None,
        }
    }

    /// The terms that are always 0 at some slave nodes are computed there, too, from a 0 that is given.
    fn follow_terms(&mut self) -> Option<()> {
        let is_zero = |node: &Node| self.graph.constant(*node).is_some_and(|x| x.to_bits() == 0);
        let zero = self.graph.needed(&self.graph.value).into_iter().find(is_zero);
        for nodes in std::mem::take(&mut self.sums) {
            let [_, term] = self.sum(nodes[0])?;
            let [factor, own] = self.multiple(0, term)?;
            let there = self.there.get(&own)?.clone();
            let mut factors = Vec::new();
            for (slave, &node) in nodes.iter().enumerate() {
                match self.sum(node).and_then(|[_, term]| self.multiple(slave, term)) {
                    Some([factor, own]) if own == there[slave] => factors.push(factor),
                    Some(_) => return None,
                    None => factors.push(zero?),
                }
            }
            if self.there.get(&factor).is_some_and(|known| *known != factors) {
                return None;
            }
            self.given.insert(factor);
            self.repeated.insert(term);
            self.there.insert(factor, factors);
        }
        Some(())
    }

    /// With what others need: the results of the element, and what is used for other results.
    fn finished(self, slaves: &[Slave]) -> Option<Repeated> {
        let mut of = HashMap::new();
        for first in &self.repeated {
            // A term of a sum is at no other place.
            self.there.get(first).into_iter().flatten().for_each(|node| _ = of.insert(*node, *first));
        }
        let (mut found, mut seen) = (BTreeSet::new(), HashSet::new());
        let mut open: Vec<_> = self.graph.refusal.iter().chain(&self.graph.value).copied().collect();
        while let Some(node) = open.pop() {
            if let Some(first) = of.get(&node) {
                found.insert(*first);
            } else if seen.insert(node) {
                open.extend(self.graph.op(node).operands());
            }
        }
        let at = |(k, slave): (usize, &Slave)| Place {
            nodes: self.there.iter().map(|(first, nodes)| (*first, nodes[k])).collect(),
            inputs: slave.inputs.clone(),
        };
        let at = slaves.iter().enumerate().map(at).collect();
        (!found.is_empty()).then(|| Repeated {
            given: self.given.into_iter().collect(),
            found: found.into_iter().collect(),
            at,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::recorded::{Recorded, Subject, element_of};
    use jointproof::toolkit::graph::{Instead, Unary};

    fn repeated(one: &Recorded, graph: &Graph) -> Option<Repeated> {
        let Subject::Element(element, _) = one.subject else { panic!("it is an element") };
        Repeated::of(graph, &element.layout(), one.inputs())
    }

    /// The operations on the way to what is found that each slave node has for its own.
    fn inside(graph: &Graph, Repeated { given, found, .. }: &Repeated) -> Vec<Node> {
        let (mut inside, mut open) = (BTreeSet::new(), found.clone());
        while let Some(node) = open.pop() {
            if !graph.is_atom(node) && !given.contains(&node) && inside.insert(node) {
                open.extend(graph.op(node).operands());
            }
        }
        inside.into_iter().collect()
    }

    #[test]
    fn each_slave_node_has_the_same_operations_and_most_of_them_are_repeated() {
        for (id, slaves) in [("isl21a_linear", 2), ("isl21a_exponential", 2), ("isl22a_linear", 3)] {
            for one in element_of(id) {
                let graph = &one.graph;
                let repeated = one.repeated.as_ref().unwrap_or_else(|| panic!("{}: nothing is repeated", one.subject));
                assert_eq!(repeated.at.len(), slaves);
                let inside = inside(graph, repeated);
                let all = graph.needed(&graph.value).iter().filter(|node| !graph.is_atom(**node)).count();
                assert!(slaves * inside.len() > all / 2, "{}: {} of {all}", one.subject, inside.len());
                let mut lacking = BTreeSet::new();
                for (node, at) in inside.iter().flat_map(|node| repeated.at.iter().map(move |at| (node, at))) {
                    // A term that is left out where it is 0 has no node, and the sum is the rest of it.
                    let there: Option<Vec<_>> =
                        graph.op(*node).operands().iter().map(|node| at.nodes.get(node).copied()).collect();
                    let same = there.map(|there| graph.op(*node).on(&there));
                    if same.as_ref() != at.nodes.get(node).map(|there| graph.op(*there)) {
                        lacking.insert(*node);
                    }
                }
                let is_known = |node: &Node| matches!(graph.op(*node), Op::Binary(Binary::Add | Binary::Multiply, ..));
                assert!(lacking.iter().all(is_known), "{}: {lacking:?}", one.subject);
                assert!(20 * lacking.len() < inside.len(), "{}: {lacking:?}", one.subject);
            }
        }
    }

    #[test]
    fn what_one_slave_node_does_in_another_way_is_not_repeated() {
        let one = &element_of("isl21a_linear")[0];
        let known = one.repeated.as_ref().unwrap();
        let before = inside(&one.graph, known).len();
        for first in &known.found {
            let there = known.at[1].nodes[first];
            let operand = one.graph.op(there).operands()[0];
            let other = one.graph.altered(there, &Instead::Op(Op::Unary(Unary::Sine, operand)));
            let after = repeated(one, &other).map_or(0, |repeated| inside(&other, &repeated).len());
            assert!(after < before, "{first:?}: {after} of {before}");
        }
        // A connector has no slave nodes.
        assert!(element_of("hinge").iter().all(|one| one.repeated.is_none()));
    }
}
