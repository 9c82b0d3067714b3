//! What is known of signs and sizes on a way: from domains, squares, magnitudes, and from what its comparisons say.

use super::exact::rational;
use super::field::{self, POINTS, Rational, Values, opposite, product, reciprocal};
use super::way::Way;
use crate::toolkit::graph::{Binary, Node, Op, Relation, Unary};
use num_traits::{Signed, Zero};
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
            let (Ok(of_x), Ok(of_y)) = (way.needed(&[x]), way.needed(&[y])) else { continue };
            nodes.extend(of_x.into_iter().chain(of_y));
            let (less, more) = if answer { (x, y) } else { (y, x) };
            pairs.push([less, more, by]);
            if is_both {
                pairs.push([more, less, by]);
            }
        }
        Self { pairs, nodes: nodes.into_iter().collect() }
    }

    /// The numbers that their domains, and comparisons with constants, bound.
    fn bounded(&self, way: &Way, domains: &[[Option<f64>; 2]], values: &BTreeMap<Node, Values>) -> Vec<Bounded> {
        let mut ends: BTreeMap<Node, [Option<Rational>; 2]> = BTreeMap::new();
        let inputs = self.nodes.iter().filter_map(|&node| match way.graph.op(node) {
            Op::Input(k) => Some((node, domains[*k].map(|end| end.and_then(rational)))),
            _ => None,
        });
        ends.extend(inputs);
        for &[less, more, _] in &self.pairs {
            if let Some(end) = way.exact(less) {
                let low = &mut ends.entry(more).or_default()[0];
                *low = Some(low.map_or(end, |low| low.max(end)));
            }
            if let Some(end) = way.exact(more) {
                let high = &mut ends.entry(less).or_default()[1];
                *high = Some(high.map_or(end, |high| high.min(end)));
            }
        }
        let is_bounded = |ends: &[Option<Rational>; 2]| ends.iter().any(Option::is_some);
        let ends = ends.into_iter().filter(|(node, ends)| is_bounded(ends) && way.exact(*node).is_none());
        ends.map(|(by, [low, high])| Bounded { value: values[&by], low, high, by }).collect()
    }
}

/// A number within bounds: an input or a result that is compared with a constant, or the ratio of two numbers of which one is larger.
pub(super) struct Bounded {
    value: Values,
    low: Option<Rational>,
    high: Option<Rational>,
    /// The number itself, or the comparison.
    pub(super) by: Node,
}

impl Bounded {
    /// The bounds of the ratio of two other numbers, if it is (α + βz)/(γ + δz) with small fractions α, β, γ and δ, z being this number.
    pub(super) fn ratio(&self, first: &Values, second: &Values) -> Option<[Rational; 2]> {
        // α q + β z q − γ p − δ z p = 0 at every point, with the ratio p/q: three points decide, the others confirm.
        let rows: [[u64; 4]; POINTS] = std::array::from_fn(|k| {
            let [z, p, q] = [self.value[k], field::negative(first[k]), second[k]];
            [q, field::multiply(z, q), p, field::multiply(z, p)]
        });
        let [alpha, beta, gamma, delta] = orthogonal(&rows[..3]);
        let factors = [alpha, beta, gamma, delta];
        let sum = |row: &[u64; 4]| row.iter().zip(factors).map(|(&x, y)| field::multiply(x, y)).fold(0, field::add);
        let unit = if gamma == 0 { delta } else { gamma };
        if unit == 0 || rows.iter().any(|row| sum(row) != 0) {
            return None;
        }
        let per_unit = field::inverse(unit)?;
        let fraction = |x: u64| field::to_rational(field::multiply(x, per_unit));
        let [alpha, beta, gamma, delta] = [fraction(alpha)?, fraction(beta)?, fraction(gamma)?, fraction(delta)?];
        // Numerator and denominator at an end; of infinity, their signs and ratio.
        let at = |end: Option<Rational>, infinity: i128| match end {
            Some(z) => [alpha + beta * z, gamma + delta * z],
            None if beta.is_zero() && delta.is_zero() => [alpha, gamma],
            None if delta.is_zero() => [beta * infinity, Rational::zero()],
            None => [beta * infinity, delta * infinity],
        };
        let [low, high] = [at(self.low, -1), at(self.high, 1)];
        // Between the ends, the ratio is monotone unless the denominator changes its sign.
        if !(low[1] * high[1]).is_positive() {
            return None;
        }
        let [low, high] = [low, high].map(|[above, below]| above / below);
        Some([low.min(high), low.max(high)])
    }

    /// How many times the second the first is at most.
    pub(super) fn most(&self, first: &Values, second: &Values) -> Option<Rational> {
        self.ratio(first, second).map(|[low, high]| high.max(-low)).filter(|most| *most <= Rational::from(MOST))
    }
}

