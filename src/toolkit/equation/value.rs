//! Numbers, vectors and matrices, and what is done to them.

use super::error::Error;
use super::name::Name;
use super::syntax::Operator;
use super::tape::{Id, Op, Tape};

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Scalar(Id),
    Vector(Vec<Id>),
    /// A square matrix, row by row.
    Matrix(Vec<Id>),
    /// The normal of the plane, **s**: its cross product with a vector of the plane turns that to the left.
    Normal,
    /// The zero vector, of any length.
    Zero,
}

/// The same done to every number.
pub(super) fn each(
    tape: &mut Tape,
    value: Value,
    at: usize,
    change: impl Fn(&mut Tape, Id) -> Id,
) -> Result<Value, Error> {
    match value {
        Value::Scalar(id) => Ok(Value::Scalar(change(tape, id))),
        Value::Vector(parts) => Ok(Value::Vector(parts.into_iter().map(|id| change(tape, id)).collect())),
        Value::Matrix(parts) => Ok(Value::Matrix(parts.into_iter().map(|id| change(tape, id)).collect())),
        Value::Normal | Value::Zero => Err(Error::new(at, "only a cross product or a comparison is written with this")),
    }
}

/// Sums and products of numbers and vectors.
pub(super) fn binary(
    tape: &mut Tape,
    operator: Operator,
    left: Value,
    right: Value,
    at: usize,
) -> Result<Value, Error> {
    use Operator::{Add, Cross, Divide, Dot, Outer, Subtract, Times};
    let pairs = |a: &[Id], b: &[Id]| a.iter().copied().zip(b.iter().copied()).collect::<Vec<_>>();
    Ok(match (operator, left, right) {
        (Add, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(tape.add(a, b)),
        (Subtract, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(tape.subtract(a, b)),
        (Times | Dot, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(tape.multiply(a, b)),
        (Divide, Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(tape.divide(a, b)),
        (Divide, Value::Vector(a), Value::Scalar(b)) => {
            Value::Vector(a.into_iter().map(|a| tape.divide(a, b)).collect())
        }
        (Times, Value::Scalar(a), Value::Vector(b)) | (Times, Value::Vector(b), Value::Scalar(a)) => {
            Value::Vector(b.into_iter().map(|b| tape.multiply(a, b)).collect())
        }
        (Add, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
            Value::Vector(pairs(&a, &b).into_iter().map(|(a, b)| tape.add(a, b)).collect())
        }
        (Subtract, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
            Value::Vector(pairs(&a, &b).into_iter().map(|(a, b)| tape.subtract(a, b)).collect())
        }
        (Times, Value::Scalar(a), Value::Matrix(b)) | (Times, Value::Matrix(b), Value::Scalar(a)) => {
            Value::Matrix(b.into_iter().map(|b| tape.multiply(a, b)).collect())
        }
        (Add, Value::Matrix(a), Value::Matrix(b)) if a.len() == b.len() => {
            Value::Matrix(pairs(&a, &b).into_iter().map(|(a, b)| tape.add(a, b)).collect())
        }
        (Subtract, Value::Matrix(a), Value::Matrix(b)) if a.len() == b.len() => {
            Value::Matrix(pairs(&a, &b).into_iter().map(|(a, b)| tape.subtract(a, b)).collect())
        }
        (Outer, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => Value::Matrix(
            a.iter().flat_map(|&a| b.iter().map(move |&b| (a, b))).map(|(a, b)| tape.multiply(a, b)).collect(),
        ),
        (Dot, Value::Vector(a), Value::Vector(b)) if a.len() == b.len() => {
            let products: Vec<_> = pairs(&a, &b).into_iter().map(|(a, b)| tape.multiply(a, b)).collect();
            let zero = tape.number(0.0);
            Value::Scalar(products.into_iter().fold(zero, |sum, product| tape.add(sum, product)))
        }
        (Cross, Value::Vector(a), Value::Vector(b)) if a.len() == 3 && b.len() == 3 => {
            let mut minor = |i: usize, j: usize| {
                let (plus, minus) = (tape.multiply(a[i], b[j]), tape.multiply(a[j], b[i]));
                tape.subtract(plus, minus)
            };
            Value::Vector(vec![minor(1, 2), minor(2, 0), minor(0, 1)])
        }
        // Of every column.
        (Cross, Value::Vector(a), Value::Matrix(b)) if a.len() == 3 && b.len() == 9 => {
            let mut minor = |i: usize, j: usize, column: usize| {
                let (plus, minus) = (tape.multiply(a[i], b[3 * j + column]), tape.multiply(a[j], b[3 * i + column]));
                tape.subtract(plus, minus)
            };
            let mut row = |i: usize, j: usize| [minor(i, j, 0), minor(i, j, 1), minor(i, j, 2)];
            Value::Matrix([row(1, 2), row(2, 0), row(0, 1)].concat())
        }
        (Cross, Value::Normal, Value::Vector(b)) if b.len() == 2 => Value::Vector(vec![tape.negative(b[1]), b[0]]),
        (operator, ..) => return Err(Error::new(at, format!("{} is not defined for these", word(operator)))),
    })
}

/// What is squared in a sum of squares.
pub(super) fn squares(tape: &Tape, sum: Id) -> Option<Vec<Id>> {
    match tape.op(sum) {
        Op::Power(base, 2) => Some(vec![base]),
        Op::Add(a, b) => Some([squares(tape, a)?, squares(tape, b)?].concat()),
        _ => None,
    }
}

/// The length of a vector of any number of components.
pub(super) fn norm(tape: &mut Tape, parts: &[Id]) -> Id {
    let zero = tape.number(0.0);
    let length = |tape: &mut Tape, parts: &[Id]| {
        let at = |k: usize| parts.get(k).copied().unwrap_or(zero);
        tape.push(Op::Norm([at(0), at(1), at(2)]))
    };
    match parts {
        [first, second, third, rest @ ..] if !rest.is_empty() => {
            let start = length(tape, &[*first, *second, *third]);
            norm(tape, &[&[start], rest].concat())
        }
        _ => length(tape, parts),
    }
}

/// Symbols that mean the same everywhere, unless somebody defines them.
pub(super) fn constant(name: &Name, tape: &mut Tape) -> Option<Value> {
    let plain = name.below.is_empty() && name.above.is_empty() && name.primes == 0 && name.change.is_empty();
    if !plain {
        return None;
    }
    let mut axis = |k: usize| Value::Vector((0..3).map(|i| tape.number(f64::from(u8::from(i == k)))).collect());
    match (name.bold, name.base.as_str()) {
        (true, "i") => Some(axis(0)),
        (true, "j") => Some(axis(1)),
        (true, "k") => Some(axis(2)),
        (true, "I") => Some(Value::Matrix((0..9).map(|k| tape.number(f64::from(u8::from(k % 4 == 0)))).collect())),
        (true, "s") => Some(Value::Normal),
        (true, "0") => Some(Value::Zero),
        (false, "pi") => Some(Value::Scalar(tape.push(Op::Pi))),
        (false, "e") => Some(Value::Scalar(tape.push(Op::Euler))),
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
        let mut tape = Tape::default();
        let [a, b, c] = [0, 1, 2].map(|k| tape.push(Op::Input(k)));
        let [aa, bb, cc, cube] = [(a, 2), (b, 2), (c, 2), (c, 3)].map(|(x, power)| tape.push(Op::Power(x, power)));
        let two = tape.add(aa, bb);
        let [three, with_cube] = [cc, cube].map(|last| tape.add(two, last));
        let difference = tape.subtract(aa, bb);
        let of = [aa, three, with_cube, difference, a].map(|sum| squares(&tape, sum));
        assert_eq!(of, [Some(vec![a]), Some(vec![a, b, c]), None, None, None]);
    }
}
