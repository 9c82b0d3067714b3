//! Mistakes planted by rule in the recorded operations of every formula: how many are seen, and how many named.

use super::super::answer::{Answer, Heard};
use super::super::question::Wanted;
use super::super::taylor::questions;
use super::super::verdict::{Bounds, Court};
use jointproof::catalog::{AnyFormula, CATALOG};
use jointproof::toolkit::graph::{Binary, Extremes, Graph, Instead, Node, Op, Unary};
use jointproof::toolkit::verify::Options;

/// Formulas with more operations are left to others.
const LONGEST: usize = 60;
/// The mistakes planted in a formula.
const EACH: usize = 2;

/// Another operation instead of this one.
fn instead(graph: &Graph, node: Node) -> Option<Instead> {
    match *graph.op(node) {
        Op::Binary(Binary::Add, x, y) => Some(Instead::Op(Op::Binary(Binary::Subtract, x, y))),
        Op::Binary(Binary::Subtract, x, y) => Some(Instead::Op(Op::Binary(Binary::Add, x, y))),
        Op::Binary(Binary::Multiply, x, y) if x != y => Some(Instead::Result(y)),
        Op::Binary(Binary::Divide, x, y) => Some(Instead::Op(Op::Binary(Binary::Multiply, x, y))),
        Op::Unary(Unary::Negative | Unary::Absolute | Unary::Root, x) => Some(Instead::Result(x)),
        Op::Unary(Unary::Sine, x) => Some(Instead::Op(Op::Unary(Unary::Cosine, x))),
        Op::Unary(Unary::Cosine, x) => Some(Instead::Op(Op::Unary(Unary::Sine, x))),
        _ => None,
    }
}

/// Value, and its derivatives if they are wanted, of an altered formula.
fn answer(graph: &Graph, inputs: &[f64], wanted: Wanted) -> Vec<f64> {
    let needed = graph.needed(&graph.value);
    let all = graph.results(inputs, needed.iter().copied());
    let mut answer: Vec<f64> = graph.value.iter().map(|node| all[node.index()]).collect();
    if wanted == Wanted::Jacobian {
        answer.extend(graph.value.iter().flat_map(|node| graph.gradient(*node, &needed, &all, inputs.len())));
    }
    answer
}

/// What is said of a planted mistake: whether it is taken for right, and its causes. `None` if it changes nothing.
fn said(formula: &'static dyn AnyFormula, altered: &Graph, wanted: Wanted) -> Option<(bool, Vec<String>)> {
    let questions = questions(formula, wanted, &Options { samples: 40, ..Options::default() });
    let court = Court { formula, wanted, bounds: Bounds::of(formula), questions: &questions, is_strict: false };
    let mut is_changed = false;
    let answers: Vec<_> = questions
        .iter()
        .map(|question| match question.right(formula, wanted) {
            None => Answer::Refused(None),
            Some(right) => {
                let found = answer(altered, &question.inputs, wanted);
                is_changed |= question.name.starts_with("random ")
                    && found.iter().zip(&right).any(|(found, right)| (found - right).abs() > 1e-3 * right.abs());
                Answer::Numbers(found.into_iter().map(Some).collect())
            }
        })
        .collect();
    let judged = court.judged(&["mine".to_owned()], &[answers.clone(), answers], &Heard::default());
    is_changed.then(|| (judged.is_well(), judged.causes))
}

#[test]
fn most_mistakes_in_any_formula_are_named_and_none_is_right() {
    let (mut right, mut named, mut rest) = (Vec::new(), 0, Vec::new());
    for formula in CATALOG {
        let Ok(graph) = formula.graph_with(Extremes::Nan) else { continue };
        let needed = graph.needed(&graph.value);
        let places: Vec<_> = needed.iter().copied().filter(|node| instead(&graph, *node).is_some()).collect();
        if needed.len() > LONGEST || places.is_empty() {
            continue;
        }
        for k in 0..EACH {
            let place = places[(places.len() - 1) * (2 * k + 1) / (2 * EACH)];
            let Some(other) = instead(&graph, place) else { continue };
            let wanted = if formula.spec().is_closed() { Wanted::Jacobian } else { Wanted::Value };
            let what = format!("{} {:?}", formula.spec().id, graph.op(place));
            match said(*formula, &graph.altered(place, &other), wanted) {
                None => {}
                Some((true, _)) => right.push(what),
                Some((false, causes)) if causes.iter().any(|cause| cause.contains("unexplained")) => rest.push(what),
                Some(_) => named += 1,
            }
        }
    }
    let all = named + rest.len();
    println!("{named} of {all} are named; not these:\n{}", rest.join("\n"));
    assert!(right.is_empty(), "taken for right: {right:?}");
    assert!(named * 100 >= all * 75, "{named} of {all} are named");
}
