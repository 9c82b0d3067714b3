//! What is done for every element of a group: registers, where they come from, and the steps.

use super::kind::{Fallback, Kind, Origin};
use super::needs::{Needs, wanted};
use super::plan::Signature;
use super::step::{Step, Wiring};
use std::fmt;
use std::ops::Range;

/// A formula with its wiring.
pub(super) struct Planned {
    pub(super) step: &'static dyn Step,
    pub(super) wiring: Wiring,
    pub(super) why: String,
}

impl fmt::Debug for Planned {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct(self.step.id()).field("wiring", &self.wiring).field("why", &self.why).finish()
    }
}

/// A run of registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    pub(super) at: usize,
    pub(super) len: usize,
}

impl Span {
    #[inline]
    pub(super) fn range(self) -> Range<usize> {
        self.at..self.at + self.len
    }
}

/// What is done for every element of a group.
#[derive(Debug)]
pub(super) struct Recipe {
    /// How many registers last from state to state; they are numbered first.
    pub(super) lasting: usize,
    /// How many there are beside them.
    pub(super) passing: usize,
    /// Parameter, by its place in the kind, what it is if not given, and its register.
    pub(super) parameters: Vec<(usize, f64, usize)>,
    /// The register of each load of the kind, if it is needed.
    pub(super) loads: Vec<Option<usize>>,
    /// In the initial configuration.
    pub(super) start: Pass,
    /// In every state.
    pub(super) state: Pass,
    /// Name and registers of each output.
    pub(super) outputs: Vec<(&'static str, Span)>,
}

/// Formulas that are evaluated together, and what must be there before.
#[derive(Debug)]
pub(super) struct Pass {
    /// What the last state has left, and where it is wanted now.
    pub(super) before: Vec<(Span, Span)>,
    /// What is read of the nodes.
    pub(super) reads: Vec<(Origin, Span)>,
    pub(super) steps: Vec<Planned>,
}

impl Recipe {
    pub(super) fn new(signature: &Signature) -> Self {
        let kind = signature.kind;
        let needs = Needs::of_outputs(signature);
        let initial = needs.given.iter().filter_map(|&(name, origin)| match origin {
            Origin::Initial(of) => Some((of, name)),
            _ => None,
        });
        let initial: Vec<_> = initial.collect();
        let at_start = initial.iter().map(|&(of, name)| (of, format!("{name}, the initial value")));
        let at_start = Needs::of(signature, at_start);

        // What an element is given lasts.
        let mut layout = Layout { kind, spans: Vec::new(), end: 0 };
        let given = |name: &str| needs.given.iter().chain(&at_start.given).any(|(other, _)| *other == name);
        let mut parameters = Vec::new();
        for (index, (name, fallback)) in kind.parameters().enumerate() {
            if given(name) && signature.gives(name) {
                parameters.push((index, fallback.number().unwrap_or(0.0), layout.span(name).at));
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
        // At the start, what becomes an initial value is computed where it is kept, and everything else is forgotten.
        let mut start_layout = layout.clone();
        for (of, name) in initial {
            start_layout.share(of, name);
        }
        // What is computed lasts where it is wanted later: by who asks for the outputs, or in the next state.
        let wanted = wanted(kind, signature.outputs);
        let outputs = wanted.map(|(name, register)| (name, layout.span(register))).collect();
        for &(_, origin) in &needs.given {
            if let Origin::Before(of) = origin {
                layout.span(of);
            }
        }
        let lasting = layout.end;
        let state = Pass::new(&needs, &mut layout);
        // The start has registers of its own, so that what it leaves there is not taken for the zeros of a state.
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
        Self { before, reads, steps: needs.wire(layout) }
    }
}

/// Registers by name.
#[derive(Clone)]
pub(super) struct Layout {
    kind: &'static Kind,
    spans: Vec<(&'static str, Span)>,
    end: usize,
}

impl Layout {
    /// The registers of this name, new ones at the end if there are none yet.
    pub(super) fn span(&mut self, name: &'static str) -> Span {
        if let Some((_, span)) = self.spans.iter().find(|(other, _)| *other == name) {
            return *span;
        }
        let len = self.kind.field(name).map_or(1, crate::formula::Field::len);
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
