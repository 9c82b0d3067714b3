//! How far inputs are from a point where a divisor vanishes.

use super::node::{Binary, Graph, Node, Op, Unary};

impl Graph {
    /// The operations among these that have no derivative where some numbers vanish together, each with these numbers: divisors,
    /// roots, lengths and angles.
    pub fn singular(&self, needed: &[Node]) -> Vec<(Node, Vec<Node>)> {
        let vanishing = |node: &Node| match self.op(*node) {
            Op::Binary(Binary::Divide, _, x) | Op::Unary(Unary::Root, x) => vec![*x],
            Op::Binary(Binary::Angle, y, x) => vec![*y, *x],
            Op::Norm(parts) => parts.to_vec(),
            _ => Vec::new(),
        };
        let with_numbers = |node: &Node| (*node, vanishing(node));
        needed.iter().map(with_numbers).filter(|(_, numbers)| !numbers.is_empty()).collect()
    }

    /// The relative change of the inputs by which, to first order, one of the divisors on the way that is taken can vanish.
    ///
    /// # Panics
    /// If there are fewer inputs than the formula has.
    pub fn distance_from_singular(&self, inputs: &[f64]) -> f64 {
        let all = self.results(inputs, (0..self.ops().len()).map(Node::at));
        let results = [self.value.as_slice(), &self.jacobian].concat();
        let live = self.live(&results, &all);
        let needed: Vec<_> = (0..live.len()).filter(|&k| live[k]).map(Node::at).collect();
        let mut least = f64::INFINITY;
        for (_, numbers) in self.singular(&needed) {
            let size = numbers.iter().fold(0.0, |most: f64, node| most.max(all[node.index()].abs()));
            let change = |node: &Node| -> f64 {
                let gradient = self.gradient(*node, &self.needed(&[*node]), &all, inputs.len());
                gradient.iter().zip(inputs).map(|(slope, x)| (slope * x).abs()).sum()
            };
            let change: f64 = numbers.iter().map(change).sum();
            if change > 0.0 {
                least = least.min(size / change);
            }
        }
        least
    }
}

#[cfg(test)]
mod tests {
    use crate::connector::slider::Line;
    use crate::toolkit::graph::record;

    /// The length of a line of 1e-3 between nodes at 1 vanishes if both move by half of it, which is 5e-4 of their coordinates.
    #[test]
    fn a_divisor_that_cancels_is_as_far_as_its_terms_have_to_change() {
        let graph = record::<Line>().expect("it is recorded");
        let near = graph.distance_from_singular(&[1.0, 0.0, 0.0, 1.001, 0.0, 0.0]);
        let far = graph.distance_from_singular(&[1.0, 2.0, 3.0, -1.0, -2.0, -3.0]);
        assert!((near / 5e-4 - 1.0).abs() < 1e-2 && far > 0.2, "{near} {far}");
    }
}
