//! The real book: intact, complete, and independent of the network.

use crate::common::{Bench, Ran, assert_accepted};
use jointproof::catalog::{AnyFormula, CATALOG};
use std::collections::HashSet;
use std::ffi::OsString;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::sync::{LazyLock, OnceLock};
use std::time::Duration;

/// The book, built once for all tests here, in a folder used by no one else, with the reference report.
static BOOK: LazyLock<PathBuf> = LazyLock::new(|| {
    let bench = Bench::new();
    let out = free_folder();
    let mut command = bench.command(&["book", "--unmeasured", "--open", "--out", out.to_str().unwrap()]);
    if cfg!(target_os = "linux") {
        command.env("PATH", opener(&bench));
    }
    let entries = format!(" chapters, {} formulas, ", CATALOG.len());
    let ran = Ran::from(command.output().unwrap()).exits(0).says(&entries).says(" listings in ");
    // Checks that were not requested are not made.
    assert_eq!(ran.stdout.lines().count(), 1, "{ran:#?}");
    assert!(!cfg!(target_os = "linux") || was_opened(&bench, &out), "the book is not shown");
    out
});

/// The first folder that no other run of these tests uses.
fn free_folder() -> PathBuf {
    static LOCK: OnceLock<File> = OnceLock::new();
    let folder = |number: u32| Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("book-{number}"));
    let locked = |number| {
        let lock = File::create(folder(number).with_extension("lock")).unwrap();
        lock.try_lock().ok()?;
        Some((folder(number), lock))
    };
    let (folder, lock) = (0..).find_map(locked).unwrap();
    LOCK.set(lock).unwrap();
    folder
}

/// The search path, preceded by a program that only records what it is told to open.
fn opener(bench: &Bench) -> OsString {
    let folder = bench.path("programs");
    fs::create_dir_all(&folder).unwrap();
    let program = folder.join("xdg-open");
    fs::write(&program, format!("#!/bin/sh\necho \"$1\" > '{}'\n", bench.path("opened").display())).unwrap();
    #[cfg(unix)]
    fs::set_permissions(&program, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
    let before = std::env::var_os("PATH").unwrap_or_default();
    std::env::join_paths([folder].into_iter().chain(std::env::split_paths(&before))).unwrap()
}

/// Whether the first page was opened; the opener runs independently.
fn was_opened(bench: &Bench, out: &Path) -> bool {
    let index = format!("{}\n", out.join("index.html").display());
    let is_it = || fs::read_to_string(bench.path("opened")).is_ok_and(|opened| opened == index);
    (0..6000).any(|_| {
        is_it() || {
            std::thread::sleep(Duration::from_millis(10));
            false
        }
    })
}

/// All files below a folder with these extensions.
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

/// The pages of the chapters, without the page that contains them all and the listings.
fn chapters() -> impl Iterator<Item = (String, String)> {
    let listings = BOOK.join("source").display().to_string();
    files(&BOOK, &["html"])
        .into_iter()
        .filter(move |(name, _)| !name.starts_with(&listings) && !name.ends_with("print.html"))
}

/// The texts between `start` and `end` in the chapters: each text is scanned once, not once per formula.
fn behind(start: &str, end: &str) -> Vec<String> {
    let until_end = |text: &str| text.split(end).next().unwrap().to_owned();
    chapters().flat_map(|(_, page)| page.split(start).skip(1).map(until_end).collect::<Vec<_>>()).collect()
}

/// Asserts that each formula has exactly one of these texts, which starts with its identifier, and returns them in order.
fn one_each(texts: &[String], what: &str) -> Vec<(&'static dyn AnyFormula, String)> {
    let one = |formula: &&'static dyn AnyFormula| {
        let begin = format!("{}\"", formula.spec().id);
        let own: Vec<_> = texts.iter().filter(|text| text.starts_with(&begin)).collect();
        assert_eq!(own.len(), 1, "{what} of {}", formula.spec().id);
        (*formula, own[0].clone())
    };
    CATALOG.iter().map(one).collect()
}

#[test]
fn every_formula_has_one_anchor_and_its_equation_as_mathml() {
    // The first chapter is also the index.
    for (formula, entry) in one_each(&behind("<h3 id=\"", "</section>"), "entries") {
        assert!(entry.contains("<math displaystyle=\"true\""), "{} has no equation", formula.spec().id);
        let rows = entry.matches("\"><td><math").count();
        assert_eq!(rows, formula.inputs().len() + formula.outputs().len(), "symbols of {}", formula.spec().id);
    }
}

