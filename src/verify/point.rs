//! A point at which claims are checked, and the names of what is compared there.

use super::claim::Deviation;
use super::subject::Subject;
use super::{exact, golden};
use crate::Octuple;
use crate::formula::Field;
use crate::proof::Convention;

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

/// Names of components: `x`, `xa[2]`.
pub(super) struct Names {
    pub(super) inputs: Vec<String>,
    pub(super) outputs: Vec<String>,
}

impl Names {
    pub(super) fn new(subject: &Subject) -> Self {
        Self { inputs: names(subject.inputs), outputs: names(subject.outputs) }
    }

    /// Of the k-th Jacobian entry.
    pub(super) fn entry(&self, k: usize) -> String {
        let (output, input) = (k / self.inputs.len(), k % self.inputs.len());
        format!("∂{}/∂{}", self.outputs[output], self.inputs[input])
    }
}

fn names(fields: &[Field]) -> Vec<String> {
    let of_field = |field: &Field| match field.len() {
        1 => vec![field.name.to_string()],
        len => (0..len).map(|k| format!("{}[{k}]", field.name)).collect(),
    };
    fields.iter().flat_map(of_field).collect()
}
