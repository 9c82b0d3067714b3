//! The rounding of one operation: how large it can be, and how large it is.

use jointproof::Octuple;
use jointproof::number::scalar::norm;
use jointproof::toolkit::graph::{Binary, Graph, Node, Number, Op, Unary};

/// Library functions are within two units in the last place of the result, and mostly within half of one.
const LIBRARY: f64 = 2.0;

/// Whether a factor or divisor changes no digit, whatever the inputs are: it is ± a power of two, or 0.
fn is_power_of_two(graph: &Graph, node: Node) -> bool {
    match *graph.op(node) {
        Op::Unary(Unary::PowerOfTwo, _) => true,
        Op::Unary(Unary::Negative | Unary::Absolute, x) => is_power_of_two(graph, x),
        Op::Binary(Binary::Multiply | Binary::Divide, x, y) | Op::Select(_, x, y) => {
            is_power_of_two(graph, x) && is_power_of_two(graph, y)
        }
        _ => graph.constant(node).is_some_and(|x| x.to_bits().trailing_zeros() >= 52),
    }
}

/// The largest rounding of an operation, relative to u times its result.
pub(crate) fn most(graph: &Graph, node: Node, all: &[f64]) -> f64 {
    let at = |node: Node| all[node.index()];
    match graph.op(node) {
        Op::Number(_) => f64::from(u8::from(Octuple::constant(at(node)) != at(node))),
        Op::Unary(function, _) => match function {
            Unary::Negative | Unary::Absolute | Unary::PowerOfTwo | Unary::NearestInteger => 0.0,
            Unary::Root => 1.0,
            _ => LIBRARY,
        },
        Op::Binary(Binary::Add | Binary::Subtract, x, y) => f64::from(u8::from(at(*x) != 0.0 && at(*y) != 0.0)),
        Op::Binary(Binary::Multiply, x, y) => {
            f64::from(u8::from(!is_power_of_two(graph, *x) && !is_power_of_two(graph, *y)))
        }
        Op::Binary(Binary::Divide, _, y) => f64::from(u8::from(!is_power_of_two(graph, *y))),
        Op::Binary(Binary::Angle, ..) => LIBRARY,
        Op::MultiplyAdd(..) | Op::ExactSum(_) => 1.0,
        #[expect(clippy::cast_precision_loss, reason = "a vector has up to four components")]
        Op::Norm(parts) => parts.len() as f64 / 2.0 + 1.0,
        Op::Binary(Binary::Maximum, ..) | Op::Input(_) | Op::Search(..) | Op::Compare(..) | Op::Select(..) => 0.0,
    }
}

/// The rounding of an operation: its result less the exact result for the same operands.
pub(crate) fn actual(graph: &Graph, node: Node, all: &[f64]) -> f64 {
    let at = |node: Node| all[node.index()];
    let result = at(node);
    let wide = |node: Node| Octuple::from(at(node));
    let off = |exact: Octuple| (Octuple::from(result) - exact).to_f64();
    match graph.op(node) {
        Op::Number(_) => off(Octuple::constant(result)),
        Op::Unary(Unary::Root, x) if result > 0.0 => result.mul_add(result, -at(*x)) / (2.0 * result),
        Op::Unary(function, x) if most(graph, node, all) > 0.0 => off(function.of(wide(*x))),
        Op::Binary(Binary::Add, x, y) => -lost(at(*x), at(*y), result),
        Op::Binary(Binary::Subtract, x, y) => -lost(at(*x), -at(*y), result),
        Op::Binary(Binary::Multiply, x, y) => -at(*x).mul_add(at(*y), -result),
        Op::Binary(Binary::Divide, x, y) => result.mul_add(at(*y), -at(*x)) / at(*y),
        Op::Binary(Binary::Angle, y, x) => off(Binary::Angle.of(wide(*y), wide(*x))),
        Op::MultiplyAdd(x, y, z) => off(wide(*x) * wide(*y) + wide(*z)),
        Op::Norm(parts) => off(match **parts {
            [x, y] => norm([x, y].map(wide)),
            [x, y, z] => norm([x, y, z].map(wide)),
            [x, y, z, w] => norm([x, y, z, w].map(wide)),
            _ => Octuple::from(result),
        }),
        Op::ExactSum(products) => off(products.iter().fold(Octuple::from(0.0), |sum, product| {
            sum + product.iter().fold(Octuple::from(1.0), |all, &factor| all * wide(factor))
        })),
        _ => 0.0,
    }
}

/// What a + b has lost by rounding (Knuth's TwoSum).
fn lost(a: f64, b: f64, sum: f64) -> f64 {
    let b_part = sum - a;
    (a - (sum - b_part)) + (b - b_part)
}
