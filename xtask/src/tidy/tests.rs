//! Each rule finds what is planted, and nothing in a tidy tree.

use super::*;
use crate::console::plain;
use std::fs;
use tempfile::TempDir;

const IDS: [&str; 1] = ["a.one"];

/// A tidy family module with one formula and its evidence.
const TIDY: [(&str, &str); 9] = [
    ("Cargo.toml", "[workspace]\nmembers = [\"tool\"]\n[package]\nname = \"lib-a\"\n"),
    (
        "src/lib.rs",
        "//! Doc.\npub mod formula;\npub mod a;\n#[cfg(feature = \"verify\")]\npub mod toolkit;\npub use a::One;\n",
    ),
    (
        "src/formula.rs",
        "pub trait Formula {}\n#[macro_export]\nmacro_rules! fields { () => { crate::toolkit::law() } }\n",
    ),
    ("src/a.rs", "//! `crate::toolkit::law`\nmod one;\n#[cfg(feature = \"verify\")]\nmod proof;\npub use one::*;\n"),
    (
        "src/a/one.rs",
        "use crate::fields;\nuse crate::formula::Formula;\npub struct One;\nfields! {}\nimpl Formula for One {\n    const SPEC: Spec = \
         Spec { id: \"a.one\" };\n    #[inline]\n    fn eval() {}\n    #[inline(always)]\n    fn jacobian() {}\n    fn laws() {}\n}\n\
         #[cfg(test)]\nmod tests {\n    use crate::toolkit::law;\n    fn f() { law(\"a.one\") }\n}\n",
    ),
    ("src/a/proof.rs", "use super::One;\nuse crate::toolkit::law;\n"),
    ("src/toolkit.rs", "use crate::formula::Formula;\npub fn law() {}\n"),
    ("tool/src/main.rs", "fn main() { let _: (lib_a::One, &str) = (todo!(), \"b.txt\"); }\n"),
    ("book/src/a.md", "# A\n\n{{#formula a.one}}\n\n`{{#formula a.two}}`\n"),
];

/// The tree, with some files replaced or added.
fn planted(files: &[(&str, &str)]) -> TempDir {
    let root = tempfile::tempdir().unwrap();
    let manifest = ("tool/Cargo.toml", "[package]\nname = \"tool\"\n");
    for (path, text) in TIDY.iter().chain([&manifest]).chain(files) {
        let path = root.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    if !root.path().join("ARCHITECTURE.md").exists() {
        let entries = fs::read_dir(root.path().join("src")).unwrap().map(|entry| entry.unwrap().path());
        let names = entries.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned());
        let mut names: Vec<_> = names.filter(|name| name != "lib").collect();
        // Families stand above what is common to them.
        names.sort_by_key(|name| (name != "formula", name != "toolkit", name.clone()));
        names.dedup();
        let rows = names.iter().map(|name| format!("| `{name}` | what it is |\n")).collect::<Vec<_>>().concat();
        fs::write(root.path().join("ARCHITECTURE.md"), format!("# Folders of `src`\n\n{rows}\n# Crates\n\n`tool`\n"))
            .unwrap();
    }
    root
}

/// The findings with these files.
fn found(files: &[(&str, &str)]) -> Vec<String> {
    found_by(&[], files)
}

/// Those of these rules; of all if there are none.
fn found_by(rules: &[Rule], files: &[(&str, &str)]) -> Vec<String> {
    let tidiness = check(planted(files).path(), &IDS, rules).unwrap();
    tidiness.findings.iter().map(ToString::to_string).collect()
}

/// Every use between files, with the text there.
fn uses(files: &[(&str, &str)]) -> Vec<String> {
    let root = planted(files);
    let tree = Tree::read(root.path()).unwrap();
    let shown = |(&(from, to), place): (&(usize, usize), &edges::Place)| {
        format!("{} → {}: {}", tree.sources[from].path, tree.sources[to].path, place.text)
    };
    edges::edges(&tree).iter().map(shown).collect()
}

/// Asserts that there is one finding, which contains all these parts.
#[track_caller]
fn one(files: &[(&str, &str)], parts: &[&str]) {
    says(&found(files), parts);
}

/// The only circle, which says all of this.
fn one_circle(files: &[(&str, &str)], parts: &[&str]) {
    says(&found_by(&[Rule::Circles], files), parts);
}

fn says(found: &[String], parts: &[&str]) {
    assert_eq!(found.len(), 1, "{found:#?}");
    for part in parts {
        assert!(found[0].contains(part), "{part:?} is not in\n{}", found[0]);
    }
}

