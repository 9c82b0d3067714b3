//! The parts of a result on one way, what rounding loads them with, and the rules by which a load moves from part to part.

use super::field::{self, POINTS, Rational, Values, opposite, product, reciprocal, sum};
use super::sign::{Order, Signs};
use super::way::Way;
use crate::toolkit::graph::{Binary, Node, Op, Unary};
use num_traits::{One, Signed, Zero};
use rustc_hash::FxHashMap;
use std::collections::{BTreeMap, BTreeSet};

/// Trials of a point at which all roots exist.
const TRIALS: u64 = 4096;

/// Why nothing is proved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Obstacle {
    /// There are too many ways.
    Ways,
    /// A search is needed.
    Search,
    /// It has roots that do not exist at the same points.
    Roots,
    /// The rounding of this operation is not bounded by any rule.
    Rounding(Node),
}

/// A part up to a factor, by index.
pub(super) type Atom = usize;
/// A multiple of a part.
pub(super) type Term = (Rational, Atom);

/// The name of a rule: what it follows from, the operation, which derivative the parts have, and which part is bounded.
///
/// The parts of an operation are those of its result (0) and of its operands, or of the uses of its result, in order (from 1). The
/// derivative 0 is that of the final result with respect to the operation; those from 1 are of its uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Rule {
    /// A number's part is the sum of the parts of its uses: one of them is at most the sum of the others.
    Uses(Node, usize),
    /// The part of a sum or a norm is the sum of those of its operands: likewise.
    Sum(Node, usize, usize),
    /// The same where nothing cancels: the parts of the operands together are at most that of the result.
    Parts(Node, usize),
    /// The part of an operand of an angle is at most that of the angle, since |sin θ cos θ| ≤ |θ|.
    Angle(Node),
    /// One part of a sum (or, if the derivative is missing, of uses) is at most so many times another one, since their ratio is a
    /// quotient of linear functions of a number that has bounds: an input, a number compared with a constant, or the ratio of two numbers
    /// that are compared.
    Range(Node, Option<usize>, usize, usize, Node),
}

/// An operation, and which derivative its parts have; none for those of its uses.
pub(super) type Place = (Node, Option<usize>);

impl Rule {
    pub(super) fn place(self) -> Place {
        match self {
            Self::Uses(node, _) | Self::Angle(node) => (node, None),
            Self::Sum(node, form, _) | Self::Parts(node, form) => (node, Some(form)),
            Self::Range(node, form, ..) => (node, form),
        }
    }
}

/// The left parts together are at most the right ones together.
#[derive(Clone, Debug)]
pub(super) struct Inequality {
    pub(super) left: Vec<Term>,
    pub(super) right: Vec<Term>,
}

/// The parts of a result on one way.
#[derive(Default)]
pub(super) struct Parts {
    known: FxHashMap<[u64; POINTS - 1], Vec<Atom>>,
    first: Vec<u64>,
    /// What rounding loads parts with, and an operation that does.
    pub(super) load: BTreeMap<Atom, (Rational, Node)>,
    /// What parts may carry for each unit of the bound: those of inputs, and the result.
    pub(super) room: BTreeMap<Atom, Rational>,
    /// The rules.
    pub(super) rules: BTreeMap<Rule, Inequality>,
    /// Whether more than the first order counts.
    pub(super) is_first_order: bool,
}

impl Parts {
    /// All parts, and the rules of these places, or all rules.
    pub(super) fn new(
        way: &Way,
        bounds: &[[Option<f64>; 2]],
        wanted: Option<&BTreeSet<Place>>,
    ) -> Result<Self, Obstacle> {
        let order = Order::of(way);
        let values = values(way, &order.nodes)?;
        let signs = Signs::of(way, bounds, &order, &values);
        let mut build =
            Build { way, values: &values, signs: &signs, wanted, parts: Self::default(), uses: BTreeMap::new() };
        build.all()?;
        let mut parts = build.parts;
        parts.is_first_order = signs.is_first_order(way);
        Ok(parts)
    }

    pub(super) fn count(&self) -> usize {
        self.first.len()
    }

