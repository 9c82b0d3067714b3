//! What decides which formulas an element needs.

use crate::scene::kind::{Kind, When};
use crate::scene::model::Parameter;
use std::ops::Range;

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
    /// Those of the members of a set of so many, one after the other as long as they are alike.
    pub(in crate::scene) fn of_members(
        kind: &'static Kind,
        parameters: &[&Parameter],
        outputs: u64,
        count: u32,
    ) -> Vec<(Self, Range<u32>)> {
        let switches = parameters.iter().enumerate().filter_map(|(bit, parameter)| match parameter {
            Parameter::Each(numbers) => Some((bit, &**numbers)),
            _ => None,
        });
        let decides: Vec<_> = switches.filter(|(bit, _)| kind.switches() >> bit & 1 == 1).collect();
        let zeros = |member: u32| {
            let is_zero = |&(bit, numbers): &(usize, &[f64])| u64::from(numbers[member as usize] == 0.0) << bit;
            decides.iter().map(is_zero).sum::<u64>()
        };
        let mut all = Vec::new();
        let mut from = 0;
        while from < count {
            let here = if decides.is_empty() { 0 } else { zeros(from) };
            let differs = |&member: &u32| zeros(member) != here;
            let to = if decides.is_empty() { count } else { (from + 1..count).find(differs).unwrap_or(count) };
            all.push((Self::of_member(kind, parameters, outputs, from), from..to));
            from = to;
        }
        all
    }

    fn of_member(kind: &'static Kind, parameters: &[&Parameter], outputs: u64, member: u32) -> Self {
        let (mut on, mut given) = (0, 0);
        for (bit, (parameter, (_, fallback))) in parameters.iter().zip(kind.parameters()).enumerate() {
            let number = parameter.of(member).or(fallback.number());
            on |= u64::from(number != Some(0.0)) << bit;
            given |= u64::from(number.is_some()) << bit;
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