/// The formula's file, with this inserted before its last line.
fn one_rs(more: &str) -> String {
    TIDY[4].1.replace("fn laws() {}", &format!("fn laws() {{}}\n{more}"))
}

#[test]
fn what_the_papers_say_is_there() {
    let page = |rows: &'static str| [("ARCHITECTURE.md", rows)];
    let rows = "# Folders of `src`\n\n| `formula` |\n| `toolkit` |\n| `a` |\n\n# Crates\n\n`tool` [a](src/a.rs#x) [b](https://b.c)\n";
    assert_eq!(found(&page(rows)), Vec::<String>::new());
    let wrong = "# Folders of `src`\n\n| `formula` |\n| `a` |\n| `scene` |\n\n# Crates\n\n[a](src/b.rs)\n";
    assert_eq!(
        found(&page(wrong)),
        [
            "ARCHITECTURE.md: the crate `tool` is not named; say what it is for",
            "ARCHITECTURE.md: the table of folders has a row for `scene`, which is not in src",
            "ARCHITECTURE.md: the table of folders has no row for `toolkit` of src; add one at its place",
            "ARCHITECTURE.md:9: the link leads to src/b.rs, which is not there",
        ]
    );
    let upside_down = "# Folders of `src`\n\n| `toolkit` |\n| `formula` |\n| `a` |\n\n`tool`\n";
    one(
        &page(upside_down),
        &["src/toolkit.rs:1: `use crate::formula::Formula`: ARCHITECTURE.md has `toolkit` below `formula`"],
    );
}

#[test]
fn a_tree_as_it_should_be_is_clean() {
    let tidiness = check(planted(&[]).path(), &IDS, &[]).unwrap();
    assert_eq!(tidiness.findings, []);
    // The formula, its evidence, verify and the tool use something; `a.rs` and `lib.rs` only re-export it.
    assert_eq!(
        tidiness.counts,
        "7 files, 5 uses, 0 circles of files, 0 with folders; 1 file with formulas, median 17 lines"
    );
}

#[test]
fn what_is_printed_is_every_finding_and_the_verdict() {
    let printed = |rules: &[Rule]| {
        let root = planted(&[("tool/src/main.rs", "fn main() {\n    f(\"a.one\", \"a.on3\");\n}\n")]);
        plain(&check(root.path(), &IDS, rules).unwrap().text())
    };
    let counts = "7 files, 4 uses, 0 circles of files, 0 with folders; 1 file with formulas, median 17 lines";
    assert_eq!(printed(&[Rule::Lengths]), format!("ok  tidy: 0 findings; {counts}"));
    let found = "tool/src/main.rs:2: the identifier \"a.on3\" is typed; no formula is called so; take the id of one from its `SPEC`\n\
                 tool/src/main.rs:2: the identifier \"a.one\" is typed; write `One::SPEC.id`\n\
                 off tidy: 2 findings; ";
    assert_eq!(printed(&[]), format!("{found}{counts}"));
}

#[test]
fn a_circle_between_files_is_named_with_a_place_for_each_use() {
    one_circle(
        &[
            ("src/lib.rs", "pub mod x;\npub mod y;\n"),
            ("src/x.rs", "use crate::{\n    y::{self, Y as Z},\n};\npub struct X;\n"),
            ("src/y.rs", "pub struct Y;\nfn f() -> super::x::X { super::x::X }\n"),
            ("book/src/a.md", "{{#formula a.one}}"),
        ],
        &[
            "src/x.rs:2: 2 files use one another: src/x.rs, src/y.rs;",
            "circle of 2: src/x.rs → src/y.rs → src/x.rs",
            "src/x.rs:2: use crate::y::Y as Z",
            "src/y.rs:2: super::x::X",
        ],
    );
}