    /// The part with these values; none if it is 0.
    fn at(&mut self, values: Values) -> Option<Term> {
        let per_first = field::inverse(values[0])?;
        let key = std::array::from_fn(|k| field::multiply(values[k + 1], per_first));
        let known = self.known.entry(key).or_default();
        let ratio = |atom: Atom| {
            let ratio = field::multiply(values[0], field::inverse(self.first[atom])?);
            Some((field::to_rational(ratio)?, atom))
        };
        Some(known.iter().find_map(|&atom| ratio(atom)).unwrap_or_else(|| {
            known.push(self.first.len());
            self.first.push(values[0]);
            (Rational::one(), self.first.len() - 1)
        }))
    }
}

/// An operation, its operands by position, and its value if it is an exact constant.
struct Step<'a> {
    node: Node,
    op: &'a Op,
    operands: Vec<usize>,
    constant: Option<u64>,
}

/// The numbers of a way, and those that its comparisons compare, at all points.
fn values(way: &Way, nodes: &[Node]) -> Result<BTreeMap<Node, Values>, Obstacle> {
    let mut values: BTreeMap<Node, Values> = nodes.iter().map(|&node| (node, [0; POINTS])).collect();
    let places: BTreeMap<Node, usize> = nodes.iter().enumerate().map(|(place, &node)| (node, place)).collect();
    let operands = |node: Node| way.operands(node).unwrap_or_default().iter().map(|operand| places[operand]).collect();
    let constant = |node: Node| way.exact(node).and_then(field::of_rational);
    let steps: Vec<_> = nodes
        .iter()
        .map(|&node| Step { node, op: way.graph.op(node), operands: operands(node), constant: constant(node) })
        .collect();
    let mut not_squares = BTreeSet::new();
    for point in 0..POINTS as u64 {
        let mut trials = (0..TRIALS).map(|trial| at_point(&steps, point * TRIALS + trial, &mut not_squares));
        let found = trials.find_map(|found| found).ok_or(Obstacle::Roots)?;
        for (values, value) in values.values_mut().zip(found) {
            values[usize::try_from(point).unwrap_or(0)] = value;
        }
    }
    // The root of a square is a magnitude, whose sign the root in the field does not have. Of others every second root does not exist.
    let mut more = POINTS as u64 * TRIALS..(POINTS as u64 + 1) * TRIALS;
    let roots = nodes.iter().filter(|node| matches!(way.graph.op(**node), Op::Unary(Unary::Root, _) | Op::Norm(_)));
    for root in roots {
        let is_no_square = |of: &BTreeSet<Node>| of.contains(root);
        while !is_no_square(&not_squares) {
            let point = more.next().ok_or(Obstacle::Roots)?;
            at_point(&steps, point, &mut not_squares);
        }
    }
    Ok(values)
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

struct Build<'a> {
    way: &'a Way<'a>,
    values: &'a BTreeMap<Node, Values>,
    signs: &'a Signs,
    wanted: Option<&'a BTreeSet<Place>>,
    parts: Parts,
    /// The derivatives of the result with respect to a number, one for each use.
    uses: BTreeMap<Node, Vec<Values>>,
}

