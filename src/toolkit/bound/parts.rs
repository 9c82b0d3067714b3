//! The parts of a result on one way, what rounding loads them with, and the rules by which a load moves from part to part.

mod rules;

use super::field::{self, POINTS, Rational, Values, opposite, product, reciprocal, sum};
use super::points::values;
use super::sign::{Order, Signs};
use super::way::Way;
use crate::toolkit::graph::{Binary, Node, Op, Unary};
use num_traits::{One, Signed, Zero};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;
use std::ops::Range;

/// The factors of a sum have so few bits together that no sum is 0 at all points by chance.
const DIGITS: u32 = 400;

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

/// The name of a part: an operation; the derivative, 0 for that of the final result with respect to the number, and from 1 for those with
/// respect to its uses; and the place, 0 for the result of the operation, and from 1 for its operands, which are weighted by what
/// they contribute to that derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Part(pub Node, pub usize, pub usize);

/// The name of a rule, which says what it follows from.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Rule {
    /// These parts, each times its factor, add up to 0: the first is at most the others together. So it is for the result and the
    /// operands of a sum or a norm, for a number and its uses, and for what follows from several of these equations.
    Sum(Vec<(Rational, Part)>),
    /// The parts of the operands of a sum or a norm in which nothing cancels, together, are at most that of the result.
    Parts(Node, usize),
    /// One part is at most so many times another one, since their ratio is a quotient of linear functions of a number that has bounds:
    /// an input, a number compared with a constant, or the ratio of two numbers that are compared.
    Range(Part, Part, Node),
    /// A part of the denominator of a normwise bound, which is a form of a number from the first of these on, is at most that, in its row
    /// and in its column.
    Beside(Node, usize),
}

/// The left parts together are at most the right ones together.
#[derive(Clone, Debug)]
pub(super) struct Inequality {
    pub(super) left: Vec<Term>,
    pub(super) right: Vec<Term>,
}

/// The parts of a result on one way.
pub(super) struct Parts<'a> {
    way: &'a Way<'a>,
    /// The components of the inputs, if the denominator is normwise.
    fields: Option<&'a [Range<usize>]>,
    /// The first of the points.
    start: u64,
    values: BTreeMap<Node, Values>,
    signs: Signs,
    /// The derivatives of the result: with respect to each number and, if there are several, each of its uses.
    forms: BTreeMap<Node, Vec<Values>>,
    /// The operands of each operation, and the derivatives of its result with respect to them.
    slopes: BTreeMap<Node, Vec<(Node, Values)>>,
    /// The operands that are the uses of a number.
    uses: BTreeMap<Node, Vec<Part>>,
    known: FxHashMap<[u64; POINTS - 1], Vec<Atom>>,
    /// The first part found of those that are the same up to a factor, and its value at the first point.
    first: Vec<(Part, u64)>,
    /// What rounding loads parts with, and an operation that does.
    pub(super) load: BTreeMap<Atom, (Rational, Node)>,
    /// What parts may carry for each unit of the bound: those of inputs, and the result. Of a normwise bound, what the rows and the columns
    /// of the denominator may, for each unit of the weight of a result beside.
    pub(super) room: BTreeMap<Atom, (usize, Rational)>,
    /// The parts of the denominator of a normwise bound, each with its row and its column.
    sizes: BTreeMap<(Node, usize), [Atom; 2]>,
    /// The equations between parts, each with the parts that add up to 0.
    equations: Vec<Vec<(Rational, Part)>>,
    /// Whether more than the first order counts.
    pub(super) is_first_order: bool,
}

impl<'a> Parts<'a> {
    pub(super) fn new(
        way: &'a Way<'a>,
        bounds: &[[Option<f64>; 2]],
        fields: Option<&'a [Range<usize>]>,
    ) -> Result<Self, Obstacle> {
        let order = Order::of(way);
        let values = values(way, &order.nodes, 0).ok_or(Obstacle::Roots)?;
        let signs = Signs::of(way, bounds, &order, &values);
        let is_first_order = signs.is_first_order(way);
        let mut parts = Self { signs, is_first_order, ..Self::at(way, values, fields, 0)? };
        parts.loads();
        parts.equations = parts.equations();
        parts.beside()?;
        Ok(parts)
    }

    /// The parts at other points.
    fn elsewhere(&self, start: u64) -> Result<Self, Obstacle> {
        let values = values(self.way, &self.way.nodes, start).ok_or(Obstacle::Roots)?;
        let mut parts = Self::at(self.way, values, self.fields, start)?;
        parts.beside()?;
        Ok(parts)
    }