#[test]
fn a_circle_is_found_through_re_exports_globs_macros_and_functions() {
    let x = "pub struct X;\n#[macro_export]\nmacro_rules! make { () => {} }\n";
    for (uses_x, uses_y) in [
        ("use crate::Renamed;", "use crate::X;"),
        ("fn f() { vec![crate::all::Y] }", "use super::*;\nfn f(x: X) {}"),
        ("fn f() {\n    use super::all::*;\n    let _ = Y {};\n}", "crate::make!();"),
        ("fn f() {\n    use super::all::*;\n    go()\n}", "pub fn go() {}\nuse crate::X;"),
        ("use lib_a::y;\nfn f() { g::<y::Y>() }", "use crate::make;\nmake! {}"),
        ("use self::super::y::Y as _;", "fn f() -> <crate::X as Clone>::T {}"),
        ("fn f() { m!(#crate::all::Y) }", "fn f() { m!(#(crate::X)) }"),
    ] {
        let lib = "mod x;\nmod y;\nmod all { pub(crate) use super::y::*; }\npub use x::X;\npub use y::Y as Renamed;\n";
        let x = format!("{x}{uses_x}\n");
        let y = format!("pub struct Y;\n{uses_y}\n");
        one_circle(
            &[("src/lib.rs", lib), ("src/x.rs", &x), ("src/y.rs", &y)],
            &["circle of 2: src/x.rs → src/y.rs → src/x.rs"],
        );
    }
}

#[test]
fn a_library_is_known_by_its_own_name() {
    let manifest = format!("{}[lib]\nname = \"other\"\n", TIDY[0].1);
    one_circle(
        &[
            ("Cargo.toml", &manifest),
            ("src/lib.rs", "mod x;\nmod y;\n"),
            ("src/x.rs", "use other::y::Y;\npub struct X;\n"),
            ("src/y.rs", "use super::x::X as _;\npub struct Y;\n"),
        ],
        &["src/x.rs:1: use other::y::Y", "src/y.rs:1: use super::x::X as _"],
    );
}

#[test]
fn a_file_that_uses_what_it_re_exports_is_in_a_circle_and_one_that_passes_it_on_is_not() {
    let tree = |p: &str| {
        let c = ("src/p/c.rs", "use super::P;\npub struct C(P);\n");
        found_by(
            &[Rule::Circles],
            &[("src/lib.rs", "mod p;\n"), ("src/p.rs", &format!("mod c;\npub use c::C;\npub struct P;\n{p}\n")), c],
        )
    };
    assert_eq!(tree(""), Vec::<String>::new());
    let found = tree("fn f(c: C) {}");
    assert_eq!(found.len(), 1, "{found:#?}");
    assert!(found[0].contains("src/p.rs:4: C\n") && found[0].contains("src/p/c.rs:1: use super::P"), "{found:#?}");
}

#[test]
fn names_that_are_no_uses_make_no_circle() {
    let lib = "mod x;\nmod y;\npub use x::*;\npub use y::{Y, go};\n";
    let y = "pub struct Y;\npub fn go() {}\n/// [`X`](crate::X)\n#[doc = \"crate::X\"]\nfn f(go: f64) -> f64 { go.x(go) }\n\
             macro_rules! m { () => { crate::X } }\n#[cfg(all(test, unix))]\nuse crate::X;\nimpl Y { #[test] fn t() { crate::X } }\n\
             fn g() { #![rule(crate::X)] #[rule(crate::X)] let one = 1; }\n\
             use super::*;\nfn h(run: f64) -> [f64; 1] { let f = |run| run; f(run); [run] }\n";
    assert_eq!(
        found_by(
            &[Rule::Circles],
            &[("src/lib.rs", lib), ("src/x.rs", "use super::Y;\npub struct X;\npub fn run() {}\n"), ("src/y.rs", y)]
        ),
        Vec::<String>::new()
    );
}

#[test]
fn a_circle_between_folders_is_found_where_no_file_is_in_one() {
    let files = [
        ("src/lib.rs", "mod p;\nmod q;\n"),
        ("src/p.rs", "mod low;\nmod high;\n"),
        ("src/p/low.rs", "pub struct Low;\n"),
        ("src/p/high.rs", "use crate::q::Q;\n"),
        ("src/q/mod.rs", "use crate::p::low::Low;\npub struct Q(Low);\n"),
    ];
    one_circle(&files, &["2 folders or files use one another: src/p/, src/q/;", "src/p/high.rs:1: use crate::q::Q"]);
    // The same within a folder, between its parent file and a folder in it.
    let inner = [
        ("src/lib.rs", "mod p;\n"),
        ("src/p.rs", "mod c;\npub struct P;\nfn f() { c::low::g() }\n"),
        ("src/p/c/mod.rs", "pub mod low;\nmod high;\n"),
        ("src/p/c/low.rs", "pub fn g() {}\n"),
        ("src/p/c/high.rs", "use crate::p::P;\n"),
    ];
    one_circle(&inner, &["2 folders or files use one another: src/p.rs, src/p/c/;"]);
}

