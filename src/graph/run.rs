//! The operations of a graph, done in `f64`.

use super::node::{Binary, Graph, Node, Op, Relation, Unary};
use crate::eft::exact_sum;
use crate::power::power_of_two_below;
use crate::scalar::norm;

impl Relation {
    /// Whether it holds.
    pub fn holds(self, x: f64, y: f64) -> bool {
        match self {
            Self::Less => x < y,
            Self::LessOrEqual => x <= y,
            Self::Equal => x == y,
        }
    }
}

impl Unary {
    /// The function.
    pub fn of(self, x: f64) -> f64 {
        match self {
            Self::Negative => -x,
            Self::Absolute => x.abs(),
            Self::Root => x.sqrt(),
            Self::Sine => x.sin(),
            Self::Cosine => x.cos(),
            Self::ArcSine => x.asin(),
            Self::Exponential => x.exp(),
            Self::ExponentialMinusOne => x.exp_m1(),
            Self::PowerOfTwo => power_of_two_below(x)[0],
        }
    }
}

impl Binary {
    /// The operation.
    pub fn of(self, x: f64, y: f64) -> f64 {
        match self {
            Self::Add => x + y,
            Self::Subtract => x - y,
            Self::Multiply => x * y,
            Self::Divide => x / y,
            Self::Angle => x.atan2(y),
            Self::Maximum => x.max(y),
        }
    }
}

impl Graph {
    /// Value and Jacobian at the components of inputs, with the bits of the formula in `f64`.
    ///
    /// # Panics
    /// If there are fewer components than the formula has.
    pub fn run(&self, inputs: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut all: Vec<f64> = Vec::with_capacity(self.ops().len());
        for op in self.ops() {
            let at = |node: Node| all[node.index()];
            all.push(match op {
                Op::Input(k) => inputs[*k],
                Op::Number(bits) => f64::from_bits(*bits),
                Op::Unary(function, x) => function.of(at(*x)),
                Op::Binary(operation, x, y) => operation.of(at(*x), at(*y)),
                Op::MultiplyAdd(x, y, z) => at(*x).mul_add(at(*y), at(*z)),
                Op::Norm(parts) => norm_of(&parts.iter().map(|&part| at(part)).collect::<Vec<_>>()),
                Op::ExactSum(products) => exact_sum(products.iter().map(|product| product.map(at))),
                Op::Search(search, numbers) => (search.find)(&numbers.iter().map(|&node| at(node)).collect::<Vec<_>>()),
                Op::Compare(relation, x, y) => f64::from(u8::from(relation.holds(at(*x), at(*y)))),
                Op::Select(condition, x, y) => at(if at(*condition) == 1.0 { *x } else { *y }),
            });
        }
        let results = |nodes: &[Node]| nodes.iter().map(|node| all[node.index()]).collect();
        (results(&self.value), results(&self.jacobian))
    }
}

/// The length of a vector of two to four components; formulas have no others.
fn norm_of(parts: &[f64]) -> f64 {
    match *parts {
        [x, y] => norm([x, y]),
        [x, y, z] => norm([x, y, z]),
        [x, y, z, w] => norm([x, y, z, w]),
        _ => unreachable!("vectors of two to four components are recorded"),
    }
}
