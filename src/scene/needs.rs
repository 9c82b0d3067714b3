//! Which formulas a set of outputs needs.

use super::kind::{Fallback, Kind, Origin, Use};
use super::plan::Signature;
use super::recipe::{Layout, Planned};
use super::step::Wiring;

/// Formulas that were chosen, and the registers they need that are given.
#[derive(Default)]
pub(super) struct Needs {
    pub(super) formulas: Vec<(&'static Use, Vec<String>)>,
    pub(super) given: Vec<(&'static str, Origin)>,
}

/// Names and registers of the outputs whose bits are set.
pub(super) fn wanted(kind: &'static Kind, outputs: u64) -> impl Iterator<Item = (&'static str, &'static str)> {
    kind.outputs.iter().enumerate().filter(move |(bit, _)| outputs >> bit & 1 == 1).map(|(_, &output)| output)
}

impl Needs {
    /// What the outputs of an element need.
    pub(super) fn of_outputs(signature: &Signature) -> Self {
        let outputs = wanted(signature.kind, signature.outputs);
        Self::of(signature, outputs.map(|(name, register)| (register, format!("output {name}"))))
    }

    /// Which outputs need a register, directly or not.
    pub(super) fn reasons(&self, register: &str) -> String {
        let readers = self.formulas.iter().filter(|(formula, _)| formula.reads(register).is_some());
        readers.map(|(formula, _)| formula.step.id()).collect::<Vec<_>>().join(", ")
    }

    /// What these registers need. Where several formulas compute a register, one that is needed anyway is taken, and the
    /// first otherwise; so those without alternative are settled first.
    pub(super) fn of(signature: &Signature, wanted: impl Iterator<Item = (&'static str, String)>) -> Self {
        let kind = signature.kind;
        let mut needs = Self::default();
        let mut open: Vec<(&'static str, String)> = wanted.collect();
        while !open.is_empty() {
            let (mut later, mut next) = (Vec::new(), Vec::new());
            for (register, why) in open {
                if let Some(origin) = kind.given(register) {
                    if !needs.given.iter().any(|(name, _)| *name == register) {
                        needs.given.push((register, origin));
                        match origin {
                            Origin::Before(of) => next.push((of, format!("{register} of the next state"))),
                            Origin::Parameter(Fallback::As(of)) if !signature.gives(register) => {
                                next.push((of, format!("{register}, which is not given")));
                            }
                            _ => {}
                        }
                    }
                    continue;
                }
                if let Some((_, whys)) = needs.formulas.iter_mut().find(|(f, _)| f.writes(register).is_some()) {
                    whys.push(why);
                    continue;
                }
                let mut writers = kind.writers(register).filter(|formula| signature.applies(formula.when));
                match (writers.next(), writers.next()) {
                    (Some(formula), None) => needs.take(formula, why, &mut next),
                    (Some(_), Some(_)) => later.push((register, why)),
                    (None, _) => {}
                }
            }
            if next.is_empty() && !later.is_empty() {
                let (register, why) = later.remove(0);
                if let Some(formula) = kind.writers(register).find(|formula| signature.applies(formula.when)) {
                    needs.take(formula, why, &mut next);
                }
            }
            next.append(&mut later);
            open = next;
        }
        needs
    }

    fn take(&mut self, formula: &'static Use, why: String, next: &mut Vec<(&'static str, String)>) {
        let id = formula.step.id();
        let input = |name| (formula.register(name), format!("{} of {id}", formula.register(name)));
        next.extend(formula.step.inputs().iter().map(|field| input(field.name)));
        self.formulas.push((formula, vec![why]));
    }

    /// The formulas, each after those whose outputs it reads.
    pub(super) fn wire(&self, layout: &mut Layout) -> Vec<Planned> {
        let mut waiting = self.formulas.clone();
        let mut wired = Vec::new();
        while !waiting.is_empty() {
            let awaited = |register: &str| waiting.iter().any(|(formula, _)| formula.writes(register).is_some());
            let ready = waiting.iter().position(|(formula, _)| {
                formula.step.inputs().iter().all(|field| !awaited(formula.register(field.name)))
            });
            // The tables have no circle; a test holds them to it.
            let (formula, mut whys) = waiting.remove(ready.unwrap_or(0));
            whys.sort();
            whys.dedup();
            // A field may be a part of its register: in the plane, formulas read two components of three.
            let mut registers = |fields: &'static [crate::formula::Field]| -> Vec<u16> {
                let spans = fields.iter().map(|field| (layout.span(formula.register(field.name)).at, field.len()));
                let all: Vec<usize> = spans.flat_map(|(at, len)| at..at + len).collect();
                all.into_iter().map(|at| u16::try_from(at).unwrap_or(u16::MAX)).collect()
            };
            let wiring =
                Wiring { inputs: registers(formula.step.inputs()), outputs: registers(formula.step.outputs()) };
            wired.push(Planned { step: formula.step, wiring, why: whys.join(", ") });
        }
        wired
    }
}
