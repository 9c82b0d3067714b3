//! Complete small books: what they contain, what makes them fail, and what a failed build leaves behind.

use std::fs;
use std::path::Path;

use super::build::{Options, build};
use super::content::{CodeSpan, Content, Entry, GoldenFile, SourceFile, Symbol};
use super::fault::Faults;
use super::output::write;
use crate::extension::{Extras, Fact};

mod printed;

/// Two formulas, one of them with code.
fn content() -> Content {
    let symbol = |name: &str, latex: &str| Symbol {
        name: name.into(),
        latex: latex.into(),
        unit: "F".into(),
        ..Symbol::default()
    };
    let entry = |id: &str, latex: &str| Entry {
        id: id.into(),
        title: format!("Title of {id}"),
        latex: latex.into(),
        inputs: vec![symbol("f2", "f_2")],
        outputs: vec![symbol("fc", "F_C")],
        ..Entry::default()
    };
    let mut first = entry("t.first", r"F_C = \lvert f_2 \rvert");
    first.code = vec![CodeSpan { name: "eval".into(), file: "src/t.rs".into(), first: 2, last: 4 }];
    let text = "//! Room.\nfn eval() {\n\n    unusual_word < 1\n}\n".to_owned();
    Content {
        entries: vec![first, entry("t.second", "P = f_1")],
        sources: vec![SourceFile { path: "src/t.rs".into(), text }],
        golden: vec![GoldenFile { name: "t.first.json".into(), bytes: b"{}".to_vec() }],
        extras: Extras {
            texts: vec![("note".into(), "## Noted\n\n| a |\n|---|\n| `t.first`, $z$ |\n".into())],
            facts: vec![Fact {
                formula: "t.first".into(),
                name: "Said".into(),
                lines: vec!["see [the `file`](golden/t.first.json), $w$".into()],
            }],
            ..Extras::default()
        },
        ..Content::default()
    }
}

/// Writes a book of one chapter and builds it.
fn book(root: &Path, chapter: &str) -> anyhow::Result<()> {
    book_of(root, chapter, content())
}

/// The same with other content.
fn book_of(root: &Path, chapter: &str, content: Content) -> anyhow::Result<()> {
    let file = |path: &str, text: &str| write(&root.join("book").join(path), text.as_bytes()).unwrap();
    file("book.toml", "[book]\ntitle = \"T\"\n");
    file("src/SUMMARY.md", "# Summary\n\n- [One](one.md)\n");
    file("src/one.md", chapter);
    file("figures/plain.svg", "<svg viewBox=\"0 0 1 1\"><title>Plain</title><path d=\"M0 0\"/></svg>\n");
    build(root, &Options::default(), content).map(|_| ())
}

/// The page of the chapter.
fn page(root: &Path) -> String {
    fs::read_to_string(root.join("target/book/one.html")).unwrap()
}

/// The faults of a book with one chapter.
fn faults(chapter: &str) -> Vec<String> {
    let root = tempfile::tempdir().unwrap();
    let error = book(root.path(), chapter).unwrap_err();
    let faults = error.downcast_ref::<Faults>().unwrap_or_else(|| panic!("{error:?}"));
    faults.0.iter().map(ToString::to_string).collect()
}

const GOOD: &str = "# One\n\n{{#formula t.first}}\n\n{{#formula t.second}}\n\n";

#[test]
fn a_good_book_has_anchors_mathematics_code_and_golden_files() {
    let root = tempfile::tempdir().unwrap();
    book(root.path(), &format!("{GOOD}See `t.first` and $x^2$.\n\n{{{{#figure plain A $y$}}}}\n\n{{{{#symbols}}}}\n"))
        .unwrap();
    let page = page(root.path());
    for expected in [
        "<h3 id=\"t.first\"><a class=\"header\" href=\"#t.first\">",
        "role=\"math\" aria-label=\"F_C = \\lvert f_2 \\rvert\"><span class=\"line\"><span class=\"left\"><math",
        "href=\"source/src/t.rs.html#L2\"",
        "unusual_word &lt; <i class=\"rn\">1</i>",
        "See <a href=\"#t.first\"><code>t.first</code></a> and <math alttext=\"x^2\">",
        "viewBox=\"0 0 1 1\"",
        "<figcaption>A <math",
        "<a href=\"#t.second\"><code>t.second</code></a>",
    ] {
        assert!(page.contains(expected), "{expected} is not in\n{page}");
    }
    assert!(!page.contains("data-later") && !page.contains("{{#"));
    assert_eq!(fs::read(root.path().join("target/book/golden/t.first.json")).unwrap(), b"{}");
}

#[test]
fn texts_are_read_as_if_they_stood_in_the_chapter() {
    let root = tempfile::tempdir().unwrap();
    book(root.path(), &format!("{GOOD}{{{{#text note}}}}\n\nAfter it.\n")).unwrap();
    let page = page(root.path());
    for expected in
        ["id=\"noted\"", "<td><a href=\"#t.first\"><code>t.first</code></a>, <math alttext=\"z\">", "After it."]
    {
        assert!(page.contains(expected), "{expected} is not in\n{page}");
    }
    assert_eq!(faults(&format!("{GOOD}{{{{#text no}}}}\n")), ["book/src/one.md:7: no text `no`; there are: note"]);
}

#[test]
fn facts_of_the_project_stand_on_the_entry_with_their_links() {
    let root = tempfile::tempdir().unwrap();
    book(root.path(), GOOD).unwrap();
    let fact = "see <a href=\"golden/t.first.json\">the <code>file</code></a>, <math alttext=\"w\">";
    assert_eq!(page(root.path()).matches(fact).count(), 1);
}

