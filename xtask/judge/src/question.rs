//! The questions for a program, and this program's own answers.

use jointproof::Error;
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::formula::quantity::{Domain, Unit};
use jointproof::toolkit::verify::{Judge, Sampler};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::ops::RangeInclusive;

/// The results requested from a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wanted {
    /// The outputs only.
    Value,
    /// The outputs, then the Jacobian row by row.
    #[default]
    Jacobian,
    /// The outputs, then J v and wᵀJ for directions v and w, which follow the inputs.
    Products,
}

impl Wanted {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Value, Self::Jacobian, Self::Products];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Value => "value",
            Self::Jacobian => "jacobian",
            Self::Products => "products",
        }
    }

    /// The count of numbers in an answer, for the given counts of inputs and outputs.
    pub fn numbers(self, [n, m]: [usize; 2]) -> usize {
        match self {
            Self::Value => m,
            Self::Jacobian => m + m * n,
            Self::Products => m + m + n,
        }
    }
}

/// A point at which results are requested.
#[derive(Debug)]
pub struct Question {
    pub(super) name: String,
    /// The inputs, by components in order.
    pub inputs: Vec<f64>,
    /// The vectors v and w that multiply the Jacobian from the right and from the left.
    pub directions: Option<[Vec<f64>; 2]>,
    pub(super) own: Own,
    pub(super) kind: Kind,
    /// The direction that the question belongs to.
    pub(super) along: Option<Along>,
}

/// The part of a verdict that a question belongs to.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    /// Sizes from a thousandth to a thousand, in general position.
    Ordinary,
    /// Sizes like these, chosen because something is special there.
    Special,
    /// On a kink, or next to it: its condition in LaTeX.
    Kink(String),
    /// Numbers of extreme sizes.
    Extreme,
    /// On a ladder of sizes.
    Rung(Rung),
    /// Inputs that are not allowed.
    Invalid,
}

/// A rung of a ladder: the fields whose largest component is a power of ten, and its exponent.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rung {
    pub(super) fields: Vec<&'static str>,
    pub(super) exponent: i32,
}

/// A question's direction. The first question of a direction is at its starting point, the others follow after its
/// steps, in order.
#[derive(Clone, Debug)]
pub(super) struct Along {
    /// The index of the direction.
    pub(super) base: usize,
    /// The level below which the remainder of an output is rounding error.
    pub(super) noise: Vec<f64>,
}

/// This program's own answer at a point.
#[derive(Debug)]
pub(super) enum Own {
    /// Value, and Jacobian if requested.
    Results(Vec<f64>),
    Refused(Error),
    /// The results are too large for doubles, so that another program is not asked for them.
    TooLarge,
}

impl Question {
    /// Whether the inputs are invalid.
    pub fn must_be_refused(&self) -> bool {
        matches!(self.own, Own::Refused(_))
    }

    /// The right numbers, in double precision.
    pub(super) fn right(&self, formula: &dyn AnyFormula, wanted: Wanted) -> Option<Vec<f64>> {
        let Own::Results(own) = &self.own else { return None };
        let (Wanted::Products, Some([v, w])) = (wanted, &self.directions) else { return Some(own.clone()) };
        let [n, m] = sizes(formula);
        let (value, jacobian) = formula.value_and_jacobian(&self.inputs).ok()?;
        let row = |i: usize| (0..n).map(|j| jacobian[i * n + j] * v[j]).sum();
        let column = |j: usize| (0..m).map(|i| jacobian[i * n + j] * w[i]).sum();
        Some(value.into_iter().chain((0..m).map(row)).chain((0..n).map(column)).collect())
    }
}

/// The counts of inputs and outputs.
pub fn sizes(formula: &dyn AnyFormula) -> [usize; 2] {
    [formula.inputs(), formula.outputs()].map(|fields| fields.iter().map(Field::len).sum())
}

/// The questions of these points.
pub fn of_points(
    formula: &dyn AnyFormula,
    wanted: Wanted,
    points: Vec<(String, Vec<f64>)>,
    seed: u64,
) -> Vec<Question> {
    let sizes = sizes(formula);
    let mut directions = Sampler::named("directions", seed);
    let own = |(_, inputs): &(String, Vec<f64>)| match (wanted, formula.value_and_jacobian(inputs)) {
        (Wanted::Jacobian, Ok((value, jacobian))) => Own::Results([value, jacobian].concat()),
        (_, Ok((value, _))) => Own::Results(value),
        (_, Err(Error::Overflow { .. } | Error::DerivativeOverflow { .. })) => Own::TooLarge,
        (_, Err(error)) => Own::Refused(error),
    };
    let owns: Vec<_> = points.par_iter().map(own).collect();
    let judge = formula.judge();
    let question = |((name, inputs), own): ((String, Vec<f64>), Own)| {
        let kind = match &own {
            Own::Refused(_) => Kind::Invalid,
            _ => kind(&judge, &name, &inputs),
        };
        let mut drawn = || sizes.map(|length| (0..length).map(|_| directions.real()).collect());
        let directions = (wanted == Wanted::Products).then(&mut drawn);
        Question { name, inputs, directions, own, kind, along: None }
    };
    points.into_iter().zip(owns).map(question).collect()
}

