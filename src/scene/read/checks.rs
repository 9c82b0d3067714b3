//! The requirements of the needed formulas on parameters.

use crate::formula::error::Error;
use crate::scene::json::Reader;
use crate::scene::kind::Kind;
use crate::scene::model::Parameter;
use crate::scene::plan::{Needs, Signature};
use std::collections::HashMap;

/// The needs, computed once for elements with equal signatures.
#[derive(Default)]
pub(super) struct Checks {
    known: HashMap<Signature, Needs>,
}

/// A faulty parameter is not also reported as missing, and does not count as 0.
const FAULTY: Parameter = Parameter::One(f64::NAN);

impl Checks {
    /// Reports the faults in the parameters of an element, or of a set of `count` elements, at a position in the text; parameters
    /// that are faulty already are `None`.
    pub(super) fn run(
        &mut self,
        reader: &mut Reader,
        place: usize,
        kind: &'static Kind,
        count: u32,
        given: &[Option<Parameter>],
        outputs: u64,
    ) {
        let parameters: Vec<_> = given.iter().map(|parameter| parameter.as_ref().unwrap_or(&FAULTY)).collect();
        for (signature, _) in Signature::of_members(kind, &parameters, outputs, count) {
            self.check_required(reader, place, signature);
        }
        for &(lower, upper) in kind.ordered {
            let [lower, upper] = [lower, upper].map(|name| {
                let mut parameters = kind.parameters().zip(given);
                (name, parameters.find(|((parameter, _), _)| *parameter == name).and_then(|(_, given)| given.as_ref()))
            });
            let value = |given: Option<&Parameter>, member| given.and_then(|given| given.of(member));
            let checked = (0..count).try_for_each(|member| match (value(lower.1, member), value(upper.1, member)) {
                (Some(low), Some(high)) => Error::check_order((lower.0, low), (upper.0, high)),
                _ => Ok(()),
            });
            if let Err(error) = checked {
                reader.reject(place, &error);
            }
        }
    }

    /// Reports a parameter that an output needs and that is not given.
    fn check_required(&mut self, reader: &mut Reader, place: usize, signature: Signature) {
        let needs = self.known.entry(signature).or_insert_with(|| Needs::of_outputs(&signature));
        for name in needs.missing(&signature) {
            let why = needs.reasons(name);
            let allowed = format!("a number, the {}", signature.kind.meaning(name));
            reader.fault(place, format!("no {name:?}, needed for {why}"), allowed);
        }
    }
}
