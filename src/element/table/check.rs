//! What the compiler checks of the tables: every name in them is the name of something, and numbers go to numbers, vectors to vectors.
//!
//! Constants are evaluated while the library is compiled, so that a name that nothing has is an error there.

use super::{Fallback, Kind, Origin, Use, When};
use crate::formula::Field;

/// Whether two names are equal.
const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut k = 0;
    while k < a.len() && k < b.len() && a[k] == b[k] {
        k += 1;
    }
    k == a.len() && k == b.len()
}

/// The field of this name.
const fn find(fields: &'static [Field], name: &str) -> Option<&'static Field> {
    let mut k = 0;
    while k < fields.len() {
        if same(fields[k].name, name) {
            return Some(&fields[k]);
        }
        k += 1;
    }
    None
}

/// Every field that is renamed is one of the formula's.
const fn check_renamed(formula: &Use) {
    let mut k = 0;
    while k < formula.renamed.len() {
        let name = formula.renamed[k].0;
        let is_field = find(formula.inputs, name).is_some() || find(formula.outputs, name).is_some();
        assert!(is_field, "a field is renamed that the formula does not have");
        k += 1;
    }
}

/// The register of a field.
const fn register(formula: &Use, field: &'static str) -> &'static str {
    let mut k = 0;
    while k < formula.renamed.len() {
        if same(formula.renamed[k].0, field) {
            return formula.renamed[k].1;
        }
        k += 1;
    }
    field
}

/// The field that has this register.
const fn in_register(formula: &Use, fields: &'static [Field], name: &str) -> Option<&'static Field> {
    let mut k = 0;
    while k < fields.len() {
        if same(register(formula, fields[k].name), name) {
            return Some(&fields[k]);
        }
        k += 1;
    }
    None
}

/// The field that writes a register, or else, where `reads`, one that reads it.
const fn user(kind: &Kind, name: &str, reads: bool) -> Option<&'static Field> {
    let mut group = 0;
    while group < kind.formulas.len() {
        let mut k = 0;
        while k < kind.formulas[group].len() {
            let formula = &kind.formulas[group][k];
            let fields = if reads { formula.inputs } else { formula.outputs };
            if let Some(field) = in_register(formula, fields, name) {
                return Some(field);
            }
            k += 1;
        }
        group += 1;
    }
    None
}

/// Whether the element is given this.
const fn is_given(kind: &Kind, name: &str) -> bool {
    let mut group = 0;
    while group < kind.given.len() {
        let mut k = 0;
        while k < kind.given[group].len() {
            if same(kind.given[group][k].0, name) {
                return true;
            }
            k += 1;
        }
        group += 1;
    }
    false
}

/// Whether this is a register.
const fn exists(kind: &Kind, name: &str) -> bool {
    is_given(kind, name) || user(kind, name, false).is_some() || user(kind, name, true).is_some()
}

/// What a formula reads is given, or written by a formula as what it is read as; and its condition is on what is given.
const fn check_formula(kind: &Kind, formula: &Use) {
    check_renamed(formula);
    let mut k = 0;
    while k < formula.inputs.len() {
        let field = &formula.inputs[k];
        let name = register(formula, field.name);
        match user(kind, name, false) {
            Some(writer) => assert!(
                writer.quantity.shape as u8 == field.quantity.shape as u8,
                "a formula reads a number as a vector, or a vector as a number"
            ),
            None => assert!(is_given(kind, name), "a formula reads what nothing writes and no element is given"),
        }
        k += 1;
    }
    let names = match formula.when {
        When::Always => &[],
        When::AllZero(names) | When::NotAllZero(names) | When::AllGiven(names) | When::NotAllGiven(names) => names,
    };
    let mut k = 0;
    while k < names.len() {
        assert!(is_given(kind, names[k]), "a formula depends on a parameter that there is not");
        k += 1;
    }
}

/// Where what is given comes from is a register too.
const fn check_given(kind: &Kind, origin: Origin) {
    if let Origin::Initial(of) | Origin::Before(of) | Origin::Parameter(Fallback::As(of)) = origin {
        assert!(exists(kind, of), "an initial or last value is of a register that there is not");
    }
}

/// Every name in the table of a kind is the name of something.
pub(crate) const fn check(kind: &Kind) {
    if kind.given.is_empty() {
        return; // It slides on a line: `isl` evaluates its formulas, and it has no registers.
    }
    let mut group = 0;
    while group < kind.given.len() {
        let mut k = 0;
        while k < kind.given[group].len() {
            check_given(kind, kind.given[group][k].1);
            k += 1;
        }
        group += 1;
    }
    let mut group = 0;
    while group < kind.formulas.len() {
        let mut k = 0;
        while k < kind.formulas[group].len() {
            check_formula(kind, &kind.formulas[group][k]);
            k += 1;
        }
        group += 1;
    }
    let mut group = 0;
    while group < kind.outputs.len() {
        let mut k = 0;
        while k < kind.outputs[group].len() {
            assert!(exists(kind, kind.outputs[group][k].1), "an output shows a register that there is not");
            k += 1;
        }
        group += 1;
    }
    let mut k = 0;
    while k < kind.meanings.len() {
        assert!(exists(kind, kind.meanings[k].0), "a meaning is of a register that there is not");
        k += 1;
    }
    let mut k = 0;
    while k < kind.ordered.len() {
        let (lower, upper) = kind.ordered[k];
        assert!(is_given(kind, lower) && is_given(kind, upper), "bounds are of parameters that there are not");
        k += 1;
    }
}
