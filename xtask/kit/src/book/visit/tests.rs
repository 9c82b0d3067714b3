//! A small book that is checked in a browser, unmodified and with planted faults.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use jointproof::catalog::AnyFormula;
use jointproof::connector::slot;
use jointproof::contact::coulomb;
use tempfile::TempDir;

use super::queries::Answers;
use super::{
    ANY, BROWSERS, VISIT, Visit, Visited, WANTED, browsers, check, declared, fonts, is_within, longest, visit,
    with_controls,
};
use crate::book::browser::{self, Browser};
use crate::book::build::{Options, build};
use crate::book::gather::content;
use crate::book::output::write;
use crate::extension::{Moving, Slider};
use crate::project::Project;

static FORMULAS: &[&dyn AnyFormula] = &[&slot::ContactForce, &coulomb::Yield];

const CHAPTER: &str = "# One\n\n{{#figure moved It moves.}}\n\n{{#formula slot.contact_force}}\n\n{{#formula coulomb.yield}}\n\n{{#symbols}}\n";

const QUERIES: &str = "contact force => coulomb.html#slot.contact_force\n\\Phi => coulomb.html#coulomb.yield\nF_C => coulomb.html#slot.contact_force\n\
    μ => coulomb.html#symbol-mu\nmu => coulomb.html#symbol-mu\n";

struct Book {
    folder: TempDir,
    project: Project,
}

impl Book {
    /// `None` if there is no browser and none is required.
    fn new(chapter: &str, queries: &str) -> Option<Self> {
        if !browser::is_here_or_not_required().unwrap() {
            eprintln!("skipped: chromium is not here");
            return None;
        }
        let folder = tempfile::tempdir().unwrap();
        let file = |path: &str, text: &str| write(&folder.path().join(path), text.as_bytes()).unwrap();
        file("book/book.toml", "[book]\ntitle = \"T\"\nauthors = [\"A\"]\n");
        file("book/src/SUMMARY.md", "# Summary\n\n- [One](coulomb.md)\n");
        file("book/src/coulomb.md", chapter);
        file("book/queries.txt", queries);
        let root = folder.path().to_str().unwrap().to_owned().leak();
        let project = Project::new("small", root, FORMULAS);
        let mut content = content(&project, None).unwrap();
        let frame = |text: &str| {
            format!("<svg viewBox=\"0 0 9 9\" role=\"img\">\n<title>Moved</title>\n<text>{text}</text>\n</svg>\n")
        };
        content.extras.moving.push(Moving {
            name: "moved".into(),
            sliders: vec![Slider { label: "way".into(), values: vec!["0".into(), "1 mm".into()], start: 0 }],
            frames: vec![frame("here"), frame("there")],
        });
        build(folder.path(), &Options::default(), content).unwrap();
        Some(Self { folder, project })
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("target/book").canonicalize().unwrap()
    }

    fn said(&self, browsers: &mut [Browser; BROWSERS], axe: Option<&str>) -> String {
        let visited = visit(&self.project, &self.out(), browsers, axe).unwrap();
        format!("{} {visited}", visited.is_well())
    }
}

/// The accessibility script, if it is available.
fn real_axe() -> Option<String> {
    std::env::var_os(super::AXE).map(|path| fs::read_to_string(path).unwrap())
}

/// Reports the colours, the screen width and the options with which it was called.
const FAKE_AXE: &str = "window.axe = { run: async (page, options) => {
    const colours = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
    const found = (id, impact) => ({ id, impact, nodes: [{ target: ['main'], html: '<main>' }] });
    const { resultTypes, preload, ...others } = options;
    return { violations: [found(`${colours} ${innerWidth} ${JSON.stringify(others)}`, 'serious'), found('small', 'minor')] };
} };";

/// Errors, content that is too wide immediately or when unfolded, and controls that the keyboard cannot operate.
const PLANTED: &str = "<p style=\"width: 500px\">wide</p><details><summary>more</summary><p style=\"width: 600px\">folded</p></details>\
    <script>console.error(['dark)', 'reduced-motion)'].some((q) => matchMedia('(prefers-color-scheme: ' + q).matches || \
    matchMedia('(prefers-' + q).matches) ? 'odd' : 'planted')</script><img src=\"no.png\" alt=\"no\">\
    <a href=\"#one\" style=\"outline: none !important; box-shadow: none\">a</a><button onfocus=\"this.blur()\">b</button>\
    <math><mi>𓀀</mi></math><span class=\"math-block\"><math><mspace width=\"1200px\"></mspace></math></span>\
    <svg width=\"99\" height=\"40\"><title>drawn</title><text y=\"9\" font-size=\"8\">small</text>\
    <text y=\"30\" font-size=\"12\">one</text><text y=\"32\" font-size=\"12\">two</text></svg>\
    <table><tbody><tr><td>a</td><td>a finite number</td></tr><tr><td>b</td><td>a finite number</td></tr>\
    <tr><td>c</td><td>a finite number</td></tr></tbody></table><code style=\"font-variant-ligatures: normal\">&lt;=</code>\
    <div class=\"table-wrapper\" style=\"background: none\"><p style=\"width: 500px\">out of sight</p></div>";