#[test]
fn search_sees_words_but_neither_code_nor_listings() {
    let root = tempfile::tempdir().unwrap();
    book(root.path(), GOOD).unwrap();
    let index = fs::read_to_string(root.path().join("target/book/searchindex.js")).unwrap();
    assert!(index.contains("t.second") && !index.contains("unusual"));
    assert!(index.contains("\"index\":{\"pages\":[["), "{index}");
    let listing = fs::read_to_string(root.path().join("target/book/source/src/t.rs.html")).unwrap();
    assert!(listing.contains("id=\"L4\"") && listing.contains("unusual_word"));
}

#[test]
fn every_fault_is_named_at_once_with_chapter_and_line() {
    let chapter = "# One\n\n{{#formula t.first}}\n\n{{#formula t.frist}}\n\n{{#formula t.first}}\n\n{{#nonsense}}\n\n\
                   {{#figure nothing}}\n\n{{#table none}}\n\n{{#output none}}\n\nBad $\\frac a$ here.\n\nCosts $ 5 {\n";
    let faults = faults(chapter);
    let expected = [
        "book/src: formula `t.second` is in the catalog but in no chapter; add `{{#formula t.second}}`",
        "book/src/one.md:5: no formula `t.frist` in the catalog; did you mean `t.first`?",
        "book/src/one.md:7: formula `t.first` has its entry already, at book/src/one.md:3",
        "book/src/one.md:9: unknown directive `{{#nonsense}}`",
        "book/src/one.md:11: no figure `nothing`; there are: plain",
        "book/src/one.md:13: no table `none`; there are: ",
        "book/src/one.md:15: no output `none`; there are: ",
        "book/src/one.md:17: cannot set the formula `\\frac a`",
        "book/src/one.md:19: no formula is closed in `$ 5 {`",
    ];
    assert_eq!(faults.len(), expected.len(), "{faults:#?}");
    for (fault, expected) in faults.iter().zip(expected) {
        assert!(fault.starts_with(expected), "{fault}");
    }
}

#[test]
fn dead_links_fail_the_build() {
    assert_eq!(
        faults(&format!("{GOOD}[x](two.md)\n")),
        [
            "index.html: the link `two.html` names no file of the book",
            "one.html: the link `two.html` names no file of the book",
        ]
    );
}

#[test]
fn code_shows_directives_and_dollars_as_they_are() {
    let root = tempfile::tempdir().unwrap();
    book(
        root.path(),
        &format!("{GOOD}Write `{{{{#formula x}}}}`, ``a`b`` or `$x$`.\n\n```text\n{{{{#formula x}}}}\n$x$\n```\n"),
    )
    .unwrap();
    let page = page(root.path());
    assert_eq!(page.matches("{{#formula x}}").count(), 2);
    assert!(page.contains("<code>a`b</code>") && page.contains("<code>$x$</code>"));
}

#[test]
fn a_failed_build_leaves_the_last_good_book_and_nothing_else() {
    let root = tempfile::tempdir().unwrap();
    book(root.path(), GOOD).unwrap();
    let before = page(root.path());
    book(root.path(), "# Nothing\n").unwrap_err();
    assert_eq!(page(root.path()), before);
    let left: Vec<_> = fs::read_dir(root.path().join("target")).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(left, ["book"]);
}

#[test]
fn files_can_be_included() {
    let root = tempfile::tempdir().unwrap();
    write(&root.path().join("tools/read.py"), b"price = '$5'\n").unwrap();
    book(root.path(), &format!("{GOOD}```python\n{{{{#include ../../tools/read.py}}}}\n```\n")).unwrap();
    assert!(page(root.path()).contains("price = '$5'"));
}

#[test]
fn a_chapter_that_is_not_there_is_not_made_up() {
    let root = tempfile::tempdir().unwrap();
    book(root.path(), GOOD).unwrap();
    let summary = |text: &str| write(&root.path().join("book/src/SUMMARY.md"), text.as_bytes()).unwrap();
    let build = || build(root.path(), &Options::default(), content());
    summary("# Summary\n\n- [One](one.md)\n- [Two](two.md)\n");
    let error = format!("{:#}", build().unwrap_err());
    assert!(error.contains("two.md"), "{error}");
    assert!(!root.path().join("book/src/two.md").exists());
    // Chapters keep their names.
    write(&root.path().join("book/src/README.md"), b"# Read\n").unwrap();
    summary("# Summary\n\n- [One](one.md)\n- [Read](README.md)\n");
    let built = build().unwrap();
    assert_eq!((built.chapters, built.formulas, built.listings), (2, 2, 1));
    assert!(root.path().join("target/book/README.html").is_file());
}

#[cfg(unix)]
#[test]
fn old_leftovers_of_builds_are_removed_and_nothing_else() {
    use std::time::{Duration, SystemTime};
    let root = tempfile::tempdir().unwrap();
    let beside = |name: &str| root.path().join("target").join(name);
    let made = |name: &str, age: Duration| {
        fs::create_dir_all(beside(name)).unwrap();
        fs::File::open(beside(name)).unwrap().set_modified(SystemTime::now() - age).unwrap();
    };
    made("book.partial-1", Duration::from_hours(1));
    made("book.partial-2", Duration::ZERO);
    made("letters", Duration::from_hours(1));
    book(root.path(), GOOD).unwrap();
    let are_there = ["book.partial-1", "book.partial-2", "letters", "book"].map(|name| beside(name).is_dir());
    assert_eq!(are_there, [false, true, true, true]);
}
