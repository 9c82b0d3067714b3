//! The questions for a program, and this program's own answers.

use jointproof::Error;
use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::toolkit::verify::Sampler;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};

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
    /// The direction that the question belongs to.
    pub(super) along: Option<Along>,
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
    let question = |((name, inputs), own)| {
        let mut drawn = || sizes.map(|length| (0..length).map(|_| directions.real()).collect());
        let directions = (wanted == Wanted::Products).then(&mut drawn);
        Question { name, inputs, directions, own, along: None }
    };
    points.into_iter().zip(owns).map(question).collect()
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