impl Build<'_> {
    fn all(&mut self) -> Result<(), Obstacle> {
        self.uses.insert(self.way.result, vec![[1; POINTS]]);
        for &node in self.way.nodes.iter().rev() {
            let Some(uses) = self.uses.remove(&node) else { continue };
            let total = uses.iter().copied().reduce(|x, y| sum(&x, &y)).unwrap_or([0; POINTS]);
            let value = self.values[&node];
            let whole = self.part(&value, &total);
            let mut forms = vec![total];
            if uses.len() > 1 && self.wants(node, None) {
                let parts: Vec<_> = uses.iter().map(|by| product(&value, by)).collect();
                self.equation(node, None, &product(&value, &total), &parts);
            }
            if uses.len() > 1 {
                forms.extend(uses);
            }
            if let Some((factor, atom)) = whole {
                let roundings = self.way.roundings(node) * factor.abs();
                if roundings.is_positive() {
                    self.parts.load.entry(atom).or_insert((Rational::zero(), node)).0 += roundings;
                }
                if matches!(self.way.graph.op(node), Op::Input(_)) {
                    *self.parts.room.entry(atom).or_default() += factor.abs();
                }
            }
            // A number that is always 0 has no part, but what it is made of may have.
            self.operation(node, &forms)?;
        }
        if let Some((factor, atom)) = self.part(&self.values[&self.way.result], &[1; POINTS]) {
            *self.parts.room.entry(atom).or_default() += factor.abs();
        }
        Ok(())
    }

    fn part(&mut self, value: &Values, by: &Values) -> Option<Term> {
        self.parts.at(product(value, by))
    }

    /// Hands the derivatives on to the operands, and adds the rules of the operation.
    fn operation(&mut self, node: Node, forms: &[Values]) -> Result<(), Obstacle> {
        let way = self.way;
        let operands = way.operands(node).unwrap_or_default();
        let x: Vec<Values> = operands.iter().map(|operand| self.values[operand]).collect();
        let (value, by) = (self.values[&node], forms[0]);
        let symbol = || std::array::from_fn(|k| field::random([k as u64, node.index() as u64, 2]));
        match way.graph.op(node) {
            Op::Search(..) => return Err(Obstacle::Search),
            Op::Unary(function, _) => {
                let slope = match function {
                    Unary::Negative => [field::negative(1); POINTS],
                    Unary::Absolute => product(&value, &reciprocal(&x[0])),
                    Unary::Root => reciprocal(&sum(&value, &value)),
                    Unary::Exponential => value,
                    Unary::ExponentialMinusOne => sum(&value, &[1; POINTS]),
                    Unary::PowerOfTwo | Unary::NearestInteger => return Ok(()),
                    Unary::Sine | Unary::Cosine | Unary::ArcSine => symbol(),
                };
                self.hand_on(operands[0], product(&by, &slope));
            }
            Op::Binary(Binary::Multiply, ..) => {
                self.hand_on(operands[0], product(&by, &x[1]));
                self.hand_on(operands[1], product(&by, &x[0]));
            }
            Op::Binary(Binary::Divide, ..) => {
                let slope = product(&by, &reciprocal(&x[1]));
                self.hand_on(operands[0], slope);
                self.hand_on(operands[1], opposite(&product(&slope, &value)));
            }
            Op::Binary(Binary::Angle, ..) => {
                let square = sum(&product(&x[0], &x[0]), &product(&x[1], &x[1]));
                let slope = product(&by, &reciprocal(&square));
                self.hand_on(operands[0], product(&slope, &x[1]));
                self.hand_on(operands[1], opposite(&product(&slope, &x[0])));
                let [whole, part] = [product(&value, &by), product(&product(&x[0], &x[1]), &slope)];
                if let (Some(whole), Some(part)) = (self.parts.at(whole), self.parts.at(part)) {
                    self.parts.rules.insert(Rule::Angle(node), inequality(vec![part], vec![whole]));
                }
            }
            Op::Binary(Binary::Add | Binary::Subtract, ..) | Op::MultiplyAdd(..) | Op::ExactSum(_) | Op::Norm(_) => {
                self.sum_of(node, &operands, &x, forms);
            }
            _ => {}
        }
        Ok(())
    }

    /// A sum of products, or a norm, whose derivative with respect to a component is the same as of its square.
    fn sum_of(&mut self, node: Node, operands: &[Node], x: &[Values], forms: &[Values]) {
        let value = self.values[&node];
        let one = [1; POINTS];
        let (lengths, factor): (Vec<usize>, _) = match self.way.graph.op(node) {
            Op::MultiplyAdd(..) => (vec![2, 1], one),
            Op::ExactSum(_) => (vec![4; x.len() / 4], one),
            Op::Norm(_) => (vec![1; x.len()], reciprocal(&value)),
            _ => (vec![1, 1], one),
        };
        let is_norm = matches!(self.way.graph.op(node), Op::Norm(_));
        let is_difference = matches!(self.way.graph.op(node), Op::Binary(Binary::Subtract, ..));
        let (mut terms, mut start) = (Vec::new(), 0);
        for (k, length) in lengths.into_iter().enumerate() {
            let places = start..start + length;
            start += length;
            for place in places.clone() {
                let others = places.clone().filter(|&other| other != place);
                let mut slope = others.fold(factor, |product_, other| product(&product_, &x[other]));
                if is_norm {
                    slope = product(&slope, &x[place]);
                }
                if is_difference && k == 1 {
                    slope = opposite(&slope);
                }
                self.hand_on(operands[place], product(&forms[0], &slope));
                if place == places.start {
                    terms.push(product(&slope, &x[place]));
                }
            }
        }
        for (form, by) in forms.iter().enumerate() {
            if !self.wants(node, Some(form)) {
                continue;
            }
            let parts: Vec<_> = terms.iter().map(|term| product(term, by)).collect();
            let whole = product(&value, by);
            self.equation(node, Some(form), &whole, &parts);
            if self.signs.adds_up(node)
                && let Some(whole) = self.parts.at(whole)
            {
                let mut left: BTreeMap<Atom, Rational> = BTreeMap::new();
                for (factor, atom) in parts.iter().filter_map(|&part| self.parts.at(part)).collect::<Vec<_>>() {
                    *left.entry(atom).or_default() += factor.abs();
                }
                let left = left.into_iter().map(|(atom, factor)| (factor, atom)).collect();
                self.parts.rules.insert(Rule::Parts(node, form), inequality(left, vec![whole]));
            }
        }
    }

    fn wants(&self, node: Node, form: Option<usize>) -> bool {
        self.wanted.is_none_or(|places| places.contains(&(node, form)))
    }

    fn hand_on(&mut self, to: Node, by: Values) {
        if by != [0; POINTS] {
            self.uses.entry(to).or_default().push(by);
        }
    }

    /// The rules that follow from whole = Σ parts.
    fn equation(&mut self, node: Node, form: Option<usize>, whole: &Values, parts: &[Values]) {
        let all: Vec<Values> = std::iter::once(opposite(whole)).chain(parts.iter().copied()).collect();
        let terms: Vec<Option<Term>> = all.iter().map(|&values| self.parts.at(values)).collect();
        let mut factors: BTreeMap<Atom, Rational> = BTreeMap::new();
        terms.iter().flatten().for_each(|&(factor, atom)| *factors.entry(atom).or_default() += factor);
        factors.retain(|_, factor| !factor.is_zero());
        for (k, atom) in terms.iter().enumerate().filter_map(|(k, term)| Some((k, term.as_ref()?.1))) {
            let Some(&factor) = factors.get(&atom) else { continue };
            let others =
                factors.iter().filter(|(other, _)| **other != atom).map(|(&other, factor)| (factor.abs(), other));
            let name = form.map_or(Rule::Uses(node, k), |form| Rule::Sum(node, form, k));
            self.parts.rules.insert(name, inequality(vec![(factor.abs(), atom)], others.collect()));
        }
        for bounded in &self.signs.bounded {
            for (k, left) in terms.iter().enumerate() {
                for (other, right) in terms.iter().enumerate().filter(|&(other, _)| other != k) {
                    let (Some(left), Some(right)) = (left, right) else { continue };
                    if let Some(most) = bounded.most(&all[k], &all[other]) {
                        let right = (right.0 * most, right.1);
                        let name = Rule::Range(node, form, k, other, bounded.by);
                        self.parts.rules.insert(name, inequality(vec![*left], vec![right]));
                    }
                }
            }
        }
    }
}

fn inequality(left: Vec<Term>, right: Vec<Term>) -> Inequality {
    let plain = |terms: Vec<Term>| terms.into_iter().map(|(factor, atom)| (factor.abs(), atom)).collect();
    Inequality { left: plain(left), right: plain(right) }
}

/// The first operation whose rounding no rule moves on to an input or to the result.
pub(super) fn obstacle(parts: &Parts) -> Option<Obstacle> {
    let mut is_bounded = vec![false; parts.count()];
    parts.room.keys().for_each(|&atom| is_bounded[atom] = true);
    loop {
        let before = is_bounded.iter().filter(|is| **is).count();
        for rule in parts.rules.values() {
            if rule.right.iter().all(|&(_, atom)| is_bounded[atom]) {
                rule.left.iter().for_each(|&(_, atom)| is_bounded[atom] = true);
            }
        }
        if is_bounded.iter().filter(|is| **is).count() == before {
            break;
        }
    }
    let missing = parts.load.iter().filter(|(atom, _)| !is_bounded[**atom]).map(|(_, &(_, node))| node);
    missing.min().map(Obstacle::Rounding)
}
