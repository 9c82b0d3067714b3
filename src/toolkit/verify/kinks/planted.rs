//! Formulas and graphs planted in the tests of the search for kinks: operations on three numbers.

use crate::connector::slot::ContactForce;
use crate::formula::Fields;
use crate::formula::proof::Convention;
use crate::formula::quantity::{Domain, Quantity, Unit};
use crate::toolkit::graph::{Graph, Node, Op, Relation};
use crate::toolkit::verify::{Kink, Subject};
use crate::{Error, Octuple, fields};

const X: Quantity = Quantity::scalar("x", Unit::L, Domain::Real, "first number");
const Y: Quantity = Quantity::scalar("y", Unit::F, Domain::Within(0.0, 4.0), "second number");
const C: Quantity = Quantity::scalar("c", Unit::L, Domain::Positive, "third number");

const A: Quantity = Quantity::scalar("a", Unit::L, Domain::Real, "first result");
const B: Quantity = Quantity::scalar("b", Unit::L, Domain::Real, "second result");

fields! { pub(super) struct Inputs<T> { x: T = X, y: T = Y, c: T = C } }
fields! { struct Outputs<T> { a: T = A, b: T = B } }

/// A function in 237 bits.
pub(super) type Function = fn(&[Octuple]) -> Vec<Octuple>;

/// A formula of x, of y from 0 to 4, and of c > 0, with outputs a and b; it has no kinks and rejects nothing.
pub(super) fn planted(value: Function, jacobian: Function) -> Subject {
    let mut subject = Subject::of::<ContactForce>();
    (subject.inputs, subject.outputs) = (Inputs::<f64>::FIELDS, Outputs::<f64>::FIELDS);
    (subject.exact_value, subject.exact_jacobian) = (value, jacobian);
    subject.check = |_| Ok(());
    subject.is_valid = |_| true;
    (subject.cases, subject.invalid_cases) = (Vec::new, Vec::new);
    subject.kinks.clear();
    subject
}

/// A kink at which the derivative is 0.
pub(super) fn kink(condition: &str, holds: fn(&[Octuple]) -> bool, at: [f64; 3], across: [f64; 3]) -> Kink {
    Kink {
        condition: condition.into(),
        convention: Convention::Subgradient,
        holds: Box::new(holds),
        at: at.into(),
        across: across.into(),
    }
}

/// Rejects inputs unless this holds.
pub(super) fn only_where(holds: bool) -> Result<(), Error> {
    let (first, second, third) = ("e1", "e2", "e3");
    if holds { Ok(()) } else { Err(Error::LeftHanded { first, second, third }) }
}

/// A graph with inputs x, y and c and this value.
pub(super) fn graph(value: impl FnOnce(&mut Graph, [Node; 3]) -> Vec<Node>) -> Graph {
    let mut graph = Graph::default();
    let inputs = graph.inputs();
    graph.value = value(&mut graph, inputs);
    graph
}

/// Adds operations one by one.
impl Graph {
    pub(super) fn inputs<const N: usize>(&mut self) -> [Node; N] {
        std::array::from_fn(|k| self.enter(Op::Input(k)))
    }

    pub(super) fn compare(&mut self, relation: Relation, x: Node, y: Node) -> Node {
        self.enter(Op::Compare(relation, x, y))
    }

    pub(super) fn select(&mut self, condition: Node, x: Node, y: Node) -> Node {
        self.enter(Op::Select(condition, x, y))
    }
}
