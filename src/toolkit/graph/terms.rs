//! Leaves out terms that are always 0, and computes what depends on no input: the chain rule records many such operations.
//!
//! Where all numbers are finite no bit of a result changes, not even the sign of a zero. A sum keeps its other term, unless that
//! may be −0 and the sign of the sum shows: what is added to a number that is never −0, or multiplied by such a term, may have
//! either sign of zero.

use super::node::{Binary, Graph, Node, Op, Unary};

/// What is known of a result without its inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Zero {
    /// It is 0, of either sign.
    always: bool,
    /// It is never −0.
    no_minus: bool,
}

impl Graph {
    /// The same without sums of a number and what is always 0, and with constants computed.
    #[must_use]
    pub(super) fn without_zero_terms(&self) -> Self {
        let hidden = self.hidden();
        let (mut rest, mut places, mut known) = (Self::default(), Vec::<Node>::new(), Vec::<Zero>::new());
        for (op, &is_hidden) in self.ops().iter().zip(&hidden) {
            let operands: Vec<_> = op.operands().iter().map(|node| places[node.index()]).collect();
            let op = rest.computed(op.with_operands(&operands));
            let is = |node: Node, x: f64| rest.constant(node) == Some(x);
            let vanishes =
                |node: Node, other: Node| known[node.index()].always && (is_hidden || known[other.index()].no_minus);
            let node = match op {
                Op::Binary(Binary::Add | Binary::Subtract, x, y) if vanishes(y, x) => x,
                Op::Binary(Binary::Add, x, y) if vanishes(x, y) => y,
                Op::Binary(Binary::Multiply | Binary::Divide, x, y) if is(y, 1.0) => x,
                Op::Binary(Binary::Multiply, x, y) if is(x, 1.0) => y,
                mut op => {
                    if is_hidden && zero(&op, &known).always {
                        op = Op::Number(0);
                    }
                    let zero = zero(&op, &known);
                    let node = rest.enter(op);
                    known.extend((node.index() == known.len()).then_some(zero));
                    node
                }
            };
            places.push(node);
        }
        rest.with_results_of(self, |node| places[node.index()]).pruned()
    }

    /// An operation on two constants as their result.
    fn computed(&self, op: Op) -> Op {
        let Op::Binary(operation, x, y) = op else { return op };
        let (Some(x), Some(y)) = (self.constant(x), self.constant(y)) else { return op };
        let result = match operation {
            Binary::Add => x + y,
            Binary::Subtract => x - y,
            Binary::Multiply => x * y,
            Binary::Divide => x / y,
            Binary::Angle | Binary::Maximum => return op,
        };
        if result.is_finite() { Op::Number(result.to_bits()) } else { op }
    }

    /// For every operation, whether no result shows which sign it has where it is 0.
    ///
    /// Of two terms one may be hidden by the other, if that is never −0 and is itself kept as it is.
    fn hidden(&self) -> Vec<bool> {
        let mut known = Vec::new();
        for op in self.ops() {
            known.push(zero(op, &known));
        }
        let mut hidden = vec![true; self.ops().len()];
        for node in self.refusal.iter().chain(&self.value).chain(&self.jacobian) {
            hidden[node.index()] = false;
        }
        for index in (0..self.ops().len()).rev() {
            let (op, is_hidden) = (self.op(Node::at(index)), hidden[index]);
            let no_minus = |node: &Node| known[node.index()].no_minus;
            let mut hide = |node: &Node, is: bool| hidden[node.index()] &= is;
            match op {
                Op::Binary(Binary::Add, x, y) if !is_hidden && x != y => {
                    hide(x, !no_minus(x) && no_minus(y));
                    hide(y, no_minus(x));
                }
                Op::Binary(Binary::Subtract, x, y) if !is_hidden && x != y => {
                    hide(x, false);
                    hide(y, no_minus(x));
                }
                Op::Binary(Binary::Divide, x, y) => {
                    hide(x, is_hidden);
                    hide(y, false);
                }
                Op::Binary(Binary::Add | Binary::Subtract | Binary::Multiply | Binary::Maximum, ..)
                | Op::Unary(Unary::Negative | Unary::Root, _)
                | Op::Select(..) => op.each_operand(|node| hide(&node, is_hidden)),
                Op::Compare(..) | Op::Unary(Unary::Absolute, _) | Op::Norm(_) => {}
                _ => op.each_operand(|node| hide(&node, false)),
            }
        }
        hidden
    }
}