    /// The parts of the first result.
    fn at(
        way: &'a Way<'a>,
        values: BTreeMap<Node, Values>,
        fields: Option<&'a [Range<usize>]>,
        start: u64,
    ) -> Result<Self, Obstacle> {
        let (forms, slopes, uses, sizes) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
        let (known, first, load, room) = (FxHashMap::default(), Vec::new(), BTreeMap::new(), BTreeMap::new());
        let (signs, is_first_order, equations) = (Signs::default(), false, Vec::new());
        let mut parts = Self {
            way,
            fields,
            start,
            values,
            signs,
            forms,
            slopes,
            uses,
            known,
            first,
            load,
            room,
            sizes,
            equations,
            is_first_order,
        };
        parts.slopes = way.nodes.iter().map(|&node| (node, parts.slopes(node))).collect();
        for (node, uses) in parts.derivatives(way.results[0])? {
            let mut forms = vec![total(&uses)];
            if uses.len() > 1 {
                forms.extend(uses.iter().map(|(by, _)| *by));
                parts.uses.insert(node, uses.into_iter().map(|(_, part)| part).collect());
            }
            parts.forms.insert(node, forms);
        }
        Ok(parts)
    }

    pub(super) fn count(&self) -> usize {
        self.first.len()
    }

    /// The derivatives of a result with respect to every use of all that it is computed from.
    fn derivatives(&self, result: Node) -> Result<BTreeMap<Node, Vec<(Values, Part)>>, Obstacle> {
        let mut uses = BTreeMap::from([(result, vec![([1; POINTS], Part(result, 0, 0))])]);
        for &node in self.way.nodes.iter().rev() {
            let Some(total) = uses.get(&node).map(|uses| total(uses)) else { continue };
            if matches!(self.way.graph.op(node), Op::Search(..)) {
                return Err(Obstacle::Search);
            }
            for (k, (operand, slope)) in self.slopes[&node].iter().enumerate() {
                let by = product(&total, slope);
                if by != [0; POINTS] {
                    uses.entry(*operand).or_default().push((by, Part(node, 0, k + 1)));
                }
            }
        }
        Ok(uses)
    }

    /// Loads and rooms.
    fn loads(&mut self) {
        for node in
            self.way.nodes.iter().copied().rev().filter(|node| self.forms.contains_key(node)).collect::<Vec<_>>()
        {
            // A number that is always 0 has no part, but what it is made of may have.
            let Some((factor, atom)) = self.atom(Part(node, 0, 0)) else { continue };
            let roundings = self.way.roundings(node) * factor.abs();
            if roundings.is_positive() {
                self.load.entry(atom).or_insert((Rational::zero(), node)).0 += roundings;
            }
            let rooms =
                u8::from(matches!(self.way.graph.op(node), Op::Input(_))) + u8::from(node == self.way.results[0]);
            for _ in (0..rooms).filter(|_| self.fields.is_none()) {
                self.room.entry(atom).or_insert((0, Rational::zero())).1 += factor.abs();
            }
        }
    }

    /// The denominator of a normwise bound: of each result beside, its size, and its derivatives with respect to the components of a
    /// field times other components of the same field. No sum over one of each row and column exceeds the product of the lengths.
    fn beside(&mut self) -> Result<(), Obstacle> {
        let Some(fields) = self.fields else { return Ok(()) };
        let inputs = self.way.nodes.iter().filter_map(|&node| match self.way.graph.op(node) {
            Op::Input(k) => Some((*k, node)),
            _ => None,
        });
        let inputs: BTreeMap<usize, Node> = inputs.collect();
        for (weight, &result) in self.way.results.iter().enumerate() {
            let by = self.derivatives(result)?;
            let limit = self.limit(weight);
            self.size(result, [1; POINTS], [limit; 2]);
            for field in fields {
                let inputs: Vec<Node> = field.clone().filter_map(|k| inputs.get(&k)).copied().collect();
                let limits: Vec<_> = inputs.iter().map(|_| [self.limit(weight), self.limit(weight)]).collect();
                for (by, [row, _]) in
                    inputs.iter().map(|node| by.get(node).map_or([0; POINTS], |uses| total(uses))).zip(&limits)
                {
                    for (&input, [_, column]) in inputs.iter().zip(&limits) {
                        self.size(input, by, [*row, *column]);
                    }
                }
            }
        }
        Ok(())
    }

    /// A row or a column of the denominator.
    fn limit(&mut self, weight: usize) -> Atom {
        self.first.push((Part(self.way.results[0], 0, 0), 0));
        self.room.insert(self.first.len() - 1, (weight, Rational::one()));
        self.first.len() - 1
    }

