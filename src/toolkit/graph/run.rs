//! Evaluates a graph in any number type.

use super::node::{Binary, Graph, Node, Op, Relation, Search, Unary};
use crate::Octuple;
use crate::number::scalar::{Leaf, abs, asin, atan2, e_minus_one, exp_m1, norm, pi};

/// A number in which a graph can be computed.
pub trait Number: Leaf {
    /// The result of a search from these numbers.
    fn found(search: &Search, numbers: &[Self]) -> Self;
    /// The number for which a recorded constant stands: π and e − 1 are recorded as doubles.
    fn constant(x: f64) -> Self;
}

impl Number for f64 {
    fn constant(x: f64) -> Self {
        x
    }
    fn found(search: &Search, numbers: &[Self]) -> Self {
        (search.find)(numbers)
    }
}

impl Number for Octuple {
    fn constant(x: f64) -> Self {
        let known = [(pi::<f64>(), pi::<Self>()), (e_minus_one(), e_minus_one())];
        known.into_iter().find(|(nearest, _)| *nearest == x).map_or(x.into(), |(_, exact)| exact)
    }
    fn found(search: &Search, numbers: &[Self]) -> Self {
        (search.find_exactly)(numbers)
    }
}

impl Relation {
    /// Whether the relation holds.
    pub fn holds<T: PartialOrd + Copy>(self, x: T, y: T) -> bool {
        match self {
            Self::Less => x < y,
            Self::LessOrEqual => x <= y,
            Self::Equal => x == y,
        }
    }
}

impl Unary {
    /// The value of the function.
    pub fn of<T: Leaf>(self, x: T) -> T {
        match self {
            Self::Negative => -x,
            Self::Absolute => abs(x),
            Self::Root => x.sqrt(),
            Self::Sine => x.sin(),
            Self::Cosine => x.cos(),
            Self::ArcSine => asin(x),
            Self::Exponential => x.exp(),
            Self::ExponentialMinusOne => exp_m1(x),
            Self::PowerOfTwo => x.power_of_two_below()[0],
            Self::NearestInteger => T::nearest_integer_of(x),
        }
    }
}

impl Binary {
    /// The result of the operation.
    pub fn of<T: Leaf>(self, x: T, y: T) -> T {
        match self {
            Self::Add => x + y,
            Self::Subtract => x - y,
            Self::Multiply => x * y,
            Self::Divide => x / y,
            Self::Angle => atan2(x, y),
            Self::Maximum => x.or_larger(y),
        }
    }
}

impl Graph {
    /// Value and Jacobian at the components of inputs, with the bits of the formula in `f64`.
    ///
    /// # Panics
    /// If there are fewer components than the formula has.
    pub fn run(&self, inputs: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let all = self.results(inputs, (0..self.ops().len()).map(Node::at));
        let results = |nodes: &[Node]| nodes.iter().map(|node| all[node.index()]).collect();
        (results(&self.value), results(&self.jacobian))
    }

    /// The results of these operations, which must be in order; NaN for all others. Booleans are 1 or 0.
    ///
    /// # Panics
    /// If there are fewer components than the formula has.
    pub fn results<T: Number>(&self, inputs: &[T], nodes: impl IntoIterator<Item = Node>) -> Vec<T> {
        let mut all = vec![T::from(f64::NAN); self.ops().len()];
        for node in nodes {
            all[node.index()] = self.op(node).result(inputs, &all);
        }
        all
    }
}

impl Op {
    /// The result of the operation, from the inputs and earlier results.
    ///
    /// # Panics
    /// If there are fewer of either than it needs.
    pub fn result<T: Number>(&self, inputs: &[T], all: &[T]) -> T {
        let at = |node: Node| all[node.index()];
        match self {
            Self::Input(k) => inputs[*k],
            Self::Number(bits) => T::constant(f64::from_bits(*bits)),
            Self::Unary(function, x) => function.of(at(*x)),
            Self::Binary(operation, x, y) => operation.of(at(*x), at(*y)),
            Self::MultiplyAdd(x, y, z) => at(*x).mul_add(at(*y), at(*z)),
            Self::Norm(parts) => norm_of(&parts.iter().map(|&part| at(part)).collect::<Vec<_>>()),
            Self::ExactSum(products) => T::exact_sum(products.iter().map(|product| product.map(at))),
            Self::Search(search, numbers) => {
                T::found(search, &numbers.iter().map(|&node| at(node)).collect::<Vec<_>>())
            }
            Self::Compare(relation, x, y) => T::from(f64::from(u8::from(relation.holds(at(*x), at(*y))))),
            Self::Select(condition, x, y) => at(if at(*condition) == 1.0 { *x } else { *y }),
        }
    }
}

/// The length of a vector of two to four components; formulas have no others.
fn norm_of<T: Leaf>(parts: &[T]) -> T {
    match *parts {
        [x, y] => norm([x, y]),
        [x, y, z] => norm([x, y, z]),
        [x, y, z, w] => norm([x, y, z, w]),
        _ => unreachable!("vectors of two to four components are recorded"),
    }
}
