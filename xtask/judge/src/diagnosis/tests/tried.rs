//! All mistakes that are tried, kept in `tests/printed/check_tried.txt`.

use super::*;
use expect_test::expect_file;
use jointproof::toolkit::graph::{Node, Op};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Permutations of numbers, with the source of each.
fn exchanges(id: &'static str, wanted: Wanted) -> String {
    exchanged(id, wanted, "")
}

/// Those of the whole Jacobian, of blocks and of matrices.
fn matrices(id: &'static str, wanted: Wanted) -> String {
    exchanged(id, wanted, "transposed: ")
}

fn exchanged(id: &'static str, wanted: Wanted, begin: &str) -> String {
    diagnosed(
        (id, wanted),
        &[],
        |_, _| {},
        |court, _| {
            let evidence = Evidence::new(court, &[], &Verdict::default());
            let mut text = format!("exchanges of {id}, {}\n", wanted.name());
            for (what, places) in permuted::exchanges(&evidence).iter().filter(|(what, _)| what.starts_with(begin)) {
                let moved = places.iter().enumerate().filter(|(place, from)| place != *from);
                let moved: Vec<_> = moved
                    .map(|(place, &from)| format!("{} ← {}", evidence.names[place], evidence.names[from]))
                    .collect();
                let _ = writeln!(
                    text,
                    "    {what}\n        {}",
                    if moved.is_empty() { "nothing".into() } else { moved.join(", ") }
                );
            }
            text
        },
    )
}

/// Other inputs, with the source of each.
fn inputs(id: &str) -> String {
    let inputs = find(id).unwrap().inputs();
    let asked: Vec<_> =
        (1_u32..).take(inputs.iter().map(jointproof::formula::Field::len).sum()).map(f64::from).collect();
    let mut text = format!("inputs of {id}\n");
    for other in inputs::others(inputs) {
        let third: Vec<_> = asked.iter().map(|x| x / 3.0).collect();
        let _ = writeln!(text, "    {}\n        {:?} {:?}", other.what, other.of(&asked), other.of(&third));
    }
    text
}

/// The wording of expressions that are rare in formulas.
fn wordings(id: &str) -> String {
    let formula = find(id).unwrap();
    let graph = formula.graph().unwrap();
    let nodes = graph.needed(&[graph.value.as_slice(), &graph.jacobian].concat());
    let is_rare = |node: &Node| matches!(graph.op(*node), Op::ExactSum(_) | Op::Search(..) | Op::Norm(_));
    let written: BTreeSet<_> =
        nodes.into_iter().filter(is_rare).map(|node| wording::expression(&graph, formula.inputs(), node)).collect();
    written.into_iter().fold(format!("wordings of {id}\n"), |text, written| format!("{text}    {written}\n"))
}

#[test]
fn all_that_is_tried() {
    let text = [
        exchanges("slot.contact_force", Wanted::Jacobian),
        exchanges("ujoint.twist_factors", Wanted::Jacobian),
        exchanges("slot.constraint_force", Wanted::Value),
        exchanges("slide_line.basis", Wanted::Jacobian),
        matrices("universal.geometric_stiffness", Wanted::Jacobian),
        matrices("universal.geometric_stiffness", Wanted::Value),
        matrices("slide_line.linear_point", Wanted::Jacobian),
        inputs("coulomb.yield"),
        inputs("element.euler_parameters"),
        inputs("slot.normal_force"),
        wordings("slider.eliminate"),
        wordings("ujoint.decomposition"),
        wordings("slide_line.closest_parabolic"),
    ];
    expect_file!["../../../tests/printed/check_tried.txt"].assert_eq(&text.join("\n"));
}

#[test]
fn every_product_of_an_exact_sum_may_be_left_out() {
    let formula = find("slider.eliminate").unwrap();
    let graph = formula.graph().unwrap();
    let nodes = graph.needed(&graph.value);
    let products = |node: &Node| if let Op::ExactSum(products) = graph.op(*node) { Some(products.len()) } else { None };
    let (sum, count) = nodes.iter().find_map(|node| Some((*node, products(node)?))).unwrap();
    let mistakes = mistakes::mistakes(&graph, formula.inputs(), &[sum]);
    let left_out: Vec<_> = mistakes.into_iter().filter(|mistake| mistake.place == sum).collect();
    assert_eq!(left_out.len(), count);
    for mistake in left_out {
        let jointproof::toolkit::graph::Instead::Op(Op::ExactSum(rest)) = mistake.instead else {
            panic!("{}", mistake.what)
        };
        assert_eq!(rest.len(), count - 1, "{}", mistake.what);
    }
}
