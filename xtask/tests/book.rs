//! The real book: whole, complete, and content with no network.

mod common;

use common::Bench;
use jointproof::catalog::CATALOG;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// The book, built once for all tests here, in a folder that only they use.
static BOOK: LazyLock<PathBuf> = LazyLock::new(|| {
    let bench = Bench::new();
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book");
    bench.run(&["book", "--unmeasured", "--out", out.to_str().unwrap()]).exits(0);
    out
});

/// All files below a folder whose names end so.
fn files(folder: &Path, extensions: &[&str]) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, extensions));
        } else if extensions.iter().any(|extension| path.extension().is_some_and(|x| x == *extension)) {
            found.push((path.display().to_string(), fs::read_to_string(&path).unwrap()));
        }
    }
    found
}

/// The pages that chapters became, without the one that holds them all and the listings.
fn chapters() -> impl Iterator<Item = (String, String)> {
    let listings = BOOK.join("source").display().to_string();
    files(&BOOK, &["html"])
        .into_iter()
        .filter(move |(name, _)| !name.starts_with(&listings) && !name.ends_with("print.html"))
}

#[test]
fn every_formula_has_one_anchor_and_its_equation_as_mathml() {
    let pages: Vec<_> = chapters().collect();
    for formula in CATALOG {
        let anchor = format!("<h3 id=\"{}\">", formula.spec().id);
        let entries: Vec<_> = pages.iter().filter_map(|(_, page)| page.split_once(&anchor)).collect();
        // The first chapter is the index too.
        assert_eq!(entries.len(), 1, "{anchor}");
        let entry = entries[0].1.split("</section>").next().unwrap();
        assert!(entry.contains("display=\"block\""), "{} has no equation", formula.spec().id);
        let rows = entry.matches("<tr><td><math").count();
        assert_eq!(rows, formula.inputs().len() + formula.outputs().len(), "symbols of {}", formula.spec().id);
    }
}

#[test]
fn every_formula_has_a_calculator_or_says_why_not() {
    let pages: String = chapters().map(|(_, page)| page).collect();
    for formula in CATALOG {
        let id = formula.spec().id;
        let calculator = format!("<details class=\"calculator\" data-formula=\"{id}\">");
        if formula.graph().is_ok() {
            assert_eq!(pages.matches(&calculator).count(), 1, "{id}");
            let script = fs::read_to_string(BOOK.join(format!("calculator/{id}.js"))).unwrap();
            assert!(script.contains("\nfunction jacobian(i) {\n"), "{script}");
        } else {
            let entry = pages.split(&format!("<h3 id=\"{id}\">")).nth(1).unwrap();
            assert!(entry.split("</section>").next().unwrap().contains("Not exported, hence no calculator: "), "{id}");
        }
    }
}

#[test]
fn no_mathematics_is_left_as_latex() {
    for (name, page) in chapters() {
        let shown = shown(&page);
        for left in ["\\frac", "\\sqrt", "\\mathrm", "\\lvert", "\\begin{", "{{#"] {
            assert!(!shown.contains(left), "{name} shows {left}");
        }
        assert!(!page.contains("MathJax") && !page.contains("katex"), "{name} wants a script for its mathematics");
    }
}

#[test]
fn nothing_is_fetched_from_the_network() {
    for (name, page) in files(&BOOK, &["html", "css", "svg"]) {
        for how in ["src=\"", "href=\"", "action=\"", "data=\"", "url(", "url(\"", "url('", "@import \"", "@import '"] {
            for scheme in ["http:", "https:", "//"] {
                let fetched = format!("{how}{scheme}");
                assert!(!page.contains(&fetched), "{name} has {fetched}");
            }
        }
    }
    // Scripts of calculators name a host only as the namespace of drawings.
    for (name, script) in files(&BOOK.join("calculator"), &["js"]) {
        let script = script.replace("http://www.w3.org/2000/svg", "");
        assert!(!["://", "fetch(", "import("].iter().any(|how| script.contains(how)), "{name}");
    }
    // The script that runs Rust code in a playground is mdBook's own; nothing here may call it.
    for (name, page) in chapters() {
        assert!(!page.contains("class=\"playground\""), "{name} has code that is run elsewhere");
    }
}

#[test]
fn a_folder_that_holds_something_else_is_not_replaced() {
    let bench = Bench::new();
    fs::create_dir(bench.path("letters")).unwrap();
    fs::write(bench.path("letters/dear.txt"), "Dear").unwrap();
    let out = bench.path("letters");
    bench
        .run(&["book", "--unmeasured", "--out", out.to_str().unwrap()])
        .exits(1)
        .says("holds something else than a book");
    assert_eq!(fs::read_to_string(bench.path("letters/dear.txt")).unwrap(), "Dear");
    assert_eq!(bench.files("letters").len(), 1);
}

/// What a reader sees of a page, without code.
fn shown(page: &str) -> String {
    let mut shown = String::new();
    let mut rest = page;
    while let Some((text, tag)) = rest.split_once('<') {
        shown += text;
        let hidden = ["code", "script", "style"].iter().find(|name| tag.starts_with(**name));
        let end = hidden.map_or(">".into(), |name| format!("</{name}>"));
        rest = tag.split_once(&end).map_or("", |(_, rest)| rest);
    }
    shown + rest
}
