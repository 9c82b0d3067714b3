//! The numbers of a way at points where they look random.

use super::field::{self, POINTS, Values};
use super::way::Way;
use crate::toolkit::graph::{Binary, Node, Op, Unary};
use std::collections::{BTreeMap, BTreeSet};

/// Trials of a point at which all roots exist.
const TRIALS: u64 = 4096;

/// An operation, its operands by position, and its value if it is an exact constant.
struct Step<'a> {
    node: Node,
    op: &'a Op,
    operands: Vec<usize>,
    constant: Option<u64>,
}

/// These numbers of a way at all points from the first on; `None` if its roots do not exist at the same points.
pub(super) fn values(way: &Way, nodes: &[Node], start: u64) -> Option<BTreeMap<Node, Values>> {
    let mut values: BTreeMap<Node, Values> = nodes.iter().map(|&node| (node, [0; POINTS])).collect();
    let places: BTreeMap<Node, usize> = nodes.iter().enumerate().map(|(place, &node)| (node, place)).collect();
    let operands = |node: Node| way.operands(node).unwrap_or_default().iter().map(|operand| places[operand]).collect();
    let constant = |node: Node| way.exact(node).and_then(field::of_rational);
    let steps: Vec<_> = nodes
        .iter()
        .map(|&node| Step { node, op: way.graph.op(node), operands: operands(node), constant: constant(node) })
        .collect();
    let mut not_squares = BTreeSet::new();
    for (k, point) in (start..start + POINTS as u64).enumerate() {
        let mut trials = (0..TRIALS).map(|trial| at_point(&steps, point * TRIALS + trial, &mut not_squares));
        let found = trials.find_map(|found| found)?;
        values.values_mut().zip(found).for_each(|(values, value)| values[k] = value);
    }
    // The root of a square is a magnitude, whose sign the root in the field does not have. Of others every second root does not exist.
    let mut more = (start + POINTS as u64) * TRIALS..(start + POINTS as u64 + 1) * TRIALS;
    let roots = nodes.iter().filter(|node| matches!(way.graph.op(**node), Op::Unary(Unary::Root, _) | Op::Norm(_)));
    for root in roots {
        let is_no_square = |of: &BTreeSet<Node>| of.contains(root);
        while !is_no_square(&not_squares) {
            let point = more.next()?;
            at_point(&steps, point, &mut not_squares);
        }
    }
    Some(values)
}

/// The numbers at one point; `None` where a root or a quotient does not exist. Roots that do not are noted.
fn at_point(steps: &[Step], point: u64, not_squares: &mut BTreeSet<Node>) -> Option<Vec<u64>> {
    let (mut values, mut is_point): (Vec<u64>, _) = (Vec::with_capacity(steps.len()), true);
    for &Step { node, op, ref operands, constant } in steps {
        let symbol = || field::random([point, node.index() as u64, 0]);
        let x: Vec<u64> = operands.iter().map(|&operand| values[operand]).collect();
        let products = |x: &[u64]| x.iter().copied().reduce(field::multiply).unwrap_or(1);
        let mut root = |square: u64| {
            let is_other = field::random([point, node.index() as u64, 1]) & 1 == 1;
            let root = field::root(square).map(|root| if is_other { field::negative(root) } else { root });
            root.unwrap_or_else(|| {
                not_squares.insert(node);
                is_point = false;
                symbol()
            })
        };
        let value = match op {
            Op::Number(_) => constant.unwrap_or_else(symbol),
            Op::Unary(Unary::Negative, _) => field::negative(x[0]),
            // The sign is as unknown as a number.
            Op::Unary(Unary::Absolute, _) => field::multiply(x[0], symbol()),
            Op::Unary(Unary::Root, _) => root(x[0]),
            Op::Binary(Binary::Add, ..) => field::add(x[0], x[1]),
            Op::Binary(Binary::Subtract, ..) => field::add(x[0], field::negative(x[1])),
            Op::Binary(Binary::Multiply, ..) => products(&x),
            Op::Binary(Binary::Divide, ..) => field::multiply(x[0], field::inverse(x[1])?),
            Op::MultiplyAdd(..) => field::add(products(&x[..2]), x[2]),
            Op::ExactSum(_) => x.chunks(4).map(products).fold(0, field::add),
            Op::Norm(_) => root(x.iter().map(|&x| field::multiply(x, x)).fold(0, field::add)),
            _ => symbol(),
        };
        values.push(value);
    }
    is_point.then_some(values)
}
