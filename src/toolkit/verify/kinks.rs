//! Kinks: points where value or derivative jumps are found, and must be registered.
//!
//! Every comparison and every guarded zero in the graph of a formula is a candidate. The toolkit solves for inputs exactly on it,
//! and one-sided differences there show whether the derivative jumps. If it does, a registered kink must hold.

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

/// The number of random starting points used before the named ones.
const FEW: usize = 6;

/// The number of random points from which kinks are searched.
pub(super) const STARTS_AT: usize = 1000;

/// How kinks of a formula were searched for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Examination {
    /// In its graph, and at named points.
    Graph {
        /// The result of the search.
        search: Search,
        /// The branches taken by the points of the audit.
        coverage: Coverage,
    },
    /// At named points only, since its graph cannot be used.
    NamedPoints {
        /// The reason.
        why: String,
    },
}

/// The jump of the derivative of an output with respect to an input at a point; 0 if only one side is in the domain.
pub(super) fn jump(point: &Point, output: usize, input: usize) -> f64 {
    let neighbourhood = Neighbourhood::new(point.subject, &point.exact);
    let (inner, _) = neighbourhood.sides(&[input]);
    if inner.is_empty() { 0.0 } else { neighbourhood.each_across(&neighbourhood.axis(input))[output].size }
}

/// Searches for kinks in the graph of a formula, and records unregistered ones in the claim. The coverage of
/// comparisons is filled in later.
pub(super) fn look(subject: &Subject, names: &Names, [named, random]: [&[Point]; 2], claim: &mut Claim) -> Examination {
    let graph = match subject.telling_graph() {
        Ok(graph) => graph,
        Err(why) => return Examination::NamedPoints { why },
    };
    // Points in general position come first.
    let starts: Vec<_> = random.iter().take(FEW).chain(named).chain(random.iter().skip(FEW)).collect();
    let search = search::search(subject, graph, names, &starts, claim);
    if search.candidates == 0 {
        // What was checked is that there is no unregistered kink.
        claim.checks += 1;
    }
    Examination::Graph { search, coverage: Coverage::default() }
}

/// The outcomes of the comparisons in the graph of a formula at points; none if the graph cannot be used.
pub(super) fn comparisons<'a>(
    subject: &Subject,
    names: &Names,
    points: impl Iterator<Item = &'a [f64]>,
) -> Vec<Comparison> {
    subject.telling_graph().map(|graph| coverage::comparisons(graph, &names.inputs, points)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::planted::{Function, graph, only_where, planted};
    use super::*;
    use crate::contact::coulomb::ReturnMap;
    use crate::contact::slide_line::ClosestParabolic;
    use crate::toolkit::graph::{Graph, NotRecorded, Relation};
    use crate::toolkit::verify::exact;
    use num_traits::Signed;
    use serde_json::json;
    use std::borrow::Cow;

    fn point<'a>(subject: &'a Subject, inputs: &[f64]) -> Point<'a> {
        Point::new(subject, "there".into(), true, inputs.to_vec())
    }

    /// b = |x|, and a = √y.
    #[test]
    fn a_jump_is_of_one_output_by_one_input_and_of_both_sides() {
        let value: Function = |i| vec![num_dual::DualNum::sqrt(&i[1]), i[0].abs()];
        let subject = planted(value, |i| {
            let slope = if i[0] > 0.0 { 1.0 } else { -1.0 };
            exact(&[0.0, 1.0, 0.0, slope, 0.0, 0.0])
        });
        let of = |y, output, input| jump(&point(&subject, &[0.0, y, 1.0]), output, input);
        assert_eq!([of(2.0, 1, 0), of(2.0, 0, 0)], [2.0 / 3.0, 0.0]);
        assert!(of(2.0, 0, 1) < SMOOTH && of(2.0, 1, 1) == 0.0);
        // There is no other side.
        assert_eq!(of(0.0, 0, 1), 0.0);
    }

    /// A smooth formula whose value has this graph.
    fn with_graph(record: fn() -> Cow<'static, Result<Graph, NotRecorded>>) -> Subject {
        let mut subject = planted(|i| vec![i[0], i[1]], |_| exact(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]));
        subject.record = record;
        subject
    }

    fn asks_where_x_is_one() -> Subject {
        with_graph(|| {
            Cow::Owned(Ok(graph(|graph, [x, ..]| {
                let one = graph.number(1.0);
                vec![graph.compare(Relation::Less, x, one)]
            })))
        })
    }

    /// What is found from named and random points with these values of c.
    fn examination(subject: &Subject, [named, random]: [&[f64]; 2]) -> (Examination, Claim) {
        let points = |all: &[f64]| all.iter().map(|&c| point(subject, &[4.0, 1.0, c])).collect::<Vec<_>>();
        let mut claim = Claim::new("kinks are registered", SMOOTH);
        let examination = look(subject, &Names::new(subject), [&points(named), &points(random)], &mut claim);
        (examination, claim)
    }

    #[test]
    fn random_points_come_before_named_ones_and_others_after_them() {
        let first = |check: fn(&[f64]) -> Result<(), crate::Error>| {
            let mut subject = asks_where_x_is_one();
            subject.check = check;
            let (examination, claim) = examination(&subject, [&[256.0], &[1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0]]);
            let Examination::Graph { search, .. } = examination else { panic!("there is a graph") };
            (search.points, claim.worst.map_or(json!(null), |worst| worst.inputs["c"].clone()))
        };
        assert_eq!(first(|_| Ok(())), (3, json!(1.0)));
        assert_eq!(first(|i| only_where(i[2] >= 16.0)), (3, json!(16.0)));
        assert_eq!(first(|i| only_where(i[2] >= 32.0)), (3, json!(32.0)));
        // From the seventh random point and the named one.
        assert_eq!(first(|i| only_where(i[2] >= 64.0)), (2, json!(256.0)));
        assert_eq!(first(|i| only_where(i[2] == 64.0)), (1, json!(64.0)));
    }

    #[test]
    fn that_there_is_no_candidate_is_a_check() {
        let none = with_graph(|| Cow::Owned(Ok(graph(|_, [x, ..]| vec![x]))));
        let (found, claim) = examination(&none, [&[1.0], &[2.0, 4.0]]);
        assert_eq!(
            (found, claim.checks),
            (Examination::Graph { search: Search::default(), coverage: Coverage::default() }, 1)
        );
        let (_, claim) = examination(&asks_where_x_is_one(), [&[1.0], &[2.0, 4.0]]);
        assert_eq!((claim.checks, claim.failures), (3, 0));
    }

    #[test]
    fn a_graph_that_does_not_tell_is_not_searched() {
        let subject = Subject::of::<ClosestParabolic>();
        let mut claim = Claim::new("kinks are registered", SMOOTH);
        let examination = look(&subject, &Names::new(&subject), [&[], &[]], &mut claim);
        assert!(
            matches!(examination, Examination::NamedPoints { why } if why.starts_with("the formula is an iterative search"))
        );
        assert_eq!(claim.checks, 0);
        assert_eq!(comparisons(&subject, &Names::new(&subject), std::iter::empty()), []);
    }

    #[test]
    fn comparisons_are_those_of_the_graph() {
        let subject = Subject::of::<ReturnMap>();
        let points = [[1.0, 0.5, 4.0], [3.0, 0.5, 4.0], [4.0, 0.5, 4.0]];
        let counted = comparisons(&subject, &Names::new(&subject), points.iter().map(<[f64; 3]>::as_slice));
        assert!(counted.iter().any(|comparison| comparison.counts == [2, 1]), "{counted:?}");
    }
}
