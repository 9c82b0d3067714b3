//! The evaluation of every element of a group: registers, their sources, and the steps.

use super::needs::{Needs, wanted};
use super::signature::Signature;
use crate::element::table::{Span, Step, Wiring};
use crate::formula::Field;
use crate::scene::kind::{Fallback, Kind, Origin};
use std::fmt;

/// A formula with its wiring.
pub(in crate::scene) struct Planned {
    pub(in crate::scene) step: &'static dyn Step,
    pub(in crate::scene) wiring: Wiring,
    pub(in crate::scene) why: String,
}

impl fmt::Debug for Planned {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct(self.step.spec().id).field("wiring", &self.wiring).field("why", &self.why).finish()
    }
}

/// The evaluation of every element of a group.
#[derive(Debug)]
pub(in crate::scene) struct Recipe {
    /// The number of registers that persist from state to state; they are numbered first.
    pub(in crate::scene) lasting: usize,
    /// The number of other registers.
    pub(in crate::scene) passing: usize,
    pub(in crate::scene) parameters: Vec<Parameter>,
    /// The register of each load of the kind, if it is needed.
    pub(in crate::scene) loads: Vec<Option<usize>>,
    /// The pass in the initial configuration.
    pub(in crate::scene) start: Pass,
    /// The pass in every state.
    pub(in crate::scene) state: Pass,
    /// Name and registers of each output.
    pub(in crate::scene) outputs: Vec<(&'static str, Span)>,
}

/// A parameter that is a number.
#[derive(Debug)]
pub(in crate::scene) struct Parameter {
    /// Its index in the kind.
    pub(in crate::scene) index: usize,
    /// The number if it is not given.
    pub(in crate::scene) fallback: Option<f64>,
    pub(in crate::scene) register: usize,
}

/// Formulas that are evaluated together, and the values that they need beforehand.
#[derive(Debug)]
pub(in crate::scene) struct Pass {
    /// Registers of the last state, and those to which they are copied.
    pub(in crate::scene) before: Vec<(Span, Span)>,
    /// The quantities of the nodes that are read.
    pub(in crate::scene) reads: Vec<(Origin, Span)>,
    pub(in crate::scene) steps: Vec<Planned>,
}

impl Recipe {
    pub(in crate::scene) fn new(signature: &Signature) -> Self {
        let kind = signature.kind;
        let needs = Needs::of_outputs(signature);
        let initial = needs.given.iter().filter_map(|&(name, origin)| match origin {
            Origin::Initial(of) => Some((of, name)),
            _ => None,
        });
        let initial: Vec<_> = initial.collect();
        let at_start = initial.iter().map(|&(of, name)| (of, format!("{name}, the initial value")));
        let at_start = Needs::of(signature, at_start);

        // The given values of an element persist.
        let mut layout = Layout { kind, spans: Vec::new(), end: 0 };
        let given = |name: &str| needs.given.iter().chain(&at_start.given).any(|(other, _)| *other == name);
        let mut parameters = Vec::new();
        for (index, (name, fallback)) in kind.parameters().enumerate() {
            if given(name) && signature.gives(name) {
                parameters.push(Parameter { index, fallback: fallback.number(), register: layout.span(name).at });
            }
        }
        for (_, name) in &initial {
            layout.span(name);
        }
        let loads = kind.loads().map(|name| given(name).then(|| layout.span(name).at)).collect();
        for (name, fallback) in kind.parameters().filter(|(name, _)| given(name) && !signature.gives(name)) {
            if let Fallback::As(of) = fallback {
                layout.share(name, of);
            }
        }
        // In the initial pass, the registers that become initial values are computed in place, and all others are discarded.
        let mut start_layout = layout.clone();
        for (of, name) in initial {
            start_layout.share(of, name);
        }
        // Computed registers persist if they are needed later: as outputs, or in the next state.
        let wanted = wanted(kind, signature.outputs);
        let outputs = wanted.map(|(name, register)| (name, layout.span(register))).collect();
        for &(_, origin) in &needs.given {
            if let Origin::Before(of) = origin {
                layout.span(of);
            }
        }
        let lasting = layout.end;
        let state = Pass::new(&needs, &mut layout);
        // The initial pass has registers of its own, so that its leftovers are not mistaken for the zeros of a state.
        start_layout.end = layout.end;
        let start = Pass::new(&at_start, &mut start_layout);
        Self { lasting, passing: start_layout.end - lasting, parameters, loads, start, state, outputs }
    }
}

impl Pass {
    fn new(needs: &Needs, layout: &mut Layout) -> Self {
        let (mut before, mut reads) = (Vec::new(), Vec::new());
        for &(name, origin) in &needs.given {
            match origin {
                Origin::Before(of) => before.push((layout.span(of), layout.span(name))),
                Origin::Position(_) | Origin::Increment(_) | Origin::Axis(..) => {
                    reads.push((origin, layout.span(name)));
                }
                _ => {}
            }
        }
        Self { before, reads, steps: wire(needs, layout) }
    }
}

/// The needed formulas, each after those whose outputs it reads.
fn wire(needs: &Needs, layout: &mut Layout) -> Vec<Planned> {
    let mut waiting = needs.formulas.clone();
    let mut wired = Vec::new();
    while !waiting.is_empty() {
        let awaited = |register: &str| waiting.iter().any(|(formula, _)| formula.writes(register).is_some());
        let ready = waiting
            .iter()
            .position(|(formula, _)| formula.step.inputs().iter().all(|field| !awaited(formula.register(field.name))));
        // A test plans every output of every kind.
        let (formula, mut whys) = waiting.remove(ready.expect("no formula of a kind waits for itself"));
        whys.sort();
        whys.dedup();
        // A field may be a part of its register: in the plane, formulas read two components of three.
        let mut registers = |fields: &'static [Field]| -> Vec<u16> {
            let spans = fields.iter().map(|field| (layout.span(formula.register(field.name)).at, field.len()));
            spans.flat_map(|(at, len)| at..at + len).map(number_of).collect()
        };
        let wiring = Wiring { inputs: registers(formula.step.inputs()), outputs: registers(formula.step.outputs()) };
        wired.push(Planned { step: formula.step, wiring, why: whys.join(", ") });
    }
    wired
}

