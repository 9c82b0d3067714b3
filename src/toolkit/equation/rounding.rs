//! What rounding can do to an equation that is evaluated as it stands.

use super::syntax::Function;
use super::tape::{Id, Op, Tape};
use crate::number::octuple::Octuple;
use num_dual::DualNum;
use num_traits::{One, Signed, Zero};

/// By how many roundings each number of the list may be off: its own, and those of its operands as they reach it.
///
/// An input is off by as much as `given` says, or not at all.
pub(super) fn terms(tape: &Tape, inputs: &[Octuple], given: &[Octuple]) -> Vec<Octuple> {
    let all = tape.run(inputs);
    let mut sizes: Vec<Octuple> = Vec::with_capacity(all.len());
    for (id, op) in tape.ops().iter().enumerate() {
        let size = match *op {
            Op::Input(k) => given.get(k).copied().unwrap_or_else(Octuple::zero),
            op => carried(op, all[id], &all, &sizes),
        };
        // Where a derivative is infinite, so may be the error; then nothing is said.
        sizes.push(if size.is_finite() { size } else { Octuple::zero() });
    }
    sizes
}

fn carried(op: Op, result: Octuple, all: &[Octuple], sizes: &[Octuple]) -> Octuple {
    let (at, size) = (|id: Id| all[id].abs(), |id: Id| sizes[id]);
    let own = result.abs();
    // 0 where there is nothing to carry, even over an infinite slope.
    let scaled = |size: Octuple, slope: Octuple| if size.is_zero() { size } else { size * slope };
    match op {
        Op::Input(_) | Op::Number(_) | Op::Compare(..) | Op::Call(Function::Sign | Function::Round, ..) => {
            Octuple::zero()
        }
        Op::Pi | Op::Euler => own,
        Op::Negative(a) | Op::Abs(a) => size(a),
        Op::Add(a, b) | Op::Subtract(a, b) => own + size(a) + size(b),
        Op::Multiply(a, b) => own + scaled(size(a), at(b)) + scaled(size(b), at(a)),
        Op::Divide(a, b) => own + scaled(size(a), at(b).recip()) + scaled(size(b), own / at(b)),
        Op::Power(a, exponent) => own + scaled(size(a), own / at(a) * f64::from(exponent)),
        Op::Exp(a) => own + scaled(size(a), own),
        Op::Norm(parts) => parts.into_iter().fold(own, |sum, part| sum + size(part)),
        Op::Call(Function::Sqrt, a, _) => own + scaled(size(a), (own * 2.0).recip()),
        Op::Call(Function::Sin | Function::Cos, a, _) => own + size(a),
        Op::Call(Function::ArcSin, a, _) => own + scaled(size(a), (Octuple::one() - at(a) * at(a)).sqrt().recip()),
        Op::Call(Function::Atan2, y, x) => {
            let square = at(x) * at(x) + at(y) * at(y);
            own + scaled(size(y), at(x) / square) + scaled(size(x), at(y) / square)
        }
        Op::Select(condition, a, b) => size(if all[condition] == Octuple::one() { a } else { b }),
    }
}

#[cfg(test)]
mod tests {
    use super::super::syntax::Relation;
    use super::*;

    /// a is 4 and off by 2 roundings, b is 3 and by 5; c is 0.6 and by 7.
    #[test]
    fn roundings_reach_what_follows() {
        let mut tape = Tape::default();
        let [a, b, c] = [0, 1, 2].map(|k| tape.push(Op::Input(k)));
        let less = tape.push(Op::Compare(Relation::Less, b, a));
        let call = |function, x, y| Op::Call(function, x, y);
        let (sin_c, cos_c) = (0.6_f64.sin(), 0.6_f64.cos());
        let expected = [
            (Op::Number(3.0_f64.to_bits()), 0.0),
            (Op::Pi, std::f64::consts::PI),
            (Op::Negative(a), 2.0),
            (Op::Abs(b), 5.0),
            (Op::Add(a, b), 7.0 + 2.0 + 5.0),
            (Op::Subtract(b, a), 1.0 + 2.0 + 5.0),
            (Op::Multiply(a, b), 12.0 + 2.0 * 3.0 + 5.0 * 4.0),
            (Op::Divide(b, a), 0.75 + 5.0 / 4.0 + 2.0 * 3.0 / 16.0),
            (Op::Power(b, 3), 27.0 + 5.0 * 27.0),
            (Op::Exp(c), 8.0 * 0.6_f64.exp()),
            (Op::Norm([a, b, a]), 41.0_f64.sqrt() + 2.0 + 5.0 + 2.0),
            (call(Function::Sqrt, a, a), 2.0 + 2.0 / 4.0),
            (call(Function::Sin, c, c), sin_c + 7.0),
            (call(Function::Cos, c, c), cos_c + 7.0),
            (call(Function::ArcSin, c, c), 0.6_f64.asin() + 7.0 / 0.8),
            (call(Function::Atan2, b, a), 3.0_f64.atan2(4.0) + 5.0 * 4.0 / 25.0 + 2.0 * 3.0 / 25.0),
            (call(Function::Sign, a, a), 0.0),
            (Op::Select(less, a, b), 2.0),
            (Op::Select(c, a, b), 5.0),
        ];
        let ids: Vec<_> = expected.iter().map(|&(op, _)| tape.push(op)).collect();
        let sizes = terms(&tape, &[4.0, 3.0, 0.6].map(Octuple::from), &[2.0, 5.0, 7.0].map(Octuple::from));
        for (id, (op, expected)) in ids.into_iter().zip(expected) {
            let found = sizes[id].to_f64();
            assert!((found - expected).abs() <= 1e-14 * expected, "{op:?}: {found}, expected {expected}");
        }
    }
}
