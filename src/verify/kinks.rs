//! Kinks: where value or derivative jumps is found, and must be registered.
//!
//! Every comparison and every guarded zero in the graph of a formula is a candidate. Inputs are solved for that are just
//! on it, and one-sided differences there tell whether the derivative jumps. Where it does, a registered kink must hold.

mod candidate;
mod coverage;
mod jump;
#[cfg(test)]
mod planted;
mod register;
mod search;
mod solve;
mod words;

pub use coverage::{Comparison, Coverage};
pub use jump::Rank;
pub use register::Sides;
pub use search::Search;
pub(super) use words::Words;

use jump::Neighbourhood;
pub(super) use jump::SMOOTH;
pub(super) use register::register;
pub(crate) use register::sides;

use super::claim::Claim;
use super::point::{Names, Point};
use super::subject::Subject;
use serde::{Deserialize, Serialize};

/// So many random points are started from before the named ones.
const FEW: usize = 6;

/// So many random points kinks are searched from.
pub(super) const STARTS_AT: usize = 1000;

/// How kinks of a formula were looked for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Looked {
    /// In its graph, and at named points.
    Graph {
        /// What was found.
        search: Search,
        /// Which sides of its comparisons the points of the audit took.
        coverage: Coverage,
    },
    /// At named points alone, since its graph does not tell.
    NamedPoints {
        /// Why.
        why: String,
    },
}

/// By how much the derivative of an output by an input jumps at a point; 0 where only one side is in the domain.
pub(super) fn jump(point: &Point, output: usize, input: usize) -> f64 {
    let neighbourhood = Neighbourhood::new(point.subject, &point.exact);
    let (inner, _) = neighbourhood.sides(&[input]);
    inner.first().map_or(0.0, |&input| neighbourhood.each_across(&neighbourhood.axis(input))[output].size)
}

/// Looks for kinks in the graph of a formula, and records in the claim what is not registered. Which sides of comparisons were
/// taken is not known yet.
pub(super) fn look(subject: &Subject, names: &Names, [named, random]: [&[Point]; 2], claim: &mut Claim) -> Looked {
    let graph = match subject.telling_graph() {
        Ok(graph) => graph,
        Err(why) => return Looked::NamedPoints { why },
    };
    // Points in general position come first.
    let starts: Vec<_> = random.iter().take(FEW).chain(named).chain(random.iter().skip(FEW)).collect();
    let search = search::search(subject, graph, names, &starts, claim);
    if search.candidates == 0 {
        // That there is no such place is what was checked.
        claim.checks += 1;
    }
    Looked::Graph { search, coverage: Coverage::default() }
}

/// How the comparisons in the graph of a formula came out at points; none where the graph does not tell.
pub(super) fn comparisons<'a>(
    subject: &Subject,
    names: &Names,
    points: impl Iterator<Item = &'a [f64]>,
) -> Vec<Comparison> {
    subject.telling_graph().map(|graph| coverage::comparisons(graph, &names.inputs, points)).unwrap_or_default()
}
