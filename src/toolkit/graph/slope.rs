//! Dependencies and derivatives of the results of a graph.

use super::node::{Binary, Graph, Node, Op, Unary};
use crate::number::scalar::{Leaf, choice, sign};

impl Graph {
    /// These results and all operations they are computed from, in order.
    pub fn needed(&self, results: &[Node]) -> Vec<Node> {
        let mut needed = vec![false; self.ops().len()];
        mark(&mut needed, results);
        for place in (0..needed.len()).rev() {
            if needed[place] {
                self.ops()[place].each_operand(|operand| needed[operand.index()] = true);
            }
        }
        (0..needed.len()).filter(|&place| needed[place]).map(Node::at).collect()
    }

    /// For each operation, whether these results depend on it at a point: operations in a branch that is not taken do
    /// not count. `all` are the results of all operations there.
    pub fn live<T: Leaf>(&self, results: &[Node], all: &[T]) -> Vec<bool> {
        let mut live = vec![false; self.ops().len()];
        mark(&mut live, results);
        for place in (0..live.len()).rev() {
            match &self.ops()[place] {
                _ if !live[place] => {}
                Op::Select(condition, x, y) => {
                    let taken = if all[condition.index()] == 1.0 { x } else { y };
                    mark(&mut live, &[*condition, *taken]);
                }
                op => op.each_operand(|operand| live[operand.index()] = true),
            }
        }
        live
    }

    /// The derivatives of a result with respect to the inputs, whose number is `inputs`. `needed` are all operations
    /// it is computed from, and `all` are the results.
    pub fn gradient<T: Leaf>(&self, of: Node, needed: &[Node], all: &[T], inputs: usize) -> Vec<T> {
        let mut slopes = vec![T::zero(); all.len()];
        let mut gradient = vec![T::zero(); inputs];
        slopes[of.index()] = T::one();
        for &node in needed.iter().rev() {
            let slope = slopes[node.index()];
            if slope.is_zero() {
                continue;
            }
            match self.op(node) {
                Op::Input(k) => gradient[*k] += slope,
                Op::Select(condition, x, y) => {
                    slopes[if all[condition.index()] == 1.0 { x.index() } else { y.index() }] += slope;
                }
                op => {
                    let by = op.derivatives(all[node.index()], all);
                    op.operands().iter().zip(by).for_each(|(node, by)| slopes[node.index()] += slope * by);
                }
            }
        }
        gradient
    }
}

fn mark(marked: &mut [bool], nodes: &[Node]) {
    for node in nodes {
        marked[node.index()] = true;
    }
}

impl Op {
    /// Its derivatives with respect to its operands, given its result.
    pub fn derivatives<T: Leaf>(&self, result: T, all: &[T]) -> Vec<T> {
        let at = |node: &Node| all[node.index()];
        let (zero, one, minus_one) = (T::zero(), T::one(), T::from(-1.0));
        match self {
            Self::Unary(function, x) => {
                let x = at(x);
                vec![match function {
                    Unary::Negative => minus_one,
                    Unary::Absolute => sign(x),
                    Unary::Root => (result * 2.0).recip(),
                    Unary::Sine => x.cos(),
                    Unary::Cosine => -x.sin(),
                    Unary::ArcSine => (one - x * x).sqrt().recip(),
                    Unary::Exponential => result,
                    Unary::ExponentialMinusOne => x.exp(),
                    Unary::PowerOfTwo | Unary::NearestInteger => zero,
                }]
            }
            Self::Binary(operation, x, y) => {
                let (x, y) = (at(x), at(y));
                match operation {
                    Binary::Add => vec![one, one],
                    Binary::Subtract => vec![one, minus_one],
                    Binary::Multiply => vec![y, x],
                    Binary::Divide => vec![y.recip(), -result / y],
                    Binary::Angle => {
                        let square = (x * x + y * y).recip();
                        vec![y * square, -x * square]
                    }
                    Binary::Maximum => choice(|| if y > x { [zero, one] } else { [one, zero] }).into(),
                }
            }
            Self::MultiplyAdd(x, y, _) => vec![at(y), at(x), one],
            Self::Norm(parts) => {
                let by = |part| choice(|| [if result.is_zero() { zero } else { at(part) / result }])[0];
                parts.iter().map(by).collect()
            }
            Self::ExactSum(products) => {
                products.iter().flat_map(|product| by_factors(product.each_ref().map(at))).collect()
            }
            // The result of a search is a constant, to which a step of Newton's method adds the derivatives.
            Self::Input(_) | Self::Number(_) | Self::Compare(..) | Self::Select(..) | Self::Search(..) => {
                vec![zero; self.operands().len()]
            }
        }
    }
}

/// The derivatives of a product with respect to its factors.
fn by_factors<T: Leaf>([a, b, c, d]: [T; 4]) -> [T; 4] {
    [b * c * d, a * c * d, a * b * d, a * b * c]
}

#[cfg(test)]
mod tests {
    use super::by_factors;

    #[test]
    fn a_product_of_four_has_four_derivatives() {
        assert_eq!(by_factors([2.0, 3.0, 5.0, 7.0]), [105.0, 70.0, 42.0, 30.0]);
    }
}
