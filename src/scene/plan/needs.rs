//! The formulas that a set of outputs needs.

use super::signature::Signature;
use crate::scene::kind::{Fallback, Kind, Origin, Use};
use crate::scene::model::Parameter;

/// The chosen formulas, and the given registers that they need.
#[derive(Default)]
pub(in crate::scene) struct Needs {
    pub(in crate::scene) formulas: Vec<(&'static Use, Vec<String>)>,
    pub(in crate::scene) given: Vec<(&'static str, Origin)>,
}

/// Names and registers of the outputs whose bits are set.
pub(in crate::scene) fn wanted(
    kind: &'static Kind,
    outputs: u64,
) -> impl Iterator<Item = (&'static str, &'static str)> {
    kind.outputs().enumerate().filter(move |(bit, _)| outputs >> bit & 1 == 1).map(|(_, output)| output)
}

impl Needs {
    /// The needs of the outputs of an element.
    pub(in crate::scene) fn of_outputs(signature: &Signature) -> Self {
        let outputs = wanted(signature.kind, signature.outputs);
        Self::of(signature, outputs.map(|(name, register)| (register, format!("output {name}"))))
    }

    /// The outputs that need a register, directly or indirectly.
    pub(in crate::scene) fn reasons(&self, register: &str) -> String {
        let readers = self.formulas.iter().filter(|(formula, _)| formula.reads(register).is_some());
        readers.map(|(formula, _)| formula.id()).collect::<Vec<_>>().join(", ")
    }

    /// The required parameters that are not given.
    pub(in crate::scene) fn missing(&self, signature: &Signature) -> impl Iterator<Item = &'static str> {
        let is_required = |origin: Origin| origin == Origin::Parameter(Fallback::Required);
        self.given
            .iter()
            .filter(move |&&(name, origin)| is_required(origin) && !signature.gives(name))
            .map(|(name, _)| *name)
    }

    /// The needs of these registers.
    pub(in crate::scene) fn of(signature: &Signature, wanted: impl Iterator<Item = (&'static str, String)>) -> Self {
        let mut needs = Self::default();
        let mut open: Vec<Wanted> = wanted.collect();
        while !open.is_empty() {
            let mut next = Vec::new();
            for (register, why) in open {
                needs.settle(signature, register, why, &mut next);
            }
            open = next;
        }
        needs
    }

    /// Determines the source of a register.
    fn settle(&mut self, signature: &Signature, register: &'static str, why: String, next: &mut Vec<Wanted>) {
        if let Some(origin) = signature.kind.given(register) {
            self.give(signature, register, origin, next);
        } else if let Some((_, whys)) = self.formulas.iter_mut().find(|(f, _)| f.writes(register).is_some()) {
            whys.push(why);
        } else {
            self.take(writer(signature, register), why, next);
        }
    }

    /// Adds a given register, and requests the register on which its value depends.
    fn give(&mut self, signature: &Signature, register: &'static str, origin: Origin, next: &mut Vec<Wanted>) {
        if self.given.iter().any(|(name, _)| *name == register) {
            return;
        }
        self.given.push((register, origin));
        match origin {
            Origin::Before(of) => next.push((of, format!("{register} of the next state"))),
            Origin::Parameter(Fallback::As(of)) if !signature.gives(register) => {
                next.push((of, format!("{register}, which is not given")));
            }
            _ => {}
        }
    }

    fn take(&mut self, formula: &'static Use, why: String, next: &mut Vec<Wanted>) {
        let id = formula.id();
        let input = |name| (formula.register(name), format!("{} of {id}", formula.register(name)));
        next.extend(formula.step.inputs().iter().map(|field| input(field.name)));
        self.formulas.push((formula, vec![why]));
    }
}

/// The outputs for which an element has all parameters that they need: one bit per output of the kind.
pub(in crate::scene) fn answerable(kind: &'static Kind, parameters: &[Parameter], count: u32) -> u64 {
    let parameters: Vec<_> = parameters.iter().collect();
    let is_answerable = |bit: usize| {
        let mut signatures = Signature::of_members(kind, &parameters, 1 << bit, count).into_iter();
        kind.slides()
            || signatures.all(|(signature, _)| Needs::of_outputs(&signature).missing(&signature).next().is_none())
    };
    (0..kind.outputs().count()).filter(|&bit| is_answerable(bit)).fold(0, |mask, bit| mask | 1 << bit)
}

/// A requested register, and the reason.
type Wanted = (&'static str, String);

/// The formula that computes a register; no kind has two at the same time.
fn writer(signature: &Signature, register: &'static str) -> &'static Use {
    let kind = signature.kind;
    let mut writers = kind.writers(register).filter(|formula| signature.applies(formula.when));
    writers.next().unwrap_or_else(|| unreachable!("{kind:?} is not given {register}, and computes it nowhere"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::kind::When;
    use crate::scene::model::Parameter;

    /// The parameters on which the use of formulas depends.
    fn conditions(kind: &Kind) -> Vec<&'static str> {
        let mut names: Vec<_> = kind
            .formulas()
            .flat_map(|formula| match formula.when {
                When::Always => &[],
                When::AllZero(names) | When::NotAllZero(names) | When::AllGiven(names) | When::NotAllGiven(names) => {
                    names
                }
            })
            .copied()
            .collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    /// Whether a register is read by a formula or in a later state, or is an output.
    fn is_read(kind: &Kind, register: &str) -> bool {
        kind.outputs().any(|(_, shown)| shown == register)
            || kind.formulas().any(|formula| formula.reads(register).is_some())
            || kind.origins().any(|origin| match origin {
                Origin::Initial(of) | Origin::Before(of) | Origin::Parameter(Fallback::As(of)) => of == register,
                _ => false,
            })
    }

    /// Otherwise it would be unclear which of them is needed.
    #[test]
    fn no_kind_has_two_formulas_at_once_that_compute_a_register() {
        let numbers = [Parameter::Absent, Parameter::One(0.0), Parameter::One(1.0)];
        for kind in Kind::all().filter(|kind| !kind.slides()) {
            let names = conditions(kind);
            let most = 3_usize.pow(u32::try_from(names.len()).unwrap());
            for choice in 0..most {
                let digit = |name| {
                    names
                        .iter()
                        .position(|known| *known == name)
                        .map_or(0, |at| choice / 3_usize.pow(u32::try_from(at).unwrap()) % 3)
                };
                let parameters: Vec<_> = kind.parameters().map(|(name, _)| &numbers[digit(name)]).collect();
                let signature = Signature::of_members(kind, &parameters, 1, 1)[0].0;
                let taken = || kind.formulas().filter(|formula| signature.applies(formula.when));
                let of_formula =
                    |formula: &'static Use| formula.step.outputs().iter().map(|field| formula.register(field.name));
                let mut written: Vec<_> =
                    taken().flat_map(of_formula).filter(|register| is_read(kind, register)).collect();
                written.sort_unstable();
                assert!(written.is_sorted_by(|one, next| one < next), "{kind:?}: {written:?}");
            }
        }
    }

    #[test]
    fn what_is_wanted_and_what_a_formula_reads_is_given_or_computed() {
        for kind in Kind::all().filter(|kind| !kind.slides()) {
            let bits = kind.outputs().count();
            for given in [Parameter::Absent, Parameter::One(0.0), Parameter::One(1.0)] {
                let parameters = vec![&given; kind.parameters().count()];
                for (a, b) in (0..bits).flat_map(|a| (a..bits).map(move |b| (a, b))) {
                    let signature = Signature::of_members(kind, &parameters, 1 << a | 1 << b, 1)[0].0;
                    let needs = Needs::of_outputs(&signature);
                    let is_there = |register: &str| {
                        needs.given.iter().any(|(name, _)| *name == register)
                            || needs.formulas.iter().any(|(formula, _)| formula.writes(register).is_some())
                    };
                    for (name, register) in wanted(kind, signature.outputs) {
                        assert!(is_there(register), "{kind:?}: {name}");
                    }
                    for (formula, _) in &needs.formulas {
                        let inputs = formula.step.inputs().iter().map(|field| formula.register(field.name));
                        inputs.for_each(|input| assert!(is_there(input), "{kind:?}: {input} of {}", formula.id()));
                    }
                }
            }
        }
    }

    #[test]
    fn every_formula_and_every_register_is_needed_once_with_all_its_reasons() {
        for kind in Kind::all().filter(|kind| !kind.slides()) {
            let given = Parameter::One(1.0);
            let parameters = vec![&given; kind.parameters().count()];
            let all = (1 << kind.outputs().count()) - 1;
            let needs = Needs::of_outputs(&Signature::of_members(kind, &parameters, all, 1)[0].0);
            for (index, (name, _)) in needs.given.iter().enumerate() {
                assert!(needs.given[..index].iter().all(|(before, _)| before != name), "{kind:?}: {name}");
            }
            for (index, (formula, whys)) in needs.formulas.iter().enumerate() {
                let is_it = |(other, _): &(&'static Use, _)| std::ptr::eq(*other, *formula);
                assert!(!needs.formulas[..index].iter().any(is_it), "{kind:?}: {}", formula.id());
                for (name, register) in kind.outputs().filter(|(_, register)| formula.writes(register).is_some()) {
                    assert!(whys.contains(&format!("output {name}")), "{kind:?}: {register} of {}", formula.id());
                }
            }
        }
    }
}