/// All formulas have a graph, as `tests/graph.rs` asserts, from which a calculator is generated.
#[test]
fn every_formula_has_a_calculator() {
    for (formula, _) in one_each(&behind("<details class=\"calculator\" data-formula=\"", ">"), "calculators") {
        let id = formula.spec().id;
        let script = fs::read_to_string(BOOK.join(format!("calculator/{id}.js"))).unwrap();
        assert!(script.contains("\nfunction compute(i) {\n"), "{script}");
    }
}

#[test]
fn the_report_of_reference_is_shown() {
    let titles = behind("<title>", "</title>");
    for id in CATALOG.iter().map(|formula| formula.spec().id) {
        for plot in ["speed against error", "error of differences over their step"] {
            assert!(titles.contains(&format!("{id}: {plot}")), "{id} has no plot of {plot}");
        }
    }
    let speed = fs::read_to_string(BOOK.join("speed.html")).unwrap();
    assert!(!speed.contains("Not measured"));
    let linked: HashSet<_> = speed.split('#').skip(1).filter_map(|text| text.split('"').next()).collect();
    for id in CATALOG.iter().map(|formula| formula.spec().id) {
        assert!(linked.contains(id), "{id} is not in the table");
        let family = id.split_once('.').unwrap().0;
        assert!(speed.contains(&format!("<figure id=\"speed-{family}\">")), "{family} has no plot");
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
        // A link is followed by the reader alone.
        let page = page.replace("<a href=\"https://", "<a href=\"");
        for how in ["src=\"", "href=\"", "action=\"", "data=\"", "url(", "url(\"", "url('", "@import \"", "@import '"] {
            for scheme in ["http:", "https:", "//"] {
                let fetched = format!("{how}{scheme}");
                assert!(!page.contains(&fetched), "{name} has {fetched}");
            }
        }
    }
    // Scripts of calculators name a host only as the namespace of SVG.
    for (name, script) in files(&BOOK.join("calculator"), &["js"]) {
        let script = script.replace("http://www.w3.org/2000/svg", "");
        assert!(!["://", "fetch(", "import("].iter().any(|how| script.contains(how)), "{name}");
    }
    // The script that runs Rust code in a playground belongs to mdBook; nothing here may call it.
    for (name, page) in chapters() {
        assert!(!page.contains("class=\"playground\""), "{name} has code that is run elsewhere");
    }
}

/// Changes of the pages are reviewed once, by the author of the change; after that only intended changes may occur.
#[test]
fn every_section_and_script_is_as_it_was_accepted() {
    assert_accepted("book", "pages.txt", &accepted());
}

/// The sections of all chapters, the scripts of all calculators and figures, and the index of the search.
fn accepted() -> Vec<(String, String)> {
    let from_root = |path: &str| Path::new(path).strip_prefix(&*BOOK).unwrap().display().to_string();
    let mut texts = Vec::new();
    for (path, page) in chapters() {
        let Some((_, main)) = page.split_once("<main>") else { continue };
        let mut sections = main.split("</main>").next().unwrap().split(" id=\"");
        texts.push((from_root(&path), lasting(sections.next().unwrap())));
        texts.extend(sections.map(|section| {
            let name = section.split('"').next().unwrap();
            (format!("{}#{name}", from_root(&path)), lasting(section))
        }));
    }
    for scripts in ["calculator", "figures"] {
        let scripts = files(&BOOK.join(scripts), &["js"]).into_iter();
        texts.extend(scripts.map(|(path, text)| (from_root(&path), text)));
    }
    texts.push(("searchindex.js".into(), lasting(&fs::read_to_string(BOOK.join("searchindex.js")).unwrap())));
    texts
}

/// A text without revisions, line numbers of sources, and the statement whether the report is of these sources: they
/// change without any change of the pages.
fn lasting(text: &str) -> String {
    let is_revision = |word: &&str| word.len() == 40 && word.bytes().all(|byte| byte.is_ascii_hexdigit());
    let text = without_lines(&without_lines(text, "#L"), ".rs:");
    let text = text.replace("<b>another version</b>", "this version");
    text.split('/').filter(|word| !is_revision(word)).collect::<Vec<_>>().join("/")
}

/// A text without the line numbers that follow this mark.
fn without_lines(text: &str, mark: &str) -> String {
    let is_line = |c: char| c.is_ascii_digit() || c == '-' || c == 'L';
    let mut parts = text.split(mark);
    let start = parts.next().unwrap_or_default().to_owned();
    parts.fold(start, |text, part| text + mark + part.trim_start_matches(is_line))
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

/// The visible text of a page, without code.
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
