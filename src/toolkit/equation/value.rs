//! Numbers, vectors and matrices, and the operations on them.

use super::error::Error;
use super::name::Name;
use super::syntax::{Operator, Relation};
use crate::toolkit::graph::{self, Binary, Graph, Node, Op, Unary};

/// The value of an expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Scalar(Node),
    Vector(Vec<Node>),
    /// A square matrix, row by row.
    Matrix(Vec<Node>),
    /// The normal of the plane, **s**: its cross product with a vector in the plane rotates that to the left.
    Normal,
    /// The zero vector, of any length.
    Zero,
}

impl Value {
    fn shape(&self) -> String {
        match self {
            Self::Scalar(_) => "a number".into(),
            Self::Vector(parts) => format!("a vector of {}", parts.len()),
            Self::Matrix(parts) => format!("a matrix of {}", parts.len()),
            Self::Normal => "the normal of the plane".into(),
            Self::Zero => "the zero vector".into(),
        }
    }
}

/// Applies an operation to every number.
pub(super) fn each(
    graph: &mut Graph,
    value: Value,
    at: usize,
    change: impl Fn(&mut Graph, Node) -> Node,
) -> Result<Value, Error> {
    match value {
        Value::Scalar(id) => Ok(Value::Scalar(change(graph, id))),
        Value::Vector(parts) => Ok(Value::Vector(parts.into_iter().map(|id| change(graph, id)).collect())),
        Value::Matrix(parts) => Ok(Value::Matrix(parts.into_iter().map(|id| change(graph, id)).collect())),
        Value::Normal | Value::Zero => Err(Error::new(at, "only a cross product or a comparison is written with this")),
    }
}