/// What is orthogonal to three rows of four.
fn orthogonal(rows: &[[u64; 4]]) -> [u64; 4] {
    let minor = |j: usize| {
        let at = |row: usize, place: usize| rows[row][place + usize::from(place >= j)];
        let pair = |place: usize, other: usize| {
            let [x, y] = [(place, other), (other, place)].map(|(k, l)| field::multiply(at(1, k), at(2, l)));
            field::add(x, field::negative(y))
        };
        let terms = [(0, 1, 2), (1, 2, 0), (2, 0, 1)].map(|(k, l, m)| field::multiply(at(0, k), pair(l, m)));
        terms.into_iter().fold(0, field::add)
    };
    std::array::from_fn(|j| if j % 2 == 0 { minor(j) } else { field::negative(minor(j)) })
}

/// A larger ratio than this serves nobody.
const MOST: i128 = 1000;

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
#[derive(Default)]
pub(super) struct Signs {
    known: BTreeMap<Node, Sign>,
    /// The sums in which nothing cancels.
    adding: BTreeSet<Node>,
    pub(super) bounded: Vec<Bounded>,
}

impl Signs {
    pub(super) fn of(way: &Way, bounds: &[[Option<f64>; 2]], order: &Order, values: &BTreeMap<Node, Values>) -> Self {
        let mut all = Self { known: BTreeMap::new(), adding: BTreeSet::new(), bounded: Vec::new() };
        let mut said: BTreeMap<Node, Sign> = BTreeMap::new();
        // What is learned from one round serves the next.
        for _ in 0..4 {
            for &node in &order.nodes {
                let sign = all.sign(way, bounds, order, node).or(said.get(&node).copied().unwrap_or_default());
                all.known.insert(node, sign);
            }
            all.bounded = order.bounded(way, bounds, values);
            for &[less, more, by] in &order.pairs {
                let (low, high) = (all.known[&less], all.known[&more]);
                said.entry(more).or_default().is_up |= low.is_up;
                said.entry(less).or_default().is_down |= high.is_down;
                let sizes = [(low.is_up, less, more), (high.is_down, more, less)];
                for (_, smaller, larger) in sizes.into_iter().filter(|(is, ..)| *is) {
                    all.bounded.extend(all.by_comparison(
                        values,
                        [smaller, larger].map(|node| without_sign(way, node)),
                        by,
                    ));
                }
            }
            for &node in &order.nodes {
                let learned = all.by_ratio(way, node, values);
                let sign = said.entry(node).or_default();
                *sign = sign.or(learned);
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
        let of = |place: usize| self.known.get(&operands[place]).copied().unwrap_or_default();
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
        let of = |place: usize| self.known.get(&operands[place]).copied().unwrap_or_default();
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

    /// The ratio of a number to a larger one.
    fn by_comparison(&self, values: &BTreeMap<Node, Values>, numbers: [Node; 2], by: Node) -> Option<Bounded> {
        let [smaller, larger] = numbers.map(|node| values[&node]);
        let is_ratio = !larger.contains(&0) && smaller != [0; POINTS];
        let [x, y] = numbers.map(|node| self.known[&node]);
        let sign = x.times(y);
        let [low, high] =
            [(sign.is_up, -1), (sign.is_down, 1)].map(|(is_none, end)| Rational::from(if is_none { 0 } else { end }));
        let value = product(&smaller, &reciprocal(&larger));
        is_ratio.then_some(Bounded { value, low: Some(low), high: Some(high), by })
    }

    /// A sum whose ratio to one of its two terms has a sign that is known.
    fn by_ratio(&self, way: &Way, node: Node, values: &BTreeMap<Node, Values>) -> Sign {
        let (Some(terms), Op::Binary(operation, ..)) = (self.terms(way, node), way.graph.op(node)) else {
            return Sign::default();
        };
        let operands = way.operands(node).unwrap_or_default();
        let of = |place: usize| {
            let value = values[&operands[place]];
            let term = if place == 1 && *operation == Binary::Subtract { opposite(&value) } else { value };
            let ratios = self.bounded.iter().filter_map(|bounded| bounded.ratio(&values[&node], &term));
            ratios.fold(Sign::default(), |sign, [low, high]| {
                sign.or(Sign { is_up: !low.is_negative(), is_down: !high.is_positive() }.times(terms[place]))
            })
        };
        if terms == [Sign::default(); 2] { Sign::default() } else { of(0).or(of(1)) }
    }

    /// Whether the error is of the first order up to a factor of 1 + O(u): if no factor but one of any product, no divisor and no
    /// argument of a function is a difference of rounded numbers, of which nothing may be left.
    pub(super) fn is_first_order(&self, way: &Way) -> bool {
        let (mut is_rounded, mut cancels) = (BTreeMap::new(), BTreeMap::new());
        way.needed(&way.results[..1]).unwrap_or_default().into_iter().all(|node| {
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
                Op::Unary(Unary::Negative | Unary::Absolute, _) | Op::Binary(Binary::Add | Binary::Subtract, ..) => {
                    true
                }
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
