//! What is known of signs and sizes on a way: from domains, squares, magnitudes, and from what its comparisons say.

use super::field::{POINTS, Rational, Values};
use super::parts::{negative, product, sum};
use super::way::Way;
use crate::toolkit::graph::{Binary, Node, Op, Relation, Unary};
use num_traits::Zero;
use std::collections::{BTreeMap, BTreeSet};

/// Which of two numbers is not above the other one, by which comparison.
pub(super) struct Order {
    /// The lesser, the greater, and the comparison.
    pairs: Vec<[Node; 3]>,
    /// The numbers of the way and those that are compared, with all that they are computed from, operands first.
    pub(super) nodes: Vec<Node>,
}

impl Order {
    pub(super) fn of(way: &Way) -> Self {
        let mut nodes: BTreeSet<Node> = way.nodes.iter().copied().collect();
        let mut pairs = Vec::new();
        for (&by, &answer) in way.answers {
            let (x, y, is_both) = match *way.graph.op(by) {
                Op::Compare(Relation::Equal, _, _) if !answer => continue,
                Op::Compare(relation, x, y) => (x, y, relation == Relation::Equal),
                // The answer says whether the maximum is its first operand.
                Op::Binary(Binary::Maximum, x, y) => (y, x, false),
                _ => continue,
            };
            let (Ok(x), Ok(y)) = (way.resolved(x), way.resolved(y)) else { continue };
            let (Ok(of_x), Ok(of_y)) = (way.needed(x), way.needed(y)) else { continue };
            nodes.extend(of_x.into_iter().chain(of_y));
            let (less, more) = if answer { (x, y) } else { (y, x) };
            pairs.push([less, more, by]);
            if is_both {
                pairs.push([more, less, by]);
            }
        }
        Self { pairs, nodes: nodes.into_iter().collect() }
    }
}

/// One number is at most as large as another one, in magnitude.
pub(super) struct Compared {
    smaller: Values,
    larger: Values,
    pub(super) by: Node,
}

impl Compared {
    /// How many times the second the first is at most, if their ratio is that of these numbers, or of their sum or difference and the
    /// larger one.
    pub(super) fn ratio(&self, first: &Values, second: &Values) -> Option<Rational> {
        let left = product(first, &self.larger);
        let is = |most: i128, number: &Values| {
            let right = product(second, number);
            (left == right || left == negative(&right)).then(|| Rational::from(most))
        };
        is(1, &self.smaller)
            .or_else(|| is(2, &sum(&self.smaller, &self.larger)))
            .or_else(|| is(2, &sum(&self.smaller, &negative(&self.larger))))
    }
}

/// What is known of the sign of a number.
#[derive(Clone, Copy, Default, PartialEq)]
struct Sign {
    /// It is not below 0.
    is_up: bool,
    /// It is not above 0.
    is_down: bool,
}

impl Sign {
    fn turned(self) -> Self {
        Self { is_up: self.is_down, is_down: self.is_up }
    }
    fn both(self, other: Self) -> Self {
        Self { is_up: self.is_up && other.is_up, is_down: self.is_down && other.is_down }
    }
    fn or(self, other: Self) -> Self {
        Self { is_up: self.is_up || other.is_up, is_down: self.is_down || other.is_down }
    }
    fn times(self, other: Self) -> Self {
        let is_up = self.is_up && other.is_up || self.is_down && other.is_down;
        Self { is_up, is_down: self.is_up && other.is_down || self.is_down && other.is_up }
    }
}

/// The signs of the numbers of a way.
pub(super) struct Signs {
    signs: BTreeMap<Node, Sign>,
    /// The sums in which nothing cancels.
    adding: BTreeSet<Node>,
    pub(super) compared: Vec<Compared>,
}

impl Signs {
    pub(super) fn of(way: &Way, bounds: &[[Option<f64>; 2]], order: &Order, values: &BTreeMap<Node, Values>) -> Self {
        let mut all = Self { signs: BTreeMap::new(), adding: BTreeSet::new(), compared: Vec::new() };
        let mut said: BTreeMap<Node, Sign> = BTreeMap::new();
        // What is learned from one round serves the next.
        for _ in 0..4 {
            for &node in &order.nodes {
                let sign = all.sign(way, bounds, order, node).or(said.get(&node).copied().unwrap_or_default());
                all.signs.insert(node, sign);
            }
            all.compared.clear();
            for &[less, more, by] in &order.pairs {
                let (low, high) = (all.signs[&less], all.signs[&more]);
                said.entry(more).or_default().is_up |= low.is_up;
                said.entry(less).or_default().is_down |= high.is_down;
                let sizes = [(low.is_up, less, more), (high.is_down, more, less)];
                for (_, smaller, larger) in sizes.into_iter().filter(|(is, ..)| *is) {
                    let [smaller, larger] = [smaller, larger].map(|node| values[&without_sign(way, node)]);
                    if larger != [0; POINTS] && smaller != [0; POINTS] {
                        all.compared.push(Compared { smaller, larger, by });
                    }
                }
            }
            for &node in &order.nodes {
                said.entry(node).or_insert_with(Sign::default);
                let learned = all.by_size(way, node, values);
                said.entry(node).and_modify(|sign| *sign = sign.or(learned));
            }
        }
        for &node in &order.nodes {
            if matches!(way.graph.op(node), Op::Norm(_)) || all.terms(way, node).is_some_and(Self::agree) {
                all.adding.insert(node);
            }
        }
        all
    }

