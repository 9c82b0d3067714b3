//! A short description of a result of a graph.

use jointproof::formula::Field;
use jointproof::toolkit::graph::{Binary, Graph, Node, Op, Relation, Unary};

/// The depth to which it is written out.
const DEPTH: usize = 4;
/// The largest length.
const LONGEST: usize = 60;

/// An expression in terms of the input names; deeper parts are written as `…`.
pub(super) fn expression(graph: &Graph, inputs: &[Field], node: Node) -> String {
    let write = |depth| text(graph, inputs, node, depth, false);
    (1..=DEPTH).rev().map(write).find(|text| text.chars().count() <= LONGEST).unwrap_or_else(|| "…".into())
}

/// In parentheses if it is a sum within a product.
fn text(graph: &Graph, inputs: &[Field], node: Node, depth: usize, tight: bool) -> String {
    let is_atom = matches!(graph.op(node), Op::Input(_) | Op::Number(_));
    let Some(depth) = depth.checked_sub(usize::from(!is_atom)) else { return "…".into() };
    let of = |node: &Node, tight: bool| text(graph, inputs, *node, depth, tight);
    let list = |nodes: &[Node]| nodes.iter().map(|node| of(node, false)).collect::<Vec<_>>().join(", ");
    let grouped = |text: String| if tight { format!("({text})") } else { text };
    match graph.op(node) {
        Op::Input(k) => component(inputs, *k),
        Op::Number(bits) => format!("{}", f64::from_bits(*bits)),
        Op::Unary(Unary::Negative, x) => grouped(format!("−{}", of(x, true))),
        Op::Unary(Unary::Absolute, x) => format!("|{}|", of(x, false)),
        Op::Unary(Unary::Root, x) => format!("√({})", of(x, false)),
        Op::Unary(Unary::Sine, x) => format!("sin({})", of(x, false)),
        Op::Unary(Unary::Cosine, x) => format!("cos({})", of(x, false)),
        Op::Unary(Unary::ArcSine, x) => format!("arcsin({})", of(x, false)),
        Op::Unary(Unary::Exponential, x) => format!("exp({})", of(x, false)),
        Op::Unary(Unary::ExponentialMinusOne, x) => format!("expm1({})", of(x, false)),
        Op::Unary(Unary::PowerOfTwo, x) => format!("power of two below {}", of(x, true)),
        Op::Unary(Unary::NearestInteger, x) => format!("integer nearest to {}", of(x, true)),
        Op::Binary(Binary::Add, x, y) => grouped(format!("{} + {}", of(x, false), of(y, false))),
        Op::Binary(Binary::Subtract, x, y) => grouped(format!("{} − {}", of(x, false), of(y, true))),
        Op::Binary(Binary::Multiply, x, y) => format!("{} {}", of(x, true), of(y, true)),
        Op::Binary(Binary::Divide, x, y) => grouped(format!("{} / {}", of(x, true), of(y, true))),
        Op::Binary(Binary::Angle, y, x) => format!("atan2({}, {})", of(y, false), of(x, false)),
        Op::Binary(Binary::Maximum, x, y) => format!("max({}, {})", of(x, false), of(y, false)),
        Op::MultiplyAdd(x, y, z) => grouped(format!("{} {} + {}", of(x, true), of(y, true), of(z, false))),
        Op::Norm(parts) => format!("length({})", list(parts)),
        Op::ExactSum(products) => {
            let product = |product: &[Node; 4]| {
                let factors = product.iter().filter(|node| graph.constant(**node) != Some(1.0));
                factors.map(|node| of(node, true)).collect::<Vec<_>>().join(" ")
            };
            grouped(products.iter().map(product).collect::<Vec<_>>().join(" + "))
        }
        Op::Search(search, numbers) => format!("{}({})", search.name, list(numbers)),
        Op::Compare(relation, x, y) => {
            let sign = match relation {
                Relation::Less => "<",
                Relation::LessOrEqual => "≤",
                Relation::Equal => "=",
            };
            format!("{} {sign} {}", of(x, false), of(y, false))
        }
        Op::Select(condition, x, y) => {
            format!("({} if {} else {})", of(x, false), of(condition, false), of(y, false))
        }
    }
}

/// A number in a few digits, where these are all that it has.
pub(super) fn short(x: f64) -> String {
    let text = format!("{x:.9}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if (short.parse::<f64>().unwrap_or(f64::NAN) - x).abs() <= 1e-8 * x.abs() {
        short.to_owned()
    } else {
        format!("{x:e}")
    }
}

/// The name of a component of the inputs.
pub(super) fn component(inputs: &[Field], mut k: usize) -> String {
    for field in inputs {
        if k < field.len() {
            return if field.len() == 1 { field.name.to_owned() } else { format!("{}[{k}]", field.name) };
        }
        k -= field.len();
    }
    unreachable!("a graph has the inputs of its formula")
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::toolkit::graph::Instead;

    #[test]
    fn sums_are_in_parentheses_within_products_alone() {
        let formula = jointproof::catalog::find("slot.normal_force").unwrap();
        let graph = formula.graph().unwrap();
        let results = |graph: &Graph| [graph.value.as_slice(), &graph.jacobian].concat();
        let nodes = graph.needed(&results(&graph));
        let find = |is_it: &dyn Fn(&Op) -> bool| *nodes.iter().find(|node| is_it(graph.op(**node))).unwrap();
        // All others come before it, so it is a result.
        let last = *nodes.last().unwrap();
        let place = results(&graph).iter().position(|node| *node == last).unwrap();
        let sum = find(&|op| matches!(op, Op::Binary(Binary::Add, ..)));
        let [force, one] = [find(&|op| matches!(op, Op::Input(0))), find(&|op| *op == Op::Number(1.0_f64.to_bits()))];
        let written = |op: Op| {
            let altered = graph.altered(last, &Instead::Op(op));
            expression(&altered, formula.inputs(), results(&altered)[place])
        };
        assert_eq!(written(Op::Unary(Unary::Absolute, sum)), "|fc + fc_int|");
        assert_eq!(written(Op::Unary(Unary::Negative, sum)), "−(fc + fc_int)");
        assert_eq!(written(Op::Norm([sum, force].into())), "length(fc + fc_int, fc)");
        let products = [[sum, force, one, one], [force, one, one, one]];
        assert_eq!(written(Op::ExactSum(products.into())), "(fc + fc_int) fc + fc");
    }
}
