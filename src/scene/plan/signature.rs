//! What decides which formulas an element needs.

use crate::scene::kind::{Fallback, Kind, When};
use crate::scene::model::SceneElement;

/// What decides which formulas an element needs.
#[derive(Clone, Copy)]
pub(in crate::scene) struct Signature {
    pub(in crate::scene) kind: &'static Kind,
    pub(in crate::scene) outputs: u64,
    /// A bit per parameter: not 0.
    on: u64,
    /// A bit per parameter: given.
    given: u64,
}

impl Signature {
    pub(in crate::scene) fn of(element: &SceneElement) -> Self {
        let zero = |(value, (_, fallback)): (&Option<f64>, (_, Fallback))| {
            value.or(fallback.number()).map(|number| number == 0.0)
        };
        let parameters = element.parameters.iter().zip(element.kind.parameters());
        Self::new(element.kind, parameters.map(zero), element.outputs)
    }

    /// Of an element, given for each parameter of its kind whether it is 0, or `None` if it has no number.
    pub(in crate::scene) fn new(kind: &'static Kind, zero: impl Iterator<Item = Option<bool>>, outputs: u64) -> Self {
        let (mut on, mut given) = (0, 0);
        for (bit, zero) in zero.enumerate() {
            on |= u64::from(zero != Some(true)) << bit;
            given |= u64::from(zero.is_some()) << bit;
        }
        Self { kind, outputs, on: on & kind.switches(), given }
    }

    fn key(&self) -> (&'static str, &'static str, u64, u64, u64) {
        (self.kind.name, self.kind.dimension.name(), self.outputs, self.on, self.given)
    }

    pub(in crate::scene) fn applies(&self, when: When) -> bool {
        let any = |names: &[&str]| {
            let mut parameters = self.kind.parameters().enumerate();
            parameters.any(|(bit, (name, _))| names.contains(&name) && self.on >> bit & 1 == 1)
        };
        match when {
            When::Always => true,
            When::AllZero(names) => !any(names),
            When::NotAllZero(names) => any(names),
            When::AllGiven(names) => names.iter().all(|name| self.gives(name)),
            When::NotAllGiven(names) => !names.iter().all(|name| self.gives(name)),
        }
    }

    pub(in crate::scene) fn gives(&self, parameter: &str) -> bool {
        self.kind.parameters().enumerate().any(|(bit, (name, _))| name == parameter && self.given >> bit & 1 == 1)
    }
}

impl PartialEq for Signature {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}
impl Eq for Signature {}
impl std::hash::Hash for Signature {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}