#[test]
fn a_good_book_is_well_and_planted_faults_are_named() {
    let Some(book) = Book::new(CHAPTER, QUERIES) else { return };
    let mut browsers = browsers().unwrap();
    let axe = real_axe();
    let said = book.said(&mut browsers, axe.as_deref());
    assert!(said.starts_with("true 4 pages on a phone") && said.contains("5 of 5 queries"), "{said}");
    assert!(said.contains("first view, compressed: ") && !said.contains("(print.html)"), "{said}");
    let controls = said.split("; ").find_map(|part| part.split_once(" controls reached")?.0.parse::<usize>().ok());
    assert!(controls > Some(10), "{said}");
    let page = book.out().join("coulomb.html");
    let good = fs::read_to_string(&page).unwrap();
    fs::write(&page, good.replacen("</main>", &format!("{PLANTED}</main>"), 1)).unwrap();
    // The keyboard is tested on the smaller one of two pages.
    let whole = book.out().join("print.html");
    let longer = fs::read_to_string(&whole).unwrap() + &" ".repeat(5000);
    fs::write(&whole, longer).unwrap();
    let said = book.said(&mut browsers, None);
    let lines: Vec<_> = said.lines().map(str::trim).collect();
    // Errors when a page is opened occur again when the keyboard is tested.
    for (begin, end) in [
        ("the page is 1", "<p style=\"width: 500px\">wide</p> (1 page, first coulomb.html)"),
        ("unfolded, the page is 2", " (1 page, first coulomb.html)"),
        ("[{\"type\":\"string\",\"value\":\"planted\"}]", " (2 pages, first coulomb.html)"),
        ("\"Failed to load resource: net::ERR_FILE_NOT_FOUND\"", "no.png\" (2 pages, first coulomb.html)"),
        ("nothing marks <a href=\"#one\"", " when the keyboard is there (1 page, first coulomb.html)"),
        ("the keyboard does not reach <button onfocus", " (1 page, first coulomb.html)"),
        ("STIX Two Math has no `𓀀`, U+13000", " (1 page, first coulomb.html)"),
        ("on paper, an equation is 12", " (1 page, first coulomb.html)"),
        ("an equation is 12", " (1 page, first coulomb.html)"),
        ("the label small has 8.0 pixels", " (1 page, first coulomb.html)"),
        ("the labels one and two cover each other in drawn", " (1 page, first coulomb.html)"),
        ("a table says \"a finite number\" in each of 3 rows", " (1 page, first coulomb.html)"),
        ("ligatures in <code style", " (1 page, first coulomb.html)"),
        ("on a phone, nothing shows that more is beside <div class=\"table-wrapper\"", " (1 page, first coulomb.html)"),
    ] {
        assert!(lines.iter().any(|line| line.starts_with(begin) && line.ends_with(end)), "{begin}…{end}: {said}");
    }
    assert!(said.starts_with("false 4 pages ") && said.contains("not searched for barriers"), "{said}");
    assert_eq!(lines.len(), 17, "{said}");
    if axe.is_some() {
        let barriers = "<p style=\"color: #ccc; background: #fff\">pale</p><img src=\"favicon.svg\">";
        fs::write(&page, good.replacen("</main>", &format!("{barriers}</main>"), 1)).unwrap();
        let said = book.said(&mut browsers, axe.as_deref());
        assert!(said.contains("serious: color-contrast") && said.contains("critical: image-alt"), "{said}");
    }
}

#[test]
fn barriers_are_looked_for_on_a_desk_in_both_colours_and_with_less_motion() {
    let moving = "<p style=\"animation: a 9s infinite !important\">It moves.</p>\n";
    let Some(book) = Book::new(&format!("{CHAPTER}\n{moving}"), "yield => coulomb.html#coulomb.yield\n") else {
        return;
    };
    let said = book.said(&mut browsers().unwrap(), Some(FAKE_AXE));
    let off: Vec<_> = said.lines().skip(3).map(str::trim).collect();
    let first = ", 1 times, first main <main> (";
    let once = |what: &str| format!("serious: light 1280 {what}{first}");
    let starts = [
        "in dark colours, serious: dark 1280 {\"runOnly\":[\"color-contrast\"]}".to_owned() + first + "3 pages",
        once("{\"rules\":{\"color-contrast\":{\"enabled\":false}}}") + "1 page, first print.html)",
        once("{}") + "3 pages",
        "with less motion wanted, <p style=\"animation: a 9s infinite !important\">It moves.</p> moves (2 pages"
            .to_owned(),
    ];
    assert_eq!(off.len(), starts.len(), "{said}");
    for (off, start) in off.iter().zip(starts) {
        assert!(off.starts_with(&start), "{start}: {said}");
    }
    assert!(said.starts_with("false 4 pages on a phone and on a desk; 4 searched for barriers, in light "), "{said}");
}

