//! The numbers with a bound: the components of the value, and the entries of a Jacobian in closed form.

use jointproof::catalog::AnyFormula;
use jointproof::formula::Field;
use jointproof::formula::quantity::Domain;
use jointproof::toolkit::graph::{Graph, Node, Op};
use std::collections::HashSet;
use std::ops::Range;

/// An operation, and all that it needs.
pub(crate) type Needed = (Node, Vec<Node>);

/// A result whose error is searched, with those beside which it is judged.
pub(crate) struct Target {
    pub(crate) is_jacobian: bool,
    /// Whether it is an angle, which is the same after a full turn.
    pub(crate) is_angle: bool,
    /// The result, and the operations that it needs.
    pub(crate) own: Needed,
    /// The same of those beside it; none unless the bounds are normwise.
    pub(crate) beside: Vec<Needed>,
    /// Everything that these need, and what tells whether inputs are refused.
    pub(crate) needed: Vec<Node>,
    /// The operations that are singular somewhere, and the numbers that vanish there, with what they need.
    pub(crate) singular: Vec<(Node, Vec<Needed>)>,
}

/// All targets of a formula, each once.
pub(crate) fn targets(formula: &dyn AnyFormula, graph: &Graph) -> Vec<Target> {
    let (inputs, outputs) = (formula.inputs(), formula.outputs());
    let (number, normwise) = (count(inputs), formula.spec().normwise.is_some());
    let of_value = (0..graph.value.len()).map(|output| {
        let others = others(outputs, output).map(|other| graph.value[other]);
        ([false, is_angle(outputs, output)], graph.value[output], others.collect::<Vec<_>>())
    });
    let of_jacobian = (0..graph.jacobian.len()).map(|entry| {
        let (output, input) = (entry / number, entry % number);
        let by_inputs = others(inputs, input).map(|other| output * number + other);
        let by_outputs = others(outputs, output).map(|other| other * number + input);
        let is_scalar = others(inputs, input).next().is_none();
        let others: Vec<_> = if is_scalar { by_outputs.collect() } else { by_inputs.collect() };
        ([true, false], graph.jacobian[entry], others.into_iter().map(|other| graph.jacobian[other]).collect())
    });
    let mut known = HashSet::new();
    of_value
        .chain(of_jacobian)
        .filter(|(_, own, _)| !matches!(graph.op(*own), Op::Input(_) | Op::Number(_)))
        .map(|(kind, own, beside)| (kind, own, if normwise { beside } else { Vec::new() }))
        .filter(|target| known.insert(target.clone()))
        .map(|([is_jacobian, is_angle], own, beside)| {
            let all: Vec<_> = beside.iter().copied().chain([own]).chain(graph.refusal).collect();
            let with_needed = |node| (node, graph.needed(&[node]));
            let beside = beside.into_iter().map(with_needed).collect();
            let (needed, own) = (graph.needed(&all), with_needed(own));
            let singular = if formula.spec().apart > 0.0 { graph.singular(&own.1) } else { Vec::new() };
            let singular = singular.into_iter().map(|(node, all)| (node, all.into_iter().map(with_needed).collect()));
            Target { is_jacobian, is_angle, own, beside, needed, singular: singular.collect() }
        })
        .collect()
}

/// The other components of the field that has this one.
fn others(fields: &[Field], component: usize) -> impl Iterator<Item = usize> + use<> {
    Field::ranges(fields).find(|range| range.contains(&component)).unwrap_or(0..0).filter(move |&k| k != component)
}

/// Whether a component is of an angle.
fn is_angle(fields: &[Field], component: usize) -> bool {
    let field = Field::ranges(fields).position(|range| range.contains(&component));
    field.is_some_and(|field| fields[field].quantity.domain == Domain::Angle)
}

/// The components of what the sensitivities of a formula are to: of whole vectors if its bounds are normwise.
pub(crate) fn fields(formula: &dyn AnyFormula) -> Vec<Range<usize>> {
    if formula.spec().normwise.is_some() {
        return Field::ranges(formula.inputs()).collect();
    }
    (0..count(formula.inputs())).map(|k| k..k + 1).collect()
}

fn count(fields: &[Field]) -> usize {
    fields.iter().map(Field::len).sum()
}
