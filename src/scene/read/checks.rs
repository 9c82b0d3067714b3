//! What the needed formulas say about parameters.

use super::given::Given;
use crate::error::Error;
use crate::scene::json::Reader;
use crate::scene::kind::{Fallback, Kind, Origin};
use crate::scene::plan::{Needs, Signature};
use std::collections::HashMap;

/// What is needed, worked out once for elements alike.
#[derive(Default)]
pub(super) struct Checks {
    known: HashMap<Signature, Needs>,
}

impl Checks {
    /// Says what is wrong with the parameters of an element that stands at a place.
    pub(super) fn run(
        &mut self,
        reader: &mut Reader,
        place: usize,
        kind: &'static Kind,
        given: &[Given],
        outputs: u64,
    ) {
        self.check_required(reader, place, kind, given, outputs);
        let value = |name: &str| {
            let mut parameters = kind.parameters().zip(given);
            parameters.find(|((parameter, _), _)| *parameter == name).and_then(|(_, given)| given.number())
        };
        for &(lower, upper) in kind.ordered {
            if let (Some(low), Some(high)) = (value(lower), value(upper))
                && let Err(error) = Error::check_order((lower, low), (upper, high))
            {
                reader.reject(place, &error);
            }
        }
    }

    /// Says which parameter an output needs that is not given. One that was given badly is not also a missing one.
    fn check_required(
        &mut self,
        reader: &mut Reader,
        place: usize,
        kind: &'static Kind,
        given: &[Given],
        outputs: u64,
    ) {
        let is_zero = |(given, (_, fallback)): (&Given, (_, Fallback))| match given {
            Given::Absent => fallback.number().map(|number| number == 0.0),
            Given::Faulty => Some(false),
            Given::Number(number) => Some(*number == 0.0),
        };
        let signature = Signature::new(kind, given.iter().zip(kind.parameters()).map(is_zero), outputs);
        let needs = self.known.entry(signature).or_insert_with(|| Needs::of_outputs(&signature));
        for &(name, origin) in &needs.given {
            if origin == Origin::Parameter(Fallback::Required) && !signature.gives(name) {
                let why = needs.reasons(name);
                let allowed = format!("a number, the {}", kind.meaning(name));
                reader.fault(place, format!("no {name:?}, needed for {why}"), allowed);
            }
        }
    }
}