    fn size(&mut self, node: Node, by: Values, limits: [Atom; 2]) {
        let forms = self.forms.entry(node).or_insert_with(|| vec![[0; POINTS]]);
        forms.push(by);
        self.sizes.insert((node, forms.len() - 1), limits);
    }

    /// The operands of an operation, and the derivatives of its result with respect to them.
    fn slopes(&self, node: Node) -> Vec<(Node, Values)> {
        let operands = self.way.operands(node).unwrap_or_default();
        let x: Vec<Values> = operands.iter().map(|operand| self.values[operand]).collect();
        let (value, one) = (self.values[&node], [1; POINTS]);
        let symbol = || std::array::from_fn(|k| field::random([self.start + k as u64, node.index() as u64, 2]));
        // Of a sum of products, the other factors of the same one.
        let others = |start: usize, length: usize, place: usize| {
            let places = (start..start + length).filter(|&other| other != place);
            places.fold(one, |all, other| product(&all, &x[other]))
        };
        let slopes = match self.way.graph.op(node) {
            Op::Unary(function, _) => match function {
                Unary::Negative => vec![opposite(&one)],
                Unary::Absolute => vec![product(&value, &reciprocal(&x[0]))],
                Unary::Root => vec![reciprocal(&sum(&value, &value))],
                Unary::Exponential => vec![value],
                Unary::ExponentialMinusOne => vec![sum(&value, &one)],
                Unary::PowerOfTwo | Unary::NearestInteger => Vec::new(),
                Unary::Sine | Unary::Cosine | Unary::ArcSine => vec![symbol()],
            },
            Op::Binary(operation, ..) => match operation {
                Binary::Add => vec![one; 2],
                Binary::Subtract => vec![one, opposite(&one)],
                Binary::Multiply => vec![x[1], x[0]],
                Binary::Divide => {
                    let slope = reciprocal(&x[1]);
                    vec![slope, opposite(&product(&slope, &value))]
                }
                Binary::Angle => {
                    let slope = reciprocal(&sum(&product(&x[0], &x[0]), &product(&x[1], &x[1])));
                    vec![product(&slope, &x[1]), opposite(&product(&slope, &x[0]))]
                }
                Binary::Maximum => Vec::new(),
            },
            Op::MultiplyAdd(..) => vec![x[1], x[0], one],
            Op::ExactSum(_) => (0..x.len()).map(|place| others(place / 4 * 4, 4, place)).collect(),
            Op::Norm(_) => x.iter().map(|x| product(x, &reciprocal(&value))).collect(),
            _ => Vec::new(),
        };
        operands.into_iter().zip(slopes).collect()
    }

    /// The value of a part; none if there is no such part.
    fn value(&self, Part(node, form, place): Part) -> Option<Values> {
        let by = self.forms.get(&node)?.get(form)?;
        match place.checked_sub(1) {
            None => Some(product(&self.values[&node], by)),
            Some(place) => {
                let (operand, slope) = *self.slopes.get(&node)?.get(place)?;
                Some(product(&self.values[&operand], &product(by, &slope)))
            }
        }
    }

    /// What a part is a multiple of; none if it is 0, or if there is no such part.
    fn atom(&mut self, part: Part) -> Option<Term> {
        let values = self.value(part)?;
        let per_first = field::inverse(values[0])?;
        let key = std::array::from_fn(|k| field::multiply(values[k + 1], per_first));
        let known = self.known.entry(key).or_default();
        let ratio = |atom: Atom| {
            let ratio = field::multiply(values[0], field::inverse(self.first[atom].1)?);
            Some((field::to_rational(ratio)?, atom))
        };
        Some(known.iter().find_map(|&atom| ratio(atom)).unwrap_or_else(|| {
            known.push(self.first.len());
            self.first.push((part, values[0]));
            (Rational::one(), self.first.len() - 1)
        }))
    }

    /// The equations between parts, each with the parts that add up to 0.
    fn equations(&self) -> Vec<Vec<(Rational, Part)>> {
        let one = Rational::one();
        let equation = |whole: Part, terms: &mut dyn Iterator<Item = Part>| {
            std::iter::once((-one, whole)).chain(terms.map(|part| (one, part))).collect()
        };
        let mut equations = Vec::new();
        for (&node, forms) in self.forms.iter().rev() {
            if let Some(uses) = self.uses.get(&node) {
                equations.push(equation(Part(node, 0, 0), &mut uses.iter().copied()));
            }
            let terms = self.terms(node);
            if !terms.is_empty() {
                equations.extend((0..forms.len()).map(|form| {
                    equation(Part(node, form, 0), &mut terms.iter().map(|&place| Part(node, form, place)))
                }));
            }
        }
        equations
    }