/// Sums and products of numbers and vectors.
pub(super) fn binary(
    graph: &mut Graph,
    operator: Operator,
    left: Value,
    right: Value,
    at: usize,
) -> Result<Value, Error> {
    use Operator::{Add, Cross, Divide, Dot, Outer, Subtract, Times};
    let pairs = |a: &[Node], b: &[Node]| a.iter().copied().zip(b.iter().copied()).collect::<Vec<_>>();
    Ok(match (operator, left, right) {
        (Add, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(graph.sum(a, b)),
        (Subtract, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(graph.difference(a, b)),
        (Times | Dot | Cross, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(graph.product(a, b)),
        (Divide, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(graph.quotient(a, b)),
        (Divide, Value::Vector(a), Value::Scalar(b)) => {
            Value::Vector(a.into_iter().map(|a| graph.quotient(a, b)).collect())
        }
        (Times | Dot | Cross, Value::Scalar(a), Value::Vector(b))
        | (Times | Dot, Value::Vector(b), Value::Scalar(a)) => {
            Value::Vector(b.into_iter().map(|b| graph.product(a, b)).collect())
        }
        (Add, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
            Value::Vector(pairs(&a, &b).into_iter().map(|(a, b)| graph.sum(a, b)).collect())
        }
        (Subtract, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
            Value::Vector(pairs(&a, &b).into_iter().map(|(a, b)| graph.difference(a, b)).collect())
        }
        (Times | Dot, Value::Scalar(a), Value::Matrix(b)) | (Times | Dot, Value::Matrix(b), Value::Scalar(a)) => {
            Value::Matrix(b.into_iter().map(|b| graph.product(a, b)).collect())
        }
        (Add, Value::Matrix(a), Value::Matrix(b)) if a.len() == b.len() => {
            Value::Matrix(pairs(&a, &b).into_iter().map(|(a, b)| graph.sum(a, b)).collect())
        }
        (Subtract, Value::Matrix(a), Value::Matrix(b)) if a.len() == b.len() => {
            Value::Matrix(pairs(&a, &b).into_iter().map(|(a, b)| graph.difference(a, b)).collect())
        }
        (Outer, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => Value::Matrix(
            a.iter().flat_map(|&a| b.iter().map(move |&b| (a, b))).map(|(a, b)| graph.product(a, b)).collect(),
        ),
        (Dot, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
            let products: Vec<_> = pairs(&a, &b).into_iter().map(|(a, b)| graph.product(a, b)).collect();
            let zero = graph.number(0.0);
            Value::Scalar(products.into_iter().fold(zero, |sum, product| graph.sum(sum, product)))
        }
        (Cross, Value::Vector(a), Value::Vector(b)) if a.len() == 3 && b.len() == 3 => {
            let mut minor = |i: usize, j: usize| {
                let (plus, minus) = (graph.product(a[i], b[j]), graph.product(a[j], b[i]));
                graph.difference(plus, minus)
            };
            Value::Vector(vec![minor(1, 2), minor(2, 0), minor(0, 1)])
        }
        // For every column.
        (Cross, Value::Vector(a), Value::Matrix(b)) if a.len() == 3 && b.len() == 9 => {
            let mut minor = |i: usize, j: usize, column: usize| {
                let (plus, minus) = (graph.product(a[i], b[3 * j + column]), graph.product(a[j], b[3 * i + column]));
                graph.difference(plus, minus)
            };
            let mut row = |i: usize, j: usize| [minor(i, j, 0), minor(i, j, 1), minor(i, j, 2)];
            Value::Matrix([row(1, 2), row(2, 0), row(0, 1)].concat())
        }
        (Cross, Value::Normal, Value::Vector(b)) if b.len() == 2 => Value::Vector(vec![graph.negative(b[1]), b[0]]),
        (operator, left, right) => {
            let (word, left, right) = (word(operator), left.shape(), right.shape());
            return Err(Error::new(at, format!("{word} of {left} and {right} is not defined")));
        }
    })
}

/// A power of two or more factors.
pub(super) fn power(graph: &mut Graph, base: Node, exponent: usize) -> Node {
    (1..exponent).fold(base, |power, _| graph.product(power, base))
}

/// The squared nodes of a sum of squares.
pub(super) fn squares(graph: &Graph, sum: Node) -> Option<Vec<Node>> {
    match *graph.op(sum) {
        Op::Binary(Binary::Multiply, a, b) if a == b => Some(vec![a]),
        Op::Binary(Binary::Add, a, b) => Some([squares(graph, a)?, squares(graph, b)?].concat()),
        _ => None,
    }
}

/// The length of a vector of any number of components.
pub(super) fn norm(graph: &mut Graph, parts: &[Node]) -> Node {
    match parts {
        [only] => graph.unary(Unary::Absolute, *only),
        [first, second, third, fourth, rest @ ..] if !rest.is_empty() => {
            let start = graph.enter(Op::Norm([*first, *second, *third, *fourth].into()));
            norm(graph, &[&[start], rest].concat())
        }
        _ => graph.enter(Op::Norm(parts.into())),
    }
}

/// A node that is 1 if the relation holds, else 0.
pub(super) fn compare(graph: &mut Graph, relation: Relation, a: Node, b: Node) -> Node {
    let (order, [a, b]) = match relation {
        Relation::Less => (graph::Relation::Less, [a, b]),
        Relation::LessOrEqual => (graph::Relation::LessOrEqual, [a, b]),
        Relation::Greater => (graph::Relation::Less, [b, a]),
        Relation::GreaterOrEqual => (graph::Relation::LessOrEqual, [b, a]),
        Relation::Equal | Relation::Unequal => (graph::Relation::Equal, [a, b]),
    };
    let holds = graph.enter(Op::Compare(order, a, b));
    if relation != Relation::Unequal {
        return holds;
    }
    let [zero, one] = [0.0, 1.0].map(|answer| graph.number(answer));
    graph.enter(Op::Select(holds, zero, one))
}

/// e
pub(super) fn euler(graph: &mut Graph) -> Node {
    let one = graph.number(1.0);
    graph.unary(Unary::Exponential, one)
}

/// π, the angle of the point (−1, 0).
fn pi(graph: &mut Graph) -> Node {
    let [y, x] = [0.0, -1.0].map(|value| graph.number(value));
    graph.enter(Op::Binary(Binary::Angle, y, x))
}

/// Symbols with the same meaning everywhere, unless they are defined.
pub(super) fn constant(name: &Name, graph: &mut Graph) -> Option<Value> {
    let plain = name.below.is_empty() && name.above.is_empty() && name.primes == 0 && name.change.is_empty();
    if !plain {
        return None;
    }
    let mut axis = |k: usize| Value::Vector((0..3).map(|i| graph.number(f64::from(u8::from(i == k)))).collect());
    match (name.bold, name.base.as_str()) {
        (true, "i") => Some(axis(0)),
        (true, "j") => Some(axis(1)),
        (true, "k") => Some(axis(2)),
        (true, "I") => Some(Value::Matrix((0..9).map(|k| graph.number(f64::from(u8::from(k % 4 == 0)))).collect())),
        (true, "s") => Some(Value::Normal),
        (true, "0") => Some(Value::Zero),
        (false, "pi") => Some(Value::Scalar(pi(graph))),
        (false, "e") => Some(Value::Scalar(euler(graph))),
        _ => None,
    }
}

fn word(operator: Operator) -> &'static str {
    match operator {
        Operator::Add => "a sum",
        Operator::Subtract => "a difference",
        Operator::Times => "a product without a sign",
        Operator::Dot => "the product `\\cdot`",
        Operator::Cross => "the product `\\times`",
        Operator::Outer => "the product `\\otimes`",
        Operator::Divide => "a quotient",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_sums_of_squares_are_lengths() {
        let mut graph = Graph::default();
        let [a, b, c] = [0, 1, 2].map(|k| graph.enter(Op::Input(k)));
        let [aa, bb, cc, cube] = [(a, 2), (b, 2), (c, 2), (c, 3)].map(|(x, exponent)| power(&mut graph, x, exponent));
        let two = graph.sum(aa, bb);
        let [three, with_cube] = [cc, cube].map(|last| graph.sum(two, last));
        let difference = graph.difference(aa, bb);
        let of = [aa, three, with_cube, difference, a].map(|sum| squares(&graph, sum));
        assert_eq!(of, [Some(vec![a]), Some(vec![a, b, c]), None, None, None]);
    }
}
