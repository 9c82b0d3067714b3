//! A result of a graph, written as an expression of the inputs.

use crate::graph::{Binary, Graph, Node, Op, Relation, Unary};

/// Deeper operations are left out.
const DEPTH: usize = 5;
/// Longer expressions have fewer operations spelled out.
const LENGTH: usize = 70;

/// A graph, and the names of its inputs.
pub(in crate::verify) struct Words<'a> {
    pub(in crate::verify) graph: &'a Graph,
    pub(in crate::verify) names: &'a [String],
}

/// How strongly an expression holds together: what is looser than its surroundings needs brackets.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Bond {
    Sum,
    Product,
    Atom,
}

impl Words<'_> {
    /// The expression; where it is long, its inner parts are left out.
    pub(in crate::verify) fn of(&self, node: Node) -> String {
        let mut texts = (1..=DEPTH).rev().map(|depth| self.written(node, depth).0);
        let short = texts.find(|text| text.chars().count() <= LENGTH);
        short.unwrap_or_else(|| self.written(node, 1).0.chars().take(LENGTH).chain(['…']).collect())
    }

    fn within(&self, node: Node, depth: usize, bond: Bond) -> String {
        let (text, own) = self.written(node, depth);
        if own < bond { format!("({text})") } else { text }
    }

    fn list(&self, nodes: &[Node], depth: usize) -> String {
        nodes.iter().map(|&node| self.written(node, depth).0).collect::<Vec<_>>().join(", ")
    }

    fn written(&self, node: Node, depth: usize) -> (String, Bond) {
        let op = self.graph.op(node);
        let deeper = match (op, depth.checked_sub(1)) {
            (Op::Input(k), _) => return (self.names[*k].clone(), Bond::Atom),
            (Op::Number(bits), _) => return (number(f64::from_bits(*bits)), Bond::Atom),
            (_, None) => return ("…".into(), Bond::Atom),
            (_, Some(deeper)) => deeper,
        };
        let sum = |node| self.within(node, deeper, Bond::Sum);
        let product = |node| self.within(node, deeper, Bond::Product);
        let atom = |node| self.within(node, deeper, Bond::Atom);
        match op {
            Op::Unary(Unary::Negative, x) => (format!("−{}", atom(*x)), Bond::Product),
            Op::Unary(Unary::Absolute, x) => (format!("|{}|", sum(*x)), Bond::Atom),
            Op::Unary(function, x) => (format!("{}({})", name(*function), sum(*x)), Bond::Atom),
            Op::Binary(Binary::Add, x, y) => (format!("{} + {}", sum(*x), sum(*y)), Bond::Sum),
            Op::Binary(Binary::Subtract, x, y) => (format!("{} − {}", sum(*x), product(*y)), Bond::Sum),
            Op::Binary(Binary::Multiply, x, y) => (format!("{} {}", product(*x), product(*y)), Bond::Product),
            Op::Binary(Binary::Divide, x, y) => (format!("{}/{}", product(*x), atom(*y)), Bond::Product),
            Op::Binary(Binary::Angle, x, y) => (format!("atan2({})", self.list(&[*x, *y], deeper)), Bond::Atom),
            Op::Binary(Binary::Maximum, x, y) => (format!("max({})", self.list(&[*x, *y], deeper)), Bond::Atom),
            Op::MultiplyAdd(x, y, z) => (format!("{} {} + {}", product(*x), product(*y), sum(*z)), Bond::Sum),
            Op::Norm(parts) => (format!("|({})|", self.list(parts, deeper)), Bond::Atom),
            Op::Compare(relation, x, y) => (format!("{} {} {}", sum(*x), sign(*relation), sum(*y)), Bond::Sum),
            Op::ExactSum(products) => (format!("exact_sum({})", self.list(&products.concat(), deeper)), Bond::Atom),
            Op::Search(search, numbers) => (format!("{}({})", search.name, self.list(numbers, deeper)), Bond::Atom),
            Op::Select(_, x, y) => match [op.both_of(), op.either_of()] {
                [Some([x, y]), _] => (format!("{} and {}", sum(x), sum(y)), Bond::Sum),
                [_, Some([x, y])] => (format!("{} or {}", sum(x), sum(y)), Bond::Sum),
                _ => (format!("either({})", self.list(&[*x, *y], deeper)), Bond::Atom),
            },
            Op::Input(_) | Op::Number(_) => unreachable!("they are written above"),
        }
    }
}

fn name(function: Unary) -> &'static str {
    match function {
        Unary::Negative => "−",
        Unary::Absolute => "abs",
        Unary::Root => "√",
        Unary::Sine => "sin",
        Unary::Cosine => "cos",
        Unary::ArcSine => "asin",
        Unary::Exponential => "exp",
        Unary::ExponentialMinusOne => "expm1",
        Unary::PowerOfTwo => "power_of_two",
    }
}

fn sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessOrEqual => "≤",
        Relation::Equal => "=",
    }
}

/// Small and large numbers by four digits of their powers of ten.
fn number(x: f64) -> String {
    let size = x.abs();
    let text = if x == 0.0 || (1e-3..1e6).contains(&size) { x.to_string() } else { format!("{x:.3e}") };
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn small_and_large_numbers_are_short() {
        let shown = [0.0, -0.5, 1e-3, -1e-4, 123_456.0, -2.5e7].map(number);
        assert_eq!(shown, ["0", "−0.5", "0.001", "−1.000e−4", "123456", "−2.500e7"]);
    }
}
