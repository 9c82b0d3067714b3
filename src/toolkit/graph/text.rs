//! A graph as text, for programs that check what is said about it.

use super::node::{Binary, Graph, Node, Op, Relation, Unary};
use crate::formula::Field;
use crate::formula::quantity::Domain;
use std::fmt::Write;

impl Graph {
    /// The operations, a line each and in order, each a list in JSON: the name, then the operands by index from 0. An input has its
    /// bounds, or `null`; a number its 64 bits in hexadecimal digits. The last two lines are the results: `value` and `jacobian`.
    ///
    /// `inputs` are the fields of the formula. The digest of this text stands in whatever is tied to the graph.
    pub fn text(&self, inputs: &[Field]) -> String {
        let bounds: Vec<_> = inputs.iter().flat_map(|field| vec![bounds(field.quantity.domain); field.len()]).collect();
        let mut text = String::new();
        for op in self.ops() {
            let _ = match op {
                Op::Input(k) => writeln!(text, "[\"input\", {k}, {}]", bounds[*k].map(shown).join(", ")),
                Op::Number(bits) => writeln!(text, "[\"number\", \"{bits:016x}\"]"),
                Op::Search(search, _) => line(&mut text, &format!("search {}", search.name), &op.operands()),
                _ => line(&mut text, op.name(), &op.operands()),
            };
        }
        for (name, results) in [("value", &self.value), ("jacobian", &self.jacobian)] {
            let _ = line(&mut text, name, results);
        }
        text
    }
}

fn line(text: &mut String, name: &str, operands: &[Node]) -> std::fmt::Result {
    write!(text, "[\"{name}\"")?;
    operands.iter().try_for_each(|operand| write!(text, ", {}", operand.index()))?;
    writeln!(text, "]")
}

/// The bounds of a domain, where it has some.
pub(crate) fn bounds(domain: Domain) -> [Option<f64>; 2] {
    match domain {
        Domain::NonNegative | Domain::Positive => [Some(0.0), None],
        Domain::Between(low, high) | Domain::Within(low, high) | Domain::HalfOpen(low, high) => [Some(low), Some(high)],
        _ => [None, None],
    }
}

fn shown(bound: Option<f64>) -> String {
    bound.map_or("null".into(), |bound| format!("{bound:?}"))
}

impl Op {
    /// The name of the operation.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Input(_) => "input",
            Self::Number(_) => "number",
            Self::Unary(function, _) => match function {
                Unary::Negative => "negative",
                Unary::Absolute => "absolute",
                Unary::Root => "root",
                Unary::Sine => "sine",
                Unary::Cosine => "cosine",
                Unary::ArcSine => "arc sine",
                Unary::Exponential => "exponential",
                Unary::ExponentialMinusOne => "exponential minus one",
                Unary::PowerOfTwo => "power of two",
                Unary::NearestInteger => "nearest integer",
            },
            Self::Binary(operation, ..) => match operation {
                Binary::Add => "add",
                Binary::Subtract => "subtract",
                Binary::Multiply => "multiply",
                Binary::Divide => "divide",
                Binary::Angle => "angle",
                Binary::Maximum => "maximum",
            },
            Self::MultiplyAdd(..) => "multiply and add",
            Self::Norm(_) => "norm",
            Self::ExactSum(_) => "exact sum",
            Self::Search(..) => "search",
            Self::Compare(relation, ..) => match relation {
                Relation::Less => "less",
                Relation::LessOrEqual => "less or equal",
                Relation::Equal => "equal",
            },
            Self::Select(..) => "select",
        }
    }
}
