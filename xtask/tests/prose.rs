//! What the chapters claim is executed: a wrong glyph in them fails the check that `verify` runs.

mod common;

use common::Bench;
use jointproof::catalog::CATALOG;
use std::fs;

/// A copy of the chapters, and of what their numbers refer to.
fn bench() -> Bench {
    Bench::with(&["book/src", "tests/isl.rs", "src/verify"])
}

/// Replaces what a chapter says once.
fn mutate(bench: &Bench, chapter: &str, from: &str, to: &str) {
    let path = bench.path(&format!("book/src/{chapter}"));
    let text = fs::read_to_string(&path).unwrap();
    assert_eq!(text.matches(from).count(), 1, "{from} in {chapter}");
    fs::write(path, text.replace(from, to)).unwrap();
}

/// Runs the check as `verify` does: few points of the printed equations, which the audit has.
fn check(bench: &Bench, code: i32) -> common::Ran {
    bench.run(&["equation", "--samples", "0"]).exits(code)
}

#[test]
fn the_chapters_as_they_are_pass() {
    let said = check(&bench(), 0).prints(&format!("{} equations: ", CATALOG.len())).stdout;
    let (before, _) = said.split_once(" views of entries").expect("views are counted");
    let views = before.rsplit(' ').next().and_then(|count| count.parse::<usize>().ok());
    assert!(views.is_some_and(|views| views > CATALOG.len()), "{said}");
}

#[test]
fn a_wrong_derivative_in_prose_is_found() {
    let bench = bench();
    mutate(&bench, "translator.md", r"\sigma\,\frac{2}{L}\,", r"\sigma\,\frac{1}{L}\,");
    check(&bench, 1).prints(r"book/src/translator.md:").prints("comparisons differ, most");
}

#[test]
fn a_wrong_number_in_prose_is_found() {
    let bench = bench();
    mutate(&bench, "translator.md", "{{3.7 = ", "{{3.8 = ");
    mutate(&bench, "slide-line.md", "{{9.15 in ", "{{9.16 in ");
    mutate(&bench, "evidence.md", "{{60 in ", "{{61 in ");
    check(&bench, 1)
        .prints("translator.md:20: 3.8 is not 3.73")
        .prints("`isl::areas_of_nodes_against_their_integrals` has no 9.16 in it")
        .prints("`CLOSED_AGAINST_AD` has no 61 in it");
}

#[test]
fn what_is_not_marked_is_found() {
    let bench = bench();
    mutate(
        &bench,
        "coulomb.md",
        "# Coulomb friction\n",
        "# Coulomb friction\n\nIt is 0.02 % of all.\n\n$$\na = b\n$$\n",
    );
    check(&bench, 1)
        .prints("coulomb.md:3: 0.02 does not say where it is from")
        .prints("coulomb.md:5: this equation is neither executed nor marked");
}
