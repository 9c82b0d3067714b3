//! A graph with one operation replaced, as by a mistake in a program.

use super::node::{Graph, Node, Op};

/// The replacement of an operation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Instead {
    /// Another operation, on inputs or earlier results.
    Op(Op),
    /// An earlier result.
    Result(Node),
}

impl Graph {
    /// The graph with one operation replaced. The replacement may use earlier results, which include all inputs.
    ///
    /// # Panics
    /// If it uses later results.
    #[must_use]
    pub fn altered(&self, place: Node, instead: &Instead) -> Self {
        let mut altered = Self::default();
        let mut moved: Vec<Option<Node>> = vec![None; self.ops().len()];
        for (here, op) in self.ops().iter().enumerate() {
            let at = |node: &Node| moved[node.index()].expect("operands stand before");
            let op = match instead {
                Instead::Result(node) if here == place.index() => {
                    moved[here] = Some(at(node));
                    continue;
                }
                Instead::Op(other) if here == place.index() => other,
                _ => op,
            };
            let operands: Vec<_> = op.operands().iter().map(at).collect();
            moved[here] = Some(altered.enter(op.with_operands(&operands)));
        }
        altered.with_results_of(self, |node| moved[node.index()].expect("every result has moved"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::NormalForce;
    use crate::toolkit::graph::{Binary, Unary, record};

    #[test]
    fn one_operation_is_another_one() {
        let graph = record::<NormalForce>().unwrap();
        let whole = graph.value[0];
        let Op::Unary(Unary::Absolute, sum) = *graph.op(whole) else { panic!("{:?}", graph.op(whole)) };
        let Op::Binary(Binary::Add, x, y) = *graph.op(sum) else { panic!("{:?}", graph.op(sum)) };
        let value = |place: Node, instead: Instead| graph.altered(place, &instead).run(&[3.0, -3.5]).0;
        assert_eq!(value(sum, Instead::Op(Op::Binary(Binary::Subtract, x, y))), [6.5]);
        assert_eq!(value(sum, Instead::Result(x)), [3.0]);
        assert_eq!(value(whole, Instead::Result(sum)), [-0.5]);
        assert_eq!(graph.run(&[3.0, -3.5]).0, [0.5]);
    }
}