fn number_of(register: usize) -> u16 {
    u16::try_from(register).expect("no kind has anywhere near 65 536 registers")
}

/// Registers by name.
#[derive(Clone)]
pub(in crate::scene) struct Layout {
    kind: &'static Kind,
    spans: Vec<(&'static str, Span)>,
    end: usize,
}

impl Layout {
    /// The registers of this name, new ones at the end if there are none yet.
    pub(in crate::scene) fn span(&mut self, name: &'static str) -> Span {
        if let Some((_, span)) = self.spans.iter().find(|(other, _)| *other == name) {
            return *span;
        }
        let len = self.kind.field(name).expect("every register is written or read by a formula").len();
        let span = Span { at: self.end, len };
        self.end += len;
        self.spans.push((name, span));
        span
    }

    /// Gives registers a second name.
    fn share(&mut self, name: &'static str, with: &'static str) {
        let span = self.span(with);
        self.spans.push((name, span));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::model;

    /// Recipes for all outputs together and for each alone, with all parameters given and with none.
    fn recipes() -> impl Iterator<Item = (&'static Kind, Recipe)> {
        Kind::all().filter(|kind| !kind.slides()).flat_map(|kind| {
            let bits = kind.outputs().count();
            let outputs = move || (0..bits).map(|bit| 1 << bit).chain([(1 << bits) - 1]);
            [model::Parameter::Absent, model::Parameter::One(1.0)].into_iter().flat_map(move |given| {
                outputs().map(move |outputs| {
                    let parameters = vec![&given; kind.parameters().count()];
                    (kind, Recipe::new(&Signature::of_members(kind, &parameters, outputs, 1)[0].0))
                })
            })
        })
    }

    #[test]
    fn there_is_no_register_that_nothing_uses() {
        for (kind, recipe) in recipes() {
            let Recipe { lasting, passing, parameters, loads, start, state, outputs } = &recipe;
            let spans = outputs.iter().map(|(_, span)| *span);
            let given = parameters.iter().map(|parameter| parameter.register).chain(loads.iter().copied().flatten());
            let lasts = spans.map(|span| span.range().end).chain(given.map(|register| register + 1)).max();
            assert!(lasts.is_some_and(|end| end <= *lasting), "{kind:?}");
            let of_pass = |pass: &Pass| {
                let before = pass.before.iter().flat_map(|&(of, before)| [of, before]);
                let spans = before.chain(pass.reads.iter().map(|&(_, span)| span));
                let wired = pass.steps.iter().flat_map(|step| step.wiring.inputs.iter().chain(&step.wiring.outputs));
                let ends = spans.map(|span| span.range().end).chain(wired.map(|&register| usize::from(register) + 1));
                ends.max().unwrap_or(0)
            };
            let end = [lasts.unwrap_or(0), of_pass(start), of_pass(state)].into_iter().max();
            assert_eq!(end, Some(lasting + passing), "{kind:?}");
        }
    }

    #[test]
    fn what_a_formula_is_needed_for_is_said_once_and_in_order() {
        for (kind, recipe) in recipes() {
            for Planned { why, .. } in recipe.start.steps.iter().chain(&recipe.state.steps) {
                let plain = why.replace(", the initial value", " initially").replace(", which is not given", "");
                let whys: Vec<_> = plain.split(", ").collect();
                assert!(whys.is_sorted_by(|one, next| one < next), "{kind:?}: {why}");
            }
        }
    }
}