    /// The places of an operand of each term of a sum, or of a norm.
    fn terms(&self, node: Node) -> Vec<usize> {
        match self.way.graph.op(node) {
            Op::Binary(Binary::Add | Binary::Subtract, ..) => vec![1, 2],
            Op::MultiplyAdd(..) => vec![1, 3],
            Op::ExactSum(parts) => (1..=parts.len()).step_by(4).collect(),
            Op::Norm(parts) => (1..=parts.len()).collect(),
            _ => Vec::new(),
        }
    }

    /// What a rule says.
    ///
    /// # Errors
    /// Why it does not hold, or says nothing.
    pub(super) fn inequality(&mut self, rule: &Rule) -> Result<Inequality, String> {
        let mut left: BTreeMap<Atom, Rational> = BTreeMap::new();
        let mut right = left.clone();
        match rule {
            Rule::Sum(terms) => {
                let mut sums = [0; POINTS];
                let mut atoms = Vec::new();
                for &(factor, part) in terms {
                    let value = self.value(part).ok_or_else(|| format!("there is no part {part:?}"))?;
                    let of = field::of_rational(factor).ok_or("a factor is too large")?;
                    sums = sum(&sums, &value.map(|x| field::multiply(x, of)));
                    atoms.push(self.atom(part).map(|(of, atom)| (factor * of, atom)));
                }
                let bits = |x: &i128| 128 - x.unsigned_abs().leading_zeros();
                let digits: u32 = terms.iter().map(|(factor, _)| bits(factor.numer()) + bits(factor.denom())).sum();
                if digits > DIGITS {
                    return Err(format!("the factors of {rule:?} have {digits} bits; allowed are {DIGITS}"));
                }
                if sums != [0; POINTS] {
                    return Err(format!("the terms of {rule:?} do not add up to 0"));
                }
                for (factor, atom) in atoms.iter().flatten() {
                    *right.entry(*atom).or_default() += *factor;
                }
                if let Some((_, atom)) = atoms.first().copied().flatten() {
                    left.extend(right.remove_entry(&atom));
                }
            }
            &Rule::Parts(node, form) => {
                if !self.signs.adds_up(node) {
                    return Err(format!("the terms of {} may cancel", node.index()));
                }
                for (factor, atom) in
                    self.terms(node).into_iter().filter_map(|place| self.atom(Part(node, form, place)))
                {
                    *left.entry(atom).or_default() += factor.abs();
                }
                right.extend(self.atom(Part(node, form, 0)).map(|(factor, atom)| (atom, factor)));
            }
            &Rule::Beside(node, form) => {
                let limits =
                    *self.sizes.get(&(node, form)).ok_or_else(|| format!("{rule:?} is no part of the denominator"))?;
                left.extend(self.atom(Part(node, form, 0)).map(|(factor, atom)| (atom, factor)));
                right.extend(limits.map(|limit| (limit, Rational::one())));
            }
            &Rule::Range(part, other, by) => {
                let values = [part, other].map(|part| self.value(part));
                let [Some(first), Some(second)] = values else { return Err(format!("{rule:?} names no parts")) };
                let known = self.signs.bounded.iter().filter(|bounded| bounded.by == by);
                let most = known.filter_map(|bounded| bounded.most(&first, &second)).min();
                let most = most.ok_or_else(|| format!("the bounds of {} say nothing of {rule:?}", by.index()))?;
                left.extend(self.atom(part).map(|(factor, atom)| (atom, factor)));
                right.extend(self.atom(other).map(|(factor, atom)| (atom, factor * most)));
            }
        }
        let plain = |terms: BTreeMap<Atom, Rational>| {
            let terms = terms.into_iter().filter(|(_, factor)| !factor.is_zero());
            terms.map(|(atom, factor)| (factor.abs(), atom)).collect::<Vec<_>>()
        };
        let (left, right) = (plain(left), plain(right));
        if left.is_empty() { Err(format!("{rule:?} bounds nothing")) } else { Ok(Inequality { left, right }) }
    }
}

/// The derivative with respect to a number, of those with respect to its uses.
fn total(uses: &[(Values, Part)]) -> Values {
    uses.iter().map(|(by, _)| *by).reduce(|x, y| sum(&x, &y)).unwrap_or_default()
}
