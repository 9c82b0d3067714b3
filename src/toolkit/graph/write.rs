//! Writes sums and products into a graph, simplified for 0, 1 and −1, and derivatives made of them.

use super::node::{Binary, Graph, Node, Op, Unary};
use super::recorder::extended;
use super::traced::Traced;
use crate::number::scalar::sign;

impl Graph {
    /// A constant.
    pub(crate) fn number(&mut self, value: f64) -> Node {
        self.enter(Op::Number(value.to_bits()))
    }

    pub(crate) fn unary(&mut self, function: Unary, x: Node) -> Node {
        self.enter(Op::Unary(function, x))
    }

    pub(crate) fn binary(&mut self, operation: Binary, x: Node, y: Node) -> Node {
        self.enter(Op::Binary(operation, x, y))
    }

    /// −x
    pub(crate) fn negative(&mut self, x: Node) -> Node {
        if self.is(x, 0.0) { x } else { self.unary(Unary::Negative, x) }
    }

    /// x + y
    pub(crate) fn sum(&mut self, x: Node, y: Node) -> Node {
        match (self.is(x, 0.0), self.is(y, 0.0)) {
            (true, _) => y,
            (_, true) => x,
            _ => self.binary(Binary::Add, x, y),
        }
    }

    /// x − y
    pub(crate) fn difference(&mut self, x: Node, y: Node) -> Node {
        match (self.is(x, 0.0), self.is(y, 0.0)) {
            (_, true) => x,
            (true, _) => self.negative(y),
            _ => self.binary(Binary::Subtract, x, y),
        }
    }

    /// x y
    pub(crate) fn product(&mut self, x: Node, y: Node) -> Node {
        if self.is(x, 0.0) || self.is(y, 1.0) {
            x
        } else if self.is(y, 0.0) || self.is(x, 1.0) {
            y
        } else if self.is(x, -1.0) {
            self.negative(y)
        } else {
            self.binary(Binary::Multiply, x, y)
        }
    }

    /// x / y
    pub(crate) fn quotient(&mut self, x: Node, y: Node) -> Node {
        self.binary(Binary::Divide, x, y)
    }

    /// 1, 0 or −1
    pub(crate) fn sign(&mut self, x: Node) -> Node {
        extended(self, || sign(Traced::at(x)).node())
    }

    fn is(&self, node: Node, value: f64) -> bool {
        self.constant(node).is_some_and(|constant| constant.to_bits() == value.to_bits())
    }

    /// The derivative of a result with respect to another one, an input or an intermediate result.
    pub(crate) fn derivative(&mut self, of: Node, by: Node) -> Node {
        let (zero, one) = (self.number(0.0), self.number(1.0));
        let all: Vec<_> = (0..self.ops().len()).map(|place| Traced::at(Node::at(place))).collect();
        let mut slopes = vec![zero; all.len()];
        for node in self.needed(&[of]) {
            slopes[node.index()] = if node == by { one } else { self.slope(node, &slopes, &all, zero) };
        }
        slopes[of.index()]
    }

    /// The derivative of a result, from those of its operands.
    fn slope(&mut self, node: Node, slopes: &[Node], all: &[Traced], zero: Node) -> Node {
        let op = self.op(node).clone();
        let operands = op.operands();
        if operands.iter().all(|operand| slopes[operand.index()] == zero) {
            return zero;
        }
        if let Op::Select(condition, x, y) = op {
            let [x, y] = [x, y].map(|side| slopes[side.index()]);
            return if x == y { x } else { self.enter(Op::Select(condition, x, y)) };
        }
        let by =
            extended(self, || op.derivatives(all[node.index()], all).into_iter().map(Traced::node).collect::<Vec<_>>());
        operands.iter().zip(by).fold(zero, |sum, (operand, by)| {
            let term = self.product(by, slopes[operand.index()]);
            self.sum(sum, term)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// For every operation that has a derivative, its symbolic form agrees with the numeric one.
    #[test]
    fn a_derivative_can_be_written() {
        let mut graph = Graph::default();
        let [x, y] = [0, 1].map(|k| graph.enter(Op::Input(k)));
        let less = graph.enter(Op::Compare(super::super::Relation::Less, x, y));
        let unary = [
            Unary::Negative,
            Unary::Absolute,
            Unary::Root,
            Unary::Sine,
            Unary::Cosine,
            Unary::ArcSine,
            Unary::Exponential,
            Unary::ExponentialMinusOne,
            Unary::PowerOfTwo,
            Unary::NearestInteger,
        ]
        .map(|function| Op::Unary(function, x));
        let binary = [Binary::Add, Binary::Subtract, Binary::Multiply, Binary::Divide, Binary::Angle, Binary::Maximum];
        let binary = binary.map(|operation| Op::Binary(operation, x, y));
        let others = [
            Op::MultiplyAdd(x, y, x),
            Op::Norm([x, y, x].into()),
            Op::ExactSum([[x, y, y, y], [x, x, x, y]].into()),
            Op::Select(less, x, y),
        ];
        for op in unary.into_iter().chain(binary).chain(others) {
            let of = graph.enter(op.clone());
            let written = [x, y].map(|by| graph.derivative(of, by));
            for inputs in [[0.25, 0.5], [0.5, 0.25], [0.5, -2.0]] {
                let all = graph.results(&inputs, (0..graph.ops().len()).map(Node::at));
                let gradient = graph.gradient(of, &graph.needed(&[of]), &all, 2);
                let found = written.map(|node| all[node.index()]);
                let is_near = |(found, expected): (&f64, &f64)| (found - expected).abs() <= 1e-15 * expected.abs();
                assert!(found.iter().zip(&gradient).all(is_near), "{op:?} at {inputs:?}: {found:?}, not {gradient:?}");
            }
        }
    }

    #[test]
    fn what_is_idle_is_not_written() {
        let mut graph = Graph::default();
        let x = graph.enter(Op::Input(0));
        let [zero, one] = [0.0, 1.0].map(|value| graph.number(value));
        let sums = [graph.sum(x, zero), graph.sum(zero, x), graph.difference(x, zero)];
        let products = [graph.product(x, one), graph.product(one, x)];
        let nothing = [graph.product(x, zero), graph.product(zero, x), graph.negative(zero)];
        assert_eq!((sums, products, nothing), ([x; 3], [x; 2], [zero; 3]));
        let falling = graph.difference(zero, x);
        assert_eq!(*graph.op(falling), Op::Unary(Unary::Negative, x));
    }
}
