//! An element in Fortran, with or without friction: a function with the recorded operations.

use super::super::language::files_within;
use super::super::recorded::{described, refusals, wrapped};
use super::{Array, Body, Fortran, Function, files_with_parts, module_of};
use jointproof::catalog::AnyElement;
use jointproof::toolkit::graph::{Extremes, Graph, NotRecorded};
use std::collections::HashMap;

/// The results in a line of the program.
const ROW: usize = 12;

/// The name of its module, without the prefix.
pub(in crate::export) fn stem(element: &dyn AnyElement, rubs: bool) -> String {
    format!("element_{}_{}", element.spec().id, if rubs { "rubbing" } else { "smooth" })
}

/// Its modules: it takes the inputs of the element, and gives all results in one array.
///
/// # Errors
/// The reason why the element cannot be recorded.
pub(in crate::export) fn modules(element: &dyn AnyElement, rubs: bool) -> Result<Vec<String>, NotRecorded> {
    let (graph, stem) = (element.graph(rubs, Extremes::Joined)?, stem(element, rubs));
    let body =
        Body { language: &Fortran, graph: &graph, inputs: element.inputs(rubs), names: &HashMap::new(), stem: &stem };
    let rows = graph.value.chunks(ROW).enumerate().map(|(k, row)| (k * ROW, row)).collect();
    let array = Array { name: "results", len: graph.value.len(), rows };
    let function = Function { name: format!("jp_{stem}_step"), outputs: &[], array: Some(array) };
    let head = description(element, rubs, &graph);
    let results: Vec<_> = graph.refusal.iter().chain(&graph.value).copied().collect();
    let files = files_within(|limit| {
        let (lines, parts) = body.program(&results, limit, 1);
        let text = function.text(&body, &lines);
        files_with_parts(&stem, module_of(&stem, &head, &[(text, function.name.clone(), lines.calls)]), &parts)
    });
    Ok(files.into_iter().map(|(_, text)| text).collect())
}

fn description(element: &dyn AnyElement, rubs: bool, graph: &Graph) -> Vec<String> {
    let (spec, inputs) = (element.spec(), element.inputs(rubs));
    let [friction, after] =
        if rubs { ["with friction", ", the state after the step"] } else { ["without friction", ""] };
    let mut lines = vec![format!("{}, {friction}", spec.title), format!("{}; {}", spec.source, spec.source.provenance)];
    lines.push(String::new());
    lines.extend(inputs.iter().map(|field| described("in ", field)));
    lines.push(format!(
        "out results({}): residuals, rows, forces, stiffness, derivative of the forces by the multipliers{after}; \
         matrices row by row",
        graph.value.len()
    ));
    lines.push(String::new());
    lines.push(format!("Golden cases: golden/elements/{}.json of jointproof {}", spec.id, env!("CARGO_PKG_VERSION")));
    lines.push("Printed by jointproof; free of conditions (CC0-1.0).".into());
    lines.push("The function gives 0, or".into());
    lines.iter().flat_map(|line| wrapped(line)).chain(refusals(inputs, graph)).collect()
}
