//! The contents of entries and generated tables for made-up data in which no two numbers are the same.

use super::*;
use crate::book::content::{Evidence, GoldenCounts, Kink, Source, TestRef, Worked};
use crate::extension::Served;
use crate::sample;
use expect_test::expect_file;

/// The chapters are one page with everything that is generated.
const ALL: &str = "# One\n\n{{#formula t.first}}\n\n{{#formula t.second}}\n\n{{#formula u.second}}\n\n## Symbols\n\n\
                   {{#symbols}}\n\n## Kinks\n\n{{#kinks}}\n\n## Evidence\n\n{{#evidence}}\n\n## Sources\n\n{{#sources}}\n\n## Accuracy\n\n{{#accuracy}}\n\n\
                   ## Speed\n\n{{#speed about}}\n\n{{#speed verdict}}\n\n{{#speed table}}\n\n{{#speed differences}}\n\n\
                   {{#speed own}}\n\n{{#speed own t}}\n";

fn text(text: &str) -> String {
    text.into()
}

fn symbol(name: &str, latex: &str, shape: &str, unit: &str, allowed: &str) -> Symbol {
    let [shape, unit, allowed] = [shape, unit, allowed].map(text);
    Symbol { name: text(name), latex: text(latex), shape, unit, allowed, meaning: format!("meaning of {name}") }
}

/// An entry in which every part is present and named after itself.
fn entry(id: &str, evidence: Evidence) -> Entry {
    let source = |place: &str| Source {
        title: format!("Document of {}", &id[..1]),
        link: "https://example.org/document".into(),
        place: text(place),
        provenance: format!("provenance of {id}"),
    };
    Entry {
        id: text(id),
        title: format!("Title of {id}"),
        latex: "F_C = f_2".into(),
        given: "where $f_2$ from `t.first`".into(),
        variation: vec![r"\delta F_C = \delta f_2".into()],
        closed: vec!["F_C = 3".into()],
        source: source("section “Place”"),
        inputs: vec![
            symbol("f2", "f_2", "scalar", "F", "a finite number ≥ 0"),
            symbol("n", r"\mathbf{n}", "vec3", "1", ""),
        ],
        outputs: vec![symbol("fc", "F_C", "scalar", "FL", "")],
        accuracy: format!("accuracy of {id}"),
        not_proved: vec![format!("why of {id}")],
        evidence,
        ..Entry::default()
    }
}

fn everything() -> Content {
    let golden = |total, hand| GoldenCounts {
        file: "t.first.json".into(),
        total,
        flags: vec![("hand".into(), hand), ("random".into(), total - hand)],
    };
    let mut first = entry("t.first", Evidence { golden_cases: Some(41), audit: Some(sample::passed()) });
    first.given = String::new();
    first.digest = Some("0123abcd".into());
    first.kinks = vec![Kink {
        at: "$f_2 = 0$".into(),
        derivative: r"$\partial F_C/\partial f_2$".into(),
        left: "−0.25".into(),
        right: "0.75".into(),
        convention: "0 is returned".into(),
    }];
    first.worked = Some(Worked {
        case: "three-four".into(),
        inputs: vec!["$f_2 = 3$".into()],
        outputs: vec!["$F_C = 5$".into()],
        derivatives: vec![r"$\partial F_C/\partial f_2 = 0.6$".into()],
    });
    first.golden = Some(golden(43, 7));
    first.code = vec![CodeSpan { name: "eval".into(), file: "src/t.rs".into(), first: 2, last: 4 }];
    first.tests = vec![TestRef { name: "it_is_tested".into(), file: "src/t.rs".into(), line: 3 }];
    let mut second = entry("t.second", Evidence { golden_cases: None, audit: Some(sample::failed()) });
    second.uses = vec!["t.first".into()];
    second.golden = Some(GoldenCounts { file: "t.second.json".into(), ..golden(53, 9) });
    let third = entry("u.second", Evidence::default());
    let lines = "//! Room.\nfn eval() {\n\n    1\n}\n".to_owned();
    let mut content = Content { entries: vec![first, second, third], ..content() };
    content.sources = vec![SourceFile { path: "src/t.rs".into(), text: lines }];
    content.golden.push(GoldenFile { name: "t.second.json".into(), bytes: b"{}".to_vec() });
    content.catalog_tests = vec![TestRef { name: "over_all".into(), file: "src/t.rs".into(), line: 4 }];
    content.extras.served = vec![Served {
        formula: "t.first".into(),
        output: "CSF".into(),
        of: "a scene".into(),
        place: "one.html".into(),
    }];
    content.report = Some(sample::report());
    content.is_current = true;
    content
}

/// A page as text: one line per row, item or paragraph, with cells separated, formulas as LaTeX, and drawings omitted.
fn in_words(page: &str) -> String {
    let main = page.split("<main>").nth(1).and_then(|rest| rest.split("</main>").next()).unwrap();
    let mut text = String::new();
    let mut rest = main;
    while let Some((before, tag)) = rest.split_once('<') {
        text += before;
        let (tag, mut after) = tag.split_once('>').unwrap();
        let name = tag.split(' ').next().unwrap();
        if let Some((_, latex)) = tag.split_once("alttext=\"") {
            text = [&text, "$", latex.split('"').next().unwrap(), "$"].concat();
        }
        if tag.contains("class=\"math-block\"") {
            // Its pieces and its number are not repeated.
            let (_, latex) = tag.split_once("aria-label=\"").unwrap();
            text = [&text, "$", latex.split('"').next().unwrap(), "$"].concat();
            after = after.split_once("</a>").unwrap().1;
        }
        if let "math" | "svg" | "script" | "style" = name {
            after = after.split_once(&format!("</{name}>")).unwrap().1;
        }
        text += match name {
            "/td" | "/th" | "/span" => " | ",
            "/tr" | "/p" | "/li" | "/dt" | "/dd" | "/summary" | "/h1" | "/h2" | "/h3" | "/pre" | "/table" => "\n",
            _ if name.starts_with('b') && tag.contains("missing") => "(!) ",
            _ => "",
        };
        rest = after;
    }
    let decoded = text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&#10;", "\n");
    let lines = decoded.replace("&#123;", "{").replace("&amp;", "&");
    let trimmed = lines.lines().map(|line| line.trim().trim_end_matches(" |").trim_end());
    trimmed.filter(|line| !line.is_empty()).flat_map(|line| [line, "\n"]).collect()
}

#[test]
fn entries_and_tables_show_the_data_that_they_are_made_from() {
    let root = tempfile::tempdir().unwrap();
    book_of(root.path(), ALL, everything()).unwrap();
    let page = page(root.path());
    expect_file!["../../../tests/printed/book.txt"].assert_eq(&in_words(&page));
}

/// For evidence of another version of the code, and for no evidence.
#[test]
fn what_is_not_of_this_version_is_said_to_be_so() {
    let root = tempfile::tempdir().unwrap();
    let mut content = everything();
    content.is_current = false;
    book_of(root.path(), ALL, content).unwrap();
    assert!(page(root.path()).contains("<b>another version</b>"));
    let mut content = everything();
    content.report = None;
    for entry in &mut content.entries {
        entry.evidence = Evidence::default();
    }
    book_of(root.path(), ALL, content).unwrap();
    let words = in_words(&page(root.path()));
    assert_eq!(words.matches("Not measured; run the command report.").count(), 6, "{words}");
    for nothing in [" of 2 laws", "1.25", "random 103", "× "] {
        assert!(!words.contains(nothing), "{nothing} is in\n{words}");
    }
}