#[test]
fn circles_of_files_and_of_folders_are_counted_each() {
    let files = [
        ("src/lib.rs", "mod x;\nmod y;\nmod p;\nmod q;\n"),
        ("src/x.rs", "use crate::y::Y;\npub struct X;\n"),
        ("src/y.rs", "use crate::x::X;\npub struct Y;\n"),
        ("src/p.rs", "pub mod low;\nmod high;\n"),
        ("src/p/low.rs", "pub struct Low;\n"),
        ("src/p/high.rs", "use crate::q::Q;\n"),
        ("src/q/mod.rs", "use crate::p::low::Low;\npub struct Q(Low);\n"),
    ];
    let tidiness = check(planted(&files).path(), &IDS, &[Rule::Circles]).unwrap();
    assert!(tidiness.counts.contains(", 4 uses, 1 circle of files, 1 with folders; "), "{}", tidiness.counts);
    assert_eq!(tidiness.findings.len(), 2);
}

#[test]
fn a_name_leads_to_the_file_that_defines_it() {
    let main = ("tool/src/main.rs", "fn main() {}\n");
    let all = |files: &[(&str, &str)]| uses(&[&[main], files].concat());
    // A function and a module with the same name: the one with items is the module.
    let twice = [
        ("src/lib.rs", "mod x;\nmod y;\n"),
        ("src/x.rs", "fn f() { crate::y::go() }\nuse crate::y::go::Z;\n"),
        ("src/y.rs", "pub mod go;\npub fn go() {}\n"),
        ("src/y/go.rs", "pub struct Z;\n"),
    ];
    assert_eq!(all(&twice), ["src/x.rs → src/y.rs: crate::y::go", "src/x.rs → src/y/go.rs: use crate::y::go::Z"]);
    // Items of a type are defined where the type is.
    let within = [
        ("src/lib.rs", "mod x;\nmod y;\n"),
        ("src/x.rs", "fn f() { crate::y::Y::new() }\n"),
        ("src/y.rs", "pub struct Y;\n"),
    ];
    assert_eq!(all(&within), ["src/x.rs → src/y.rs: crate::y::Y::new"]);
    // One glob may be followed for each segment of a path.
    let again = [
        ("src/lib.rs", "mod inner;\nmod x;\npub use inner::*;\n"),
        ("src/inner.rs", "pub mod a;\npub struct T;\n"),
        ("src/inner/a.rs", "pub use crate::*;\n"),
        ("src/x.rs", "use crate::a::T;\n"),
    ];
    assert_eq!(all(&again), ["src/x.rs → src/inner.rs: use crate::a::T"]);
    // Globs that import each other terminate, and undefined names lead nowhere.
    let round =
        [("src/lib.rs", "mod x;\npub use x::*;\n"), ("src/x.rs", "use super::*;\nfn f() { Nowhere::new(Nothing) }\n")];
    assert_eq!(all(&round), [""; 0]);
}

#[test]
fn formulas_and_rooms_do_not_use_the_toolkit() {
    let formula = one_rs("fn more() { crate::toolkit::law() }");
    one(&[("src/a/one.rs", &formula)], &["src/a/one.rs:12: `crate::toolkit::law`: a file of formulas"]);
    let specification = TIDY[4].1.replace("id: \"a.one\"", "id: \"a.one\", of: crate::toolkit::law()");
    one(&[("src/a/one.rs", &specification)], &["`crate::toolkit::law`: a file of formulas"]);
    let ungated = "mod one;\nmod proof;\npub use one::*;\n";
    one(
        &[("src/a.rs", ungated)],
        &["src/a/proof.rs:2: `use crate::toolkit::law`: formulas and connectors compile without"],
    );
    let proving = "use super::One;\nuse crate::toolkit::law;\nimpl Proved for One {}\n";
    assert_eq!(found(&[("src/a.rs", ungated), ("src/a/proof.rs", proving)]), Vec::<String>::new());
    let verify = "use crate::One;\npub fn law() {}\n";
    let unproved = "pub mod formula;\npub mod a;\npub mod toolkit;\npub use a::One;\n";
    one(
        &[("src/toolkit.rs", verify), ("src/lib.rs", unproved), ("src/a.rs", "mod one;\npub use one::*;\n")],
        &["src/toolkit.rs:1: `use crate::One`: ARCHITECTURE.md has `toolkit` below `a`"],
    );
}