/// What is known of the result of an operation.
fn zero(op: &Op, known: &[Zero]) -> Zero {
    let of = |node: &Node| known[node.index()];
    let (always, no_minus) = match op {
        Op::Number(bits) => (f64::from_bits(*bits) == 0.0, *bits != (-0.0_f64).to_bits()),
        Op::Unary(Unary::Absolute, x) => (of(x).always, true),
        Op::Unary(Unary::Negative, x) | Op::Binary(Binary::Divide, x, _) => (of(x).always, false),
        Op::Binary(Binary::Add, x, y) => (of(x).always && of(y).always, of(x).no_minus || of(y).no_minus),
        Op::Binary(Binary::Subtract, x, y) => (of(x).always && of(y).always, of(x).no_minus),
        Op::Binary(Binary::Multiply, x, y) => (of(x).always || of(y).always, x == y),
        Op::Norm(_) => (false, true),
        Op::Select(_, yes, no) => (of(yes).always && of(no).always, of(yes).no_minus && of(no).no_minus),
        _ => (false, false),
    };
    Zero { always, no_minus }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The operations that are left of a result of inputs x, y and z, and whether it is the same for zeros of both signs.
    fn left(result: impl Fn(&mut dyn FnMut(Op) -> Node, [Node; 3]) -> Node) -> usize {
        let mut graph = Graph::default();
        let inputs = [0, 1, 2].map(|k| graph.enter(Op::Input(k)));
        graph.value = vec![result(&mut |op| graph.enter(op), inputs)];
        let rest = graph.without_zero_terms();
        let numbers = [0.0, -0.0, 1.5, -2.5];
        for (x, y, z) in numbers.iter().flat_map(|x| numbers.iter().flat_map(move |y| numbers.map(|z| (*x, *y, z)))) {
            let [before, after] = [&graph, &rest].map(|graph| graph.run(&[x, y, z]).0[0]);
            assert_eq!(before.to_bits(), after.to_bits(), "{x:?} {y:?} {z:?}: {before:?} and not {after:?}");
        }
        rest.ops().len() - rest.ops().iter().filter(|op| matches!(op, Op::Input(_) | Op::Number(_))).count()
    }

    const ZERO: Op = Op::Number(0);

    fn op(operation: Binary, x: Node, y: Node) -> Op {
        Op::Binary(operation, x, y)
    }

    #[test]
    fn what_is_always_zero_is_left_out_of_a_sum_and_no_sign_of_a_zero_changes() {
        use Binary::{Add, Multiply, Subtract};
        // 0 + x y + 0 z: the first zero decides about the sign, the last term does not.
        let sum = |enter: &mut dyn FnMut(Op) -> Node, [x, y, z]: [Node; 3]| {
            let zero = enter(ZERO);
            let (product, none) = (enter(op(Multiply, x, y)), enter(op(Multiply, zero, z)));
            let first = enter(op(Add, zero, product));
            enter(op(Add, first, none))
        };
        assert_eq!(left(sum), 2);
        // x + 0 y is −0 where both are.
        assert_eq!(
            left(|enter, [x, y, _]| {
                let zero = enter(ZERO);
                let none = enter(op(Multiply, zero, y));
                enter(op(Add, x, none))
            }),
            2
        );
        // (x + 0 y) z + 1: no sign shows.
        let product = |enter: &mut dyn FnMut(Op) -> Node, [x, y, z]: [Node; 3]| {
            let (zero, one) = (enter(ZERO), enter(Op::Number(1.0_f64.to_bits())));
            let none = enter(op(Multiply, zero, y));
            let (sum, twice) = (enter(op(Add, x, none)), enter(op(Add, one, one)));
            let product = enter(op(Multiply, sum, z));
            enter(op(Subtract, twice, product))
        };
        assert_eq!(left(product), 2);
        // (0 + x) + (0 + y): one of them keeps its zero.
        let both = |enter: &mut dyn FnMut(Op) -> Node, [x, y, _]: [Node; 3]| {
            let zero = enter(ZERO);
            let [x, y] = [x, y].map(|x| enter(op(Add, zero, x)));
            enter(op(Add, x, y))
        };
        assert_eq!(left(both), 2);
    }
}