#[test]
fn a_wrong_answer_of_search_is_named() {
    let Some(book) = Book::new(CHAPTER, "yield => coulomb.html#one\n") else { return };
    let visited = check(&book.project, &book.out()).unwrap().expect("the browser is here");
    let said = visited.to_string();
    assert!(!visited.is_well(), "{said}");
    assert!(said.contains("yield: wanted is coulomb.html#one, found coulomb.html#coulomb.yield"), "{said}");
}

#[test]
fn sliders_show_the_position_they_are_at() {
    let Some(book) = Book::new(CHAPTER, QUERIES) else { return };
    let mut browser = Browser::start().unwrap();
    browser.open(&book.out().join("coulomb.html")).unwrap();
    let shown = browser
        .evaluate(
            "(async () => {
                const figure = document.getElementById('figure-moved');
                const slider = figure.querySelector('input');
                const before = figure.querySelector('.drawing').textContent.trim();
                slider.value = 1;
                slider.dispatchEvent(new Event('input'));
                const drawn = () => figure.querySelector('.drawing').textContent.trim();
                for (let left = 300; left > 0 && drawn() === before; --left) await new Promise((done) => setTimeout(done, 10));
                return [before, drawn(), figure.querySelector('output').textContent, slider.getAttribute('aria-valuetext')].join('|');
            })()",
        )
        .unwrap();
    let text = shown.as_str().unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(text, "Moved here|Moved there|1 mm|1 mm");
}

#[test]
fn what_was_found_in_some_pages_is_added_to_what_was_found_in_others() {
    let found = |pages: usize| Visited {
        pages,
        searched: 2 * pages,
        controls: 3 * pages,
        answers: None,
        weights: [(7, format!("{pages}.html"))].into(),
        off: [("too wide".to_owned(), vec![pages.to_string()])].into(),
    };
    let both = found(1).and(found(10));
    assert_eq!((both.pages, both.searched, both.controls, both.weights.len()), (11, 22, 33, 2));
    assert_eq!(both.off["too wide"], ["1", "10"]);
}

#[test]
fn all_is_well_where_pages_were_seen_and_nothing_is_off() {
    let seen = || Visited { pages: 1, ..Visited::default() };
    assert!(seen().is_well());
    assert!(!Visited::default().is_well());
    assert!(!Visited { answers: Some(Answers::default()), ..seen() }.is_well());
    let mut off = seen();
    off.note("a.html", ["odd".to_owned()]);
    assert!(!off.is_well());
}

#[test]
fn what_loads_more_than_wanted_is_off() {
    let weights = [(WANTED + 1, "a.html".to_owned()), (WANTED, "b.html".to_owned())].into();
    let mut visited = Visited { pages: 2, weights, ..Visited::default() };
    visited.note_heavy();
    let off: Vec<_> = visited.off.into_iter().collect();
    assert_eq!(off, [("the first view loads 400001 bytes, wanted are 400000".to_owned(), vec!["a.html".to_owned()])]);
}

#[test]
fn a_page_weighs_all_that_it_loads_and_each_file_once() {
    let Some(book) = Book::new("# One\n\n{{#formula slot.contact_force}}\n\n{{#formula coulomb.yield}}\n", QUERIES)
    else {
        return;
    };
    let folder = book.folder.path().canonicalize().unwrap();
    let file = |name: &str, text: &[u8]| {
        write(&folder.join(name), text).unwrap();
        folder.join(name)
    };
    let css = file("a.css", b"p { color: red }");
    let script = file("b.js", b"const b = 1;");
    let link = "<link rel=\"stylesheet\" href=\"a.css\">";
    let page = file("page.html", format!("<!DOCTYPE html>{link}<script src=\"b.js\"></script>{link}").as_bytes());
    let mut browser = Browser::start().unwrap();
    let mut visit_of = |page: &PathBuf| {
        browser.open(page).unwrap();
        browser.evaluate(VISIT).unwrap();
        let (visited, sizes) = (Visited::default(), BTreeMap::new());
        let mut visit = Visit { browser: &mut browser, out: &book.out(), axe: None, visited, sizes };
        let parts = [page, &css, &script].map(|file| visit.size(file).unwrap());
        let binary = visit.size(&file("c.bin", &[0xff; 1000])).unwrap();
        (visit.weight(page).unwrap(), parts, binary)
    };
    let (weight, parts, binary) = visit_of(&page);
    assert!(parts.iter().all(|size| (10..200).contains(size)), "{parts:?}");
    assert_eq!((weight, binary), (parts.iter().sum(), 1000));
    // The size includes fonts.
    let (weight, [page, ..], _) = visit_of(&book.out().join("coulomb.html"));
    let loaded: super::Loaded = serde_json::from_value(browser.evaluate("loaded()").unwrap()).unwrap();
    let fonts = fonts(&book.out().join("fonts"), &loaded.fonts).unwrap();
    let fonts: u64 = fonts.iter().map(|font| font.metadata().unwrap().len()).sum();
    assert!(fonts > 10_000 && weight > page + fonts, "{weight}, {page} and {fonts} bytes");
}

