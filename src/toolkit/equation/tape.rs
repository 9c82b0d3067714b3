//! An equation as a list of operations on numbers, in which nothing is computed twice.

use super::syntax::{Function, Relation};
use crate::number::scalar::{Scalar, abs, atan2, e_minus_one, norm, pi, sign};
use std::collections::HashMap;

/// The place of a number in the list.
pub(super) type Id = usize;

/// How a number follows from earlier ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Op {
    Input(usize),
    /// By its bits, so that it can be looked up.
    Number(u64),
    Pi,
    /// Euler's number.
    Euler,
    Negative(Id),
    Add(Id, Id),
    Subtract(Id, Id),
    Multiply(Id, Id),
    Divide(Id, Id),
    Power(Id, i32),
    Exp(Id),
    Abs(Id),
    /// √(a² + b² + c²)
    Norm([Id; 3]),
    Call(Function, Id, Id),
    /// 1 where it holds, else 0.
    Compare(Relation, Id, Id),
    /// The second where the first is 1, else the third.
    Select(Id, Id, Id),
}

/// Numbers that do not follow from the inputs by an equation.
#[derive(Debug, Default)]
pub(super) struct Beside {
    /// The outputs of the code, each with its row of the Jacobian of the code.
    pub(super) outputs: Vec<(Id, Vec<Id>)>,
    /// Numbers that change, and their changes.
    pub(super) changes: Vec<(Id, Id)>,
}

/// The list.
#[derive(Clone, Debug, Default)]
pub(super) struct Tape {
    ops: Vec<Op>,
    known: HashMap<Op, Id>,
}

impl Tape {
    /// The place of a number, which is entered where it is new.
    pub(super) fn push(&mut self, op: Op) -> Id {
        let new = self.ops.len();
        let id = *self.known.entry(op).or_insert(new);
        if id == new {
            self.ops.push(op);
        }
        id
    }

    pub(super) fn number(&mut self, value: f64) -> Id {
        self.push(Op::Number(value.to_bits()))
    }

    /// The operations in order.
    pub(super) fn ops(&self) -> &[Op] {
        &self.ops
    }

    pub(super) fn op(&self, id: Id) -> Op {
        self.ops[id]
    }

    /// Every number, at these inputs.
    pub(super) fn run<D: Scalar>(&self, inputs: &[D]) -> Vec<D> {
        let mut all: Vec<D> = Vec::with_capacity(self.ops.len());
        let truth = |holds: bool| D::from(f64::from(u8::from(holds)));
        for op in &self.ops {
            let at = |id: Id| all[id];
            let next = match *op {
                Op::Input(k) => inputs[k],
                Op::Number(bits) => D::from(f64::from_bits(bits)),
                Op::Pi => pi(),
                Op::Euler => e_minus_one::<D>() + 1.0,
                Op::Negative(a) => -at(a),
                Op::Add(a, b) => at(a) + at(b),
                Op::Subtract(a, b) => at(a) - at(b),
                Op::Multiply(a, b) => at(a) * at(b),
                Op::Divide(a, b) => at(a) / at(b),
                Op::Power(a, exponent) => at(a).powi(exponent),
                Op::Exp(a) => at(a).exp(),
                Op::Abs(a) => abs(at(a)),
                Op::Norm(parts) => norm(parts.map(at)),
                Op::Call(function, a, b) => call(function, at(a), at(b)),
                Op::Compare(relation, a, b) => truth(holds(relation, at(a), at(b))),
                Op::Select(condition, a, b) => at(if at(condition) == 1.0 { a } else { b }),
            };
            all.push(next);
        }
        all
    }

    /// The inputs that some of the numbers depend on.
    pub(super) fn inputs_of(&self, ids: impl IntoIterator<Item = Id>) -> Vec<usize> {
        let mut needed = vec![false; self.ops.len()];
        ids.into_iter().for_each(|id| needed[id] = true);
        let mut inputs = Vec::new();
        // From the end: what a number needs stands before it.
        for id in (0..self.ops.len()).rev() {
            if needed[id] {
                if let Op::Input(k) = self.ops[id] {
                    inputs.push(k);
                }
                self.operands(id).into_iter().for_each(|operand| needed[operand] = true);
            }
        }
        inputs
    }

    fn operands(&self, id: Id) -> Vec<Id> {
        match self.ops[id] {
            Op::Input(_) | Op::Number(_) | Op::Pi | Op::Euler => Vec::new(),
            Op::Negative(a) | Op::Power(a, _) | Op::Exp(a) | Op::Abs(a) => vec![a],
            Op::Add(a, b)
            | Op::Subtract(a, b)
            | Op::Multiply(a, b)
            | Op::Divide(a, b)
            | Op::Call(_, a, b)
            | Op::Compare(_, a, b) => vec![a, b],
            Op::Norm(parts) => parts.to_vec(),
            Op::Select(c, a, b) => vec![c, a, b],
        }
    }

    /// The derivative of a number by another one, an input or what stands between.
    pub(super) fn derivative(&mut self, of: Id, by: Id) -> Id {
        let (zero, one) = (self.number(0.0), self.number(1.0));
        let mut slopes: Vec<Id> = Vec::with_capacity(of + 1);
        for id in 0..=of {
            let slope = if id == by { one } else { self.slope(self.ops[id], id, &slopes, zero) };
            slopes.push(slope);
        }
        slopes[of]
    }

