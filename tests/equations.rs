//! The printed equations are executed, and a wrong token in one is found.
//!
//! That they agree with the code, value and Jacobian, is a claim of the audit.

mod mutations;

use jointproof::catalog::{CATALOG, find};
use jointproof::equation::Equation;
use jointproof::verify::Options;
use mutations::mutants;
use std::cell::LazyCell;

#[test]
fn every_equation_can_be_executed() {
    for formula in CATALOG {
        let read = Equation::of(&formula.spec(), formula.inputs(), formula.outputs());
        assert!(read.is_ok(), "{}: {}", formula.spec().id, read.unwrap_err());
    }
}

/// Mutants that are the same function, and why.
const EQUIVALENT: &[(&str, &str, &str)] = &[
    ("slider.basis", "/ →  at 166", "|n×k| is 1 wherever n×i is 0, since n is a unit vector"),
    ("interaction.damping", "c_0 → h at 92", "the first case has taken −h ≤ η c0 already"),
];

/// Every single-token mutant of every equation is refused, or gives another value at some point.
#[test]
fn a_wrong_token_is_found() {
    let (mut tried, mut refused, mut equivalent, mut survivors) = (0, 0, 0, Vec::new());
    for formula in CATALOG {
        let spec = formula.spec();
        // Most fall at the first point; what survives a few is tried at many.
        let few = formula.trial(&Options { samples: 3, seed: 7 });
        let many = LazyCell::new(|| formula.trial(&Options { samples: 200, seed: 7 }));
        for mutant in mutants(spec.latex) {
            tried += 1;
            let read = Equation::in_place_of(&spec, &mutant.latex, formula.inputs(), formula.outputs());
            let Ok(equation) = read else {
                refused += 1;
                continue;
            };
            if few.first_difference(&equation).is_some() || many.first_difference(&equation).is_some() {
                continue;
            }
            let is_known = EQUIVALENT.iter().any(|(id, what, _)| (*id, *what) == (spec.id, mutant.what.as_str()));
            if is_known {
                equivalent += 1;
            } else {
                survivors.push(format!("{} {}: {}", spec.id, mutant.what, mutant.latex));
            }
        }
    }
    println!("{tried} mutants: {refused} cannot be read, {equivalent} are equivalent");
    assert!(tried >= 500, "only {tried} mutants");
    assert_eq!(equivalent, EQUIVALENT.len(), "a mutant is no longer equivalent");
    assert!(survivors.is_empty(), "{} survive:\n{}", survivors.len(), survivors.join("\n"));
}

/// Value and Jacobian of every equation at every case, on both sides of every kink, and at random points.
#[test]
fn every_equation_is_its_formula() {
    for formula in CATALOG {
        let audit = formula.audit(&Options { samples: 3, seed: 2 });
        for claim in [&audit.equation, &audit.equation_jacobian] {
            assert!(claim.held(), "{}: {claim:#?}", audit.formula);
        }
    }
}

#[test]
fn what_cannot_be_read_is_named_with_its_place() {
    let formula = find("slot.contact_force").unwrap();
    let error = |latex| Equation::read(latex, &[], formula.inputs(), formula.outputs()).unwrap_err().to_string();
    let mut wrong = Vec::new();
    for (latex, expected) in [
        (r"F_C = \sqrt{f_2^2 + f_4^2}", "byte 20: f_4 is nobody's symbol"),
        (r"F_C = \sqrt{f_2^2 + }", "byte 20: a number, a symbol or a bracket was expected here"),
        (r"F_C = \lvert f_2\rvert", "byte 0: the input f_3 is not needed for any output"),
        (r"F_C = f_2 f_3,\quad x = f_2", "byte 20: x is defined and not needed"),
        (r"F_C = f_2 f_3,\quad F_C = f_2", "byte 20: F_C is defined twice"),
        (r"F_C = a f_2 f_3,\quad a = b,\quad b = a", "a is defined by itself"),
        (r"F_C = f_2/f_3 f_2", "byte 14: what follows a slash and its divisor is read in two ways: use a fraction"),
        (r"F_C = f_2 f_3\quad \text{if } f_2 > 0", r"byte 30: an operator, a comma or `\quad` was expected here"),
        (r"F_C = f_2 f_3\quad\text{twice 2}", "byte 18: a remark holds words only, not `2`: mathematics is executed"),
        (r"F_C = f_2 f_3 \pm 1", "byte 14: a number, a symbol or a bracket was expected here"),
        (r"F_C = \mathbf{f}\cdot\mathbf{f} f_2 f_3", "f (a vector) is nobody's symbol"),
    ] {
        let found = error(latex);
        if !found.starts_with("the equation of yours, ") || !found.contains(expected) {
            wrong.push(format!("{latex}: {found}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