/// Sizes at which a program may be expected to work as at any other.
const ORDINARY: RangeInclusive<f64> = 1e-4..=1e4;

fn kind(judge: &Judge, name: &str, inputs: &[f64]) -> Kind {
    if name.starts_with("random ") {
        return Kind::Ordinary;
    }
    if let Some(condition) = judge.kink(inputs) {
        return Kind::Kink(condition);
    }
    let is_ordinary = |x: &f64| *x == 0.0 || ORDINARY.contains(&x.abs());
    match name.strip_prefix("kink ").and_then(|name| name.rsplit_once(' ')) {
        Some((condition, _)) => Kind::Kink(condition.to_owned()),
        None if inputs.iter().all(is_ordinary) => Kind::Special,
        None => Kind::Extreme,
    }
}

/// The exponents of a ladder.
const RUNGS: [i32; 34] = [
    -300, -250, -200, -162, -161, -160, -155, -154, -153, -140, -110, -104, -102, -80, -77, -76, -50, -20, 20, 50, 76,
    77, 78, 80, 102, 103, 104, 140, 152, 153, 154, 155, 200, 300,
];

/// Points at which a field is 0, or all of them: there quotients are 0/0.
pub(super) fn zeros(formula: &dyn AnyFormula, start: &[f64]) -> Vec<(String, Vec<f64>)> {
    let inputs = formula.inputs();
    let without = |is_zero: &dyn Fn(&Field) -> bool| {
        let zeros = inputs.iter().flat_map(|field| std::iter::repeat_n(is_zero(field), field.len()));
        start.iter().zip(zeros).map(|(x, is_zero)| if is_zero { 0.0 } else { *x }).collect::<Vec<_>>()
    };
    let scalable: Vec<_> = inputs.iter().filter(|field| is_scalable(field)).collect();
    let one = scalable.iter().map(|one| (format!("{} = 0", one.name), without(&|field| field.name == one.name)));
    let all = (!scalable.is_empty()).then(|| ("all of them 0".to_owned(), without(&is_scalable)));
    one.chain(all).collect()
}

/// Points at which the fields of a unit are scaled together, from this point: they tell where a program over- or underflows.
pub(super) fn ladder(formula: &dyn AnyFormula, start: &[f64]) -> Vec<(Rung, Vec<f64>)> {
    let inputs = formula.inputs();
    let mut units: Vec<Unit> = Vec::new();
    for field in inputs.iter().filter(|field| is_scalable(field)) {
        if !units.contains(&field.quantity.unit) {
            units.push(field.quantity.unit);
        }
    }
    let mut rungs = Vec::new();
    for unit in units {
        let is_scaled = |field: &Field| is_scalable(field) && field.quantity.unit == unit;
        let fields: Vec<_> = inputs.iter().filter(|field| is_scaled(field)).map(|field| field.name).collect();
        let (mut first, mut size) = (0, 1.0_f64);
        let mut drawn = start.to_vec();
        for field in inputs {
            // Of one size, so that all of them come to the limit.
            for x in &mut drawn[first..first + field.len()] {
                if is_scaled(field) {
                    *x = if *x < 0.0 { -size } else { size };
                    size = if size < 0.9 { 1.0 } else { size - 0.015 };
                }
            }
            first += field.len();
        }
        for exponent in RUNGS {
            let scale = 10.0_f64.powi(exponent);
            let mut first = 0;
            let mut inputs_there = drawn.clone();
            for field in inputs {
                if is_scaled(field) {
                    inputs_there[first..first + field.len()].iter_mut().for_each(|x| *x *= scale);
                }
                first += field.len();
            }
            rungs.push((Rung { fields: fields.clone(), exponent }, inputs_there));
        }
    }
    rungs
}

fn is_scalable(field: &Field) -> bool {
    let domain = field.quantity.domain;
    field.quantity.unit != Unit::ONE
        && matches!(domain, Domain::Real | Domain::NonNegative | Domain::Positive | Domain::Point | Domain::Vector)
}

/// All indices of a list in another order, in which hardly any follows its previous predecessor.
pub fn other_order(count: usize) -> Vec<usize> {
    let step = (count * 5 / 8..count).find(|step| gcd(*step, count) == 1).unwrap_or_default();
    (0..count).map(|k| (k * step + count / 2) % count).collect()
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_has_the_outputs_and_what_is_wanted_beside() {
        assert_eq!(Wanted::ALL.map(|wanted| wanted.numbers([5, 3])), [3, 18, 11]);
    }

    #[test]
    fn the_other_order_begins_in_the_middle() {
        assert_eq!(other_order(8), [4, 1, 6, 3, 0, 5, 2, 7]);
    }

    #[test]
    fn the_other_order_has_every_place_once() {
        for count in 0..200 {
            let mut order = other_order(count);
            let follows = order.windows(2).filter(|pair| pair[1] == pair[0] + 1).count();
            assert!(count < 4 || follows == 0, "{count}: {follows}");
            order.sort_unstable();
            assert_eq!(order, (0..count).collect::<Vec<_>>());
        }
    }
}