    /// The derivative of the result of an operation, by those of its operands.
    fn slope(&mut self, op: Op, id: Id, slopes: &[Id], zero: Id) -> Id {
        let two = self.number(2.0);
        match op {
            Op::Input(_)
            | Op::Number(_)
            | Op::Pi
            | Op::Euler
            | Op::Compare(..)
            | Op::Call(Function::Sign | Function::Round, ..) => zero,
            Op::Negative(a) => {
                let a = slopes[a];
                self.negative(a)
            }
            Op::Add(a, b) => self.add(slopes[a], slopes[b]),
            Op::Subtract(a, b) => self.subtract(slopes[a], slopes[b]),
            Op::Multiply(a, b) => {
                let (left, right) = (self.multiply(slopes[a], b), self.multiply(a, slopes[b]));
                self.add(left, right)
            }
            Op::Divide(a, b) => {
                let carried = self.multiply(id, slopes[b]);
                let above = self.subtract(slopes[a], carried);
                self.divide(above, b)
            }
            Op::Power(a, exponent) => {
                let (factor, power) = (self.number(f64::from(exponent)), self.push(Op::Power(a, exponent - 1)));
                let outer = self.multiply(factor, power);
                self.multiply(outer, slopes[a])
            }
            Op::Exp(a) => self.multiply(id, slopes[a]),
            Op::Abs(a) => {
                let sign = self.push(Op::Call(Function::Sign, a, a));
                self.multiply(sign, slopes[a])
            }
            Op::Norm(parts) => {
                let terms = parts.map(|part| self.multiply(part, slopes[part]));
                let sum = terms.into_iter().reduce(|sum, term| self.add(sum, term)).unwrap_or(zero);
                self.divide(sum, id)
            }
            Op::Call(Function::Sqrt, a, _) => {
                let below = self.multiply(two, id);
                self.divide(slopes[a], below)
            }
            Op::Call(Function::Sin, a, _) => {
                let cosine = self.push(Op::Call(Function::Cos, a, a));
                self.multiply(cosine, slopes[a])
            }
            Op::Call(Function::Cos, a, _) => {
                let sine = self.push(Op::Call(Function::Sin, a, a));
                let falling = self.multiply(sine, slopes[a]);
                self.negative(falling)
            }
            Op::Call(Function::ArcSin, a, _) => {
                let (one, square) = (self.number(1.0), self.multiply(a, a));
                let rest = self.subtract(one, square);
                let cosine = self.push(Op::Call(Function::Sqrt, rest, rest));
                self.divide(slopes[a], cosine)
            }
            Op::Call(Function::Atan2, y, x) => {
                let (left, right) = (self.multiply(x, slopes[y]), self.multiply(y, slopes[x]));
                let above = self.subtract(left, right);
                let (yy, xx) = (self.multiply(y, y), self.multiply(x, x));
                let below = self.add(yy, xx);
                self.divide(above, below)
            }
            Op::Select(condition, a, b) => {
                if slopes[a] == slopes[b] {
                    return slopes[a];
                }
                self.push(Op::Select(condition, slopes[a], slopes[b]))
            }
        }
    }

    /// Whether this is the number 0, which derivatives are full of.
    fn is_zero(&self, id: Id) -> bool {
        self.ops[id] == Op::Number(0.0_f64.to_bits())
    }

    pub(super) fn negative(&mut self, a: Id) -> Id {
        if self.is_zero(a) { a } else { self.push(Op::Negative(a)) }
    }

    pub(super) fn add(&mut self, a: Id, b: Id) -> Id {
        match (self.is_zero(a), self.is_zero(b)) {
            (true, _) => b,
            (_, true) => a,
            _ => self.push(Op::Add(a, b)),
        }
    }

    pub(super) fn subtract(&mut self, a: Id, b: Id) -> Id {
        match (self.is_zero(a), self.is_zero(b)) {
            (_, true) => a,
            (true, _) => self.negative(b),
            _ => self.push(Op::Subtract(a, b)),
        }
    }

    pub(super) fn multiply(&mut self, a: Id, b: Id) -> Id {
        match (self.is_zero(a), self.is_zero(b)) {
            (true, _) => a,
            (_, true) => b,
            _ => self.push(Op::Multiply(a, b)),
        }
    }

    pub(super) fn divide(&mut self, a: Id, b: Id) -> Id {
        self.push(Op::Divide(a, b))
    }
}

fn call<D: Scalar>(function: Function, a: D, b: D) -> D {
    match function {
        Function::Sqrt => a.sqrt(),
        Function::Sin => a.sin(),
        Function::Cos => a.cos(),
        Function::ArcSin => a.asin(),
        Function::Sign => sign(a),
        Function::Round => D::from(a.re().round()),
        // Zeros of mathematics have no sign.
        Function::Atan2 => atan2(a + 0.0, b),
    }
}

/// Of dual numbers, only the values are compared.
pub(super) fn holds<D: Scalar>(relation: Relation, a: D, b: D) -> bool {
    match relation {
        Relation::Less => a < b,
        Relation::LessOrEqual => a <= b,
        Relation::Greater => a > b,
        Relation::GreaterOrEqual => a >= b,
        Relation::Equal => a == b,
        Relation::Unequal => a != b,
    }
}
