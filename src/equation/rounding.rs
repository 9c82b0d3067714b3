//! What rounding can do to an equation that is evaluated as it stands.

use super::syntax::Function;
use super::tape::{Id, Op, Tape};
use crate::octuple::Octuple;
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
