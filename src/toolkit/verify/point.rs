//! A point at which claims are checked, and the names of the numbers compared there.

use super::claim::Deviation;
use super::sample::Sampler;
use super::subject::Subject;
use super::{exact, golden};
use crate::Octuple;
use crate::formula::Field;
use crate::formula::proof::Convention;
use std::ops::Range;

/// The extent of an audit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Random points, in addition to the cases and the neighbourhoods of kinks.
    pub samples: usize,
    /// Seed of the random points.
    pub seed: u64,
}

impl Default for Options {
    /// A thousand points with seed 1.
    fn default() -> Self {
        Self { samples: 1000, seed: 1 }
    }
}

/// A point of a formula.
pub(super) struct Point<'a> {
    pub(super) subject: &'a Subject,
    pub(super) label: String,
    pub(super) random: bool,
    pub(super) inputs: Vec<f64>,
    pub(super) exact: Vec<Octuple>,
    pub(super) kink: Option<Convention>,
}

impl<'a> Point<'a> {
    pub(super) fn new(subject: &'a Subject, label: String, random: bool, inputs: Vec<f64>) -> Self {
        let exact = exact(&inputs);
        let kink = subject.kink(&exact);
        Self { subject, label, random, inputs, exact, kink }
    }

    pub(super) fn deviation(&self, size: f64, entry: String, found: f64, expected: f64) -> Deviation {
        let inputs = golden::named(self.subject.inputs, &self.inputs).into();
        Deviation { size, entry, point: self.label.clone(), found, expected, inputs }
    }
}

/// Random points of a formula, independent of the range requested: the points before it are drawn, too.
pub(super) fn random_points<'a>(subject: &'a Subject, options: &Options, range: Range<usize>) -> Vec<Point<'a>> {
    let mut sampler = Sampler::for_formula(subject.spec.id, options.seed);
    let point = |(k, inputs)| Point::new(subject, format!("random {k} of seed {}", options.seed), true, inputs);
    let drawn = (0..range.end).map(|k| (k, sampler.components(subject)));
    drawn.skip(range.start).map(point).collect()
}

/// Names of components: `x`, `xa[2]`.
pub(super) struct Names {
    pub(super) inputs: Vec<String>,
    pub(super) outputs: Vec<String>,
}

impl Names {
    pub(super) fn new(subject: &Subject) -> Self {
        Self { inputs: names(subject.inputs), outputs: names(subject.outputs) }
    }

    /// The name of the k-th Jacobian entry.
    pub(super) fn entry(&self, k: usize) -> String {
        let (output, input) = (k / self.inputs.len(), k % self.inputs.len());
        format!("∂{}/∂{}", self.outputs[output], self.inputs[input])
    }
}

pub(super) fn names(fields: &[Field]) -> Vec<String> {
    let of_field = |field: &Field| match field.len() {
        1 => vec![field.name.to_string()],
        len => (0..len).map(|k| format!("{}[{k}]", field.name)).collect(),
    };
    fields.iter().flat_map(of_field).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::connector::slot::{Constraint, ContactForce};
    use crate::contact::coulomb::{ReturnMap, Trial};

    #[test]
    fn by_default_there_are_a_thousand_points_of_seed_1() {
        assert_eq!(Options::default(), Options { samples: 1000, seed: 1 });
    }

    #[test]
    fn a_point_knows_its_kink_and_names_its_inputs() {
        let subject = Subject::of::<ReturnMap>();
        let at = |f_trial| Point::new(&subject, "here".into(), true, vec![f_trial, 0.5, 4.0]);
        assert_eq!((at(2.0).kink, at(2.5).kink), (Some(Convention::Switch), None));
        assert_eq!(at(2.5).exact, exact(&[2.5, 0.5, 4.0]));
        let Deviation { size, entry, point, found, expected, inputs } = at(2.5).deviation(1.0, "f".into(), 2.0, 3.0);
        assert_eq!((size, entry.as_str(), point.as_str(), found, expected), (1.0, "f", "here", 2.0, 3.0));
        assert_eq!(inputs, serde_json::json!({"f_trial": 2.5, "mu": 0.5, "fn": 4.0}));
    }

    #[test]
    fn random_points_do_not_depend_on_how_many_are_asked_for() {
        let subject = Subject::of::<ContactForce>();
        let options = Options { samples: 0, seed: 7 };
        let drawn = |range| {
            let points = random_points(&subject, &options, range).into_iter();
            points.map(|point| (point.label, point.random, point.inputs)).collect::<Vec<_>>()
        };
        let all = drawn(0..5);
        assert_eq!((all.len(), all[2].0.as_str(), all[2].1), (5, "random 2 of seed 7", true));
        assert_ne!(all[0].2, all[1].2);
        assert_eq!(drawn(2..4), all[2..4]);
    }

    #[test]
    fn components_are_named_by_field_and_place() {
        let names = Names::new(&Subject::of::<Constraint>());
        assert_eq!((names.inputs.len(), names.inputs[2].as_str(), names.inputs[13].as_str()), (14, "e2a[2]", "z0"));
        assert_eq!(names.outputs, ["gy", "gz"]);
        assert_eq!([0, 13, 14, 17].map(|k| names.entry(k)), ["∂gy/∂e2a[0]", "∂gy/∂z0", "∂gz/∂e2a[0]", "∂gz/∂e3a[0]"]);
    }

    #[test]
    fn the_kink_of_typed_inputs_is_that_of_their_components() {
        let at = |f_trial| crate::toolkit::verify::kink::<ReturnMap>(&Trial { f_trial, mu: 0.5, r#fn: 4.0 });
        assert_eq!((at(2.0), at(2.5)), (Some(Convention::Switch), None));
    }
}