#[test]
fn the_keyboard_is_tried_on_the_smallest_page_with_all_sorts_of_controls() {
    let folder = tempfile::tempdir().unwrap();
    let page = |name: &str, text: &str| {
        fs::write(folder.path().join(name), text).unwrap();
        folder.path().join(name)
    };
    let (calculator, sliders) = ("<div class=\"calculator\">", "<div class=\"sliders\">");
    let both = format!("{calculator}{sliders}");
    let (large, small, index) = (page("large.html", &both), page("small.html", &both), page("index.html", &both));
    let others = [page("c.html", calculator), page("s.html", sliders)];
    let [c, s] = others.clone();
    assert_eq!(with_controls(&[large, small.clone(), c, s, index.clone()]).unwrap(), Some(small));
    let [c, s] = others;
    assert_eq!(with_controls(&[c, s, index]).unwrap(), None);
}

#[test]
fn the_longest_file_is_found_in_any_folder() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, length: usize| write(&folder.path().join(name), &vec![b'x'; length]).unwrap();
    assert_eq!(longest(&folder.path().join("no")).unwrap(), None);
    assert_eq!(longest(folder.path()).unwrap(), None);
    file("z.html", 10);
    file("a/b/c.html", 30);
    file("a/z.html", 20);
    assert_eq!(longest(folder.path()).unwrap(), Some(folder.path().join("a/b/c.html")));
}

#[test]
fn fonts_are_found_by_family_style_and_range() {
    let folder = tempfile::tempdir().unwrap();
    let css = "/* Fonts. */
        @font-face { font-family: \"One\"; src: url(one.woff2); }
        @font-face { font-family: 'Two'; font-style: italic; src: url(\"no.woff2\"); }
        @font-face { font-family: One; font-style: italic; src: url(\"one-italic.woff2\"); }
        @font-face { font-family: One; font-style: normal; unicode-range: U+41; src: url(one-part.woff2); }
        @font-face { font-family: Two; src: url(two.woff2); }";
    fs::write(folder.path().join("fonts.css"), css).unwrap();
    let found = |family: &str, style: &str, range: &str| {
        let font = [family, style, range].map(String::from);
        let files = fonts(folder.path(), &[font]).map_err(|error| error.to_string())?;
        assert_eq!(files.len(), 1);
        Ok(files[0].file_name().unwrap().to_str().unwrap().to_owned())
    };
    let ok = |name: &str| Ok::<_, String>(name.to_owned());
    assert_eq!(found("One", "normal", ANY), ok("one.woff2"));
    assert_eq!(found("One", "italic", ANY), ok("one-italic.woff2"));
    assert_eq!(found("One", "normal", "U+41"), ok("one-part.woff2"));
    assert_eq!(found("Two", "normal", ANY), ok("two.woff2"));
    assert_eq!(found("Two", "oblique", ANY), Err("fonts.css has no Two, oblique, U+0-10FFFF".to_owned()));
    assert_eq!(declared("a: b; font-family: \"One Two\" ; c: d", "font-family").as_deref(), Some("One Two"));
    assert_eq!(declared("a: b", "font-family"), None);
}

#[test]
fn a_character_is_in_a_range_as_css_writes_it() {
    let range = "U+20-7E, U+131,U+1D400-1D7FF";
    for (c, is_so) in [
        (' ', true),
        ('~', true),
        ('\u{7f}', false),
        ('ı', true),
        ('\u{1f}', false),
        ('𝐀', true),
        ('x', true),
        ('é', false),
    ] {
        assert_eq!(is_within(c, range), is_so, "{c:?}");
    }
    assert!(!is_within('a', "") && !is_within('1', "31"));
}
