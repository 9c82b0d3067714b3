//! The claims of the chapters are executed: a wrong glyph in them fails the check that `verify` runs.

use crate::common::Bench;
use jointproof::catalog::CATALOG;
use jointproof::toolkit::verify::Options;
use std::fs;

/// A copy of the chapters, and of the files that their numbers refer to.
fn bench() -> Bench {
    Bench::with(&["book/src", "tests", "src", "xtask/src"])
}

/// Replaces a text of a chapter that occurs once.
fn mutate(bench: &Bench, chapter: &str, from: &str, to: &str) {
    let path = bench.path(&format!("book/src/{chapter}"));
    let text = fs::read_to_string(&path).unwrap();
    assert_eq!(text.matches(from).count(), 1, "{from} in {chapter}");
    fs::write(path, text.replace(from, to)).unwrap();
}

/// Everything is checked once, as in `verify`: at few points of the printed equations, which are covered by the audit.
#[test]
fn what_is_wrong_in_the_chapters_is_found_and_nothing_else() {
    let bench = bench();
    let planted = [
        // A derivative.
        ("translator.md", r"\sigma\,\frac{2}{L}\,", r"\sigma\,\frac{1}{L}\,"),
        // Numbers: by an expression, in a test, in a constant.
        ("translator.md", "{{3.7 = ", "{{3.8 = "),
        ("slide-line.md", "{{9.15 in ", "{{9.16 in "),
        ("evidence.md", "{{60 in ", "{{61 in "),
        // Unmarked mathematics and numbers.
        ("coulomb.md", "# Coulomb friction\n", "# Coulomb friction\n\nIt is 0.02 % of all.\n\n$$\na = b\n$$\n"),
    ];
    for (chapter, from, to) in planted {
        mutate(&bench, chapter, from, to);
    }
    let chapters = fs::read_dir(bench.path("book/src")).unwrap().map(|entry| entry.unwrap().path());
    let text: String = chapters.filter_map(|path| fs::read_to_string(path).ok()).collect();
    // Unmarked mathematics is not executed either.
    let presented = text.lines().filter(|line| line.starts_with("{{#presentation ")).count() + 1;
    let options = Options { samples: 0, ..Options::default() };
    let claims: Vec<_> = CATALOG.iter().map(|formula| formula.audit_equation(&options)).collect();
    let [values, derivatives] = [0, 1].map(|part| claims.iter().map(|claims| claims[part].checks).sum::<usize>());
    let ran = bench
        .run(&["equation", "--samples", "0"])
        .exits(1)
        .prints("comparisons differ, most")
        .prints("translator.md:22: 3.8 is not 3.73")
        .prints("`isl::areas_of_nodes_against_their_integrals` has no 9.16 in it")
        .prints("`CLOSED_AGAINST_AD` has no 61 in it")
        .prints("coulomb.md:3: 0.02 does not say where it is from")
        .prints("coulomb.md:5: this equation is neither executed nor marked")
        .prints(&format!("{} equations: {values} values and {derivatives} derivatives compared in ", CATALOG.len()))
        .prints(&format!(", {presented} for presentation, "));
    let off = ran.stdout.lines().filter(|line| line.starts_with("off ")).count();
    assert_eq!(off, 6, "{ran:#?}");
    let (before, _) = ran.stdout.split_once(" views of entries").expect("views are counted");
    let views = before.rsplit(' ').next().and_then(|count| count.parse::<usize>().ok());
    assert!(views.is_some_and(|views| views > CATALOG.len()), "{ran:#?}");
}