#[test]
fn a_typed_identifier_fails_with_what_to_write() {
    let main = |id: &str| format!("fn main() {{\n    println!(\"{{}}\", \"{id}\");\n}}\n");
    one(
        &[("tool/src/main.rs", &main("a.one"))],
        &["tool/src/main.rs:2: the identifier \"a.one\" is typed; write `One::SPEC.id`"],
    );
    one(&[("tool/src/main.rs", &main("a.on3"))], &["the identifier \"a.on3\" is typed; no formula is called so"]);
    // Of the strings in a `SPEC`, the identifier is the one that looks like it.
    let titled = TIDY[4].1.replace("{ id:", "{ title: \"A.b\", id:");
    one(&[("src/a/one.rs", &titled), ("tool/src/main.rs", &main("a.one"))], &["is typed; write `One::SPEC.id`"]);
    for other in ["motion.x1", "a.Foo", "A.one", "a."] {
        assert_eq!(found(&[("tool/src/main.rs", &main(other))]), Vec::<String>::new(), "{other}");
    }
}

#[test]
fn an_evaluation_without_inline_fails() {
    for name in ["eval", "jacobian", "linearized"] {
        let formula = one_rs(&format!("    /// Doc.\n    fn {name}() {{}}"));
        one(&[("src/a/one.rs", &formula)], &[&format!("src/a/one.rs:13: `One::{name}` is not `#[inline]`")]);
    }
}

#[test]
fn every_formula_has_one_directive() {
    let book = |text: &'static str| [("book/src/a.md", text)];
    one(
        &book("{{#formula a.one}}\n\n{{#formula a.one}}\n"),
        &["book/src/a.md:3: formula `a.one` has its entry already, at book/src/a.md:1"],
    );
    one(
        &book("{{#formula a.one}}\n\n{{#formula a.on}}\n"),
        &["book/src/a.md:3: no formula `a.on` in the catalog; did you mean `a.one`?"],
    );
    one(&book("# A\n"), &["book/src: formula `a.one` is in the catalog but in no chapter"]);
}

#[test]
fn a_file_has_no_more_than_500_lines() {
    let lines = |number: usize| "// A line.\n".repeat(number);
    assert_eq!(found(&[("tests/long.rs", &lines(500))]), Vec::<String>::new());
    one(&[("tests/long.rs", &lines(501))], &["tests/long.rs: 501 lines, allowed are 500"]);
}

/// Each member has its own test program; files in subfolders belong to a file that is named.
#[test]
fn a_file_of_tests_that_no_program_has_is_found() {
    let manifest =
        ("tool/Cargo.toml", "[package]\nname = \"tool\"\n[[test]]\nname = \"all\"\n[[test]]\nname = \"alone\"\n");
    let named = [
        manifest,
        ("tests/all.rs", "mod sums;\n"),
        ("tests/sums.rs", ""),
        ("tests/sums/deeper.rs", ""),
        ("tool/tests/all.rs", "mod roots;\n"),
        ("tool/tests/roots.rs", ""),
        ("tool/tests/alone.rs", ""),
    ];
    assert_eq!(found(&named), Vec::<String>::new());
    for (path, folder) in [("tests/roots.rs", "tests"), ("tool/tests/sums.rs", "tool/tests")] {
        let name = path.rsplit('/').next().unwrap().trim_end_matches(".rs");
        let said = format!("{path}: no program has these tests; write `mod {name};` in {folder}/all.rs");
        assert_eq!(found(&[&named[..], &[(path, "")]].concat()), [said]);
    }
    // Without a common test program, each file is a program.
    assert_eq!(found(&[("tests/sums.rs", ""), ("tests/roots.rs", "")]), Vec::<String>::new());
}

#[test]
fn files_with_formulas_are_short() {
    let formula = one_rs(&"    // A comment.\n".repeat(150));
    one(&[("src/a/one.rs", &formula)], &["src: the files with formulas have a median of 1"]);
}

#[test]
fn a_file_that_is_not_rust_is_named_with_its_line() {
    one(&[("src/toolkit.rs", "fn f() {}\nfn {\n")], &["src/toolkit.rs:2: this cannot be read"]);
}

#[test]
fn a_rule_can_be_checked_alone() {
    let root = planted(&[("book/src/a.md", "# A\n"), ("src/a/one.rs", &one_rs("    fn linearized() {}"))]);
    let findings = |rules: &[Rule]| check(root.path(), &IDS, rules).unwrap().findings.len();
    assert_eq!([findings(&[]), findings(&[Rule::Inline]), findings(&[Rule::Lengths])], [2, 1, 0]);
}
