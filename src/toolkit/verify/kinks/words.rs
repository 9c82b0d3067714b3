//! Writes a result of a graph as an expression of the inputs.

use crate::toolkit::graph::{Binary, Graph, Node, Op, Relation, Unary};

/// Deeper operations are omitted.
const DEPTH: usize = 5;
/// In longer expressions fewer operations are spelled out.
const LENGTH: usize = 70;

/// A graph, and the names of its inputs.
pub(in crate::toolkit::verify) struct Words<'a> {
    pub(in crate::toolkit::verify) graph: &'a Graph,
    pub(in crate::toolkit::verify) names: &'a [String],
}

/// The precedence of an expression: one of lower precedence than its context needs brackets.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Bond {
    Sum,
    Product,
    Atom,
}

impl Words<'_> {
    /// The expression; inner parts of long ones are omitted.
    pub(in crate::toolkit::verify) fn of(&self, node: Node) -> String {
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
        Unary::NearestInteger => "nearest_integer",
    }
}

fn sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessOrEqual => "≤",
        Relation::Equal => "=",
    }
}

/// Writes small and large numbers with four digits and a power of ten.
fn number(x: f64) -> String {
    let size = x.abs();
    let text = if x == 0.0 || (1e-3..1e6).contains(&size) { x.to_string() } else { format!("{x:.3e}") };
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;
    use Binary::{Add, Angle, Divide, Maximum, Multiply, Subtract};
    use Unary::{
        Absolute, ArcSine, Cosine, Exponential, ExponentialMinusOne, NearestInteger, Negative, PowerOfTwo, Root, Sine,
    };

    fn named(graph: &Graph, names: [&str; 2], node: Node) -> String {
        Words { graph, names: &names.map(str::to_owned) }.of(node)
    }

    /// An operation on x and y, in words.
    fn written(op: impl FnOnce(&mut Graph, [Node; 2]) -> Node) -> String {
        let mut graph = Graph::default();
        let inputs = graph.inputs();
        let node = op(&mut graph, inputs);
        named(&graph, ["x", "y"], node)
    }

    #[test]
    fn small_and_large_numbers_are_short() {
        let shown = [0.0, -0.5, 1e-3, -1e-4, 123_456.0, 1e6, -2.5e7].map(number);
        assert_eq!(shown, ["0", "−0.5", "0.001", "−1.000e−4", "123456", "1.000e6", "−2.500e7"]);
    }

    #[test]
    fn functions_are_called_by_their_names() {
        let of = |function| written(|graph, [x, _]| graph.unary(function, x));
        assert_eq!([Negative, Absolute, Root].map(of), ["−x", "|x|", "√(x)"]);
        assert_eq!([Sine, Cosine, ArcSine].map(of), ["sin(x)", "cos(x)", "asin(x)"]);
        let others = [Exponential, ExponentialMinusOne, PowerOfTwo, NearestInteger].map(of);
        assert_eq!(others, ["exp(x)", "expm1(x)", "power_of_two(x)", "nearest_integer(x)"]);
    }

    #[test]
    fn operations_stand_between_what_they_are_on() {
        let of = |operation| written(|graph, [x, y]| graph.binary(operation, x, y));
        assert_eq!([Add, Subtract, Multiply, Divide].map(of), ["x + y", "x − y", "x y", "x/y"]);
        assert_eq!([Angle, Maximum].map(of), ["atan2(x, y)", "max(x, y)"]);
        let compared = |relation| written(|graph, [x, y]| graph.compare(relation, x, y));
        let relations = [Relation::Less, Relation::LessOrEqual, Relation::Equal];
        assert_eq!(relations.map(compared), ["x < y", "x ≤ y", "x = y"]);
        assert_eq!(written(|graph, [x, y]| graph.enter(Op::MultiplyAdd(x, y, x))), "x y + x");
        assert_eq!(written(|graph, [x, y]| graph.enter(Op::Norm([x, y].into()))), "|(x, y)|");
        let products = [[0, 1, 1, 1], [1, 0, 0, 0]];
        let exact = |graph: &mut Graph, inputs: [Node; 2]| {
            graph.enter(Op::ExactSum(products.map(|product| product.map(|k: usize| inputs[k])).into()))
        };
        assert_eq!(written(exact), "exact_sum(x, y, y, y, y, x, x, x)");
    }

    #[test]
    fn answers_are_joined_and_other_choices_named() {
        let chosen = |select: fn([Node; 2]) -> [Node; 3]| {
            written(|graph, [x, y]| {
                let answers = [(x, y), (y, x)].map(|(x, y)| graph.compare(Relation::Less, x, y));
                let [condition, yes, no] = select(answers);
                graph.select(condition, yes, no)
            })
        };
        assert_eq!(chosen(|[a, b]| [a, b, a]), "x < y and y < x");
        assert_eq!(chosen(|[a, b]| [a, a, b]), "x < y or y < x");
        assert_eq!(chosen(|[a, b]| [a, b, b]), "either(y < x, y < x)");
    }

    /// Expressions of lower precedence than their context are in brackets, and no others.
    #[test]
    fn brackets_stand_where_they_are_needed() {
        let within = |inner, outer: fn(Node, Node) -> Op| {
            written(|graph, [x, y]| {
                let inner = graph.binary(inner, x, y);
                graph.enter(outer(inner, x))
            })
        };
        let of_sum = |outer| within(Add, outer);
        let of_product = |outer| within(Multiply, outer);
        let unary = |function| within(Subtract, function);
        assert_eq!(unary(|inner, _| Op::Unary(Negative, inner)), "−(x − y)");
        assert_eq!(unary(|inner, _| Op::Unary(Absolute, inner)), "|x − y|");
        assert_eq!(unary(|inner, _| Op::Unary(Root, inner)), "√(x − y)");
        assert_eq!(of_product(|inner, _| Op::Unary(Negative, inner)), "−(x y)");
        assert_eq!(of_sum(|inner, x| Op::Binary(Add, inner, x)), "x + y + x");
        assert_eq!(of_sum(|inner, x| Op::Binary(Add, x, inner)), "x + x + y");
        assert_eq!(of_sum(|inner, x| Op::Binary(Subtract, inner, x)), "x + y − x");
        assert_eq!(of_sum(|inner, x| Op::Binary(Subtract, x, inner)), "x − (x + y)");
        assert_eq!(of_product(|inner, x| Op::Binary(Subtract, x, inner)), "x − x y");
        assert_eq!(of_sum(|inner, x| Op::Binary(Multiply, inner, x)), "(x + y) x");
        assert_eq!(of_sum(|inner, x| Op::Binary(Multiply, x, inner)), "x (x + y)");
        assert_eq!(of_product(|inner, x| Op::Binary(Multiply, x, inner)), "x x y");
        assert_eq!(within(Divide, |inner, x| Op::Binary(Multiply, inner, x)), "x/y x");
        assert_eq!(of_sum(|inner, x| Op::Binary(Divide, inner, x)), "(x + y)/x");
        assert_eq!(of_product(|inner, x| Op::Binary(Divide, inner, x)), "x y/x");
        assert_eq!(of_product(|inner, x| Op::Binary(Divide, x, inner)), "x/(x y)");
        assert_eq!(within(Angle, |inner, x| Op::Binary(Divide, x, inner)), "x/atan2(x, y)");
        assert_eq!(within(Maximum, |inner, x| Op::Binary(Divide, x, inner)), "x/max(x, y)");
        assert_eq!(of_sum(|inner, x| Op::MultiplyAdd(inner, x, inner)), "(x + y) x + x + y");
        assert_eq!(of_sum(|inner, x| Op::MultiplyAdd(x, inner, x)), "x (x + y) + x");
        assert_eq!(of_sum(|inner, x| Op::Compare(Relation::Less, inner, x)), "x + y < x");
    }

    /// The precedence of expressions that are no binary operations, as a divisor and as a subtrahend.
    #[test]
    fn a_function_holds_together_and_a_sum_does_not() {
        let divisor = |op: fn([Node; 2]) -> Op| {
            written(|graph, [x, y]| {
                let inner = graph.enter(op([x, y]));
                graph.binary(Divide, x, inner)
            })
        };
        assert_eq!(divisor(|[x, _]| Op::Unary(Negative, x)), "x/(−x)");
        assert_eq!(divisor(|[x, _]| Op::Unary(Absolute, x)), "x/|x|");
        assert_eq!(divisor(|[x, _]| Op::Unary(Sine, x)), "x/sin(x)");
        assert_eq!(divisor(|[x, y]| Op::Norm([x, y].into())), "x/|(x, y)|");
        assert_eq!(divisor(|[x, y]| Op::ExactSum([[x, y, x, y]].into())), "x/exact_sum(x, y, x, y)");
        assert_eq!(divisor(|[x, y]| Op::Select(x, y, y)), "x/either(y, y)");
        assert_eq!(divisor(|_| Op::Number(2.0_f64.to_bits())), "x/2");
        let taken_away = |op: fn([Node; 2]) -> Op| {
            written(|graph, [x, y]| {
                let inner = graph.enter(op([x, y]));
                graph.binary(Subtract, x, inner)
            })
        };
        assert_eq!(taken_away(|[x, _]| Op::Unary(Negative, x)), "x − −x");
        assert_eq!(taken_away(|[x, y]| Op::Binary(Divide, x, y)), "x − x/y");
        assert_eq!(taken_away(|[x, y]| Op::Binary(Subtract, x, y)), "x − (x − y)");
        assert_eq!(taken_away(|[x, y]| Op::MultiplyAdd(x, y, x)), "x − (x y + x)");
        assert_eq!(taken_away(|[x, y]| Op::Compare(Relation::Equal, x, y)), "x − (x = y)");
        assert_eq!(taken_away(|[x, y]| Op::Select(x, y, x)), "x − (x and y)");
        assert_eq!(taken_away(|[x, y]| Op::Select(x, x, y)), "x − (x or y)");
    }

    #[test]
    fn what_is_deep_is_left_out() {
        let nested = |depth: usize| written(|graph, [x, _]| (0..depth).fold(x, |inner, _| graph.unary(Sine, inner)));
        assert_eq!(nested(5), "sin(sin(sin(sin(sin(x)))))");
        assert_eq!(nested(6), "sin(sin(sin(sin(sin(…)))))");
    }

    #[test]
    fn what_is_long_is_written_with_fewer_operations_and_at_last_cut() {
        let mut graph = Graph::default();
        let [x, y] = graph.inputs();
        let sum = graph.binary(Add, x, y);
        let size = graph.unary(Absolute, sum);
        // Two bars and ` + ` are five characters.
        let of = |letters: usize| named(&graph, [&"φ".repeat(letters), "y"], size);
        assert_eq!(of(64), format!("|{} + y|", "φ".repeat(64)));
        assert_eq!(of(65), "|…|");
        let cut = named(&graph, [&"φ".repeat(71), "y"], sum);
        assert_eq!(cut, format!("{}…", "φ".repeat(70)));
    }
}