    /// Whether nothing cancels in this sum or norm.
    pub(super) fn adds_up(&self, node: Node) -> bool {
        self.adding.contains(&node)
    }

    fn agree([x, y]: [Sign; 2]) -> bool {
        x.is_up && y.is_up || x.is_down && y.is_down
    }

    /// The signs of the terms of a sum of two.
    fn terms(&self, way: &Way, node: Node) -> Option<[Sign; 2]> {
        let operands = way.operands(node).ok()?;
        let of = |place: usize| self.signs.get(&operands[place]).copied().unwrap_or_default();
        match way.graph.op(node) {
            Op::Binary(Binary::Add, ..) => Some([of(0), of(1)]),
            Op::Binary(Binary::Subtract, ..) => Some([of(0), of(1).turned()]),
            Op::MultiplyAdd(..) => Some([of(0).times(of(1)), of(2)]),
            _ => None,
        }
    }

    fn sign(&self, way: &Way, bounds: &[[Option<f64>; 2]], order: &Order, node: Node) -> Sign {
        let up = Sign { is_up: true, is_down: false };
        let operands = way.operands(node).unwrap_or_default();
        let of = |place: usize| self.signs.get(&operands[place]).copied().unwrap_or_default();
        match way.graph.op(node) {
            Op::Input(k) => {
                let [low, high] = bounds[*k];
                Sign { is_up: low.is_some_and(|low| low >= 0.0), is_down: high.is_some_and(|high| high <= 0.0) }
            }
            Op::Number(bits) => {
                let x = f64::from_bits(*bits);
                Sign { is_up: x >= 0.0, is_down: x <= 0.0 }
            }
            Op::Norm(_) => up,
            Op::Unary(function, _) => match function {
                Unary::Absolute | Unary::Root | Unary::Exponential | Unary::PowerOfTwo => up,
                Unary::Negative => of(0).turned(),
                Unary::ExponentialMinusOne | Unary::ArcSine => of(0),
                Unary::Sine | Unary::Cosine | Unary::NearestInteger => Sign::default(),
            },
            Op::Binary(Binary::Angle, ..) => of(0),
            Op::Binary(Binary::Multiply, ..) if operands[0] == operands[1] => up,
            Op::Binary(Binary::Multiply | Binary::Divide, ..) => of(0).times(of(1)),
            Op::Binary(Binary::Subtract, ..) => {
                let is_order = |less: usize, more: usize| {
                    order.pairs.iter().any(|pair| pair[..2] == [operands[less], operands[more]])
                };
                let ordered = Sign { is_up: is_order(1, 0), is_down: is_order(0, 1) };
                ordered.or(of(0).both(of(1).turned()))
            }
            _ => self.terms(way, node).map(|[x, y]| x.both(y)).unwrap_or_default(),
        }
    }

    /// A sum that is at least as large as one of its two terms has the sign of the other one.
    fn by_size(&self, way: &Way, node: Node, values: &BTreeMap<Node, Values>) -> Sign {
        let (Some(terms), Op::Binary(..)) = (self.terms(way, node), way.graph.op(node)) else { return Sign::default() };
        let operands = way.operands(node).unwrap_or_default();
        let is_as_large_as = |place: usize| {
            let at_most = |compared: &Compared| compared.ratio(&values[&operands[place]], &values[&node]);
            self.compared.iter().any(|compared| at_most(compared) == Some(Rational::from(1)))
        };
        let of = |place: usize| if is_as_large_as(place) { terms[1 - place] } else { Sign::default() };
        of(0).or(of(1))
    }

    /// Whether the error is of the first order up to a factor of 1 + O(u): if no factor but one of any product, no divisor and no
    /// argument of a function is a difference of rounded numbers, of which nothing may be left.
    pub(super) fn is_first_order(&self, way: &Way) -> bool {
        let (mut is_rounded, mut cancels) = (BTreeMap::new(), BTreeMap::new());
        way.nodes.iter().all(|&node| {
            let operands = way.operands(node).unwrap_or_default();
            let some = |of: &BTreeMap<Node, bool>| operands.iter().filter(|&operand| of[operand]).count();
            let (rounded, cancelling) = (some(&is_rounded), some(&cancels));
            let is_sum = matches!(
                way.graph.op(node),
                Op::Binary(Binary::Add | Binary::Subtract, ..) | Op::MultiplyAdd(..) | Op::ExactSum(_)
            );
            is_rounded.insert(node, rounded > 0 || !way.roundings(node).is_zero());
            cancels.insert(node, cancelling > 0 || is_sum && rounded > 0 && !self.adds_up(node));
            match way.graph.op(node) {
                Op::Unary(Unary::Negative | Unary::Absolute, _) => true,
                Op::Binary(Binary::Add | Binary::Subtract, ..) => true,
                Op::Binary(Binary::Multiply, ..) | Op::MultiplyAdd(..) => cancelling <= 1,
                Op::Binary(Binary::Divide, ..) => !cancels[&operands[1]],
                _ => cancelling == 0,
            }
        })
    }
}

/// The number whose magnitude this is.
fn without_sign(way: &Way, node: Node) -> Node {
    match way.graph.op(node) {
        Op::Unary(Unary::Absolute | Unary::Negative, _) => {
            way.operands(node).map_or(node, |operands| without_sign(way, operands[0]))
        }
        _ => node,
    }
}
