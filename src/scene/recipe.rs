//! What is done for every element of a group: registers, where they come from, and the steps.

use super::kind::{Fallback, Kind, Origin};
use super::needs::{Needs, wanted};
use super::plan::Signature;
use super::step::{Step, Wiring};
use std::fmt;

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

/// What is done for every element of a group. Registers below `kept` last from state to state.
#[derive(Debug, Default)]
pub(super) struct Recipe {
    pub(super) stride: usize,
    pub(super) kept: usize,
    /// Parameter, by its place in the kind, and its register.
    pub(super) parameters: Vec<(usize, Span)>,
    /// The register of each load of the kind, if it is needed.
    pub(super) loads: Vec<Option<Span>>,
    /// Copied at the end of the start: from a computed register to a kept one.
    pub(super) initial: Vec<(Span, Span)>,
    /// Parameters that are not given, after the initial values: from, to.
    pub(super) fallbacks: Vec<(Span, Span)>,
    /// Copied at the end of a state.
    pub(super) before: Vec<(Span, Span)>,
    /// Node and register.
    pub(super) positions: Vec<(usize, Span)>,
    /// Node, register of the increment, register of the position before.
    pub(super) increments: Vec<(usize, Span, Span)>,
    /// Node, axis, register.
    pub(super) axes: Vec<(usize, usize, Span)>,
    pub(super) start: Vec<Planned>,
    pub(super) steps: Vec<Planned>,
    /// Name and register of each output.
    pub(super) outputs: Vec<(&'static str, Span)>,
}

impl Recipe {
    pub(super) fn new(signature: &Signature) -> Self {
        let kind = signature.kind;
        let every = Needs::of_outputs(signature);
        let mut at_start = Vec::new();
        for &(name, origin) in &every.given {
            match origin {
                Origin::Initial(of) => at_start.push((of, format!("{name}, the initial value"))),
                Origin::Parameter(Fallback::As(of)) if !signature.gives(name) => {
                    if let Some(Origin::Initial(initial)) = kind.given(of) {
                        at_start.push((initial, format!("{name}, which is not given")));
                    }
                }
                _ => {}
            }
        }
        let start = Needs::of(signature, at_start.into_iter());
        let mut layout = Layout { kind, spans: Vec::new(), end: 0 };
        let mut recipe = Self::default();
        recipe.keep(signature, &every, &mut layout);
        recipe.gather(every.given.iter().chain(&start.given), &mut layout);
        recipe.start = start.wire(&mut layout);
        recipe.steps = every.wire(&mut layout);
        for &(name, origin) in &every.given {
            match origin {
                Origin::Initial(of) => recipe.initial.push((layout.span(of), layout.span(name))),
                Origin::Before(of) => recipe.before.push((layout.span(of), layout.span(name))),
                Origin::Parameter(Fallback::As(of)) if !signature.gives(name) => {
                    let of = match kind.given(of) {
                        Some(Origin::Initial(initial)) => initial,
                        _ => of,
                    };
                    recipe.fallbacks.push((layout.span(of), layout.span(name)));
                }
                _ => {}
            }
        }
        recipe.outputs =
            wanted(kind, signature.outputs).map(|(name, register)| (name, layout.span(register))).collect();
        recipe.stride = layout.end;
        recipe
    }

    /// Lays out what lasts from state to state.
    fn keep(&mut self, signature: &Signature, needs: &Needs, layout: &mut Layout) {
        let given = |name: &str| needs.given.iter().any(|(other, _)| *other == name);
        for (index, (name, _)) in signature.kind.parameters().enumerate() {
            if given(name) {
                self.parameters.push((index, layout.span(name)));
            }
        }
        self.loads = signature.kind.loads().map(|name| given(name).then(|| layout.span(name))).collect();
        for &(name, origin) in &needs.given {
            match origin {
                Origin::Initial(_) | Origin::Before(_) => drop(layout.span(name)),
                Origin::Increment(node) => {
                    let before = layout.extra(layout.len(name));
                    self.increments.push((node, Span { at: 0, len: 0 }, before));
                }
                _ => {}
            }
        }
        self.kept = layout.end;
        let increments = needs.given.iter().filter(|(_, origin)| matches!(origin, Origin::Increment(_)));
        for (increment, (name, _)) in self.increments.iter_mut().zip(increments) {
            increment.1 = layout.span(name);
        }
    }

    /// Lays out what comes from the nodes.
    fn gather<'n>(&mut self, given: impl Iterator<Item = &'n (&'static str, Origin)>, layout: &mut Layout) {
        for &(name, origin) in given {
            let known = layout.spans.iter().any(|(other, _)| *other == name);
            let span = layout.span(name);
            match origin {
                Origin::Position(node) if !known => self.positions.push((node, span)),
                Origin::Axis(node, axis) if !known => self.axes.push((node, axis, span)),
                _ => {}
            }
        }
    }
}

/// Registers by name.
pub(super) struct Layout {
    kind: &'static Kind,
    spans: Vec<(&'static str, Span)>,
    end: usize,
}

impl Layout {
    fn len(&self, register: &str) -> usize {
        self.kind.field(register).map_or(1, crate::formula::Field::len)
    }

    fn extra(&mut self, len: usize) -> Span {
        self.end += len;
        Span { at: self.end - len, len }
    }

    pub(super) fn span(&mut self, register: &'static str) -> Span {
        if let Some((_, span)) = self.spans.iter().find(|(name, _)| *name == register) {
            return *span;
        }
        let span = self.extra(self.len(register));
        self.spans.push((register, span));
        span
    }
}
