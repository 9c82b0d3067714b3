//! The properties that determine which formulas an element needs.

use crate::scene::kind::{Kind, When};
use crate::scene::model::Parameter;
use std::ops::Range;

/// The properties that determine which formulas an element needs.
#[derive(Clone, Copy)]
pub(in crate::scene) struct Signature {
    pub(in crate::scene) kind: &'static Kind,
    pub(in crate::scene) outputs: u64,
    /// One bit per parameter, set if it is not 0.
    on: u64,
    /// One bit per parameter, set if it is given.
    given: u64,
}

impl Signature {
    /// The signatures of the `count` members of a set, with consecutive members of equal signature combined.
    pub(in crate::scene) fn of_members(
        kind: &'static Kind,
        parameters: &[&Parameter],
        outputs: u64,
        count: u32,
    ) -> Vec<(Self, Range<u32>)> {
        let switches = kind.switches();
        let decides = parameters.iter().enumerate().filter_map(|(bit, parameter)| match parameter {
            Parameter::Each(numbers) if switches >> bit & 1 == 1 => Some(&**numbers),
            _ => None,
        });
        let decides: Vec<&[f64]> = decides.collect();
        let mut all = Vec::new();
        let mut from = 0;
        while from < count {
            let differs = |&member: &u32| {
                decides.iter().any(|numbers| (numbers[member as usize] == 0.0) != (numbers[from as usize] == 0.0))
            };
            let to = (from + 1..count).find(differs).unwrap_or(count);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::kind::Dimension;

    /// The ranges of four members of a kind in space, of which some parameters are given.
    fn ranges(kind: &str, given: &[(&str, Parameter)]) -> Vec<Range<u32>> {
        let kind = Kind::find(kind, Dimension::Space).unwrap();
        let of = |name| given.iter().find(|(known, _)| *known == name).map_or(&Parameter::Absent, |(_, given)| given);
        let parameters: Vec<_> = kind.parameters().map(|(name, _)| of(name)).collect();
        Signature::of_members(kind, &parameters, 1, 4).into_iter().map(|(_, members)| members).collect()
    }

    fn each(numbers: [f64; 4]) -> Parameter {
        Parameter::Each(numbers.into())
    }

    #[test]
    fn members_are_alike_as_long_as_the_same_parameters_are_zero() {
        assert_eq!(ranges("slot", &[("mu", each([0.5, 0.25, 0.0, 0.0]))]), [0..2, 2..4]);
        assert_eq!(ranges("slot", &[("mu", each([0.0, 0.5, 0.0, 0.5]))]), [0..1, 1..2, 2..3, 3..4]);
        assert_eq!(ranges("slot", &[("mu", Parameter::One(0.0))]), [0..4; 1]);
        let (rr, l) = (each([1.0, 0.0, 0.0, 0.0]), each([1.0, 1.0, 1.0, 0.0]));
        assert_eq!(ranges("translator", &[("rr", rr), ("l", l)]), [0..1, 1..3, 3..4]);
    }

    #[test]
    fn a_zero_of_what_decides_nothing_parts_no_members() {
        let numbers = each([0.0, 1.0, 0.0, 1.0]);
        let given = ["l1_ref", "l1_min", "k_stick", "fc_int"].map(|name| (name, numbers.clone()));
        assert_eq!(ranges("slot", &given), [0..4; 1]);
        assert_eq!(ranges("universal", &[("theta1_ref", numbers)]), [0..4; 1]);
    }

    #[test]
    fn a_number_that_decides_nothing_makes_no_other_signature() {
        let kind = Kind::find("slot", Dimension::Space).unwrap();
        let of = |number| {
            let (absent, given) = (Parameter::Absent, Parameter::One(number));
            let parameters: Vec<_> =
                kind.parameters().map(|(name, _)| if name == "mu" { &absent } else { &given }).collect();
            Signature::of_members(kind, &parameters, 1, 1)[0].0
        };
        assert!(of(0.0) == of(1.0));
        assert!(of(0.0).applies(When::AllZero(&["mu"])) && !of(1.0).applies(When::NotAllZero(&["mu"])));
        assert!(of(1.0).gives("l1_min") && of(1.0).gives("mu"), "μ is 0 where it is not given");
    }
}
